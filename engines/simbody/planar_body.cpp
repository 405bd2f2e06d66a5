#include "planar_body.hpp"

#include "tautline/point_mass.hpp"

namespace tautline::simbody {
namespace {

// the coordinates of MobilizedBody::Planar
constexpr int angle = 0;
constexpr int x = 1;
constexpr int y = 2;

SimTK::Body::Rigid rigid(const Body& body) {
  const double about_z = turnable_inertia(body);
  return SimTK::Body::Rigid(
      SimTK::MassProperties(body.mass, SimTK::Vec3(0.0), SimTK::Inertia(about_z)));
}

}  // namespace

PlanarBody::PlanarBody(const Case& the_case)
    : case_(the_case), body_(matter_.updGround(), rigid(the_case.body)) {
  SimTK::Force::UniformGravity(forces_, matter_, vector(the_case.gravity));
}

SimTK::State PlanarBody::initial_state() {
  system_.realizeTopology();
  SimTK::State result = system_.getDefaultState();
  system_.realizeModel(result);
  const State& wanted = case_.initial;
  body_.setOneQ(result, angle, wanted.angle);
  body_.setOneQ(result, x, wanted.position.x());
  body_.setOneQ(result, y, wanted.position.y());
  body_.setOneU(result, angle, wanted.spin);
  body_.setOneU(result, x, wanted.velocity.x());
  body_.setOneU(result, y, wanted.velocity.y());
  system_.realize(result, SimTK::Stage::Velocity);
  return result;
}

State PlanarBody::state_of(const SimTK::State& state) const {
  State result;
  result.angle = body_.getOneQ(state, angle);
  result.position = Vec2(body_.getOneQ(state, x), body_.getOneQ(state, y));
  result.spin = body_.getOneU(state, angle);
  result.velocity = Vec2(body_.getOneU(state, x), body_.getOneU(state, y));
  return result;
}

}  // namespace tautline::simbody
