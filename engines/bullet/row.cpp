// A cable is a constraint row of our own (Bullet manual, "Constraints"): it exists while the cable
// is overstretched when a step starts (`row`), or already when the step would overstretch it
// (`early`). `row-sleeping` is `row` on a body that Bullet may put to sleep, as it does with every
// body unless it is told not to.

#include <algorithm>
#include <string>

#include "cable_constraint.hpp"
#include "models.hpp"

namespace tautline::bullet {
namespace {

/// Two coupled rows converge by a factor per iteration: with Bullet's 10 the mirror image of a run
/// differs by 3e-7, with 50 by 1e-14.
constexpr int iterations = 50;

class RowSimulation final : public Simulation {
 public:
  RowSimulation(const Case& the_case, Activation activation, Sleep sleep, double step)
      : case_(the_case),
        activation_(activation),
        correction_(usual_correction / step),
        world_(the_case, sleep),
        impulses_(the_case.cables.size()) {
    world_.solver_info().m_numIterations = iterations;
    for (auto& constraint : cable_constraints(the_case, world_)) {
      cables_.push_back(&world_.add(std::move(constraint)));
    }
  }

  [[nodiscard]] State state() const override { return world_.state(); }
  [[nodiscard]] std::span<const double> impulses() const override { return impulses_; }

  void step(double dt) override {
    const State start = world_.state();
    for (std::size_t index = 0; index < cables_.size(); ++index) {
      const Cable& cable = case_.cables[index];
      const CableRow row = cable_row(cable, start);
      if (acts(row, activation_, dt)) {
        cables_[index]->pull(row, wanted_rate(row, restitution(cable, row.rate), correction_));
      } else {
        cables_[index]->let_go();
      }
    }
    world_.advance(dt);
    std::transform(cables_.begin(), cables_.end(), impulses_.begin(), [&](CableConstraint* cable) {
      return world_.asleep() ? 0.0 : cable->impulse();
    });
  }

 private:
  const Case case_;
  Activation activation_;
  double correction_;  // [1/s], part of the overstretch
  World world_;
  std::vector<CableConstraint*> cables_;  // owned by world_
  std::vector<double> impulses_;
};

ModelEntry entry(const std::string& name, const std::string& sentence, Activation activation,
                 Sleep sleep = Sleep::never) {
  return {{name, sentence,
           with_world_settings(
               {{"m_numIterations", std::to_string(iterations),
                 "With Bullet's 10 the order of the cables shows: mirror images differ by 3e-7."}},
               sleep)},
          [activation, sleep](const Case& the_case,
                              const RunSettings& settings) -> std::unique_ptr<Simulation> {
            return std::make_unique<RowSimulation>(the_case, activation, sleep, settings.step);
          },
          true};
}

}  // namespace

std::vector<ModelEntry> row_models() {
  return {
      entry("row",
            "A one-sided constraint row from the step after the cable is overstretched; it asks "
            "for the larger of the bounce and 0.2 of the overstretch per step.",
            Activation::overstretched),
      entry("early",
            "The same row already in the step that would overstretch the cable: the bounce comes "
            "up to one step early.",
            Activation::crossing),
      entry("row-sleeping",
            "The row of `row` with Bullet's own deactivation: a body slower than 0.8 m/s and "
            "1 rad/s for 2 s is frozen where it is.",
            Activation::overstretched, Sleep::as_shipped)};
}

}  // namespace tautline::bullet
