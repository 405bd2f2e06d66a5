// Draws the picture of one motion. Words, dashes and shapes say everything that colours say.

#include <fmt/format.h>

#include <algorithm>
#include <array>

#include "bench/base/text.hpp"
#include "bench/plot/motion.hpp"
#include "bench/plot/svg.hpp"
#include "tautline/geometry.hpp"

namespace tautline::bench {
namespace {

// The sheet [px].
constexpr double right_margin = 20.0;
constexpr double first_top = 64.0;
constexpr double below_panels = 92.0;
constexpr double between_views = 84.0;
constexpr double narrowest = 560.0;   // [px]
constexpr double legend_end = 388.0;  // [px], of the words left of the scale bar

/// The motion has a panel of its own where it fills less of the whole than this [-].
constexpr double enlarged_below = 0.33;

// Of a panel [px].
constexpr double widest = 636.0;  // of a sheet of 720
constexpr double tallest = 900.0;

/// One view of a motion: axes, cables, bodies and impacts.
class PlotPanel {
 public:
  /// Which part of the motion a panel shows: one that is enlarged takes the crowd of impacts.
  enum class Kind { all, whole, enlarged };

  /// Shows the part `view` of the world, below `top` [px] on the sheet. `motion` must outlive it.
  PlotPanel(const PlotMotion& motion, const Extent& view, double top)
      : motion_(motion),
        view_(view),
        top_(top),
        scale_(std::min(widest / view.size().x(), tallest / view.size().y())),
        width_(scale_ * view.size().x()),
        height_(scale_ * view.size().y()) {}

  [[nodiscard]] std::string text(Kind kind) const {
    const Case& the_case = motion_.the_case;
    const auto& arcs = motion_.solution.arcs();
    std::string out = axes(kind) + cables(the_case.initial, arcs.front().taut, "cable before");
    if (kind != Kind::whole) {
      for (std::size_t index = std::min(faint_bodies, motion_.marks.size()); index-- > 0;) {
        out += body(motion_.marks[index].pose, "faint");
      }
    }
    out += cables(motion_.end, arcs.back().taut, "cable");
    out += body(the_case.initial, "start") + body(motion_.end, "end") + anchors();
    out += path();  // over the bodies: it runs inside them
    if (kind != Kind::whole) {
      const bool start_above = the_case.initial.position.y() > motion_.end.position.y();
      out += impacts() + label(the_case.initial, start_above ? -14.0 : 24.0, "start") +
             label(motion_.end, start_above ? 24.0 : -14.0, "end");
    }
    return out + "</g>\n";
  }

  /// A dotted frame around `part`.
  [[nodiscard]] std::string frame(const Extent& part) const {
    const Vec2 low = part.low();
    const Vec2 high = low + part.size();
    return rectangle("class=\"frame\" stroke-dasharray=\"2 3\" ", px(low), py(high),
                     px(high) - px(low), py(low) - py(high)) +
           "\n";
  }

  /// Where the last number of the x axis ends [px].
  [[nodiscard]] double labels_end() const {
    double end = panel_left + width_;
    for (const double x : ticks(view_.low().x(), view_.size().x())) {
      end = std::max(end, px({x, 0.0}) + 0.5 * room_for(fmt::format("{:.6g}", x), letters));
    }
    return end;
  }

  [[nodiscard]] double top() const { return top_; }
  [[nodiscard]] double bottom() const { return top_ + height_; }
  [[nodiscard]] double scale() const { return scale_; }  // [px/m]
  [[nodiscard]] const Extent& view() const { return view_; }

 private:
  [[nodiscard]] double px(const Vec2& point) const {
    return panel_left + scale_ * (point.x() - view_.low().x());
  }

  [[nodiscard]] double py(const Vec2& point) const {
    return top_ + height_ - scale_ * (point.y() - view_.low().y());
  }

  /// The grid, its numbers and the frame; opens the group that the frame clips.
  [[nodiscard]] std::string axes(Kind kind) const {
    constexpr std::array names = {"all", "whole", "enlarged"};
    std::string out;
    for (const double x : ticks(view_.low().x(), view_.size().x())) {
      out += grid_down(px({x, 0.0}), top_, height_) +
             muted_text(px({x, 0.0}), bottom() + 18.0, fmt::format("{:.6g}", x), "middle");
    }
    for (const double y : ticks(view_.low().y(), view_.size().y())) {
      out += grid_across(panel_left, py({0.0, y}), width_, fmt::format("{:.6g}", y));
    }
    return out + rectangle(frame_look, panel_left, top_, width_, height_) +
           fmt::format(
               "\n<text text-anchor=\"middle\" x=\"{0:.1f}\" y=\"{1:.1f}\">x [m]</text>\n<text "
               "text-anchor=\"middle\" transform=\"translate(14 {2:.1f}) rotate(-90)\">y "
               "[m]</text>\n<clipPath id=\"{4}\">{3}</clipPath>\n<g clip-path=\"url(#{4})\">\n",
               panel_left + 0.5 * width_, bottom() + 38.0, top_ + 0.5 * height_,
               rectangle("", panel_left, top_, width_, height_),
               names.at(static_cast<std::size_t>(kind)));
  }

