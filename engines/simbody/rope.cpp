// A cable is SimTK::Rope, Simbody's own one-sided distance constraint with a coefficient of
// restitution, in the time-stepper that such constraints need, SemiExplicitEulerTimeStepper: first
// the impact of a step, then its forces. `spring` pulls elastic cables by forces, and leaves the
// others to these ropes.

#include <algorithm>

#include "adapter/spring_model.hpp"
#include "bodies.hpp"
#include "models.hpp"
#include "quiet.hpp"

namespace tautline::simbody {
namespace {

/// A rope acts from this gap on, and bounces from twice this rate on [m], [m/s]: far below the
/// error of a step, far above rounding.
constexpr double constraint_tolerance = 1e-8;

/// Simbody's solver, which sums up the impulses it finds: the time-stepper keeps them to itself.
class SummingSolver final : public SimTK::PLUSImpulseSolver {
 public:
  explicit SummingSolver(double transition_speed) : PLUSImpulseSolver(transition_speed) {}

  /// One entry per multiplier of the latest step [N s]; of no length if nothing was solved.
  [[nodiscard]] const SimTK::Vector& sum() const { return sum_; }
  void start_sum() { sum_.resize(0); }

  bool solve(int phase, const SimTK::Array_<SimTK::MultiplierIndex>& participating,
             const SimTK::Matrix& inverse_mass, const SimTK::Vector& softness,
             const SimTK::Array_<SimTK::MultiplierIndex>& expanding,
             SimTK::Vector& expansion_impulse, SimTK::Vector& start_rates,
             SimTK::Vector& applied_rates, SimTK::Vector& impulse,
             SimTK::Array_<UncondRT>& unconditional, SimTK::Array_<UniContactRT>& contacts,
             SimTK::Array_<UniSpeedRT>& speeds, SimTK::Array_<BoundedRT>& bounded,
             SimTK::Array_<ConstraintLtdFrictionRT>& constraint_friction,
             SimTK::Array_<StateLtdFrictionRT>& state_friction) const override {
    const bool converged = PLUSImpulseSolver::solve(
        phase, participating, inverse_mass, softness, expanding, expansion_impulse, start_rates,
        applied_rates, impulse, unconditional, contacts, speeds, bounded, constraint_friction,
        state_friction);
    if (sum_.size() == 0) {
      sum_ = impulse;
    } else {
      sum_ += impulse;
    }
    return converged;
  }

 private:
  mutable SimTK::Vector sum_;
};

template <class TheCase>
class RopeSimulation final : public BasicSteppedSimulation<TheCase> {
 public:
  RopeSimulation(const TheCase& the_case, const RunSettings& /*run*/)
      : bodies_(the_case), stepper_(bodies_.system()), impulses_(the_case.cables.size()) {
    for (std::size_t index = 0; index < the_case.cables.size(); ++index) {
      Station from = bodies_.from(index);
      Station to = bodies_.to(index);
      ropes_.push_back(new SimTK::Rope(to.body, to.at, from.body, from.at, bodies_.length(index),
                                       the_case.cables[index].restitution));
      bodies_.matter().adoptUnilateralContact(ropes_.back());
    }
    stepper_.setRestitutionModel(SimTK::SemiExplicitEulerTimeStepper::Newton);
    stepper_.setConstraintTolerance(constraint_tolerance);
    solver_ = new SummingSolver(stepper_.getDefaultFrictionTransitionVelocityInUse());
    stepper_.setImpulseSolver(solver_);
    const Quiet quiet;
    stepper_.initialize(bodies_.initial_state());
  }

  [[nodiscard]] StateOf<TheCase> state() const override {
    return bodies_.state_of(stepper_.getState());
  }
  [[nodiscard]] std::span<const double> impulses() const override { return impulses_; }

  /// Lets these act in the next step, next to what is given.
  void pull(const std::vector<BodyLoad>& loads) {
    bodies_.set_pulls(loads);
    stepper_.getState().invalidateAllCacheAtOrAbove(SimTK::Stage::Dynamics);
  }

  void step(double dt) override {
    solver_->start_sum();
    {
      const Quiet quiet;
      stepper_.stepTo(stepper_.getTime() + dt);
    }
    const SimTK::State& after = stepper_.getState();
    for (std::size_t index = 0; index < ropes_.size(); ++index) {
      impulses_[index] = ropes_[index]->isEnabled(after) ? impulse_of(*ropes_[index], after) : 0.0;
    }
  }

 private:
  /// [N s], of a rope in the latest step; its rounding may be of the other sign.
  [[nodiscard]] double impulse_of(const SimTK::Rope& rope, const SimTK::State& state) const {
    return std::max(0.0, solver_->sum()[rope.getContactMultiplierIndex(state)]);
  }

  Bodies<TheCase> bodies_;
  std::vector<SimTK::Rope*> ropes_;  // owned by the matter of the bodies
  SimTK::SemiExplicitEulerTimeStepper stepper_;
  SummingSolver* solver_;  // owned by stepper_
  std::vector<double> impulses_;
};

}  // namespace

std::vector<ModelEntry> rope_models() {
  const ModelEntry rope = {
      .model = {.name = "rope",
                .sentence = "SimTK::Rope in SemiExplicitEulerTimeStepper: a bounce in the step "
                            "after the cable is overstretched, and then the step's gravity.",
                .settings = {{"setRestitutionModel", "Newton",
                              "Simbody's default is Poisson's law."},
                             {"setConstraintTolerance", "1e-8",
                              "A rope acts from this gap on; with the default 1e-4 the error "
                              "stops shrinking there."},
                             {"setImpulseSolver", "PLUSImpulseSolver, summed up",
                              "The default solver; the time-stepper does not tell its "
                              "impulses.",
                              Origin::engine_default},
                             {"std::cout, stdout", "dropped while it steps",
                              "Debian's build prints a page of every step."}},
                .maker = Maker::engine,
                .in_space = system_settings()},
      .start = makes<RopeSimulation<Case>>(),
      .start_system = makes<RopeSimulation<SpatialSystem>>()};
  return {rope, spring_model<RopeSimulation<SpatialSystem>>(rope, {})};
}

}  // namespace tautline::simbody
