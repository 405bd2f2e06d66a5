#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <functional>
#include <vector>

#include "bench/base/listed.hpp"
#include "bench/base/text.hpp"
#include "bench/plot/motion.hpp"
#include "bench/plot/svg.hpp"
#include "tautline/geometry.hpp"
#include "tautline/system_geometry.hpp"

namespace tautline::bench {
namespace {

// The sheet [px].
constexpr double panel_height = 112.0;
constexpr double motion_width = panel_left + panel_width + 20.0;
constexpr double motion_top = 76.0;
constexpr double between_panels = 32.0;  // panels

/// Lines of cables differ in dashes and in colour.
constexpr std::array<const char*, max_cables> cable_lines = {
    "stroke=\"#1f6fb4\"",
    "stroke=\"#c4320a\" stroke-dasharray=\"7 3\"",
    "stroke=\"#2a8a4a\" stroke-dasharray=\"2 3\"",
    "stroke=\"#8a4fb0\" stroke-dasharray=\"9 3 2 3\"",
    "stroke=\"#a0700a\" stroke-dasharray=\"4 2\"",
    "stroke=\"#0a8a96\" stroke-dasharray=\"12 4\"",
    "stroke=\"#c03a80\" stroke-dasharray=\"1 2\"",
    "stroke=\"#6a6a6a\" stroke-dasharray=\"6 2 1 2 1 2\""};

/// A curve over time.
struct Curve {
  std::string line;            // how it is drawn
  std::vector<double> values;  // one for each time
};

/// Curves that share axes.
struct Panel {
  std::string name;  // with its unit
  std::vector<Curve> curves;
};

/// The motion at many times, in order; a jump is two values of one time.
struct Curves {
  std::vector<double> times;
  std::vector<Panel> panels;
};

/// By which angle a body has turned [rad]: in the plane it goes on over whole turns, in space it is
/// that between its orientation and that at its start.
double turned(const State& state, const State& /*start*/) { return state.angle; }
double turned(const SpatialState& state, const SpatialState& start) {
  return angle_between(start.orientation, state.orientation);
}

template <class TheCase>
class Gatherer {
 public:
  using Arc = BasicArc<TheCase>;
  using State = StateOf<TheCase>;

  // The places of the panels.
  static constexpr std::size_t axes = dimensions_of<TheCase>;
  static constexpr std::size_t turns = axes;
  static constexpr std::size_t gaps = turns + 1;
  static constexpr std::size_t tensions = gaps + 1;
  static constexpr std::size_t energies = tensions + 1;
  static constexpr bool in_space = axes == 3;

  Gatherer(const TheCase& the_case, const BasicSolution<TheCase>& solution)
      : case_(the_case), solution_(solution) {
    const std::string line = "stroke=\"#1f6fb4\"";  // of one alone
    for (const char* const name : {"x [m]", "y [m]", "z [m]"}) {
      result_.panels.push_back({name, {}});
    }
    result_.panels.resize(axes);
    result_.panels.push_back({in_space ? "turned from the start [rad]" : "angle [rad]", {}});
    const std::size_t bodies = bodies_of(case_.initial).size();
    for (std::size_t index = 0; index < bodies; ++index) {
      for (Panel& panel : result_.panels) {
        panel.curves.push_back({bodies == 1 ? line : line_look(index, index), {}});
      }
    }
    result_.panels.push_back({"gap [m]", {}});
    result_.panels.push_back({"tension [N]", {}});
    for (std::size_t index = 0; index < case_.cables.size(); ++index) {
      result_.panels[gaps].curves.push_back({cable_lines.at(index), {}});
      result_.panels[tensions].curves.push_back({cable_lines.at(index), {}});
    }
    if (in_space) {
      result_.panels.push_back({"energy [J]", {{line, {}}}});
    }
  }