  [[nodiscard]] std::string cables(const State& state, CableSet taut, const char* kind) const {
    std::string out;
    for (std::size_t index = 0; index < motion_.the_case.cables.size(); ++index) {
      const Cable& cable = motion_.the_case.cables[index];
      const Vec2 end = attachment_point(state, cable);
      const bool is_taut = taut.contains(index) || gap(cable, state) <= gap_rounding * cable.length;
      // the control point of a parabola lies twice as deep as its vertex
      const Vec2 control =
          2.0 * lowest_point(motion_.the_case, cable, state) - 0.5 * (cable.anchor + end);
      out += fmt::format("<path class=\"{}{}\" d=\"M{:.1f} {:.1f}", kind, is_taut ? "" : " slack",
                         px(cable.anchor), py(cable.anchor));
      out += is_taut ? fmt::format("L{:.1f} {:.1f}\"/>\n", px(end), py(end))
                     : fmt::format("Q{:.1f} {:.1f} {:.1f} {:.1f}\"/>\n", px(control), py(control),
                                   px(end), py(end));
    }
    return out;
  }

  /// The body as the hull of its centre and attachments; a bar where those lie on one line.
  [[nodiscard]] std::string body(const State& state, const char* kind) const {
    std::vector<Vec2> points = {state.position};
    for (const Cable& cable : motion_.the_case.cables) {
      points.push_back(attachment_point(state, cable));
    }
    const std::vector<Vec2> hull = convex_hull(points);
    std::string line;
    for (const Vec2& point : hull) {
      add_point(line, px(point), py(point));
    }
    std::string out = fmt::format("<g class=\"{}\">", kind);
    out += hull.size() > 2 ? "<path class=\"body\" d=\"" + line + "Z\"/>"
                           : "<path class=\"bar\" d=\"" + line + "\"/><path class=\"core\" d=\"" +
                                 line + "\"/>";
    out += fmt::format("<circle class=\"centre\" cx=\"{:.1f}\" cy=\"{:.1f}\" r=\"2.5\"/></g>\n",
                       px(state.position), py(state.position));
    return out;
  }

  [[nodiscard]] std::string anchors() const {
    std::string out;
    for (const Cable& cable : motion_.the_case.cables) {
      const double x = px(cable.anchor);
      const double y = py(cable.anchor);
      out += fmt::format(
          "<rect class=\"anchor\" x=\"{:.1f}\" y=\"{:.1f}\" width=\"8\" "
          "height=\"8\"/>\n",
          x - 4.0, y - 4.0);
    }
    return out;
  }

  [[nodiscard]] std::string path() const {
    std::string line;
    for (const Vec2& point : motion_.path) {
      if (point.allFinite()) {
        add_point(line, px(point), py(point));
      }
    }
    return "<path class=\"path\" d=\"" + line + "\"/>\n";
  }

  [[nodiscard]] std::string impacts() const {
    std::string out;
    for (std::size_t index = 0; index < std::min(marked_impacts, motion_.marks.size()); ++index) {
      const Vec2& at = motion_.marks[index].pose.position;
      out += fmt::format("<circle class=\"impact\" cx=\"{:.1f}\" cy=\"{:.1f}\" r=\"2.5\"/>\n",
                         px(at), py(at));
    }
    return out;
  }

  /// A word below a body, away from the other one.
  [[nodiscard]] std::string label(const State& state, double dy, const char* word) const {
    const double x = std::clamp(px(state.position), panel_left + 24.0, panel_left + width_ - 24.0);
    const double y = std::clamp(py(state.position) + dy, top_ + 16.0, top_ + height_ - 8.0);
    return fmt::format(
        "<text class=\"halo\" text-anchor=\"middle\" x=\"{:.1f}\" "
        "y=\"{:.1f}\">{}</text>\n",
        x, y, word);
  }

  const PlotMotion& motion_;
  Extent view_;
  double top_;     // [px]
  double scale_;   // [px/m]
  double width_;   // [px]
  double height_;  // [px]
};

/// The length of the scale bar [m] and its label.
struct ScaleBar {
  explicit ScaleBar(const PlotPanel& panel)
      : length(round_below(0.25 * panel.view().size().x())),
        label(fmt::format("{:g} m", length)),
        width(panel.scale() * length) {}
  [[nodiscard]] double text_start() const { return panel_left + legend_end + width; }

