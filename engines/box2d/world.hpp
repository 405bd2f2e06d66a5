#pragma once

#include <box2d/box2d.h>

#include <vector>

#include "tautline/cable_row.hpp"
#include "tautline/case.hpp"
#include "tautline/engine.hpp"

namespace tautline::box2d {

/// `v` as Box2D has it. Throws std::invalid_argument where single precision cannot hold it.
[[nodiscard]] b2Vec2 vector(const Vec2& v);

/// The same for a number, of which a positive one stays positive.
[[nodiscard]] float number(double value);

/// A Box2D world with the body of a case in it, and nothing else.
class World {
 public:
  explicit World(const Case& the_case);

  [[nodiscard]] State state() const;

  /// Puts the body there.
  void place(const State& state);

  /// Adds `change` to the body's velocity [m/s].
  void kick(const Vec2& change);

  /// One `b2World::Step` of `dt` [s]. Box2D moves a body by no more than 2 m and a quarter turn in
  /// it, and slows it down to that.
  void advance(double dt);

  /// The impulses [N s], >= 0, along `rows` that leave the rate along each of them at least at
  /// `rates` [m/s], found with Box2D's mass and inertia, and applied. One entry per row.
  CableVector pull(const std::vector<CableRow>& rows, const CableVector& rates);

  [[nodiscard]] b2Body& body() { return *body_; }
  [[nodiscard]] b2Body& ground() { return *ground_; }

  /// Adds a joint, which the world then owns.
  template <class Joint, class Definition>
  Joint& add(const Definition& definition) {
    return *static_cast<Joint*>(world_.CreateJoint(&definition));
  }

 private:
  b2World world_;
  b2Body* ground_;
  b2Body* body_;
};

/// The settings every model needs: those of `World`.
[[nodiscard]] std::vector<Setting> world_settings();

}  // namespace tautline::box2d