  Curves gather() {
    const auto& arcs = solution_.arcs();
    const double end = solution_.end_time();
    for (const Arc& arc : arcs) {
      // what bends shows within an arc, what takes long needs points on its way
      constexpr double bends = 6.0;
      const double length = arc.end - arc.start;
      const double pixels = end > 0.0 ? length / end * panel_width : 0.0;
      const int parts = static_cast<int>(std::clamp(pixels, bends, panel_width));
      for (int k = 0; k <= parts && (k == 0 || length > 0.0); ++k) {
        // what is cut at the end of an arc pulls up to there
        constexpr double before_end = TheCase::has_several_bodies ? 1.0 - 1e-9 : 1.0;  // [-]
        const double dt = k == parts ? length * before_end : length * k / parts;
        add(arc.start + dt, arc.after(dt, solution_.gravity()), arc.taut,
            solution_.tensions(arc, dt));
      }
    }
    add_repeated(end);
    return std::move(result_);
  }

 private:
  /// What follows the arcs, where those of one period represent all.
  void add_repeated(double end) {
    const double known = solution_.arcs().back().end;
    const auto& repetition = solution_.repetition();
    if (!repetition || !(known < end)) {
      return;
    }
    constexpr double in_a_period = 24.0;
    constexpr double most = 60'000.0;
    const double count =
        std::min(most, std::ceil((end - known) / repetition->period * in_a_period));
    for (double k = 1.0; k <= count; ++k) {
      const double time = std::min(end, known + (end - known) * k / count);
      add(time, solution_.at(time), solution_.arcs().back().taut, solution_.tensions(time));
    }
  }

  void add(double time, const State& state, CableSet taut, const CableVector& pulls) {
    result_.times.push_back(time);
    const auto& start = bodies_of(case_.initial);
    std::size_t place = 0;
    for (const auto& body : bodies_of(state)) {
      for (std::size_t axis = 0; axis < axes; ++axis) {
        add(axis, place, body.position[static_cast<Eigen::Index>(axis)]);
      }
      add(turns, place, turned(body, start[place]));
      ++place;
    }
    for (std::size_t index = 0; index < case_.cables.size(); ++index) {
      add(gaps, index, taut.contains(index) ? 0.0 : gap(case_.cables[index], state));
      add(tensions, index, pulls[static_cast<Eigen::Index>(index)]);
    }
    if constexpr (in_space) {
      add(energies, 0, energy(case_, state));
    }
  }
  void add(std::size_t panel, std::size_t curve, double value) {
    result_.panels[panel].curves[curve].values.push_back(value);
  }

  const TheCase& case_;
  const BasicSolution<TheCase>& solution_;
  Curves result_;
};

/// The instants of the fastest impacts.
template <class TheCase>
std::vector<double> impact_times(const TheCase& the_case, const BasicSolution<TheCase>& solution) {
  auto marks = impact_marks(the_case, solution);
  marks.erase(marks.begin() + static_cast<std::ptrdiff_t>(std::min(marks.size(), marked_impacts)),
              marks.end());
  std::vector<double> result = listed(marks, [](const auto& mark) { return mark.time; });
  std::sort(result.begin(), result.end());
  return result;
}

/// Names the lines of `drawn` impacts: all of them, or the fastest ones.
std::string words_on_marks(std::size_t drawn) {
  return drawn == 0               ? "no impacts"
         : drawn < marked_impacts ? "a thin line marks an impact"
                                  : fmt::format("lines: {} fastest impacts", marked_impacts);
}

/// A panel on the sheet.
class DrawnPanel {
 public:
  DrawnPanel(const Panel& panel, const std::vector<double>& times, double end, double from_top)
      : panel_(panel), times_(times), end_(end), top_(from_top) {
    bool any = false;
    for (const Curve& curve : panel.curves) {
      for (const double value : curve.values) {
        if (std::isfinite(value)) {
          low_ = any ? std::min(low_, value) : value;
          high_ = any ? std::max(high_, value) : value;
          any = true;
        }
      }
    }
    // values that differ by rounding alone are one
    const double scale = std::max(std::abs(low_), std::abs(high_));
    constexpr double thinnest = 1e-9;  // [-]
    const double size = high_ - low_;
    const double missing = size > thinnest * scale && size > 0.0 ? 0.0 : scale > 0.0 ? scale : 1.0;
    constexpr double margin = 0.08;  // [-]
    const double more = margin * (size + missing) + 0.5 * missing;
    low_ -= more;
    high_ += more;
  }

