#pragma once

#include <btBulletDynamicsCommon.h>

#include <memory>
#include <utility>
#include <vector>

#include "tautline/case.hpp"
#include "tautline/engine.hpp"
#include "tautline/system_loads.hpp"

namespace tautline::bullet {

/// These sources are compiled twice, once for each build of Bullet.
inline constexpr bool in_double_precision = sizeof(btScalar) == sizeof(double);

[[nodiscard]] inline btVector3 vector(const Vec2& v) {
  return {static_cast<btScalar>(v.x()), static_cast<btScalar>(v.y()), btScalar(0)};
}
[[nodiscard]] inline btVector3 vector(const Eigen::Vector3d& v) {
  return {static_cast<btScalar>(v.x()), static_cast<btScalar>(v.y()), static_cast<btScalar>(v.z())};
}
[[nodiscard]] inline Eigen::Vector3d from_bullet(const btVector3& v) {
  return {v.x(), v.y(), v.z()};
}

/// Whether Bullet may deactivate the body.
enum class Sleep { never, as_shipped };

/// A Bullet world with nothing in it but what is added.
class BareWorld {
 public:
  BareWorld() = default;
  BareWorld(const BareWorld&) = delete;
  BareWorld& operator=(const BareWorld&) = delete;
  ~BareWorld();

  /// Adds a body that does not move; Bullet's contacts need one at the other side.
  btRigidBody& add_fixed_body(const btVector3& position);

  /// Adds a kinematic body, which goes in a step to where `pose` has it then.
  btRigidBody& add_hook(btMotionState& pose);

  /// Adds a constraint, which the world then owns.
  template <class Constraint>
  Constraint& add(std::unique_ptr<Constraint> constraint) {
    Constraint& added = *constraint;
    dynamics_.addConstraint(constraint.get());
    constraints_.push_back(std::move(constraint));
    return added;
  }

  /// Owns a constraint that acts in no step.
  void keep(std::unique_ptr<btTypedConstraint> constraint) {
    kept_.push_back(std::move(constraint));
  }

  [[nodiscard]] btDiscreteDynamicsWorld& dynamics() { return dynamics_; }
  [[nodiscard]] btContactSolverInfo& solver_info() { return dynamics_.getSolverInfo(); }
  [[nodiscard]] btConstraintSolver& solver() { return solver_; }
  [[nodiscard]] btDispatcher& dispatcher() { return dispatcher_; }

 protected:
  /// A body with these moments about its axes [kg m^2]; 0 means infinite to Bullet. It
  /// touches nothing, and gravity is to be set before.
  btRigidBody& add_body(double mass, const btVector3& moments);

  /// One `stepSimulation` of `dt` [s] as one substep.
  void step_once(double dt);

 private:
  btDefaultCollisionConfiguration configuration_;
  btCollisionDispatcher dispatcher_{&configuration_};
  btDbvtBroadphase broadphase_;
  btSequentialImpulseConstraintSolver solver_;
  btDiscreteDynamicsWorld dynamics_{&dispatcher_, &broadphase_, &solver_, &configuration_};
  btEmptyShape shape_;
  std::vector<std::unique_ptr<btRigidBody>> bodies_;
  std::vector<std::unique_ptr<btTypedConstraint>> constraints_;
  std::vector<std::unique_ptr<btTypedConstraint>> kept_;
};

/// A Bullet world with the body of a case in it, kept in the plane, and nothing else.
class World : public BareWorld {
 public:
  explicit World(const Case& the_case, Sleep sleep = Sleep::never);

  [[nodiscard]] State state() const;

  /// Puts the body there.
  void place(const State& state);

  /// One step of `dt` [s].
  void advance(double dt);

  /// After a step of `dt` [s] that another made: the angle goes on from there.
  void follow(double dt);

  /// Adds `change` to the body's velocity [m/s].
  void kick(const Vec2& change);

  /// Whether Bullet has frozen the body; it then solves nothing, and old impulses stay as they are.
  [[nodiscard]] bool asleep() const { return !body_->isActive(); }

  [[nodiscard]] btRigidBody& body() { return *body_; }

 private:
  btRigidBody* body_;  // owned by the base
  double angle_;       // [rad], not wrapped
};

/// A Bullet world with the bodies of a system in space in it, and nothing else.
class SystemWorld : public BareWorld {
 public:
  explicit SystemWorld(const SpatialSystem& system);

  using BareWorld::add;

  [[nodiscard]] SpatialSystemState state() const;

  /// Puts the bodies there.
  void place(const SpatialSystemState& state);

  /// One step of `dt` [s] under what is given to act.
  void advance(double dt);

  /// Lets these act in the next step, too.
  void add(const std::vector<BodyLoad>& loads);

  /// The two halves of that where another makes the step: before it, and after it or a part of it.
  void load(double dt);
  void follow(double dt) { time_ += dt; }

  [[nodiscard]] double time() const { return time_; }  // [s]
  void set_time(double time) { time_ = time; }

  /// A step without cables in which a body flies the exact parabola: half of what gravity and
  /// loads give is taken away before the step and given back after it.
  void fly(double dt);

  [[nodiscard]] btRigidBody& body(std::size_t index) { return *moving_[index]; }
  [[nodiscard]] const std::vector<btRigidBody*>& bodies() const { return moving_; }

 private:
  void load(const std::vector<BodyLoad>& loads, const Eigen::Vector3d& gravity);

  const SpatialSystem system_;
  std::vector<btRigidBody*> moving_;  // owned by the base
  double time_ = 0.0;                 // [s]
};

/// The settings every model needs: those of `World`.
[[nodiscard]] std::vector<Setting> world_settings(Sleep sleep = Sleep::never);

/// Settings of models that run systems.
[[nodiscard]] std::vector<Setting> system_settings();

}  // namespace tautline::bullet
