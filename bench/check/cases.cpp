#include "bench/check/cases.hpp"

#include <algorithm>
#include <stdexcept>
#include <string>

#include "tautline/geometry.hpp"
#include "tautline/scenarios.hpp"

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

}  // namespace tautline::bench
