// Simbody's integrator with error control finds the instants, by its own event handlers: a cable
// that reaches its length is an event, and so is a tension that ends. What happens then is
// CableEvents.

#include "cable_events.hpp"
#include "models.hpp"
#include "tautline/clock.hpp"

namespace tautline::simbody {
namespace {

/// Of the integrator [-]. The standard case is then right to 1e-13 m up to t = 2; with the default
/// 1e-3, to 1e-7 m.
constexpr double accuracy = 1e-10;

/// In space a spinning body takes more.
constexpr double accuracy_in_space = 1e-12;

/// Of an event, in units of the accuracy times the system's time scale of 0.1 s [-]: 1e-14 s.
/// Simbody takes no less than rounding.
constexpr double window = 1e-3;

/// A value of one cable that Simbody watches.
template <class TheCase>
using Watched = double (CableEvents<TheCase>::*)(const SimTK::State& state,
                                                 std::size_t cable) const;

enum class Sign { rises, falls };

/// An event of one cable, which is handled with all that touch.
template <class TheCase>
class CableHandler final : public SimTK::TriggeredEventHandler {
 public:
  CableHandler(SimTK::Stage stage, Watched<TheCase> watched, Sign sign,
               CableEvents<TheCase>& cables, std::size_t cable)
      : TriggeredEventHandler(stage), watched_(watched), cables_(cables), cable_(cable) {
    getTriggerInfo().setRequiredLocalizationTimeWindow(window);
    getTriggerInfo().setTriggerOnRisingSignTransition(sign == Sign::rises);
    getTriggerInfo().setTriggerOnFallingSignTransition(sign == Sign::falls);
  }

  [[nodiscard]] SimTK::Real getValue(const SimTK::State& state) const override {
    return (cables_.*watched_)(state, cable_);
  }

  void handleEvent(SimTK::State& state, SimTK::Real /*accuracy*/, bool& terminate) const override {
    cables_.react(state);
    terminate = cables_.trouble().has_value();
  }

 private:
  Watched<TheCase> watched_;
  CableEvents<TheCase>& cables_;
  std::size_t cable_;
};

template <class TheCase>
class EventHandlerSimulation final : public BasicSimulation<TheCase> {
 public:
  explicit EventHandlerSimulation(const TheCase& the_case) : bodies_(the_case), cables_(bodies_) {
    for (std::size_t index = 0; index < the_case.cables.size(); ++index) {
      watch(SimTK::Stage::Position, &CableEvents<TheCase>::overstretch, Sign::rises, index);
      watch(SimTK::Stage::Velocity, &CableEvents<TheCase>::opening, Sign::falls, index);
      watch(SimTK::Stage::Acceleration, &CableEvents<TheCase>::tension, Sign::falls, index);
    }
    start_ = bodies_.initial_state();
    integrator_.setAccuracy(TheCase::has_several_bodies ? accuracy_in_space : accuracy);
    integrator_.setAllowInterpolation(false);
  }

  [[nodiscard]] StateOf<TheCase> state() const override {
    return bodies_.state_of(clock_.now() > 0.0 ? integrator_.getState() : start_);
  }
  [[nodiscard]] std::span<const double> impulses() const override { return cables_.impulses(); }
  [[nodiscard]] std::span<const BasicEvent<TheCase>> events() const override {
    return cables_.events();
  }
  [[nodiscard]] std::optional<StopOfRun> stopped() const override { return stop_; }

  void step(double dt) override {
    cables_.start_step();
    if (clock_.now() == 0.0) {  // exactly: nothing has moved yet
      cables_.react(start_);
      stepper_.initialize(start_);
    }
    clock_.advance(dt);
    if (!cables_.trouble()) {
      stepper_.stepTo(clock_.now());
      cables_.check(integrator_.getState());
    }
    if (cables_.trouble() && !stop_) {
      stop_ = StopOfRun{integrator_.getTime(), *cables_.trouble()};
    }
  }

 private:
  void watch(SimTK::Stage stage, Watched<TheCase> watched, Sign sign, std::size_t cable) {
    bodies_.system().addEventHandler(
        new CableHandler<TheCase>(stage, watched, sign, cables_, cable));
  }

  Bodies<TheCase> bodies_;
  CableEvents<TheCase> cables_;
  SimTK::State start_;
  SimTK::RungeKuttaMersonIntegrator integrator_{bodies_.system()};
  SimTK::TimeStepper stepper_{bodies_.system(), integrator_};
  Clock clock_;
  std::optional<StopOfRun> stop_;
};

}  // namespace

std::vector<ModelEntry> event_handler_models() {
  return {{.model = {.name = "event-handler",
                     .sentence = "RungeKuttaMersonIntegrator finds the instants by event handlers "
                                 "of our own, which solve "
                                 "impacts by Newton's law, all cables at once, and switch rods on "
                                 "while cables are taut.",
                     .settings =
                         {{"setAccuracy", "1e-10",
                           "The default 1e-3 finds an instant to 1e-9 s, and leaves 1e-7 m on the "
                           "standard case."},
                          {"setRequiredLocalizationTimeWindow", "1e-3",
                           "In units of the accuracy times 0.1 s: the default 0.1 leaves 1e-12 s."},
                          {"setAllowInterpolation", "false",
                           "A step of the integrator is then no longer than one of the run: it "
                           "sees a cable that "
                           "is at its length at the end of a step, not one that was in between."},
                          {"Constraint::Rod", "on while a cable is taut",
                           "A rebound slower than 1e-6 m/s is none; the rod is off again when its "
                           "tension ends."}},
                     .in_space = joined(
                         {{{"setAccuracy", "1e-12",
                            "A spinning ball was off by 1e-7 rad in three seconds with 1e-10."}},
                          system_settings()})},
           .start = makes<EventHandlerSimulation<Case>>(),
           .start_system = makes<EventHandlerSimulation<SpatialSystem>>(),
           .follows_speed = true}};
}

}  // namespace tautline::simbody
