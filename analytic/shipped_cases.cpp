#include <cmath>
#include <string>
#include <utility>

#include "tautline/scenarios.hpp"

namespace tautline {
namespace {

/// A container of 2 t on one sling that is not above its centre of mass, SI units.
Case crane_load() {
  Case result;
  result.name = "crane-load";
  result.body = {2000.0, 3400.0};
  result.gravity = Vec2(0.0, -9.81);
  result.cables = {{Vec2(0.0, 12.0), Vec2(0.4, 1.2), 8.0, 0.3}};
  result.initial = {Vec2(0.5, 3.6), 0.1, Vec2(0.8, 0.0), 0.0};
  result.duration = 10.0;
  return result;
}

/// A buoy held down by gravity's mirror image: net buoyancy pulls it up, three cables hold it, SI.
Case buoy_three_cables() {
  Case result;
  result.name = "buoy-three-cables";
  result.body = {150.0, 40.0};
  result.gravity = Vec2(0.0, 3.0);
  result.cables = {{Vec2(-6.0, -8.0), Vec2(-0.6, -0.3), 10.0, 0.6},
                   {Vec2(0.0, -8.0), Vec2(0.0, -0.5), 8.4, 0.4},
                   {Vec2(6.0, -8.0), Vec2(0.6, -0.3), 10.0, 0.6}};
  result.initial = {Vec2(0.5, -0.4), 0.15, Vec2(-0.6, 0.5), 0.2};
  result.duration = 20.0;
  return result;
}

/// A square plate slung from its four corners, nondimensional.
Case plate_four_cables() {
  Case result;
  result.name = "plate-four-cables";
  result.body = {1.0, 0.06};
  result.cables = {{Vec2(-1.0, 1.5), Vec2(-0.3, 0.3), 1.6, 0.8},
                   {Vec2(1.0, 1.5), Vec2(0.3, 0.3), 1.6, 0.8},
                   {Vec2(-1.6, 1.5), Vec2(-0.3, -0.3), 2.3, 0.7},
                   {Vec2(1.6, 1.5), Vec2(0.3, -0.3), 2.3, 0.7}};
  result.initial = {Vec2(0.15, 0.1), 0.1, Vec2(-0.3, 0.2), 0.5};
  result.duration = 20.0;
  return result;
}

/// The standard breakwater with gravity turned by 0.2 rad: nothing is symmetric any more.
Case tilted_breakwater() {
  Case result = breakwater(table_5_1().front().parameters, "tilted-gravity");
  constexpr double tilt = 0.2;  // [rad]
  result.gravity = Vec2(sin(tilt), -cos(tilt));
  return result;
}

/// A load of two cables that hangs level and is dropped: both go taut in the same instant, and as
/// they rebound differently it then tumbles from one to the other, SI units.
Case level_beam() {
  Case result;
  result.name = "level-beam";
  result.body = {800.0, 1100.0};
  result.gravity = Vec2(0.0, -9.81);
  result.cables = {{Vec2(-3.0, 8.0), Vec2(-2.0, 0.2), 5.0, 0.6},
                   {Vec2(3.0, 8.0), Vec2(2.0, 0.2), 5.0, 0.4}};
  result.initial.position = Vec2(0.0, 3.4);
  result.duration = 3.0;
  return result;
}

/// A ball thrown into its cable, which does not rebound: it is caught, swings up above the anchor,
/// lets go, falls, and is caught again, SI units.
Case caught_swing() {
  Case result;
  result.name = "caught-swing";
  result.body = {5.0, 0.05};
  result.gravity = Vec2(0.0, -9.81);
  result.cables = {{Vec2(0.0, 0.0), Vec2(0.0, 0.0), 1.0, 0.0}};
  result.initial = {Vec2(0.0, -0.9), 0.0, Vec2(6.3, 0.0), 1.0};
  result.duration = 4.0;
  return result;
}

/// A rod held by its end and dropped level: a body whose arm is five times its radius of gyration
/// turns its fall into spin, SI units.
Case spinning_rod() {
  Case result;
  result.name = "spinning-rod";
  result.body = {4.0, 0.05};
  result.gravity = Vec2(0.0, -9.81);
  result.cables = {{Vec2(0.0, 3.0), Vec2(0.6, 0.0), 1.5, 0.5}};
  result.initial.position = Vec2(-0.3, 2.0);
  result.duration = 2.0;
  return result;
}

/// A box on one cable at its corner that loses nothing, SI units.
Case elastic_box() {
  Case result;
  result.name = "elastic-box";
  result.body = {12.0, 0.5};
  result.gravity = Vec2(0.0, -9.81);
  result.cables = {{Vec2(0.0, 3.0), Vec2(0.2, 0.15), 2.0, 1.0}};
  result.initial.position = Vec2(0.3, 1.4);
  result.initial.angle = 0.2;
  result.duration = 3.0;
  return result;
}

}  // namespace

Case bouncing_ball(double restitution) {
  Case result;
  result.name = "bouncing-ball";
  result.body = {1.0, 0.4};
  result.cables = {{Vec2(0.0, 2.0), Vec2(0.0, 0.0), 2.0, restitution}};
  result.initial.position = Vec2(0.0, 0.5);
  result.duration = 10.0;
  return result;
}

std::vector<Case> shipped_cases() {
  std::vector<Case> cases;
  for (const TableRow& table_row : table_5_1()) {
    cases.push_back(
        breakwater(table_row.parameters, "breakwater/" + std::string(table_row.number)));
  }
  for (Case& other : std::vector<Case>{bouncing_ball(), crane_load(), buoy_three_cables(),
                                       plate_four_cables(), tilted_breakwater(), elastic_box(),
                                       caught_swing(), spinning_rod(), level_beam()}) {
    cases.push_back(std::move(other));
  }
  return cases;
}

}  // namespace tautline
