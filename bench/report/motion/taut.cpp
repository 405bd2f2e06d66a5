#include "bench/report/motion/taut.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <cstdlib>
#include <utility>

#include "tautline/geometry.hpp"

namespace tautline::bench {
namespace {

/// The gap of a cable at one instant.
struct Gap {
  double time;   // [s]
  double value;  // [m]
};

/// The gaps recorded while a cable was taut, from the first to the last.
using Stretch = std::vector<Gap>;

/// A page shows the gap on a taut cable by this part of the motion [-].
constexpr double shown_part = 1e-2;

/// And the instants where it was so to this part of the motion [-]: a tenth of a pixel.
constexpr double instant_part = 1e-5;

/// Three digits say how large a rest is.
double three_digits(double value) {
  return std::strtod(fmt::format("{:.3g}", value).c_str(), nullptr);
}

TautColumns columns_of(const std::vector<Stretch>& stretches, double duration) {
  std::vector<double> times;
  std::vector<double> gap_times;
  TautColumns columns;
  const auto show = [&](const Gap& gap) {
    gap_times.push_back(gap.time);
    columns.gap.push_back(three_digits(gap.value));
  };
  for (const Stretch& stretch : stretches) {
    times.insert(times.end(), {stretch.front().time, stretch.back().time});
    auto from = stretch.begin();
    while (stretch.back().time - stretch.front().time >= shown_part * duration &&
           from != stretch.end()) {
      const auto to = std::find_if(from, stretch.end(), [&](const Gap& gap) {
        return gap.time - from->time >= shown_part * duration;
      });
      const auto [least, largest] = std::minmax_element(
          from, to, [](const Gap& a, const Gap& b) { return a.value < b.value; });
      show(*std::min(least, largest));
      if (least != largest) {
        show(*std::max(least, largest));
      }
      from = to;
    }
  }
  const double fine = std::max(duration, 1e-300) * 1e-9;  // [s]: no engine steps as finely
  columns.times = on_grid(times, fine);
  columns.gap_times = on_grid(gap_times, instant_part / 1e-9 * fine);
  return columns;
}

bool long_enough(const Stretch& stretch) {
  return stretch.size() > 1 && stretch.back().time - stretch.front().time >= shortest_hold;
}

}  // namespace

std::vector<TautColumns> taut_columns(const Case& the_case, const Trajectory& run) {
  std::vector<TautColumns> result;
  for (const Cable& cable : the_case.cables) {
    std::vector<Stretch> stretches;
    Stretch now;
    const auto end_stretch = [&] {
      if (long_enough(now)) {
        stretches.push_back(std::move(now));
      }
      now = {};
    };
    for (const Point& point : run.points) {
      const Gap here{point.time, gap(cable, point.state)};
      if (!(here.value <= taut_part * cable.length)) {
        end_stretch();
      } else if (std::isfinite(here.value)) {
        now.push_back(here);
      }
    }
    end_stretch();
    result.push_back(columns_of(stretches, the_case.duration));
  }
  return result;
}

std::vector<TautColumns> taut_columns(const Case& the_case, const Solution& solution) {
  constexpr double fine = 1000.0;  // parts of the whole motion, each with a gap
  std::vector<TautColumns> result;
  for (std::size_t index = 0; index < the_case.cables.size(); ++index) {
    const Cable& cable = the_case.cables[index];
    std::vector<Stretch> stretches;
    bool held = false;  // at the end of the arc before
    for (const Arc& arc : solution.arcs_until(solution.end_time())) {
      if (!arc.taut.contains(index)) {
        held = false;
        continue;
      }
      if (!std::exchange(held, true)) {
        stretches.emplace_back();
      }
      const double length = arc.end - arc.start;
      const std::size_t parts = 1 + static_cast<std::size_t>(fine * length / solution.end_time());
      for (std::size_t part = 0; part <= parts; ++part) {
        const double dt = length * static_cast<double>(part) / static_cast<double>(parts);
        stretches.back().push_back({arc.start + dt, gap(cable, arc.after(dt, solution.gravity()))});
      }
    }
    result.push_back(columns_of(stretches, solution.end_time()));
  }
  return result;
}

}  // namespace tautline::bench
