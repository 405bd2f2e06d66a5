// Draws the picture of one motion. Words, dashes and shapes say everything that colours say.

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <utility>

#include "bench/base/text.hpp"
#include "bench/plot/motion.hpp"
#include "bench/plot/svg.hpp"

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
constexpr double widest = panel_width;  // of a sheet of 720
constexpr double tallest = 900.0;

/// The looks that a picture of a system adds: of cables by their state, and of ends that move.
constexpr const char* system_style = R"(<style>
.path{stroke-width:1.6}.cable{stroke-width:3}.slack{stroke:#8a8a8a;stroke-width:1.6}
.moving{fill:none;stroke:#8a4fb0;stroke-width:1.6}
.ring{fill:#fff;stroke:#1a1a1a;stroke-width:1.8}
@media (prefers-color-scheme:dark){.moving{stroke:#c79be8}.ring{fill:#16181c;stroke:#eee}}
</style>
)";

std::string anchor_at(double x, double y) {
  return fmt::format(
      "<rect class=\"anchor\" x=\"{:.1f}\" y=\"{:.1f}\" width=\"8\" height=\"8\"/>\n", x - 4.0,
      y - 4.0);
}

std::string ring_at(double x, double y) {
  return fmt::format("<circle class=\"ring\" cx=\"{:.1f}\" cy=\"{:.1f}\" r=\"4.5\"/>\n", x, y);
}

/// The colour of a body, and the dashes of its path, as a style.
std::string style_of(std::size_t body, bool path) {
  return fmt::format(
      " style=\"stroke:{}{}\"", line_colours[body % line_colours.size()],
      path ? fmt::format(";stroke-dasharray:{}", line_dashes[body % line_dashes.size()]) : "");
}

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
    std::string out = axes(kind) + cables(motion_.start, "cable before");
    if (kind != Kind::whole) {
      for (std::size_t index = motion_.fastest.size(); index-- > 0;) {
        out += bodies(motion_.fastest[index], "faint");
      }
    }
    out += cables(motion_.end, "cable");
    out += bodies(motion_.start, "start") + bodies(motion_.end, "end") + anchors();
    out += paths() + moving_ends();  // over the bodies: they run inside them
    if (kind != Kind::whole) {
      out += impacts() + (motion_.bodies.empty() ? start_and_end() : "") +
             (motion_.numbers_cables ? cable_numbers() : "");
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

  [[nodiscard]] std::string cables(const Pose& pose, const char* kind) const {
    std::string out;
    for (const DrawnCable& cable : pose.cables) {
      out +=
          fmt::format("<path class=\"{}{}\" d=\"M{:.1f} {:.1f}", kind, cable.taut ? "" : " slack",
                      px(cable.points.front()), py(cable.points.front()));
      each_part(cable, [&](const Vec2& from, const Vec2& to, double length) {
        // the control point of a parabola lies twice as deep as its vertex
        const Vec2 control = 2.0 * lowest_point(from, to, length, motion_.down) - 0.5 * (from + to);
        out += cable.taut ? fmt::format("L{:.1f} {:.1f}", px(to), py(to))
                          : fmt::format("Q{:.1f} {:.1f} {:.1f} {:.1f}", px(control), py(control),
                                        px(to), py(to));
      });
      out += "\"/>\n";
    }
    return out;
  }

  /// The style of body `index`; "" of one alone.
  [[nodiscard]] std::string look(std::size_t index, bool path) const {
    return motion_.bodies.empty() ? "" : style_of(index, path);
  }

  [[nodiscard]] std::string bodies(const Pose& pose, const char* kind) const {
    std::string out;
    for (std::size_t index = 0; index < pose.bodies.size(); ++index) {
      out += body(pose.bodies[index], kind, look(index, false));
    }
    return out;
  }

  /// A body as the hull of its centre and attachments; a bar where those lie on one line, and a dot
  /// where they are one point.
  [[nodiscard]] std::string body(const DrawnBody& drawn, const char* kind,
                                 const std::string& look) const {
    std::vector<Vec2> points = {drawn.centre};
    points.insert(points.end(), drawn.points.begin(), drawn.points.end());
    const std::vector<Vec2> hull = convex_hull(points);
    std::string line;
    bool dot = !look.empty();
    for (const Vec2& point : hull) {
      add_point(line, px(point), py(point));
      dot = dot && (point - drawn.centre).norm() * scale_ < 0.5;
    }
    std::string out = fmt::format("<g class=\"{}\">", kind);
    if (dot) {
      out += fmt::format("<circle class=\"body\"{} cx=\"{:.1f}\" cy=\"{:.1f}\" r=\"5\"/>", look,
                         px(drawn.centre), py(drawn.centre));
    } else {
      out += hull.size() > 2 ? "<path class=\"body\"" + look + " d=\"" + line + "Z\"/>"
                             : "<path class=\"bar\"" + look + " d=\"" + line +
                                   "\"/><path class=\"core\" d=\"" + line + "\"/>";
    }
    out += fmt::format("<circle class=\"centre\" cx=\"{:.1f}\" cy=\"{:.1f}\" r=\"2.5\"/></g>\n",
                       px(drawn.centre), py(drawn.centre));
    return out;
  }

  [[nodiscard]] std::string anchors() const {
    std::string out;
    for (const Vec2& anchor : motion_.anchors) {
      out += anchor_at(px(anchor), py(anchor));
    }
    for (const Vec2& ring : motion_.rings) {
      out += ring_at(px(ring), py(ring));
    }
    return out;
  }

  /// The points of a path as a line.
  [[nodiscard]] std::string line_of(const std::vector<Vec2>& points) const {
    std::string line;
    for (const Vec2& point : points) {
      if (point.allFinite()) {
        add_point(line, px(point), py(point));
      }
    }
    return line;
  }

  [[nodiscard]] std::string paths() const {
    std::string out;
    for (std::size_t index = 0; index < motion_.paths.size(); ++index) {
      out += "<path class=\"path\"" + look(index, true) + " d=\"" + line_of(motion_.paths[index]) +
             "\"/>\n";
    }
    return out;
  }

  [[nodiscard]] std::string moving_ends() const {
    std::string out;
    for (const std::vector<Vec2>& path : motion_.moving) {
      out += "<path class=\"moving\" d=\"" + line_of(path) + "\"/>\n";
    }
    return out;
  }

  [[nodiscard]] std::string impacts() const {
    std::string out;
    for (std::size_t index = 0; index < std::min(marked_impacts, motion_.marks.size()); ++index) {
      for (const Vec2& at : motion_.marks[index].places) {
        out += fmt::format("<circle class=\"impact\" cx=\"{:.1f}\" cy=\"{:.1f}\" r=\"2.5\"/>\n",
                           px(at), py(at));
      }
    }
    return out;
  }

  /// A word below the only body, away from the other one.
  [[nodiscard]] std::string start_and_end() const {
    const Vec2& start = motion_.start.bodies.front().centre;
    const Vec2& end = motion_.end.bodies.front().centre;
    const bool start_above = start.y() > end.y();
    return label(start, start_above ? -14.0 : 24.0, "start") +
           label(end, start_above ? 24.0 : -14.0, "end");
  }

  /// About the middle of what is seen of each cable at the end; those of one place together.
  [[nodiscard]] std::string cable_numbers() const {
    std::vector<std::pair<Vec2, std::string>> labels;
    const Vec2 high = view_.low() + view_.size();
    for (const DrawnCable& cable : motion_.end.cables) {
      std::vector<Vec2> seen;
      each_part(cable, [&](const Vec2& from, const Vec2& to, double length) {
        const Vec2 hang = lowest_point(from, to, length, motion_.down) - 0.5 * (from + to);
        constexpr int pieces = 40;
        for (int k = 0; k <= pieces; ++k) {
          const double part = static_cast<double>(k) / pieces;
          const Vec2 point = from + part * (to - from) + 4.0 * part * (1.0 - part) * hang;
          if ((point.array() >= view_.low().array() && point.array() <= high.array()).all()) {
            seen.push_back(point);
          }
        }
      });
      if (seen.empty()) {
        continue;
      }
      const Vec2 at = seen[2 * seen.size() / 5];  // and not on a ring
      const auto near = std::find_if(labels.begin(), labels.end(), [&](const auto& one) {
        constexpr double apart = 18.0;  // [px]
        return scale_ * (one.first - at).cwiseAbs().maxCoeff() < apart;
      });
      if (near != labels.end()) {
        near->second += ", " + std::to_string(cable.index);
      } else {
        labels.emplace_back(at, std::to_string(cable.index));
      }
    }
    std::string out;
    for (const auto& [at, word] : labels) {
      out += label(at, 5.0, word);
    }
    return out;
  }

  [[nodiscard]] std::string label(const Vec2& at, double dy, const std::string& word) const {
    const double x = std::clamp(px(at), panel_left + 24.0, panel_left + width_ - 24.0);
    const double y = std::clamp(py(at) + dy, top_ + 16.0, top_ + height_ - 8.0);
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
std::string ending_words(Ending ending) {
  switch (ending) {
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
      return std::string(to_string(ending));
  }
}

/// The words below the title.
std::string heading_of(const PlotMotion& motion) {
  return fmt::format(
      "t = 0 to {:.6g} s, {} impact{}, ends {}{}", motion.end_time, motion.marks.size(),
      motion.marks.size() == 1 ? "" : "s", ending_words(motion.ending),
      motion.path_end < motion.end_time ? fmt::format("; path to t = {:.6g} s", motion.path_end)
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

/// The panels of a sheet; `last` is the lowest.
struct Views {
  std::string drawn;
  PlotPanel last;
  double end;  // [px], where the words next to them end
};

Views views_of(const PlotMotion& motion) {
  const Extent all = extent_of_all(motion).with_margin();
  const Extent bodies = extent_of_bodies(motion).with_margin();
  const PlotPanel whole(motion, all, first_top);
  const bool enlarge = bodies.size().maxCoeff() < enlarged_below * all.size().maxCoeff();
  if (!enlarge) {
    return {whole.text(PlotPanel::Kind::all), whole, whole.labels_end()};
  }
  const PlotPanel enlarged(motion, bodies, whole.bottom() + between_views);
  return {whole.text(PlotPanel::Kind::whole) + whole.frame(bodies) +
              muted_text(panel_left, enlarged.top() - 10.0, "the dotted part, enlarged") +
              enlarged.text(PlotPanel::Kind::enlarged),
          enlarged, std::max(whole.labels_end(), enlarged.labels_end())};
}

/// The sheet around its views, with what is drawn below them.
std::string sheet(const PlotMotion& motion, const Views& views, const std::string& heading,
                  const std::string& below, double height, double least_width) {
  constexpr std::size_t longest_title = 64;  // [bytes]
  const std::string name = printable(motion.name, longest_title);
  const ScaleBar bar(views.last);
  const double end = std::max({views.end, bar.text_start() + room_for(bar.label, letters),
                               panel_left + room_for(name, title_letters),
                               panel_left + room_for(heading, letters)});
  return svg_sheet({.width = std::max(end + right_margin, least_width),
                    .height = height,
                    .left = panel_left,
                    .title = name,
                    .description = "Exact motion of " + motion.subject + ": " + heading + ".",
                    .line = heading},
                   views.drawn + legend(views.last, views.last.bottom() + 68.0) + below);
}

}  // namespace

std::string plot_svg(const Case& the_case, const Solution& solution) {
  const PlotMotion motion = plot_motion(the_case, solution);
  const Views views = views_of(motion);
  return sheet(motion, views, heading_of(motion), "", views.last.bottom() + below_panels,
               narrowest);
}

std::string plot_svg(const SystemMotion& asked) {
  const PlotMotion motion = plot_motion(asked.system, asked.solution);
  const Views views = views_of(motion);
  LegendRows rows(views.last.bottom() + 68.0);
  std::string style = system_style;
  if (!motion.bodies.empty()) {
    style += "<style>.path{stroke:#8a8a8a}</style>\n";  // in the legend: each has its own
    for (std::size_t index = 0; index < motion.bodies.size(); ++index) {
      rows.add("<path class=\"path\"" + style_of(index, true) + " d=\"M0 0h26\"/>",
               motion.bodies[index]);
    }
    rows.add("<g class=\"start\"><circle class=\"body\" cx=\"13\" cy=\"0\" r=\"5\"/></g>", "start");
    rows.add("<circle class=\"body\" cx=\"13\" cy=\"0\" r=\"5\"/>", "end");
  }
  if (!motion.anchors.empty()) {
    rows.add(anchor_at(13.0, 0.0), "anchor");
  }
  if (!motion.moving.empty()) {
    rows.add("<path class=\"moving\" d=\"M0 0h26\"/>", "moving end");
  }
  if (!motion.rings.empty()) {
    rows.add(ring_at(13.0, 0.0), "ring");
  }
  const TensionPanel tensions = tension_panel(asked, rows.bottom() + 52.0);
  return sheet(motion, views, heading_of(motion) + horizon_words(asked),
               style + rows.drawn() + tensions.drawn, tensions.bottom,
               panel_left + widest + right_margin);
}

}  // namespace tautline::bench
