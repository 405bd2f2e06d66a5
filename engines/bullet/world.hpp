#pragma once

#include <btBulletDynamicsCommon.h>

#include <memory>
#include <utility>
#include <vector>

#include "tautline/case.hpp"
#include "tautline/engine.hpp"

namespace tautline::bullet {

/// These sources are compiled twice, once for each build of Bullet.
inline constexpr bool in_double_precision = sizeof(btScalar) == sizeof(double);

[[nodiscard]] inline btVector3 vector(const Vec2& v) {
  return {static_cast<btScalar>(v.x()), static_cast<btScalar>(v.y()), btScalar(0)};
}

/// Whether Bullet may deactivate the body.
enum class Sleep { never, as_shipped };

/// A Bullet world with the body of a case in it, kept in the plane, and nothing else.
class World {
 public:
  explicit World(const Case& the_case, Sleep sleep = Sleep::never);
  World(const World&) = delete;
  World& operator=(const World&) = delete;
  ~World();

  [[nodiscard]] State state() const;

  /// Puts the body there.
  void place(const State& state);

  /// One `stepSimulation` of `dt` [s] as one substep.
  void advance(double dt);

  /// After a step of `dt` [s] that another made: the angle goes on from there.
  void follow_turn(double dt);

  /// Adds `change` to the body's velocity [m/s].
  void kick(const Vec2& change);

  /// Adds a body that does not move; Bullet's contacts need one at the other side.
  btRigidBody& add_fixed_body(const Vec2& position);

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

  /// Whether Bullet has frozen the body; it then solves nothing, and old impulses stay as they are.
  [[nodiscard]] bool asleep() const { return !body_->isActive(); }

  [[nodiscard]] btRigidBody& body() { return *body_; }
  [[nodiscard]] btDiscreteDynamicsWorld& dynamics() { return dynamics_; }
  [[nodiscard]] btContactSolverInfo& solver_info() { return dynamics_.getSolverInfo(); }
  [[nodiscard]] btConstraintSolver& solver() { return solver_; }
  [[nodiscard]] btDispatcher& dispatcher() { return dispatcher_; }

 private:
  std::unique_ptr<btRigidBody> make_body(double mass, double inertia);

  btDefaultCollisionConfiguration configuration_;
  btCollisionDispatcher dispatcher_{&configuration_};
  btDbvtBroadphase broadphase_;
  btSequentialImpulseConstraintSolver solver_;
  btDiscreteDynamicsWorld dynamics_{&dispatcher_, &broadphase_, &solver_, &configuration_};
  btEmptyShape shape_;
  std::unique_ptr<btRigidBody> body_;
  std::vector<std::unique_ptr<btRigidBody>> fixed_;
  std::vector<std::unique_ptr<btTypedConstraint>> constraints_;
  std::vector<std::unique_ptr<btTypedConstraint>> kept_;
  double angle_;  // [rad], not wrapped
};

/// The settings every model needs: those of `World`.
[[nodiscard]] std::vector<Setting> world_settings(Sleep sleep = Sleep::never);

}  // namespace tautline::bullet