  [[nodiscard]] std::string text(const std::vector<double>& impacts, bool last) const {
    std::string out = axes(last);
    std::string marks;
    for (const double time : impacts) {
      marks += fmt::format("M{:.1f} {:.1f}v{:.1f}", px(time), top_, panel_height);
    }
    if (!marks.empty()) {
      out += "<path class=\"impact\" style=\"stroke-width:.6;opacity:.35\" d=\"" + marks + "\"/>\n";
    }
    for (const Curve& curve : panel_.curves) {
      out += "<path fill=\"none\" stroke-width=\"1.3\" " + curve.line + " d=\"" + line(curve) +
             "\"/>\n";
    }
    return out;
  }

 private:
  [[nodiscard]] double px(double time) const {
    return panel_left + (end_ > 0.0 ? panel_width * time / end_ : 0.0);
  }
  [[nodiscard]] double py(double value) const {
    return top_ + panel_height * (1.0 - (value - low_) / (high_ - low_));
  }

  [[nodiscard]] std::string axes(bool last) const {
    const double below = top_ + panel_height;
    std::string out;
    for (const double time : ticks(0.0, end_ > 0.0 ? end_ : 1.0)) {
      out += grid_down(px(time), top_, panel_height) + "\n";
      if (last) {
        out += muted_text(px(time), below + 18.0, fmt::format("{:.6g}", time), "middle");
      }
    }
    for (const double value : ticks(low_, high_ - low_)) {
      out += grid_across(panel_left, py(value), panel_width, fmt::format("{:.6g}", value));
    }
    out += rectangle(frame_look, panel_left, top_, panel_width, panel_height) +
           fmt::format("\n<text x=\"{:.1f}\" y=\"{:.1f}\">{}</text>\n", panel_left, top_ - 6.0,
                       panel_.name);
    if (last) {
      out += fmt::format("<text text-anchor=\"middle\" x=\"{:.1f}\" y=\"{:.1f}\">t [s]</text>\n",
                         panel_left + 0.5 * panel_width, below + 38.0);
    }
    return out;
  }

  /// Of the points within one pixel the first, the least, the largest and the last.
  [[nodiscard]] std::string line(const Curve& curve) const {
    std::string out;
    const auto point = [&](std::size_t k) { add_point(out, px(times_[k]), py(curve.values[k])); };
    for (std::size_t first = 0; first < times_.size();) {
      const double pixel = std::floor(px(times_[first]));
      std::size_t least = first;
      std::size_t largest = first;
      std::size_t next = first;
      bool finite = true;
      for (; next < times_.size() && std::floor(px(times_[next])) == pixel; ++next) {
        finite = finite && std::isfinite(curve.values[next]);
        least = curve.values[next] < curve.values[least] ? next : least;
        largest = curve.values[next] > curve.values[largest] ? next : largest;
      }
      std::array<std::size_t, 4> chosen = {first, least, largest, next - 1};
      std::sort(chosen.begin(), chosen.end());
      const auto end = std::unique(chosen.begin(), chosen.end());
      if (finite) {
        std::for_each(chosen.begin(), end, point);
      }
      first = next;
    }
    return out;
  }

