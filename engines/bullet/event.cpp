// The event driver over Bullet: half of gravity's impulse before and after a step makes its
// semi-implicit Euler fly the exact parabola, and one `solveGroup` at the pose of an impact gives
// the impulses without moving.

#include <algorithm>
#include <cmath>
#include <limits>
#include <string>
#include <utility>
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

/// The impulses of one solve of `rows` for `rates`, without moving. `speed` [m/s] is the
/// speed of the bodies; a body at rest has none to measure by.
template <class Rows, class TheWorld, class TheCase>
CableVector solve_here(Rows& rows, TheWorld& world, std::vector<btCollisionObject*> bodies,
                       const TheCase& the_case, CableSet cables, const CableVector& rates,
                       double speed) {
  return solve_rows(rows, the_case, world.state(), cables, rates, [&] {
    std::vector<btTypedConstraint*> constraints;
    for (const std::size_t index : cables) {
      constraints.push_back(rows[index]);
    }
    btContactSolverInfo info = world.solver_info();
    info.m_timeStep = 1;  // any: no force acts, and the rows ask for rates
    info.m_numIterations = event_iterations;
    const double change = solve_rounding * std::max(speed, rates.cwiseAbs().maxCoeff());
    info.m_leastSquaresResidualThreshold = static_cast<btScalar>(change * change);
    world.solver().solveGroup(bodies.data(), static_cast<int>(bodies.size()), nullptr, 0,
                              constraints.data(), static_cast<int>(constraints.size()), info,
                              nullptr, &world.dispatcher());
  });
}

/// In how many steps Bullet flies `dt` [s] at a spin [rad/s].
int parts_of_flight(double spin, double dt) {
  return std::max(1, static_cast<int>(std::ceil(std::abs(spin) * dt / largest_turn)));
}

EventAdapter::Rounding rounding_of_bullet() {
  return in_double_precision ? EventAdapter::Rounding{1e-14, 1e-12} : EventAdapter::float_rounding;
}

class BulletEventAdapter final : public EventAdapter {
 public:
  explicit BulletEventAdapter(const Case& the_case)
      : case_(the_case), world_(the_case), rows_(the_case, world_, Acting::in_solves_alone) {}

  [[nodiscard]] State state() const override { return world_.state(); }
  void place(const State& state) override { world_.place(state); }
  [[nodiscard]] Rounding rounding() const override { return rounding_of_bullet(); }

  void fly(double dt) override {
    const int parts = parts_of_flight(world_.state().spin, dt);
    for (int done = 0; done < parts; ++done) {
      fly_parabola(world_, case_.gravity, dt / parts);
    }
  }

  [[nodiscard]] CableVector solve(CableSet cables, const CableVector& rates) override {
    world_.body().clearForces();
    return solve_here(rows_, world_, {&world_.body()}, case_, cables, rates,
                      speed_scale(case_, world_.state()));
  }

 private:
  const Case case_;
  World world_;
  CableConstraints rows_;
};

/// The event driver over a system.
class BulletSystemAdapter final : public SystemEventAdapter {
 public:
  explicit BulletSystemAdapter(const SpatialSystem& system)
      : system_(system), world_(system), rows_(system, world_, Acting::in_solves_alone) {}

  [[nodiscard]] SpatialSystemState state() const override { return world_.state(); }
  void place(const SpatialSystemState& state) override { world_.place(state); }
  [[nodiscard]] Rounding rounding() const override {
    return {rounding_of_bullet().gap, rounding_of_bullet().rate};
  }

  void fly(double dt) override {
    double spin = 0.0;  // [rad/s], the largest
    for (const SpatialState& body : world_.state().bodies) {
      spin = std::max(spin, body.spin.norm());
    }
    const int parts = parts_of_flight(spin, dt);
    for (int done = 0; done < parts; ++done) {
      world_.fly(dt / parts);
    }
  }

  [[nodiscard]] CableVector solve(CableSet cables, const CableVector& rates) override {
    std::vector<btCollisionObject*> bodies;
    for (btRigidBody* const body : world_.bodies()) {
      body->clearForces();
      body->setFlags(0);  // no time passes: no turn brings a gyroscopic impulse
      bodies.push_back(body);
    }
    CableVector impulses = solve_here(rows_, world_, std::move(bodies), system_, cables, rates,
                                      fastest(world_.state()));
    for (btRigidBody* const body : world_.bodies()) {
      body->setFlags(BT_ENABLE_GYROSCOPIC_FORCE_IMPLICIT_BODY);  // as shipped
    }
    return impulses;
  }

 private:
  const SpatialSystem system_;
  SystemWorld world_;
  SystemCableConstraints rows_;
};

}  // namespace

std::vector<ModelEntry> event_models() {
  return {event_model<BulletEventAdapter, BulletSystemAdapter>(
      "Bullet flies and solves, the event driver finds the instants: each impact is one solve at "
      "the exact pose.",
      joined({world_settings(),
              {{"m_numIterations", std::to_string(event_iterations),
                "Nearly dependent cables hit together converge slowly; one cable takes two."},
               {"m_leastSquaresResidualThreshold",
                "(4 roundings of the speed, or of the rate asked for)^2",
                "With Bullet's 0 a solve goes on while its last bit flickers."},
               parabola_setting()}}),
      joined({system_settings(),
              {{"setFlags while an impact is solved", "0",
                "No time passes in an impact, and so no turn brings a gyroscopic impulse."}}}))};
}

}  // namespace tautline::bullet
