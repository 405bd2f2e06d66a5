// The event driver over Chipmunk: it moves a body before it changes its velocity, so that half of
// gravity's impulse more before a step and less after it make it fly the exact parabola. An impact
// is Chipmunk's solver, the iteration over the rows of the cables, at the pose of the impact.

#include <algorithm>
#include <cmath>
#include <string>

#include "adapter/row_model.hpp"
#include "cable_constraint.hpp"
#include "models.hpp"
#include "tautline/event_driver.hpp"

namespace tautline::chipmunk {
namespace {

/// One cable takes two iterations. Nearly dependent cables hit together take up to some ten
/// thousand.
constexpr int event_iterations = 100'000;

/// A solve ends when no row changes its rate by more than this part of the speeds [-].
constexpr double solve_rounding = 1e-15;

class ChipmunkEventAdapter final : public EventAdapter {
 public:
  explicit ChipmunkEventAdapter(const Case& the_case)
      : case_(the_case), world_(the_case), rows_(the_case, world_) {}

  [[nodiscard]] State state() const override { return world_.state(); }
  void place(const State& state) override { world_.place(state); }

  void fly(double dt) override {
    world_.kick(0.5 * dt * case_.gravity);
    world_.advance(dt);
    world_.kick(-0.5 * dt * case_.gravity);
  }

  [[nodiscard]] CableVector solve(CableSet cables, const CableVector& rates) override {
    return solve_rows(rows_, case_, world_.state(), cables, rates, [&] { iterate(cables); });
  }

 private:
  void iterate(CableSet cables) {
    const double enough = solve_rounding * speed_scale(case_, world_.state());
    for (int iteration = 0; iteration < event_iterations; ++iteration) {
      double change = 0.0;
      for (const std::size_t index : cables) {
        change = std::max(change, std::abs(rows_[index].apply()));
      }
      if (change <= enough) {
        return;
      }
    }
  }

  const Case case_;
  World world_;
  CableConstraints rows_;  // not in the space: they act in solves
};

}  // namespace

std::vector<ModelEntry> event_models() {
  return {event_model<ChipmunkEventAdapter>(
      "Chipmunk flies and solves, the event driver finds the instants: each impact is the solver's "
      "iteration at the exact pose.",
      {{"iterations", std::to_string(event_iterations),
        "Nearly dependent cables hit together converge slowly; one cable takes two."},
       {"body velocity", "half of gravity's impulse more before each step, and less after it",
        "Chipmunk moves a body before gravity acts; it then flies the exact parabola."}})};
}

}  // namespace tautline::chipmunk
