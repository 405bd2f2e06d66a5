// A cable takes two steps for an impact: in the step that would overstretch it the row lets the gap
// close exactly to zero, and in the next one it gives the bounce of the rate with which the body
// came. The body flies exact parabolas: half of gravity's impulse is taken away before a step and
// given back after it. What a bounce pays for landing first is energy: an elastic body loses some.

#include <algorithm>
#include <optional>
#include <string>
#include <vector>

#include "cable_constraint.hpp"
#include "models.hpp"
#include "tautline/parabola.hpp"

namespace tautline::bullet {
namespace {

/// As for `row`: with Bullet's 10 the order of the cables shows.
constexpr int phase_iterations = 50;

class TwoPhaseSimulation final : public SteppedSimulation {
 public:
  TwoPhaseSimulation(const Case& the_case, const RunSettings& run)
      : case_(the_case),
        correction_(usual_correction / run.step),
        world_(the_case),
        rows_(the_case, world_, Acting::in_steps),
        landed_(the_case.cables.size()),
        impulses_(the_case.cables.size()) {
    world_.solver_info().m_numIterations = phase_iterations;
  }

  [[nodiscard]] State state() const override { return world_.state(); }
  [[nodiscard]] std::span<const double> impulses() const override { return impulses_; }

  void step(double dt) override {
    const State start = world_.state();
    for (std::size_t index = 0; index < impulses_.size(); ++index) {
      prepare(index, cable_row(case_.cables[index], start), dt);
    }
    fly_parabola(world_, case_.gravity, dt);
    for (std::size_t index = 0; index < impulses_.size(); ++index) {
      impulses_[index] = rows_.impulse(index);
      if (impulses_[index] <= 0.0) {
        landed_[index].reset();  // it did not get there
      }
    }
  }

 private:
  /// Says what the cable `index` asks for in a step of `dt` [s] from `row`.
  void prepare(std::size_t index, const CableRow& row, double dt) {
    const double push = correction_ * std::max(0.0, -row.gap);
    if (landed_[index]) {
      rows_.pull(index, row, std::max(*landed_[index], push));
      landed_[index].reset();
    } else if (row.rate < 0.0 && acts(row, Activation::crossing, dt)) {
      rows_.pull(index, row, row.gap > 0.0 ? -row.gap / dt : push);
      landed_[index] = rebound_rate(row, restitution(case_.cables[index], row.rate));
    } else if (row.gap <= 0.0) {
      rows_.pull(index, row, push);
    } else {
      rows_.let_go(index);
    }
  }

  const Case case_;
  double correction_;  // [1/s], part of the overstretch
  World world_;
  CableConstraints rows_;
  std::vector<std::optional<double>> landed_;  // [m/s], the rebound that the next step owes
  std::vector<double> impulses_;
};

}  // namespace

std::vector<ModelEntry> two_phase_models() {
  return {{.model = {.name = "two-phase",
                     .sentence = "A row that lets the gap close exactly to zero in one step and "
                                 "gives the bounce in the next one, with exact flights between.",
                     .settings = joined({world_settings(),
                                         {{"m_numIterations", std::to_string(phase_iterations),
                                           "With Bullet's 10 the order of the cables shows."},
                                          parabola_setting()}})},
           .start = makes<TwoPhaseSimulation>(),
           .follows_speed = true}};
}

}  // namespace tautline::bullet
