// A cable is the upper limit of Box2D's b2DistanceJoint. The limit looks ahead, lands the body on
// the length, and has no restitution: as shipped it stops the body (`distance-joint`). Who wants a
// bounce gives it by hand (`distance-joint-bounce`): after a step in which the joint pulled,
// impulses make the rates what restitution says.

#include <utility>

#include "models.hpp"
#include "tautline/parabola.hpp"
#include "world.hpp"

namespace tautline::box2d {
namespace {

enum class Bounce { none, by_hand };

b2DistanceJointDef definition_of(const Cable& cable, World& world) {
  b2DistanceJointDef definition;
  definition.bodyA = &world.ground();
  definition.bodyB = &world.body();
  definition.localAnchorA = vector(cable.anchor);
  definition.localAnchorB = vector(cable.attachment);
  definition.length = number(cable.length);
  definition.maxLength = number(cable.length);
  return definition;
}

class DistanceJointSimulation final : public SteppedSimulation {
 public:
  DistanceJointSimulation(const Case& the_case, Bounce bounce)
      : case_(the_case), bounce_(bounce), world_(the_case), impulses_(the_case.cables.size()) {
    for (const Cable& cable : case_.cables) {
      joints_.push_back(&world_.add<b2DistanceJoint>(definition_of(cable, world_)));
    }
  }

  [[nodiscard]] State state() const override { return world_.state(); }
  [[nodiscard]] std::span<const double> impulses() const override { return impulses_; }

  void step(double dt) override {
    const State before = world_.state();
    // half of gravity's impulse less before, and more after: the parabola between the bounces
    const Vec2 half = bounce_ == Bounce::by_hand ? Vec2(0.5 * dt * case_.gravity) : Vec2(0.0, 0.0);
    world_.kick(-half);
    world_.advance(dt);
    world_.kick(half);
    for (std::size_t index = 0; index < joints_.size(); ++index) {
      const float per_second = 1.0F;  // of a force that lasts a second: the impulse
      impulses_[index] = joints_[index]->GetReactionForce(per_second).Length();
    }
    if (bounce_ == Bounce::by_hand) {
      bounce(before);
    }
  }

 private:
  /// Brings the gap rates of the cables that pulled up to restitution times their closing rates at
  /// `before`, where the step began, at the pose in which it has landed the body.
  void bounce(const State& before) {
    const State now = world_.state();
    std::vector<CableRow> rows;
    CableVector rates(static_cast<Eigen::Index>(joints_.size()));
    for (std::size_t index = 0; index < joints_.size(); ++index) {
      if (impulses_[index] > 0.0) {
        const Cable& cable = case_.cables[index];
        const CableRow closing = cable_row(cable, before);
        rates[static_cast<Eigen::Index>(rows.size())] =
            rebound_rate(closing, restitution(cable, closing.rate));
        rows.push_back(cable_row(cable, now));
      }
    }
    if (rows.empty()) {
      return;
    }
    const CableVector given = world_.pull(rows, rates.head(static_cast<Eigen::Index>(rows.size())));
    Eigen::Index row = 0;
    for (double& impulse : impulses_) {
      impulse += impulse > 0.0 ? given[row++] : 0.0;
    }
  }

  const Case case_;
  Bounce bounce_;
  World world_;
  std::vector<b2DistanceJoint*> joints_;  // owned by world_
  std::vector<double> impulses_;
};

ModelEntry entry(std::string name, std::string sentence, Bounce bounce,
                 const std::vector<Setting>& own) {
  return {.model = {.name = std::move(name),
                    .sentence = std::move(sentence),
                    .settings =
                        joined({world_settings(),
                                {{"maxLength", "length", "Without it the joint limits nothing."}},
                                own}),
                    .maker = bounce == Bounce::none ? Maker::engine : Maker::by_hand},
          .start = makes<DistanceJointSimulation>(bounce),
          .follows_speed = true};
}

}  // namespace

std::vector<ModelEntry> distance_joint_models() {
  return {entry("distance-joint",
                "The upper limit of b2DistanceJoint, which ignores restitution: what one tries "
                "first.",
                Bounce::none, {}),
          entry("distance-joint-bounce",
                "The same joint, and after a step in which it pulled an impulse that gives the "
                "cable's restitution.",
                Bounce::by_hand, {parabola_setting()})};
}

}  // namespace tautline::box2d
