// The event driver over Box2D: half of gravity's impulse before and after a step makes its
// semi-implicit Euler fly the parabola, as exactly as single precision can. Box2D takes no joints
// but its own, and these no rates, so an impact is the complementarity problem of its mass and
// inertia.

#include <algorithm>
#include <cmath>
#include <stdexcept>

#include "models.hpp"
#include "tautline/event_driver.hpp"
#include "tautline/geometry.hpp"
#include "tautline/parabola.hpp"
#include "world.hpp"

namespace tautline::box2d {
namespace {

/// A flight is split so that no part comes near what Box2D allows in a step, 2 m and pi/2 [-].
constexpr double part_of_limit = 0.9;

/// More parts than this are given up: the body moves by kilometres in a step.
constexpr double most_parts = 1e5;

class Box2dEventAdapter final : public EventAdapter {
 public:
  explicit Box2dEventAdapter(const Case& the_case) : case_(the_case), world_(the_case) {}

  [[nodiscard]] State state() const override { return world_.state(); }
  void place(const State& state) override { world_.place(state); }

  void fly(double dt) override {
    const State start = world_.state();
    const double move = (start.velocity.norm() + dt * case_.gravity.norm()) * dt;
    const double turn = std::abs(start.spin) * dt;
    const double limits =
        std::max(move / double{b2_maxTranslation}, turn / double{b2_maxRotation}) / part_of_limit;
    if (!(limits < most_parts)) {
      throw std::runtime_error("unsupported: Box2D moves a body by no more than 2 m in a step");
    }
    const int parts = std::max(1, static_cast<int>(std::ceil(limits)));
    const double part = dt / parts;
    for (int done = 0; done < parts; ++done) {
      fly_parabola(world_, case_.gravity, part);
    }
  }

  [[nodiscard]] CableVector solve(CableSet cables, const CableVector& rates) override {
    std::vector<CableRow> rows;
    for (const std::size_t index : cables) {
      rows.push_back(cable_row(case_.cables[index], world_.state()));
    }
    return world_.pull(rows, rates);
  }

  [[nodiscard]] Rounding rounding() const override { return float_rounding; }

 private:
  const Case case_;
  World world_;
};

}  // namespace

std::vector<ModelEntry> event_models() {
  return {event_model<Box2dEventAdapter>(
      "Box2D flies, the event driver finds the instants: each impact is solved by hand at the "
      "exact pose, in Box2D's mass and inertia.",
      joined({world_settings(),
              {parabola_setting(),
               {"Step", "in parts where the body would move by 1.8 m or turn by 1.4 rad",
                "Box2D slows a body down to 2 m and pi/2 in a step."}}}))};
}

}  // namespace tautline::box2d