  double length;      // [m]
  std::string label;  //
  double width;       // [px]
};

/// How the motion ends, after "ends".
std::string ending_words(const Solution& solution) {
  switch (solution.ending()) {
    case Ending::reached_duration:
      return "at its duration";
    case Ending::rest:
      return "at rest";
    case Ending::unstable_rest:
      return "at an unstable equilibrium";
    case Ending::locked:
      return "locked";
    case Ending::angle_limit:
      return "at the angle limit";
    case Ending::ceiling:
      return "at the ceiling";
    default:
      return std::string(to_string(solution.ending()));
  }
}

/// The words below the title.
std::string heading_of(const PlotMotion& motion) {
  return fmt::format("t = 0 to {:.6g} s, {} impact{}, ends {}{}", motion.solution.end_time(),
                     motion.marks.size(), motion.marks.size() == 1 ? "" : "s",
                     ending_words(motion.solution),
                     motion.path_end < motion.solution.end_time()
                         ? fmt::format("; path to t = {:.6g} s", motion.path_end)
                         : "");
}

/// What the lines mean, and the scale bar of the last panel.
std::string legend(const PlotPanel& panel, double y) {
  const ScaleBar bar(panel);
  return fmt::format(
      "<path class=\"path\" d=\"M{0} {1:.1f}h26\"/><text x=\"{2}\" y=\"{3:.1f}\">centre of "
      "mass</text>\n<path class=\"cable\" d=\"M{4} {1:.1f}h26\"/><text x=\"{5}\" "
      "y=\"{3:.1f}\">taut</text>\n<path class=\"cable slack\" d=\"M{6} {1:.1f}h30\"/><text "
      "x=\"{7}\" y=\"{3:.1f}\">slack</text>\n<circle class=\"impact\" cx=\"{8}\" "
      "cy=\"{1:.1f}\" r=\"3\"/><text x=\"{9}\" y=\"{3:.1f}\">impact</text>\n<path "
      "class=\"scale\" d=\"M{10} {11:.1f}v8m0-4h{12:.1f}m0-4v8\"/><text x=\"{13:.1f}\" "
      "y=\"{3:.1f}\">{14}</text>\n",
      panel_left, y, panel_left + 32.0, y + 4.0, panel_left + 140.0, panel_left + 172.0,
      panel_left + 214.0, panel_left + 250.0, panel_left + 304.0, panel_left + 313.0,
      panel_left + legend_end - 8.0, y - 4.0, bar.width, bar.text_start(), bar.label);
}

/// The sheet around its panels, of which `last` is the lowest; they need `panels_end` [px].
std::string sheet(const PlotMotion& motion, const std::string& panels, const PlotPanel& last,
                  double panels_end) {
  constexpr std::size_t longest_title = 64;  // [bytes]
  const std::string name = printable(motion.the_case.name, longest_title);
  const std::string words = heading_of(motion);
  const ScaleBar bar(last);
  const double end =
      std::max({panels_end, bar.text_start() + room_for(bar.label, letters),
                panel_left + room_for(name, title_letters), panel_left + room_for(words, letters)});
  const std::size_t cables = motion.the_case.cables.size();
  return svg_sheet({.width = std::max(end + right_margin, narrowest),
                    .height = last.bottom() + below_panels,
                    .left = panel_left,
                    .title = name,
                    .description = fmt::format("Exact motion of a body on {} cable{}: {}.", cables,
                                               cables == 1 ? "" : "s", words),
                    .line = words},
                   panels + legend(last, last.bottom() + 68.0));
}

}  // namespace

std::string plot_svg(const Case& the_case, const Solution& solution) {
  const PlotMotion motion = plot_motion(the_case, solution);
  const Extent all = extent_of_all(motion).with_margin();
  const Extent bodies = extent_of_bodies(motion).with_margin();
  const PlotPanel whole(motion, all, first_top);
  const bool enlarge = bodies.size().maxCoeff() < enlarged_below * all.size().maxCoeff();
  if (!enlarge) {
    return sheet(motion, whole.text(PlotPanel::Kind::all), whole, whole.labels_end());
  }
  const PlotPanel enlarged(motion, bodies, whole.bottom() + between_views);
  const std::string panels =
      whole.text(PlotPanel::Kind::whole) + whole.frame(bodies) +
      muted_text(panel_left, enlarged.top() - 10.0, "the dotted part, enlarged") +
      enlarged.text(PlotPanel::Kind::enlarged);
  return sheet(motion, panels, enlarged, std::max(whole.labels_end(), enlarged.labels_end()));
}

}  // namespace tautline::bench
