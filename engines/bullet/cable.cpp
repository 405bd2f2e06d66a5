// A cable is the constraint that this project ships for a user's own Bullet world: added to the
// world and stepped as any other (`cable`), or with the world's step split at its impacts
// (`cable-events`). Through the public headers alone.

#include <limits>
#include <utility>
#include <vector>

#include "adapter/drop_in_model.hpp"
#include "models.hpp"
#include "tautline/bullet/btCableConstraint.h"
#include "tautline/bullet/btStepWithCables.h"
#include "tautline/geometry.hpp"
#include "tautline/impacts_between_parts.hpp"
#include "tautline/system_loads.hpp"
#include "world.hpp"

namespace tautline::bullet {
namespace {

/// The cables of a case in a world, which owns them.
class Cables {
 public:
  Cables(const Case& the_case, World& world) {
    for (const Cable& cable : the_case.cables) {
      cables_.push_back(&world.add(std::make_unique<btCableConstraint>(
          world.body(), vector(cable.attachment), vector(cable.anchor),
          static_cast<btScalar>(cable.length))));
      cables_.back()->setRestitution(static_cast<btScalar>(cable.restitution));
    }
  }

  [[nodiscard]] btCableConstraint* const* data() const { return cables_.data(); }
  [[nodiscard]] int count() const { return static_cast<int>(cables_.size()); }
  [[nodiscard]] btCableConstraint& operator[](std::size_t index) const { return *cables_[index]; }

 protected:
  Cables() = default;

  std::vector<btCableConstraint*> cables_;
};

/// Cables of a system: ends that move are kinematic bodies, and what changes the length a winch.
class SystemCables : public Cables {
 public:
  SystemCables(const SpatialSystem& system, SystemWorld& world) : system_(system) {
    check_straight(system, "tautline's drop-in cable");
    for (const SpatialCable& cable : system.cables) {
      const SpatialEnd& first = cable.from.body ? cable.from : cable.to;
      const SpatialEnd& second = cable.from.body ? cable.to : cable.from;
      btRigidBody& at = world.body(*first.body);
      const auto length = static_cast<btScalar>(cable.length.at(0.0)[0]);
      btRigidBody* other = second.body ? &world.body(*second.body) : nullptr;
      hooks_.emplace_back(nullptr);
      if (!second.motion.empty()) {
        hooks_.back() = std::make_unique<btDefaultMotionState>();
        move_hook(hooks_.size() - 1, 0.0);
        other = &world.add_hook(*hooks_.back());
      }
      const btVector3 pivot = hooks_.back() ? btVector3(0, 0, 0) : vector(second.at);
      cables_.push_back(&world.add(
          other != nullptr
              ? std::make_unique<btCableConstraint>(at, *other, vector(first.at), pivot, length)
              : std::make_unique<btCableConstraint>(at, vector(first.at), pivot, length)));
      cables_.back()->setRestitution(static_cast<btScalar>(cable.restitution));
      cables_.back()->setElasticity(drop_in_elasticity(system, cable));
    }
  }

  /// For a step from `time` to `end` [s].
  void set(double time, double end) {
    const double soon = time + same_instant * (end - time);
    for (std::size_t index = 0; index < cables_.size(); ++index) {
      const SpatialCable& cable = system_.cables[index];
      cables_[index]->setEnabled(cable.acts_at(soon));
      if (!cable.length.is_constant()) {
        const double length = cable.length.at(time)[0];
        cables_[index]->setMaxLength(static_cast<btScalar>(length));
        cables_[index]->setMaxLengthRate(
            static_cast<btScalar>((cable.length.at(end)[0] - length) / (end - time)));
      }
      if (hooks_[index]) {
        move_hook(index, end);
      }
    }
  }

  [[nodiscard]] const SpatialSystem& system() const { return system_; }

 private:
  void move_hook(std::size_t index, double time) {
    const SpatialCable& cable = system_.cables[index];
    const SpatialEnd& end = cable.from.body ? cable.to : cable.from;
    hooks_[index]->m_graphicsWorldTrans.setOrigin(
        vector(Eigen::Vector3d(end.at + end.motion.at(time))));
  }

  const SpatialSystem system_;
  std::vector<std::unique_ptr<btDefaultMotionState>> hooks_;  // of each cable; most have none
};

/// TheCase is Case or SpatialSystem.
template <class TheCase, class TheWorld, class TheCables>
class CableSimulation final : public BasicSteppedSimulation<TheCase> {
 public:
  explicit CableSimulation(const TheCase& the_case)
      : world_(the_case), cables_(the_case, world_), impulses_(the_case.cables.size()) {}

  [[nodiscard]] StateOf<TheCase> state() const override { return world_.state(); }
  [[nodiscard]] std::span<const double> impulses() const override { return impulses_; }

