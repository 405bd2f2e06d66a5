#pragma once

#include "chipmunk.hpp"
#include "tautline/case.hpp"
#include "tautline/engine.hpp"

namespace tautline::chipmunk {

[[nodiscard]] inline cpVect vector(const Vec2& v) { return cpv(v.x(), v.y()); }

/// A Chipmunk space with the body of a case in it, and nothing else.
class World {
 public:
  explicit World(const Case& the_case);
  World(const World&) = delete;
  World& operator=(const World&) = delete;
  ~World();

  [[nodiscard]] State state() const;

  /// Puts the body there.
  void place(const State& state);

  /// Adds `change` to the body's velocity [m/s].
  void kick(const Vec2& change);

  /// One `cpSpaceStep` of `dt` [s]: Chipmunk moves the body first and then changes its velocity.
  void advance(double dt);

  [[nodiscard]] cpSpace* space() { return space_; }
  [[nodiscard]] cpBody* body() { return body_; }
  [[nodiscard]] cpBody* ground() { return cpSpaceGetStaticBody(space_); }

 private:
  cpSpace* space_;
  cpBody* body_;
};

}  // namespace tautline::chipmunk
