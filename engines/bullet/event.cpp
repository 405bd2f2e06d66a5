// The event driver over Bullet: half of gravity's impulse before and after a step makes its
// semi-implicit Euler fly the exact parabola, and one `solveGroup` at the pose of an impact gives
// the impulses without moving.

#include <algorithm>
#include <cmath>
#include <limits>
#include <string>
#include <vector>

#include "adapter/row_model.hpp"
#include "cable_constraint.hpp"
#include "models.hpp"
#include "tautline/event_driver.hpp"
#include "tautline/parabola.hpp"

namespace tautline::bullet {
namespace {

/// One cable takes two iterations. Nearly dependent cables hit together take up to some ten
/// thousand.
constexpr int event_iterations = 100'000;

/// A solve ends when no row changes its velocity by more than this part of the speeds [-].
constexpr double solve_rounding = 4.0 * std::numeric_limits<btScalar>::epsilon();

/// Bullet turns a body by no more than pi/4 in a step (ANGULAR_MOTION_THRESHOLD) [rad].
constexpr double largest_turn = 0.7;

class BulletEventAdapter final : public EventAdapter {
 public:
  explicit BulletEventAdapter(const Case& the_case)
      : case_(the_case), world_(the_case), rows_(the_case, world_, Acting::in_solves_alone) {}

  [[nodiscard]] State state() const override { return world_.state(); }

  void fly(double dt) override {
    const double turn = std::abs(world_.state().spin) * dt;
    const int parts = std::max(1, static_cast<int>(std::ceil(turn / largest_turn)));
    const double part = dt / parts;
    for (int done = 0; done < parts; ++done) {
      fly_parabola(world_, case_.gravity, part);
    }
  }

  void place(const State& state) override { world_.place(state); }

  [[nodiscard]] Rounding rounding() const override {
    return in_double_precision ? EventAdapter::rounding() : float_rounding;
  }

  [[nodiscard]] CableVector solve(CableSet cables, const CableVector& rates) override {
    return solve_rows(rows_, case_, world_.state(), cables, rates,
                      [&] { solve(cables, rates.cwiseAbs().maxCoeff()); });
  }

 private:
  /// `fastest` [m/s] is the largest rate asked for: a body at rest has no speed to measure by.
  void solve(CableSet cables, double fastest) {
    std::vector<btTypedConstraint*> constraints;
    for (const std::size_t index : cables) {
      constraints.push_back(rows_[index]);
    }
    btContactSolverInfo info = world_.solver_info();
    info.m_timeStep = 1;  // any: no force acts, and the rows ask for rates
    info.m_numIterations = event_iterations;
    const double change = solve_rounding * std::max(speed_scale(case_, world_.state()), fastest);
    info.m_leastSquaresResidualThreshold = static_cast<btScalar>(change * change);
    btCollisionObject* body = &world_.body();
    world_.body().clearForces();
    world_.solver().solveGroup(&body, 1, nullptr, 0, constraints.data(),
                               static_cast<int>(constraints.size()), info, nullptr,
                               &world_.dispatcher());
  }

  const Case case_;
  World world_;
  CableConstraints rows_;
};

}  // namespace

std::vector<ModelEntry> event_models() {
  return {event_model<BulletEventAdapter>(
      "Bullet flies and solves, the event driver finds the instants: each impact is one solve at "
      "the exact pose.",
      joined({world_settings(),
              {{"m_numIterations", std::to_string(event_iterations),
                "Nearly dependent cables hit together converge slowly; one cable takes two."},
               {"m_leastSquaresResidualThreshold",
                "(4 roundings of the speed, or of the rate asked for)^2",
                "With Bullet's 0 a solve goes on while its last bit flickers."},
               parabola_setting()}}))};
}

}  // namespace tautline::bullet