  void step(double dt) override {
    if constexpr (TheCase::has_several_bodies) {
      cables_.set(world_.time(), world_.time() + dt);
    }
    world_.advance(dt);
    for (std::size_t index = 0; index < impulses_.size(); ++index) {
      impulses_[index] = cables_[index].isEnabled() ? cables_[index].getAppliedImpulse() : 0.0;
    }
  }

 private:
  TheWorld world_;
  TheCables cables_;
  std::vector<double> impulses_;
};

/// Bullet's tick callbacks frame every part of a step; what jumps between two parts is an impact.
template <class TheCase, class TheWorld, class TheCables>
class CableEventsSimulation final : public BasicSimulation<TheCase> {
 public:
  explicit CableEventsSimulation(const TheCase& the_case)
      : world_(the_case),
        cables_(the_case, world_),
        impacts_(the_case, std::numeric_limits<btScalar>::epsilon()) {
    world_.dynamics().setInternalTickCallback(before_part, this, true);
    world_.dynamics().setInternalTickCallback(after_part, this, false);
  }

  [[nodiscard]] StateOf<TheCase> state() const override { return world_.state(); }
  [[nodiscard]] std::span<const double> impulses() const override { return impacts_.impulses(); }
  [[nodiscard]] std::span<const BasicEvent<TheCase>> events() const override {
    return impacts_.events();
  }

  void step(double dt) override {
    impacts_.begin_step(world_.state());
    if constexpr (TheCase::has_several_bodies) {
      each_smooth_part(cables_.system(), world_.time(), dt,
                       [this](double start, double end) { step_smoothly(start, end); });
    } else {
      step_with_cables(dt);
    }
    impacts_.end_step(dt, world_.state());
  }

 private:
  void step_smoothly(double start, double end) {
    cables_.set(start, end);
    impacts_.sees(evenly_in_step(cables_.system(), start, end - start));
    world_.load(end - start);
    step_with_cables(end - start);
    world_.set_time(end);
  }

  void step_with_cables(double dt) {
    btStepWithCables(&world_.dynamics(), cables_.data(), cables_.count(),
                     static_cast<btScalar>(dt));
  }

  static CableEventsSimulation& of(btDynamicsWorld* world) {
    return *static_cast<CableEventsSimulation*>(world->getWorldUserInfo());
  }
  static void before_part(btDynamicsWorld* world, btScalar /*dt*/) {
    of(world).impacts_.begin_part(of(world).world_.state());
  }
  static void after_part(btDynamicsWorld* world, btScalar dt) {
    CableEventsSimulation& self = of(world);
    self.world_.follow(dt);
    CableSet pulled;
    for (std::size_t index = 0; index < self.impulses().size(); ++index) {
      if (self.cables_[index].isTaut()) {
        pulled.insert(index);
      }
    }
    self.impacts_.end_part(dt, self.world_.state(), pulled);
  }

  TheWorld world_;
  TheCables cables_;
  ImpactsBetweenParts<TheCase> impacts_;
};

std::vector<Setting> settings(const std::vector<Setting>& own) {
  return joined({world_settings(),
                 {{"setRestitution", "the cable's restitution",
                   "A cable does not rebound unless it is set."}},
                 own});
}

std::vector<Setting> in_space() {
  return joined({system_settings(),
                 {{"kinematic bodies, setMaxLengthRate",
                   "from where an end or a length is as a step starts to where it is at its end",
                   "btCableConstraint knows no function of time; it moves both evenly."},
                  {"setEnabled", "while a cable is hooked up and not cut",
                   "Such a cable pulls at nothing."}}});
}

}  // namespace

std::vector<ModelEntry> cable_models() {
  return {
      {.model = {.name = "cable",
                 .sentence = "tautline's btCableConstraint, the drop-in cable for a world of "
                             "one's own, in stepSimulation.",
                 .settings = settings({}),
                 .in_space = joined({in_space(), elastic_drop_in_settings("setElasticity")}),
                 .cables = tautline::Cables::any},
       .start = makes<CableSimulation<Case, World, Cables>>(),
       .start_system = makes<CableSimulation<SpatialSystem, SystemWorld, SystemCables>>()},
      {.model = {.name = "cable-events",
                 .sentence = "The same btCableConstraint with btStepWithCables, which splits a "
                             "step at its impacts.",
                 .settings = settings({{"btStepWithCables",
                                        "instead of stepSimulation, with its own 8 parts a "
                                        "step",
                                        "Impacts are solved at zero gap and in no time."}}),
                 .in_space = in_space()},
       .start = makes<CableEventsSimulation<Case, World, Cables>>(),
       .start_system = makes<CableEventsSimulation<SpatialSystem, SystemWorld, SystemCables>>()}};
}

}  // namespace tautline::bullet
