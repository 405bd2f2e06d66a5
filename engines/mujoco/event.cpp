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

}  // namespace

std::vector<ModelEntry> event_models() {
  return {event_model<MujocoEventAdapter>(
      "MuJoCo flies and gives tendons and masses, the event driver finds the instants: each impact "
      "is solved by hand at the exact pose.",
      joined({world_settings(), {parabola_setting()}}))};
}

}  // namespace tautline::mujoco
