#include "bench/tools/reproduce/checks.hpp"

#include <algorithm>
#include <cmath>
#include <numbers>
#include <random>
#include <stdexcept>
#include <utility>

#include "tautline/geometry.hpp"
#include "tautline/impact.hpp"
#include "tautline/scenarios.hpp"
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

/// Numbers that are the same with every standard library, which the distributions are not.
class Draw {
 public:
  [[nodiscard]] double between(double low, double high) {
    constexpr double unit = 0x1p-53;
    return low + (high - low) * static_cast<double>(engine_() >> 11U) * unit;
  }

 private:
  std::mt19937_64 engine_{chapter_seed};
};

Breakwater any_breakwater(Draw& draw) {
  Breakwater body;
  body.r = draw.between(1.2, 3.0);
  body.e = draw.between(0.0, 1.0);
  body.a = draw.between(0.05, 0.4);
  body.b = draw.between(0.0, 0.4);
  body.shape = Shape::box;
  return body;
}

State any_motion(Draw& draw) {
  State state;
  state.position = {draw.between(-0.3, 0.3), draw.between(-0.2, 0.6)};
  state.angle = draw.between(-1.5, 1.5);
  state.velocity = {draw.between(-1.0, 1.0), draw.between(-1.0, 1.0)};
  state.spin = draw.between(-3.0, 3.0);
  return state;
}

constexpr std::size_t draws = 10'000;

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
  return {angle, slack->time, impact->time,
          closing_speed(the_case, impact->cables, impact->before)};
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

Share slope_signs_wrong() {
  Draw draw;
  Share result{0, 0};
  for (std::size_t index = 0; index < draws; ++index) {
    const Breakwater body = any_breakwater(draw);
    const Case the_case = breakwater(body, "any");
    const Cable& right = the_case.cables[1];
    State state = any_motion(draw);
    const double s = std::sin(state.angle);
    const double c = std::cos(state.angle);
    const double across = 1.0 - state.position.x() - body.a * c + body.b * s;
    if (std::abs(across) >= body.r || across == 0.0) {  // no such pose, or no sign to have
      continue;
    }
    const double down = std::sqrt(body.r * body.r - across * across);
    state.position.y() = right.anchor.y() - body.a * s - body.b * c - down;  // Eq. 5.65
    const auto gradient = gap_gradient(right, state);
    const double slope = -gradient[0] / gradient[1];
    result.times += slope * (across / down) < 0.0 ? 1U : 0U;  // Eq. 5.66
    ++result.of;
  }
  return result;
}

Share spins_kept() {
  Draw draw;
  Share result{0, 0};
  for (std::size_t index = 0; index < draws; ++index) {
    const Case the_case = breakwater(any_breakwater(draw), "any");
    const Cable& cable = the_case.cables[index % 2];
    State before = any_motion(draw);
    const Vec2 u = (attachment_point(before, cable) - cable.anchor).normalized();
    before.position += gap(cable, before) * u;
    if (gap_rate(cable, before) >= 0.0) {  // not an impact: it would be if it ran backwards
      before.velocity = -before.velocity;
      before.spin = -before.spin;
    }
    const State after = newton_impact(the_case, before, CableSet::of(index % 2)).after;
    result.times += before.spin * after.spin > 0.0 ? 1U : 0U;
    ++result.of;
  }
  return result;
}

}  // namespace tautline::bench
