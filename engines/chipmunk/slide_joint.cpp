// A cable is the upper limit of Chipmunk's cpSlideJoint. The limit has no restitution: as shipped
// it stops the body (`slide-joint`). Who wants a bounce gives it by hand (`slide-joint-bounce`):
// after a step in which the joint pulled, impulses make the rates what restitution says.

#include <algorithm>
#include <cmath>
#include <functional>

#include "models.hpp"
#include "tautline/cable_row.hpp"
#include "world.hpp"

namespace tautline::chipmunk {
namespace {

enum class Bounce { none, by_hand };

/// Two coupled cables converge by a factor per iteration; a few leave an order of cables.
constexpr int joint_iterations = 50;

class SlideJointSimulation final : public SteppedSimulation {
 public:
  SlideJointSimulation(const Case& the_case, Bounce bounce)
      : case_(the_case), bounce_(bounce), world_(the_case), impulses_(the_case.cables.size()) {
    for (const Cable& cable : case_.cables) {
      joints_.push_back(cpSlideJointNew(world_.ground(), world_.body(), vector(cable.anchor),
                                        vector(cable.attachment), 0.0, cable.length));
      cpSpaceAddConstraint(world_.space(), joints_.back());
    }
  }
  ~SlideJointSimulation() override {
    for (cpConstraint* joint : joints_) {
      cpSpaceRemoveConstraint(world_.space(), joint);
      cpConstraintFree(joint);
    }
  }

  [[nodiscard]] State state() const override { return world_.state(); }
  [[nodiscard]] std::span<const double> impulses() const override { return impulses_; }

  void step(double dt) override {
    State moved = world_.state();  // as the step is going to
    moved.position += dt * moved.velocity;
    moved.angle += dt * moved.spin;
    world_.advance(dt);
    for (std::size_t index = 0; index < joints_.size(); ++index) {
      impulses_[index] = std::abs(cpConstraintGetImpulse(joints_[index]));
    }
    if (bounce_ == Bounce::by_hand) {
      bounce(moved);
    }
  }

 private:
  /// Brings the gap rates of the cables that pulled up to restitution times their closing rates at
  /// `before`, the pose and velocity with which the joints began to pull.
  void bounce(const State& before) {
    std::vector<double> given(joints_.size());
    for (int iteration = 0; iteration < joint_iterations; ++iteration) {
      for (std::size_t index = 0; index < joints_.size(); ++index) {
        if (impulses_[index] > 0.0) {
          const Cable& cable = case_.cables[index];
          const CableRow row = cable_row(cable, before);
          push(cable, rebound_rate(row, restitution(cable, row.rate)), given[index]);
        }
      }
    }
    std::transform(given.begin(), given.end(), impulses_.begin(), impulses_.begin(), std::plus<>());
  }

  /// Adds to the impulse `given` to a cable what its gap rate is short of `wanted` [m/s].
  void push(const Cable& cable, double wanted, double& given) {
    const CableRow row = cable_row(cable, world_.state());
    cpBody* body = world_.body();
    const double response = body->m_inv + body->i_inv * row.moment * row.moment;
    const double impulse = std::max(-given, (wanted - row.rate) / response);
    cpBodyApplyImpulseAtWorldPoint(body, cpvmult(vector(row.towards), impulse), vector(row.point));
    given += impulse;
  }

  const Case case_;
  Bounce bounce_;
  World world_;
  std::vector<cpConstraint*> joints_;
  std::vector<double> impulses_;
};

ModelEntry entry(std::string name, std::string sentence, Bounce bounce) {
  return {.model = {.name = std::move(name),
                    .sentence = std::move(sentence),
                    .settings = {{"cpSlideJointNew min, max", "0, length",
                                  "The distance between anchor and attachment is all that is "
                                  "limited."}},
                    .maker = bounce == Bounce::none ? Maker::engine : Maker::by_hand},
          .start = makes<SlideJointSimulation>(bounce),
          .follows_speed = true};
}

}  // namespace

std::vector<ModelEntry> slide_joint_models() {
  return {entry("slide-joint",
                "The upper limit of cpSlideJoint, which ignores restitution: what one tries first.",
                Bounce::none),
          entry("slide-joint-bounce",
                "The same joint, and after a step in which it pulled an impulse that gives the "
                "cable's restitution.",
                Bounce::by_hand)};
}

}  // namespace tautline::chipmunk
