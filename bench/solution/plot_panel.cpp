#include "bench/solution/plot_panel.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cstddef>
#include <vector>

#include "bench/base/table.hpp"
#include "tautline/geometry.hpp"

namespace tautline::bench {
namespace {

constexpr double widest = 636.0;   // [px], of a sheet of 720
constexpr double tallest = 900.0;  // [px]

const char* name_of(PlotPanel::Kind kind) {
  constexpr std::array names = {"all", "whole", "enlarged"};
  return names.at(static_cast<std::size_t>(kind));
}

}  // namespace

double room_for(const std::string& text, double size) {
  constexpr double width_of_a_letter = 0.66;  // [-] of its size: bold letters and digits
  return width_of_a_letter * size * static_cast<double>(terminal_width(text));
}

PlotPanel::PlotPanel(const PlotMotion& motion, const Extent& view, double top)
    : motion_(motion),
      view_(view),
      top_(top),
      scale_(std::min(widest / view.size().x(), tallest / view.size().y())),
      width_(scale_ * view.size().x()),
      height_(scale_ * view.size().y()) {}

std::string PlotPanel::text(Kind kind) const {
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

std::string PlotPanel::frame(const Extent& part) const {
  const Vec2 low = part.low();
  const Vec2 high = low + part.size();
  return fmt::format(
      "<rect class=\"frame\" stroke-dasharray=\"2 3\" x=\"{:.1f}\" y=\"{:.1f}\" "
      "width=\"{:.1f}\" height=\"{:.1f}\"/>\n",
      px(low), py(high), px(high) - px(low), py(low) - py(high));
}

double PlotPanel::labels_end() const {
  double end = panel_left + width_;
  for (const double x : ticks(view_.low().x(), view_.size().x())) {
    end = std::max(end, px({x, 0.0}) + 0.5 * room_for(fmt::format("{:.6g}", x), letters));
  }
  return end;
}

double PlotPanel::px(const Vec2& point) const {
  return panel_left + scale_ * (point.x() - view_.low().x());
}

double PlotPanel::py(const Vec2& point) const {
  return top_ + height_ - scale_ * (point.y() - view_.low().y());
}

/// The grid, its numbers and the frame; opens the group that the frame clips.
std::string PlotPanel::axes(Kind kind) const {
  std::string out;
  for (const double x : ticks(view_.low().x(), view_.size().x())) {
    out += fmt::format(
        "<path class=\"grid\" d=\"M{0:.1f} {1:.1f}v{2:.1f}\"/><text class=\"muted\" "
        "text-anchor=\"middle\" x=\"{0:.1f}\" y=\"{3:.1f}\">{4:.6g}</text>\n",
        px({x, 0.0}), top_, height_, top_ + height_ + 18.0, x);
  }
  for (const double y : ticks(view_.low().y(), view_.size().y())) {
    const double at = py({0.0, y});
    const std::string number = fmt::format("{:.6g}", y);
    // a longer number is set narrower: it must not leave the sheet
    constexpr double room = panel_left - 12.0;
    const std::string narrower =
        room_for(number, letters) > room
            ? fmt::format("textLength=\"{}\" lengthAdjust=\"spacingAndGlyphs\" ", room)
            : "";
    out += fmt::format(
        "<path class=\"grid\" d=\"M{0:.1f} {1:.1f}h{2:.1f}\"/><text class=\"muted\" "
        "text-anchor=\"end\" {6}x=\"{3:.1f}\" y=\"{4:.1f}\">{5}</text>\n",
        panel_left, at, width_, panel_left - 6.0, at + 4.0, number, narrower);
  }
  const std::string frame = fmt::format(
      "x=\"{:.1f}\" y=\"{:.1f}\" width=\"{:.1f}\" "
      "height=\"{:.1f}\"/>",
      panel_left, top_, width_, height_);
  return out +
         fmt::format(
             "<rect class=\"frame\" {0}\n<text text-anchor=\"middle\" x=\"{1:.1f}\" "
             "y=\"{2:.1f}\">x [m]</text>\n<text text-anchor=\"middle\" transform=\"translate(14 "
             "{3:.1f}) rotate(-90)\">y [m]</text>\n<clipPath id=\"{4}\"><rect "
             "{0}</clipPath>\n<g clip-path=\"url(#{4})\">\n",
             frame, panel_left + 0.5 * width_, top_ + height_ + 38.0, top_ + 0.5 * height_,
             name_of(kind));
}

std::string PlotPanel::cables(const State& state, CableSet taut, const char* kind) const {
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
std::string PlotPanel::body(const State& state, const char* kind) const {
  std::vector<Vec2> points = {state.position};
  for (const Cable& cable : motion_.the_case.cables) {
    points.push_back(attachment_point(state, cable));
  }
  const std::vector<Vec2> hull = convex_hull(points);
  std::string line;
  for (const Vec2& point : hull) {
    line += fmt::format("{}{:.1f} {:.1f}", line.empty() ? 'M' : 'L', px(point), py(point));
  }
  std::string out = fmt::format("<g class=\"{}\">", kind);
  out += hull.size() > 2
             ? "<path class=\"body\" d=\"" + line + "Z\"/>"
             : "<path class=\"bar\" d=\"" + line + "\"/><path class=\"core\" d=\"" + line + "\"/>";
  out += fmt::format("<circle class=\"centre\" cx=\"{:.1f}\" cy=\"{:.1f}\" r=\"2.5\"/></g>\n",
                     px(state.position), py(state.position));
  return out;
}

std::string PlotPanel::anchors() const {
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

std::string PlotPanel::path() const {
  std::string out = "<path class=\"path\" d=\"";
  char move = 'M';
  for (const Vec2& point : motion_.path) {
    if (point.allFinite()) {
      out += fmt::format("{}{:.1f} {:.1f}", move, px(point), py(point));
      move = 'L';
    }
  }
  out += "\"/>\n";
  return out;
}

std::string PlotPanel::impacts() const {
  std::string out;
  for (std::size_t index = 0; index < std::min(marked_impacts, motion_.marks.size()); ++index) {
    const Vec2& at = motion_.marks[index].pose.position;
    out += fmt::format("<circle class=\"impact\" cx=\"{:.1f}\" cy=\"{:.1f}\" r=\"2.5\"/>\n", px(at),
                       py(at));
  }
  return out;
}

/// A word below a body, away from the other one.
std::string PlotPanel::label(const State& state, double dy, const char* word) const {
  const double x = std::clamp(px(state.position), panel_left + 24.0, panel_left + width_ - 24.0);
  const double y = std::clamp(py(state.position) + dy, top_ + 16.0, top_ + height_ - 8.0);
  return fmt::format(
      "<text class=\"halo\" text-anchor=\"middle\" x=\"{:.1f}\" "
      "y=\"{:.1f}\">{}</text>\n",
      x, y, word);
}

}  // namespace tautline::bench
