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

/// Of an event, in units of the accuracy times the system's time scale of 0.1 s [-]: 1e-14 s.
/// Simbody takes no less than rounding.
constexpr double window = 1e-3;

/// A value of one cable that Simbody watches.
using Watched = double (CableEvents::*)(const SimTK::State& state, std::size_t cable) const;

enum class Sign { rises, falls };

/// An event of one cable, which is handled with all that touch.
class CableHandler final : public SimTK::TriggeredEventHandler {
 public:
  CableHandler(SimTK::Stage stage, Watched watched, Sign sign, CableEvents& cables,
               std::size_t cable)
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
  Watched watched_;
  CableEvents& cables_;
  std::size_t cable_;
};

class EventHandlerSimulation final : public Simulation {
 public:
  explicit EventHandlerSimulation(const Case& the_case) : body_(the_case), cables_(body_) {
    for (std::size_t index = 0; index < the_case.cables.size(); ++index) {
      watch(SimTK::Stage::Position, &CableEvents::overstretch, Sign::rises, index);
      watch(SimTK::Stage::Velocity, &CableEvents::opening, Sign::falls, index);
      watch(SimTK::Stage::Acceleration, &CableEvents::tension, Sign::falls, index);
    }
    start_ = body_.initial_state();
    integrator_.setAccuracy(accuracy);
    integrator_.setAllowInterpolation(false);
  }

  [[nodiscard]] State state() const override {
    return body_.state_of(clock_.now() > 0.0 ? integrator_.getState() : start_);
  }
  [[nodiscard]] std::span<const double> impulses() const override { return cables_.impulses(); }
  [[nodiscard]] std::span<const Event> events() const override { return cables_.events(); }
  [[nodiscard]] std::optional<Stop> stopped() const override { return stop_; }

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
      stop_ = Stop{integrator_.getTime(), *cables_.trouble()};
    }
  }

 private:
  void watch(SimTK::Stage stage, Watched watched, Sign sign, std::size_t cable) {
    body_.system().addEventHandler(new CableHandler(stage, watched, sign, cables_, cable));
  }

  PlanarBody body_;
  CableEvents cables_;
  SimTK::State start_;
  SimTK::RungeKuttaMersonIntegrator integrator_{body_.system()};
  SimTK::TimeStepper stepper_{body_.system(), integrator_};
  Clock clock_;
  std::optional<Stop> stop_;
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
                           "tension ends."}}},
           .start = makes<EventHandlerSimulation>(),
           .follows_speed = true}};
}

}  // namespace tautline::simbody
