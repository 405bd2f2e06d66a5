#include "world.hpp"

#include <limits>

namespace tautline::chipmunk {

World::World(const Case& the_case)
    : space_(cpSpaceNew()),
      // a point mass does not turn: no cable of its own turns it, and none may divide by zero
      body_(cpBodyNew(the_case.body.mass, the_case.body.inertia > 0.0
                                              ? the_case.body.inertia
                                              : std::numeric_limits<double>::infinity())) {
  cpSpaceSetGravity(space_, vector(the_case.gravity));
  cpSpaceAddBody(space_, body_);
  place(the_case.initial);
}

World::~World() {
  cpSpaceRemoveBody(space_, body_);
  cpBodyFree(body_);
  cpSpaceFree(space_);
}

State World::state() const {
  const cpVect position = cpBodyGetPosition(body_);
  const cpVect velocity = cpBodyGetVelocity(body_);
  State result;
  result.position = Vec2(position.x, position.y);
  result.angle = cpBodyGetAngle(body_);
  result.velocity = Vec2(velocity.x, velocity.y);
  result.spin = cpBodyGetAngularVelocity(body_);
  return result;
}

void World::place(const State& state) {
  cpBodySetAngle(body_, state.angle);
  cpBodySetPosition(body_, vector(state.position));
  cpBodySetVelocity(body_, vector(state.velocity));
  cpBodySetAngularVelocity(body_, state.spin);
}

void World::kick(const Vec2& change) {
  cpBodySetVelocity(body_, cpvadd(cpBodyGetVelocity(body_), vector(change)));
}

void World::advance(double dt) { cpSpaceStep(space_, dt); }

}  // namespace tautline::chipmunk
