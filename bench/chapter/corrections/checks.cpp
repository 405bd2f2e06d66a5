#include "bench/chapter/corrections/checks.hpp"

#include <algorithm>
#include <cmath>
#include <numbers>
#include <stdexcept>
#include <utility>

#include "tautline/geometry.hpp"
#include "tautline/impact.hpp"
#include "tautline/solve.hpp"

namespace tautline::bench {
namespace {

/// The pose with both cables taut at `angle`: the lower meeting of two equal circles about what the
/// anchors leave for the centre.
State linkage_pose(const Case& the_case, double angle) {
  State state;
  state.angle = angle;
  const Vec2 left = the_case.cables[0].anchor - attachment_arm(state, the_case.cables[0]);
  const Vec2 right = the_case.cables[1].anchor - attachment_arm(state, the_case.cables[1]);
  const double length = the_case.cables[0].length;
  const Vec2 half = (right - left) / 2;
  const double depth = std::sqrt(length * length - half.squaredNorm());
  state.position = left + half - depth * perpendicular(half).normalized();
  return state;
}

/// The speed of the centre of mass after the first impact of the standard start.
double rebound(double size, double inertia) {
  Breakwater body = table_5_1().front().parameters;
  body.a = size;
  Case the_case = breakwater(body, "shrunk");
  the_case.body.inertia = inertia;
  the_case.duration = 1.0;
  return solve(the_case).events().front().after.velocity.norm();
}

}  // namespace

double ceiling_excess(const ChapterCase& solved) {
  State state;
  state.position.y() = solved.the_case.cables[0].anchor.y();  // H + B, the most that 5.4 allows
  return attachment_point(state, solved.the_case.cables[0]).y() -
         solved.the_case.cables[0].anchor.y();
}

TimeScale time_scale(const ChapterCase& standard) {
  constexpr double spacing = 10.0;
  constexpr double gravity = 9.81;
  Case the_case = standard.the_case;
  the_case.gravity *= gravity;
  the_case.body.inertia *= spacing * spacing;
  for (Cable& cable : the_case.cables) {
    cable.anchor *= spacing;
    cable.attachment *= spacing;
    cable.length *= spacing;
  }
  the_case.initial.position *= spacing;
  the_case.initial.velocity *= std::sqrt(gravity * spacing);
  the_case.initial.spin *= std::sqrt(gravity / spacing);
  const double time = solve(the_case).events().front().time;
  return {spacing, gravity, time, time / standard.solution.events().front().time};
}

SpinChange heavy_spin_change(const ChapterCase& standard) {
  constexpr double mass = 2.0;
  const Event& first = standard.solution.events().front();
  const auto change = [&](double heavy) {
    Case the_case = standard.the_case;
    the_case.body.mass = heavy;
    the_case.body.inertia *= mass;
    return newton_impact(the_case, first.before, first.cables).after.spin - first.before.spin;
  };
  return {change(mass), change(1.0)};
}

Release release(const ChapterCase& solved, double angle) {
  Case the_case = solved.the_case;
  the_case.initial = linkage_pose(the_case, angle);
  const Solution solution = solve(the_case);
  const auto& events = solution.events();
  const auto slack = std::find_if(events.begin(), events.end(), [](const Event& event) {
    return event.kind == EventKind::slack;
  });
  const auto impact = std::find_if(
      slack, events.end(), [](const Event& event) { return event.kind == EventKind::impact; });
  if (impact == events.end()) {
    throw std::logic_error("the release keeps its cables taut");
  }
  return {angle, slack->time, impact->time, closing_speed(the_case, *impact)};
}

Share inertia_pairs_against(const ChapterStudy& study) {
  std::vector<std::pair<double, double>> bodies;  // inertia, largest angle
  for (const ChapterCase& one : study.cases) {
    const Breakwater& p = one.parameters;
    const Breakwater& standard = study.cases.front().parameters;
    const bool same_start =
        p.initial.angle == standard.initial.angle && p.initial.spin == standard.initial.spin;
    if (p.a > 0.0 && p.r == standard.r && p.e == standard.e && same_start) {  // exactly: as given
      bodies.emplace_back(one.the_case.body.inertia, largest_angle(one));
    }
  }
  std::sort(bodies.begin(), bodies.end());
  Share result{0, 0};
  for (std::size_t light = 0; light < bodies.size(); ++light) {
    for (std::size_t heavy = light + 1; heavy < bodies.size(); ++heavy) {
      result.times += bodies[heavy].second > bodies[light].second ? 1U : 0U;
      ++result.of;
    }
  }
  return result;
}

std::vector<Shrunk> shrunk_bodies() {
  std::vector<Shrunk> result;
  for (const double size : {1e-1, 1e-2, 1e-3, 1e-4}) {
    result.push_back({size, rebound(size, size * size), rebound(size, 1.0)});
  }
  return result;
}

double point_rebound() { return rebound(0.0, 0.0); }

OtherLaw sequential_law(const ChapterCase& solved) {
  SolveOptions options;
  options.law = ImpactLaw::sequential;
  const Solution solution = solve(solved.the_case, options);
  const Settling settled = settling(solved.the_case, solution);
  return {settled.lock.value().time, settled.lock->swing.value().energy};
}

double slowest_resolved(const ChapterCase& solved) {
  constexpr double tolerance = 1e-6;  // of g, Eq. 5.120
  // a bounce of speed v opens the gap by v^2 / (2 c), and g = -2 r gap
  const double c = -free_gap_acceleration(solved.the_case, 1, State{});
  return std::sqrt(c * tolerance / solved.the_case.cables[1].length);
}

double corner_angle(const Breakwater& parameters) {
  const double span = 1.0 - parameters.a;
  const double slope = span / std::sqrt(parameters.r * parameters.r - span * span);
  return std::numbers::pi - 2.0 * std::atan(slope);
}

}  // namespace tautline::bench
