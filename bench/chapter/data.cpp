#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <numbers>

#include "bench/chapter/figures.hpp"
#include "tautline/geometry.hpp"

namespace tautline::bench {
namespace {

/// A cable that is held closes at rounding only [sqrt(gS)].
constexpr double resting_speed = 1e-12;

// twelve digits: a plot needs four, and files stay small
std::string motion_row(const ChapterCase& solved, double time, const State& state,
                       std::string_view event, std::string_view kind) {
  return fmt::format("{:.12g},{:.12g},{:.12g},{:.12g},{:.12g},{:.12g},{:.12g},{:.12g},{},{}\n",
                     time, state.position.x(), state.position.y(), state.angle, state.velocity.x(),
                     state.velocity.y(), state.spin, energy(solved.the_case, state), event, kind);
}

/// Where the motion of a figure ends: at rest, or with the solution.
double figure_end(const ChapterCase& solved) {
  const auto& lock = solved.settling.lock;
  const double end = solved.solution.end_time();
  return lock && lock->rests ? std::min(end, std::ceil(lock->time)) : end;
}

}  // namespace

std::string motion_csv(const ChapterCase& solved) {
  std::string csv =
      "t [sqrt(S/g)],x [S],y [S],theta [rad],vx [sqrt(gS)],vy [sqrt(gS)],vtheta [sqrt(g/S)],"
      "energy [mgS],event,kind\n";
  const double end = figure_end(solved);
  const auto samples = static_cast<int>(std::lround(end / figure_step));
  auto event = solved.solution.events().begin();
  for (int index = 0; index <= samples; ++index) {
    const double time = std::min(index * figure_step, end);
    for (; event != solved.solution.events().end() && event->time <= time; ++event) {
      const std::string_view kind = to_string(event->kind);
      csv += motion_row(solved, event->time, event->before, "before", kind);
      csv += motion_row(solved, event->time, event->after, "after", kind);
    }
    csv += motion_row(solved, time, solved.solution.at(time), "", "");
  }
  return csv;
}

std::string impacts_csv(const ChapterCase& solved) {
  std::string csv =
      "t [sqrt(S/g)],cable,vn before [sqrt(gS)],vn after [sqrt(gS)],energy before [mgS],"
      "energy after [mgS]\n";
  for (const Event& event : solved.solution.events()) {
    for (const std::size_t index : event.cables) {
      const Cable& cable = solved.the_case.cables[index];
      // the chapter's normal velocity stretches the cable where it is above 0
      const double before = -gap_rate(cable, event.before);
      if (event.kind == EventKind::impact && before > resting_speed) {
        csv +=
            fmt::format("{:.12g},{},{:.12g},{:.12g},{:.12g},{:.12g}\n", event.time, index, before,
                        -gap_rate(cable, event.after), energy(solved.the_case, event.before),
                        energy(solved.the_case, event.after));
      }
    }
  }
  return csv;
}

std::string boundary_csv(const Breakwater& parameters) {
  std::string csv = "x [S],y on g1 = 0 [S],y on g2 = 0 [S],lowest y [S]\n";
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
    csv += fmt::format("{:.12g},{:.12g},{:.12g},{:.12g}\n", x, right, left, std::max(right, left));
  }
  return csv;
}

double corner_angle(const Breakwater& parameters) {
  const double span = 1.0 - parameters.a;
  const double slope = span / std::sqrt(parameters.r * parameters.r - span * span);
  return std::numbers::pi - 2.0 * std::atan(slope);
}

}  // namespace tautline::bench
