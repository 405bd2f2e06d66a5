#include "bench/check/cases.hpp"

#include <algorithm>
#include <stdexcept>
#include <string>

#include "tautline/geometry.hpp"
#include "tautline/scenarios.hpp"
#include "tautline/system_geometry.hpp"

namespace tautline::bench {

Case shipped_case(std::string_view name) {
  for (const Case& the_case : shipped_cases()) {
    if (the_case.name == name) {
      return the_case;
    }
  }
  throw std::invalid_argument("no case ships under the name " + std::string(name));
}

Case standard_breakwater(double restitution) {
  Breakwater parameters = table_5_1().front().parameters;
  parameters.e = restitution;
  return breakwater(parameters, "standard");
}

Case spinning_on_one_cable(double slack) {
  Case result;
  result.name = "spinning";
  result.body = {2.0, 0.3};
  result.gravity = Vec2(0.3, -1.2);
  result.cables = {{Vec2(0.2, 2.0), Vec2(0.3, 0.2), 1.0, 0.6}};
  result.initial = {Vec2(0.0, 1.2), 0.4, Vec2(0.1, -0.6), 1.5};
  const Cable& cable = result.cables.front();
  result.cables.front().length += slack - gap(cable, result.initial);
  result.duration = 20.0;
  return result;
}

State mirrored(State state) {
  state.position.x() = -state.position.x();
  state.angle = -state.angle;
  state.velocity.x() = -state.velocity.x();
  state.spin = -state.spin;
  return state;
}

Case mirrored(const Case& the_case) {
  Case result = the_case;
  result.gravity.x() = -result.gravity.x();
  result.initial = mirrored(result.initial);
  for (Cable& cable : result.cables) {
    cable.anchor.x() = -cable.anchor.x();
    cable.attachment.x() = -cable.attachment.x();
  }
  std::reverse(result.cables.begin(), result.cables.end());
  return result;
}

SpatialSystem body_in_space(const Eigen::Vector3d& moments) {
  SpatialSystem result;
  result.name = "body";
  result.gravity = Function<3>::constant(Eigen::Vector3d::Zero());
  result.duration = 10.0;
  result.bodies.resize(1);
  result.bodies.front().inertia = moments;
  result.initial.bodies.resize(1);
  SpatialCable cable;
  cable.from.body = 0;
  cable.to.at = Eigen::Vector3d(0.0, 0.0, 2.0);  // not at the body: a cable needs a direction
  cable.length = Function<1>::constant(100.0);
  cable.restitution = 0.5;
  result.cables = {cable};
  return result;
}

Eigen::Vector3d struck_direction() { return {0.48, 0.6, 0.64}; }

SpatialSystem pair_on_a_cable(double restitution) {
  SpatialSystem result = body_in_space(Eigen::Vector3d::Constant(0.05));
  result.name = "pair";
  result.bodies.resize(2);
  result.bodies[1].mass = 3.0;
  result.bodies[1].inertia.setConstant(0.3);
  result.initial.bodies.resize(2);
  SpatialState& light = result.initial.bodies[0];
  SpatialState& heavy = result.initial.bodies[1];
  light.orientation = quaternion_of<double>(Eigen::Vector3d(0.3, -0.5, 0.2));
  heavy.orientation = quaternion_of<double>(Eigen::Vector3d(-0.4, 0.1, 0.6));
  SpatialCable& cable = result.cables.front();
  cable.from = {0, Eigen::Vector3d(0.1, -0.2, 0.15), {}};
  cable.to = {1, Eigen::Vector3d(-0.2, 0.1, 0.3), {}};
  cable.length = Function<1>::constant(1.0);
  cable.restitution = restitution;
  light.position = Eigen::Vector3d(0.3, -0.4, 0.2);
  heavy.position = light.position + in_the_world(light, cable.from.at) +
                   (1.0 - way_to_strike) * struck_direction() - in_the_world(heavy, cable.to.at);
  light.velocity = -0.75 * struck_direction();
  heavy.velocity = 0.25 * struck_direction();
  light.spin = Eigen::Vector3d(0.2, -0.1, 0.3);
  heavy.spin = Eigen::Vector3d(-0.1, 0.2, 0.1);
  return result;
}

}  // namespace tautline::bench
