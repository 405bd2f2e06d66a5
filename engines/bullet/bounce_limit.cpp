// A cable is the upper limit of the x axis of a btGeneric6DofSpring2Constraint between its anchor
// and its attachment, with Bullet's own bounce; the joint's frame is turned along the cable before
// every step. Bullet's limit always has a row: it lets the body take STOP_ERP of the room to the
// limit in one step, and bounces where the step would pass the limit. With Bullet's 0.2 the row
// brakes the body on its way and nothing is left to bounce, hence 1. The bounce is taken from the
// velocity of the body's centre, not of the attachment; no setting mends that.

#include <BulletDynamics/ConstraintSolver/btGeneric6DofSpring2Constraint.h>

#include <algorithm>
#include <cmath>

#include "models.hpp"
#include "tautline/cable_row.hpp"
#include "world.hpp"

namespace tautline::bullet {
namespace {

using Joint = btGeneric6DofSpring2Constraint;

/// The joint's frame in the world: at the anchor, x along the cable to the attachment.
btTransform frame_along(const CableRow& row, const Vec2& anchor) {
  const btVector3 x = -vector(row.towards);
  const btVector3 y(-x.y(), x.x(), 0);
  return btTransform(btMatrix3x3(x.x(), y.x(), 0, x.y(), y.y(), 0, 0, 0, 1), vector(anchor));
}

/// The same axes at the attachment, in the body's frame.
btTransform frame_on_body(const btRigidBody& body, const btTransform& along, const Cable& cable) {
  return btTransform(body.getWorldTransform().getBasis().transpose() * along.getBasis(),
                     vector(cable.attachment));
}

std::unique_ptr<Joint> make_joint(btRigidBody& body, const Cable& cable, const RunSettings& run) {
  auto joint = std::make_unique<Joint>(btTypedConstraint::getFixedBody(), body,
                                       btTransform::getIdentity(), btTransform::getIdentity());
  for (int axis = 0; axis < 6; ++axis) {
    joint->setLimit(axis, 1, -1);  // free
  }
  joint->setLimit(0, 0, static_cast<btScalar>(cable.length));
  joint->setBounce(0, static_cast<btScalar>(parameter_of(run, "bounce", cable.restitution)));
  return joint;
}

class BounceLimitSimulation final : public SteppedSimulation {
 public:
  BounceLimitSimulation(const Case& the_case, const RunSettings& run)
      : case_(the_case), step_(run.step), world_(the_case), impulses_(the_case.cables.size()) {
    for (const Cable& cable : case_.cables) {
      joints_.push_back(&world_.add(make_joint(world_.body(), cable, run)));
    }
  }

  [[nodiscard]] State state() const override { return world_.state(); }
  [[nodiscard]] std::span<const double> impulses() const override { return impulses_; }

  void step(double dt) override {
    const State start = world_.state();
    // all the room and all the overstretch in a usual step, no faster in a short last one
    const auto correction = static_cast<btScalar>(std::min(1.0, dt / step_));
    for (std::size_t index = 0; index < joints_.size(); ++index) {
      const Cable& cable = case_.cables[index];
      const btTransform along = frame_along(cable_row(cable, start), cable.anchor);
      joints_[index]->setFrames(along, frame_on_body(world_.body(), along, cable));
      joints_[index]->setParam(BT_CONSTRAINT_STOP_ERP, correction, 0);
    }
    world_.advance(dt);
    for (std::size_t index = 0; index < joints_.size(); ++index) {
      // Bullet's sign says which limit pulls; a cable has only the one
      impulses_[index] = std::abs(joints_[index]->internalGetAppliedImpulse());
    }
  }

 private:
  const Case case_;
  double step_;  // [s], the usual one
  World world_;
  std::vector<Joint*> joints_;  // owned by world_
  std::vector<double> impulses_;
};

}  // namespace

std::vector<ModelEntry> bounce_limit_models() {
  return {
      {.model = {.name = "bounce-limit",
                 .sentence = "The upper limit of a btGeneric6DofSpring2Constraint turned along the "
                             "cable before every step, with Bullet's bounce.",
                 .settings = joined(
                     {world_settings(),
                      {{"setLimit", "axis 0: [0, length], the others free",
                        "The distance between anchor and attachment is all that is limited."},
                       {"setBounce", "the cable's restitution",
                        "Bullet's bounce of a limit is 0 unless it is set."},
                       {"BT_CONSTRAINT_STOP_ERP", "1",
                        "With Bullet's 0.2 the limit brakes the body before it gets there, and "
                        "never bounces."}}}),
                 .maker = Maker::engine,
                 .parameters = {{.name = "bounce", .low = 0.0, .high = 4.0}},
                 .code = "joint.setBounce(0, {bounce});"},
       .start = makes<BounceLimitSimulation>()}};
}

}  // namespace tautline::bullet
