// The event driver over MuJoCo: half of gravity's impulse before and after a step makes its
// semi-implicit Euler fly the exact parabola. MuJoCo's solver knows forces that take time and no
// impulses, so an impact is the complementarity problem of MuJoCo's Jacobian and mass matrix.

#include "models.hpp"
#include "tautline/event_driver.hpp"
#include "tautline/parabola.hpp"
#include "world.hpp"

namespace tautline::mujoco {
namespace {

class MujocoEventAdapter final : public EventAdapter {
 public:
  explicit MujocoEventAdapter(const Case& the_case)
      : gravity_(the_case.gravity), world_(the_case, Integrator::euler) {}

  [[nodiscard]] State state() const override { return world_.state(); }
  void place(const State& state) override { world_.place(state); }

  void fly(double dt) override { fly_parabola(world_, gravity_, dt); }

  [[nodiscard]] CableVector solve(CableSet cables, const CableVector& rates) override {
    return world_.pull(cables, rates);
  }

 private:
  const Vec2 gravity_;
  World world_;
};

/// In space MuJoCo flies by its method of Runge and Kutta: its Euler method turns bodies to first
/// order alone.
class MujocoSystemAdapter final : public SystemEventAdapter {
 public:
  explicit MujocoSystemAdapter(const SpatialSystem& system) : world_(system, Integrator::rk4) {}

  [[nodiscard]] SpatialSystemState state() const override { return world_.state(); }
  void place(const SpatialSystemState& state) override { world_.place(state); }
  void fly(double dt) override { world_.advance(dt); }
  [[nodiscard]] CableVector solve(CableSet cables, const CableVector& rates) override {
    (void)world_.look();
    return world_.pull(cables, rates);
  }

 private:
  SystemWorld world_;
};

}  // namespace

std::vector<ModelEntry> event_models() {
  return {event_model<MujocoEventAdapter, MujocoSystemAdapter>(
      "MuJoCo flies and gives tendons and masses, the event driver finds the instants: each impact "
      "is solved by hand at the exact pose.",
      joined({world_settings(), {parabola_setting()}}),
      joined({{{"integrator", "RK4",
                "It turns bodies to second order, Euler's method to first, and flies parabolas."}},
              system_settings()}))};
}

}  // namespace tautline::mujoco
