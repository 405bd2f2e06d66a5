#pragma once

#include <vector>

#include "tautline/case.hpp"

// Systems at the edge of what a double can tell, each of which a solver once got wrong.

namespace tautline::test {

/// A light body on two taut inelastic cables: I / (m a^2) is 6e-5. One of them must be let go.
inline Case light_on_two_cables() {
  Case stuck;
  stuck.name = "stuck";
  stuck.duration = 20.0;
  stuck.gravity = Vec2(0.2868278708686587, -9.81);
  stuck.body = {1.0, 1.8161933100256764e-05};
  for (const double side : {-1.0, 1.0}) {
    stuck.cables.push_back({Vec2(side * 1.245278120623644, 1.0),
                            Vec2(side * 0.4929653880130568, 0.22264473309749683), 1.231342079009619,
                            0.0});
  }
  stuck.initial = {Vec2(0.05, 0.1), 0.1, Vec2(0.3, 0.0), 0.17356018271713736};
  return stuck;
}

/// A cable of restitution `e` beside one of 1/2: its bounces shrink below rounding and never end.
inline Case elastic_beside_inelastic(double e) {
  Case mix;
  mix.name = "mix";
  mix.duration = 5.0;
  mix.gravity = Vec2(0.0, -9.81);
  mix.body = {1.0, 0.04};
  mix.cables = {{Vec2(1.92, 2.11), Vec2(0.43, 0.21), 3.18, e},
                {Vec2(-0.7, 1.26), Vec2(0.42, -0.2), 2.04, 0.5}};
  mix.initial = {Vec2(0.0, 0.0), -1.1, Vec2(2.6, -3.0), -6.8};
  return mix;
}

/// A point mass between an elastic cable and one almost opposed, which stop it within an instant;
/// it slides off along the elastic one, on bounces far below rounding.
inline Case sliding_off_a_wedge() {
  Case wedge;
  wedge.name = "wedge";
  wedge.duration = 10.0;
  wedge.gravity = Vec2(-0.045, 0.956);
  wedge.body = {0.876, 0.0};
  wedge.cables = {{Vec2(-1.85, 0.385), Vec2(0.0, 0.0), 1.996, 0.035},
                  {Vec2(1.176, -0.646), Vec2(0.0, 0.0), 1.2142, 1.0}};
  wedge.initial = {Vec2(0.077, -0.13), 0.0, Vec2(0.24, -0.84), 0.0};
  return wedge;
}

/// A body that comes to rest on three cables, at `away` from the origin.
inline Case resting_at(const Vec2& away) {
  Case far;
  far.name = "far";
  far.duration = 6.0;
  far.gravity = Vec2(0.0, -9.81);
  far.body = {1.0, 0.12};
  far.cables = {{Vec2(2.02, 1.97) + away, Vec2(-0.49, -0.23), 3.04, 0.3},
                {Vec2(0.22, 1.55) + away, Vec2(0.13, 0.05), 1.54, 0.0},
                {Vec2(-1.04, 1.18) + away, Vec2(-0.19, -0.21), 1.95, 0.3}};
  far.initial = {away, 2.2, Vec2(0.9, 1.0), 9.5};
  return far;
}

/// A body that turns with next to no inertia: I / (m a^2) is 6e-9. Its cables are 63 degrees apart.
inline Case hardly_any_inertia() {
  Case tiny;
  tiny.name = "tiny";
  tiny.duration = 1.0;
  tiny.gravity = Vec2(1.5, -5.0);
  tiny.body = {17.0, 1e-8};
  tiny.cables = {{Vec2(2.174, 1.287), Vec2(0.11, -0.304), 2.344, 0.05},
                 {Vec2(-0.56, 1.636), Vec2(-0.18, 0.054), 2.058, 0.0}};
  tiny.initial = {Vec2(0.0, 0.0), 2.4266, Vec2(0.925, -1.849), -5.924};
  return tiny;
}

/// A body on cables that hang side by side, with these restitutions.
inline Case side_by_side_cables(const std::vector<double>& restitutions) {
  Case twins;
  twins.name = "twins";
  twins.duration = 5.0;
  twins.gravity = Vec2(0.0, -9.81);
  twins.body = {2.0, 0.1};
  for (const double e : restitutions) {
    twins.cables.push_back({Vec2(0.0, 2.0), Vec2(0.3, 0.2), 2.2, e});
  }
  twins.initial = {Vec2(0.0, 0.0), 0.1, Vec2(0.3, 0.0), 0.5};
  return twins;
}

/// A body above its anchor on a taut cable, turned by `angle` from where it would stand.
inline Case standing_on_its_cable(double angle) {
  Case inverted;
  inverted.name = "inverted";
  inverted.duration = 100.0;
  inverted.body = {1.0, 0.1};
  inverted.cables = {{Vec2(0.0, 0.0), Vec2(0.0, -0.5), 1.0, 0.5}};
  inverted.initial.position = Vec2(-angle / 2.0, -0.5);
  inverted.initial.angle = angle;
  return inverted;
}

/// A body that hangs at its centre and turns at `spin`, beside a second cable that stays slack.
inline Case turning_on_its_centre(double spin) {
  Case turning;
  turning.name = "turning";
  turning.duration = 0.1;
  turning.gravity = Vec2(0.0, -9.81);
  turning.body = {1.0, 0.1};
  turning.cables = {{Vec2(0.0, 1.0), Vec2(0.0, 0.0), 1.0, 0.5},
                    {Vec2(0.5, 1.0), Vec2(0.2, 0.1), 3.0, 0.5}};
  turning.initial.spin = spin;
  return turning;
}

}  // namespace tautline::test
