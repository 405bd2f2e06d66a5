#include "bench/chapter/figures/figure_data.hpp"

#include <algorithm>
#include <cmath>

#include "tautline/geometry.hpp"

namespace tautline::bench {
namespace {

/// A cable that is held closes at rounding only [sqrt(gS)].
constexpr double resting_speed = 1e-12;

DataRow motion_row(const ChapterCase& solved, double time, const State& state,
                   std::string_view side, std::string_view kind) {
  return {{time, state.position.x(), state.position.y(), state.angle, state.velocity.x(),
           state.velocity.y(), state.spin, energy(solved.the_case, state)},
          {side, kind}};
}

/// Where the motion of a figure ends: at rest, or with the solution.
double figure_end(const ChapterCase& solved) {
  const auto& lock = solved.settling.lock;
  const double end = solved.solution.end_time();
  return lock && lock->rests ? std::min(end, std::ceil(lock->time)) : end;
}

}  // namespace

FigureData motion_data(const ChapterCase& solved) {
  FigureData data{{"t [sqrt(S/g)]", "x [S]", "y [S]", "theta [rad]", "vx [sqrt(gS)]",
                   "vy [sqrt(gS)]", "vtheta [sqrt(g/S)]", "energy [mgS]", "event", "kind"},
                  {}};
  const double end = figure_end(solved);
  const auto samples = static_cast<int>(std::lround(end / figure_step));
  auto event = solved.solution.events().begin();
  for (int index = 0; index <= samples; ++index) {
    const double time = std::min(index * figure_step, end);
    for (; event != solved.solution.events().end() && event->time <= time; ++event) {
      const std::string_view kind = to_string(event->kind);
      data.rows.push_back(motion_row(solved, event->time, event->before, "before", kind));
      data.rows.push_back(motion_row(solved, event->time, event->after, "after", kind));
    }
    data.rows.push_back(motion_row(solved, time, solved.solution.at(time), "", ""));
  }
  return data;
}

FigureData impacts_data(const ChapterCase& solved) {
  FigureData data{{"t [sqrt(S/g)]", "cable", "vn before [sqrt(gS)]", "vn after [sqrt(gS)]",
                   "energy before [mgS]", "energy after [mgS]"},
                  {}};
  for (const Event& event : solved.solution.events()) {
    for (const std::size_t index : event.cables) {
      const Cable& cable = solved.the_case.cables[index];
      // the chapter's normal velocity stretches the cable where it is above 0
      const double before = -gap_rate(cable, event.before);
      if (event.kind == EventKind::impact && before > resting_speed) {
        data.rows.push_back(
            {{event.time, static_cast<double>(index), before, -gap_rate(cable, event.after),
              energy(solved.the_case, event.before), energy(solved.the_case, event.after)},
             {}});
      }
    }
  }
  return data;
}

FigureData boundary_data(const Breakwater& parameters) {
  FigureData data{{"x [S]", "y on g1 = 0 [S]", "y on g2 = 0 [S]", "lowest y [S]"}, {}};
  const double r = parameters.r;
  const double span = 1.0 - parameters.a;
  const double h = std::sqrt(r * r - span * span);
  // between these neither cable, stretched, is above its anchor's height
  const double reach = r - span;
  constexpr int half = 200;  // samples on each side
  for (int index = -half; index <= half; ++index) {
    const double x = reach * index / half;
    const auto boundary = [&](double across) {
      return h - std::sqrt(std::max(0.0, r * r - across * across));
    };
    const double right = boundary(span - x);
    const double left = boundary(span + x);
    data.rows.push_back({{x, right, left, std::max(right, left)}, {}});
  }
  return data;
}

}  // namespace tautline::bench
