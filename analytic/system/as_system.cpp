#include "tautline/system.hpp"

namespace tautline {

System as_system(const Case& the_case) {
  System result;
  result.name = the_case.name;
  result.bodies.emplace_back();
  result.bodies.front().mass = the_case.body.mass;
  result.bodies.front().inertia = the_case.body.inertia;
  for (const Cable& cable : the_case.cables) {
    CableOfSystem& one = result.cables.emplace_back();
    one.from = {0, cable.attachment, {}};
    one.to = {std::nullopt, cable.anchor, {}};
    one.length = Function<1>::constant(cable.length);
    one.restitution = cable.restitution;
    one.capture_speed = cable.capture_speed;
    one.restitution_table = cable.restitution_table;
  }
  result.gravity = Function<2>::constant(the_case.gravity);
  result.initial.bodies = {the_case.initial};
  result.duration = the_case.duration;
  return result;
}

}  // namespace tautline
