// Siconos' time-stepping after Moreau and Jean: a step flies at the mean of the velocities at its
// ends, and a linear complementarity problem of impulses makes the gap rates at its end what
// Newton's law says of those at its start. With theta = 1/2 a flight is the exact parabola.
// `moreau-jean-projected` then moves the body back to where no cable is overstretched. `spring`
// pulls elastic cables by forces, and leaves the others to these problems.

#include "system.hpp"  // before Siconos' own: see storage_in_cpp20.hpp

#include <algorithm>
#include <optional>
#include <string>
#include <utility>

#include <MLCPProjectOnConstraints.hpp>
#include <MoreauJeanDirectProjectionOSI.hpp>
#include <MoreauJeanOSI.hpp>
#include <TimeDiscretisation.hpp>
#include <TimeStepping.hpp>
#include <TimeSteppingDirectProjection.hpp>

#include "adapter/spring_model.hpp"
#include "checked_lcp.hpp"
#include "models.hpp"
#include "tautline/clock.hpp"

namespace tautline::siconos_engine {
namespace {

enum class Projection { none, direct };

/// The choices in which the models differ.
struct Scheme {
  Projection projection;
  /// The weight of a step's end in the mean of its velocities. One half is of second order in
  /// flight, and exact under gravity; 1 doubles the error of a run.
  double theta = 0.5;
};

std::shared_ptr<TimeStepping> stepping(const Interactions& system, double dt,
                                       const Scheme& scheme) {
  auto times = std::make_shared<TimeDiscretisation>(0.0, dt);
  std::shared_ptr<TimeStepping> result;
  if (scheme.projection == Projection::none) {
    result = std::make_shared<TimeStepping>(system.dynamics(), times,
                                            std::make_shared<MoreauJeanOSI>(scheme.theta),
                                            std::make_shared<CheckedLcp>());
  } else {
    constexpr unsigned int all_cables = 0;  // index set that is projected on
    result = std::make_shared<TimeSteppingDirectProjection>(
        system.dynamics(), times, std::make_shared<MoreauJeanDirectProjectionOSI>(scheme.theta),
        std::make_shared<CheckedLcp>(), std::make_shared<MLCPProjectOnConstraints>(), all_cables);
  }
  return result;
}

/// `TheSystem` is what Siconos sees of a `TheCase`.
template <class TheCase, class TheSystem>
class MoreauJeanSimulation final : public BasicSteppedSimulation<TheCase> {
 public:
  MoreauJeanSimulation(const TheCase& the_case, const RunSettings& run, const Scheme& scheme)
      : case_(the_case),
        scheme_(scheme),
        now_(the_case.initial),
        impulses_(the_case.cables.size()) {
    begin(run.step);
  }

  [[nodiscard]] StateOf<TheCase> state() const override { return now_; }
  [[nodiscard]] std::span<const double> impulses() const override { return impulses_; }
  [[nodiscard]] std::optional<StopOfRun> stopped() const override { return stop_; }

  /// Lets these act in the next step, next to what is given.
  void pull(const std::vector<BodyLoad>& loads) { pulls_ = loads; }

  void step(double dt) override {
    std::fill(impulses_.begin(), impulses_.end(), 0.0);
    if (stop_) {
      return;
    }
    try {
      if (dt != dt_) {
        begin(dt);
      }
      if constexpr (TheCase::has_several_bodies) {
        system_->set_pulls(pulls_);
      }
      system_->set_restitutions();
      stepping_->computeOneStep();
      for (const std::size_t index : system_->index_set(1)) {
        impulses_[index] = system_->multiplier(index, 1);
      }
      stepping_->nextStep();
    } catch (const std::exception& error) {
      std::fill(impulses_.begin(), impulses_.end(), 0.0);
      stop_ = StopOfRun{clock_.now(), reason(error)};
      return;
    }
    now_ = system_->state();
    clock_.advance(dt);
    if constexpr (TheCase::has_several_bodies) {
      now_.time = clock_.now();
    }
  }

 private:
  /// Steps of `dt` from now on. The scheme has no memory but the state, so that a step of another
  /// length is a new simulation from there.
  void begin(double dt) {
    dt_ = dt;
    stepping_.reset();
    system_.emplace(case_, now_);
    stepping_ = stepping(*system_, dt, scheme_);
  }

  const TheCase case_;
  Scheme scheme_;
  StateOf<TheCase> now_;
  Clock clock_;
  double dt_ = 0.0;  // [s]
  std::vector<BodyLoad> pulls_;
  std::optional<TheSystem> system_;
  std::shared_ptr<TimeStepping> stepping_;
  std::vector<double> impulses_;
  std::optional<StopOfRun> stop_;
};

ModelEntry entry(std::string name, std::string sentence, Projection projection) {
  ModelEntry result = {
      .model = {.name = std::move(name),
                .sentence = std::move(sentence),
                .settings = {{"LCP::compute", "overridden, ends the run where the solver fails",
                              "Siconos prints a line and goes on with what the solver has left."}},
                .maker = Maker::engine},
      .start = makes<MoreauJeanSimulation<Case, System>>(Scheme{projection}),
      .follows_speed = true};
  if (projection == Projection::none) {
    result.model.in_space = system_settings();
    result.start_system =
        makes<MoreauJeanSimulation<SpatialSystem, SystemInSpace>>(Scheme{projection});
  }
  return result;
}

}  // namespace

std::vector<ModelEntry> moreau_jean_models() {
  const ModelEntry plain =
      entry("moreau-jean",
            "TimeStepping with MoreauJeanOSI: impulses of a linear complementarity problem "
            "give the gap rates at a step's end Newton's restitution.",
            Projection::none);
  return {plain,
          entry("moreau-jean-projected",
                "TimeSteppingDirectProjection: the same, and then the pose is projected to where "
                "no cable is overstretched.",
                Projection::direct),
          spring_model<MoreauJeanSimulation<SpatialSystem, SystemInSpace>>(
              plain,
              {{"MoreauJeanOSI theta", "1",
                "With 1/2 a force that stays as it is in a step gives a spring energy."}},
              Scheme{Projection::none, 1.0})};
}

}  // namespace tautline::siconos_engine