  const Panel& panel_;
  const std::vector<double>& times_;
  double end_;  // [s]
  double top_;  // [px]
  double low_ = 0.0;
  double high_ = 0.0;
};

/// Which line is which cable.
std::string cable_legend(std::size_t cables, double y) {
  std::string out;
  constexpr double step = 78.0;  // [px]
  for (std::size_t index = 0; index < cables; ++index) {
    const double x = panel_left + step * static_cast<double>(index);
    out += fmt::format(
        "<path fill=\"none\" stroke-width=\"1.6\" {} d=\"M{:.1f} {:.1f}h22\"/><text x=\"{:.1f}\" "
        "y=\"{:.1f}\">cable {}</text>\n",
        cable_lines.at(index), x, y, x + 26.0, y + 4.0, index);
  }
  return out;
}

/// The panels below each other, with more words below the title; what is drawn `below` them is
/// `more` high [px].
template <class TheCase>
std::string panels_over_time(const TheCase& the_case, const BasicSolution<TheCase>& solution,
                             const std::string& more_words,
                             const std::function<std::string(double)>& below, double more) {
  constexpr std::size_t longest_title = 64;  // [bytes]
  const Curves curves = Gatherer(the_case, solution).gather();
  const std::vector<double> impacts = impact_times(the_case, solution);
  const auto panels = static_cast<double>(curves.panels.size());
  const double bottom = motion_top + panels * panel_height + (panels - 1.0) * between_panels;
  std::string drawn;
  double from_top = motion_top;
  for (std::size_t index = 0; index < curves.panels.size(); ++index) {
    const bool last = index + 1 == curves.panels.size();
    drawn += DrawnPanel(curves.panels[index], curves.times, solution.end_time(), from_top)
                 .text(impacts, last);
    from_top += panel_height + between_panels;
  }
  const std::string words =
      fmt::format("t = 0 to {:.6g} s; {}{}{}", solution.end_time(), words_on_marks(impacts.size()),
                  contact_words(the_case, solution), more_words);
  return svg_sheet(
      {.width = motion_width,
       .height = bottom + 92.0 + more,
       .left = panel_left,
       .title = printable(the_case.name, longest_title),
       .description = fmt::format(
           "Exact motion over time: position, angle, gaps{}, {}.",
           dimensions_of<TheCase> == 3 ? ", tensions and energy" : " and tensions", words),
       .line = words},
      drawn + cable_legend(the_case.cables.size(), bottom + 66.0) + below(bottom + 66.0));
}

}  // namespace

std::string plot_motion_svg(const Case& the_case, const Solution& solution) {
  return panels_over_time(
      the_case, solution, "", [](double) { return std::string(); }, 0.0);
}

template <int D>
static std::string over_time(const BasicSystemMotion<D>& motion) {
  LegendRows rows(0.0);
  const auto& bodies = motion.system.bodies;
  for (std::size_t index = 0; bodies.size() > 1 && index < bodies.size(); ++index) {
    rows.add("<path stroke-width=\"1.6\" " + line_look(index, index) + " d=\"M0 0h26\"/>",
             body_name(bodies[index].name, index));
  }
  return panels_over_time(
      motion.system, motion.solution, horizon_words(motion.horizon),
      [&](double y) {
        return fmt::format("<g transform=\"translate(0 {:.1f})\">{}</g>\n", y, rows.drawn());
      },
      rows.bottom());
}
std::string plot_motion_svg(const SystemMotion& motion) { return over_time(motion); }
std::string plot_motion_svg(const SpatialMotion& motion) { return over_time(motion); }

template <int D>
TensionPanel tension_panel(const BasicSystemMotion<D>& motion, double top) {
  using Gathering = Gatherer<BasicSystem<double, D>>;
  Curves curves = Gathering(motion.system, motion.solution).gather();
  Panel& panel = curves.panels[Gathering::tensions];
  const std::vector<double> impacts = impact_times(motion.system, motion.solution);
  const CableUse* most = nullptr;
  for (const CableUse& use : motion.settling.cables) {
    if (use.tension && (most == nullptr || use.tension->value > most->tension->value)) {
      most = &use;
    }
  }
  panel.name +=
      (most != nullptr && most->tension->value > 0.0
           ? fmt::format("; largest {:.5g} on cable {} at t = {:.4g} s", most->tension->value,
                         most - motion.settling.cables.data(), most->tension->time)
           : std::string("; zero except in impacts")) +
      "; " + words_on_marks(impacts.size());
  const double bottom = top + panel_height;
  return {DrawnPanel(panel, curves.times, motion.solution.end_time(), top).text(impacts, true) +
              cable_legend(motion.system.cables.size(), bottom + 66.0),
          bottom + 92.0};
}
template TensionPanel tension_panel(const SystemMotion&, double);
template TensionPanel tension_panel(const SpatialMotion&, double);

}  // namespace tautline::bench
