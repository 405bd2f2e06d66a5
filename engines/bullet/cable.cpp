// A cable is the constraint that this project ships for a user's own Bullet world: added to the
// world and stepped as any other (`cable`), or with the world's step split at its impacts
// (`cable-events`). Through the public headers alone.

#include <limits>
#include <utility>
#include <vector>

#include "models.hpp"
#include "tautline/bullet/btCableConstraint.h"
#include "tautline/bullet/btStepWithCables.h"
#include "tautline/geometry.hpp"
#include "tautline/impacts_between_parts.hpp"
#include "world.hpp"

namespace tautline::bullet {
namespace {

/// The cables of `the_case` in `world`, which owns them.
std::vector<btCableConstraint*> add_cables(const Case& the_case, World& world) {
  std::vector<btCableConstraint*> result;
  for (const Cable& cable : the_case.cables) {
    btCableConstraint& added = world.add(std::make_unique<btCableConstraint>(
        world.body(), vector(cable.attachment), vector(cable.anchor),
        static_cast<btScalar>(cable.length)));
    added.setRestitution(static_cast<btScalar>(cable.restitution));
    result.push_back(&added);
  }
  return result;
}

class CableSimulation final : public SteppedSimulation {
 public:
  explicit CableSimulation(const Case& the_case)
      : world_(the_case),
        cables_(add_cables(the_case, world_)),
        impulses_(the_case.cables.size()) {}

  [[nodiscard]] State state() const override { return world_.state(); }
  [[nodiscard]] std::span<const double> impulses() const override { return impulses_; }

  void step(double dt) override {
    world_.advance(dt);
    for (std::size_t index = 0; index < cables_.size(); ++index) {
      impulses_[index] = cables_[index]->getAppliedImpulse();
    }
  }

 private:
  World world_;
  std::vector<btCableConstraint*> cables_;  // owned by world_
  std::vector<double> impulses_;
};

/// Bullet's tick callbacks frame every part of a step; what jumps between two parts is an impact.
class CableEventsSimulation final : public Simulation {
 public:
  explicit CableEventsSimulation(const Case& the_case)
      : world_(the_case),
        cables_(add_cables(the_case, world_)),
        impacts_(the_case, std::numeric_limits<btScalar>::epsilon()) {
    world_.dynamics().setInternalTickCallback(before_part, this, true);
    world_.dynamics().setInternalTickCallback(after_part, this, false);
  }

  [[nodiscard]] State state() const override { return world_.state(); }
  [[nodiscard]] std::span<const double> impulses() const override { return impacts_.impulses(); }
  [[nodiscard]] std::span<const Event> events() const override { return impacts_.events(); }

  void step(double dt) override {
    impacts_.begin_step(world_.state());
    btStepWithCables(&world_.dynamics(), cables_.data(), static_cast<int>(cables_.size()),
                     static_cast<btScalar>(dt));
    impacts_.end_step(dt, world_.state());
  }

 private:
  static CableEventsSimulation& of(btDynamicsWorld* world) {
    return *static_cast<CableEventsSimulation*>(world->getWorldUserInfo());
  }
  static void before_part(btDynamicsWorld* world, btScalar /*dt*/) {
    of(world).impacts_.begin_part(of(world).world_.state());
  }
  static void after_part(btDynamicsWorld* world, btScalar dt) {
    CableEventsSimulation& self = of(world);
    self.world_.follow_turn(dt);
    CableSet pulled;
    for (std::size_t index = 0; index < self.cables_.size(); ++index) {
      if (self.cables_[index]->isTaut()) {
        pulled.insert(index);
      }
    }
    self.impacts_.end_part(dt, self.world_.state(), pulled);
  }

  World world_;
  std::vector<btCableConstraint*> cables_;  // owned by world_
  ImpactsBetweenParts impacts_;
};

std::vector<Setting> settings(const std::vector<Setting>& own) {
  return joined({world_settings(),
                 {{"setRestitution", "the cable's restitution",
                   "A cable does not rebound unless it is set."}},
                 own});
}

}  // namespace

std::vector<ModelEntry> cable_models() {
  return {{.model = {.name = "cable",
                     .sentence = "tautline's btCableConstraint, the drop-in cable for a world of "
                                 "one's own, in stepSimulation.",
                     .settings = settings({})},
           .start = makes<CableSimulation>()},
          {.model = {.name = "cable-events",
                     .sentence = "The same btCableConstraint with btStepWithCables, which splits a "
                                 "step at its impacts.",
                     .settings = settings({{"btStepWithCables",
                                            "instead of stepSimulation, with its own 8 parts a "
                                            "step",
                                            "Impacts are solved at zero gap and in no time."}})},
           .start = makes<CableEventsSimulation>()}};
}

}  // namespace tautline::bullet
