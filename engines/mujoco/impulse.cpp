// A cable is a tendon without a limit, which MuJoCo only measures. While it is overstretched when a
// step starts, an impulse by hand gives it its bounce (`ten_J`, `mj_solveM`); MuJoCo flies.
// `spring` pulls elastic cables by forces, and leaves the others to these impulses.

#include "adapter/spring_model.hpp"
#include "models.hpp"
#include "world.hpp"

namespace tautline::mujoco {
namespace {

template <class TheCase, class TheWorld>
class ImpulseSimulation final : public BasicSteppedSimulation<TheCase> {
 public:
  ImpulseSimulation(const TheCase& the_case, const RunSettings& run, Integrator integrator)
      : case_(the_case),
        correction_(usual_correction / run.step),
        world_(the_case, integrator),
        impulses_(the_case.cables.size()) {}

  [[nodiscard]] StateOf<TheCase> state() const override { return world_.state(); }
  [[nodiscard]] std::span<const double> impulses() const override { return impulses_; }

  /// Adds these to the loads of the next step.
  void pull(const std::vector<BodyLoad>& loads) {
    pulls_ = loads;
    world_.add(loads);
  }

  void step(double dt) override {
    pull_overstretched(dt);
    world_.advance(dt);
    if (const auto moved = out_of_overstretch(case_, world_.state(), correction_, dt, pulls_)) {
      world_.place(*moved);
    }
  }

 private:
  void pull_overstretched(double dt) {
    std::fill(impulses_.begin(), impulses_.end(), 0.0);
    const StateOf<TheCase> now = world_.state();
    const auto rows = world_.look(dt);
    CableSet cables;
    CableVector rates(static_cast<Eigen::Index>(rows.size()));
    Eigen::Index count = 0;
    for (std::size_t index = 0; index < rows.size(); ++index) {
      const auto& row = rows[index];
      if (acts(row, Activation::overstretched, dt)) {
        cables.insert(index);
        rates[count++] = wanted_rate(row, restitution(case_.cables[index], row.rate), correction_,
                                     change_in_step(case_, index, now, dt, pulls_));
      }
    }
    if (cables.empty()) {
      return;
    }
    const CableVector impulses = world_.pull(cables, rates.head(count));
    Eigen::Index position = 0;
    for (const std::size_t index : cables) {
      impulses_[index] = impulses[position++];
    }
  }

  const TheCase case_;
  double correction_;  // [1/s], part of the overstretch
  TheWorld world_;
  std::vector<BodyLoad> pulls_;  // of the step; empty: none
  std::vector<double> impulses_;
};

}  // namespace

std::vector<ModelEntry> impulse_models() {
  const ModelEntry impulse = {
      .model = {.name = "impulse",
                .sentence = "Impulses by hand before the steps that start overstretched, for "
                            "the bounce; 0.2 of the overstretch goes out per step without "
                            "throwing the body back. MuJoCo flies and gives tendons and "
                            "masses.",
                .settings = joined(
                    {world_settings(),
                     {{"integrator", "RK4", "It flies the exact parabola between the impulses."}}}),
                .in_space = system_settings()},
      .start = makes<ImpulseSimulation<Case, World>>(Integrator::rk4),
      .start_system = makes<ImpulseSimulation<SpatialSystem, SystemWorld>>(Integrator::rk4),
      .follows_speed = true};
  return {impulse, spring_model<ImpulseSimulation<SpatialSystem, SystemWorld>>(
                       impulse,
                       {{"integrator", "Euler",
                         "A force that stays as it is in a step of RK4 gives a spring energy."}},
                       Integrator::euler)};
}

}  // namespace tautline::mujoco
