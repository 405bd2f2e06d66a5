// Draws the picture of one motion. Words, dashes and shapes say everything that colours say.

#include "bench/solution/plot_svg.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <vector>

#include "bench/base/text.hpp"
#include "bench/solution/plot_style.hpp"
#include "bench/solution/plot_view.hpp"
#include "tautline/geometry.hpp"

namespace tautline::bench {
namespace {

// The sheet [px].
constexpr double wide = 720.0;
constexpr double tallest = 900.0;
constexpr double left = 64.0;
constexpr double right = 20.0;
constexpr double top = 64.0;
constexpr double bottom = 92.0;
constexpr double between = 84.0;     // two panels
constexpr double narrowest = 560.0;  // what the words below a panel need

/// The motion has a panel of its own where it fills less of the whole than this [-].
constexpr double enlarged_below = 0.33;

constexpr std::size_t path_points = 4000;    // a finer path is not seen
constexpr std::size_t marked_impacts = 400;  // the fastest; more is a smear
constexpr std::size_t faint_bodies = 8;      // at the fastest impacts

/// An impact that is drawn.
struct Mark {
  double speed;  // [m/s], of the fastest closing cable
  State pose;
};

/// Every impact, the fastest first.
std::vector<Mark> marks_of(const Case& the_case, const Solution& solution) {
  std::vector<Mark> marks;
  for (const Event& event : solution.events()) {
    if (event.kind != EventKind::impact) {
      continue;
    }
    double speed = 0.0;
    for (const std::size_t index : event.cables) {
      speed = std::max(speed, -gap_rate(the_case.cables[index], event.before));
    }
    marks.push_back({speed, event.before});
  }
  std::stable_sort(marks.begin(), marks.end(),
                   [](const Mark& a, const Mark& b) { return a.speed > b.speed; });
  return marks;
}

/// Points of the path in rising time: evenly in time, and at the ends of every arc while they fit.
std::vector<Vec2> path_of(const Solution& solution) {
  const double end = solution.end_time();
  std::vector<double> times;
  for (std::size_t index = 0; index <= path_points; ++index) {
    times.push_back(end * static_cast<double>(index) / static_cast<double>(path_points));
  }
  if (solution.arcs().size() <= path_points) {
    for (const Arc& arc : solution.arcs()) {
      times.push_back(std::min(arc.start, end));
    }
  }
  std::sort(times.begin(), times.end());
  std::vector<Vec2> points;
  points.reserve(times.size());
  for (const double time : times) {
    points.emplace_back(solution.at(time).position);
  }
  return points;
}

class Picture {
 public:
  Picture(const Case& the_case, const Solution& solution)
      : case_(the_case),
        solution_(solution),
        path_(path_of(solution)),
        marks_(marks_of(the_case, solution)),
        end_(solution.at(solution.end_time())) {
    std::for_each(path_.begin(), path_.end(), [&](const Vec2& point) { motion_.add(point); });
    for (const Cable& cable : case_.cables) {
      for (const State& state : {case_.initial, end_}) {
        motion_.add(attachment_point(state, cable));
      }
    }
    for (std::size_t index = 0; index < std::min(faint_bodies, marks_.size()); ++index) {
      for (const Cable& cable : case_.cables) {
        motion_.add(attachment_point(marks_[index].pose, cable));
      }
    }
    whole_ = motion_;
    for (const Cable& cable : case_.cables) {
      whole_.add(cable.anchor);
      whole_.add(lowest(cable, case_.initial));
      whole_.add(lowest(cable, end_));
    }
    whole_ = whole_.with_margin();
    motion_ = motion_.with_margin();
  }

  std::string text() {
    const bool enlarge = motion_.size().maxCoeff() < enlarged_below * whole_.size().maxCoeff();
    std::string panels;
    show(whole_, top);
    panels += panel(enlarge ? "whole" : "all");
    double bottom_of_panels = top_ + height_;
    double sheet_width = width_;
    if (enlarge) {
      panels += enlarged_frame();
      show(motion_, bottom_of_panels + between);
      panels += heading() + panel("enlarged");
      bottom_of_panels = top_ + height_;
      sheet_width = std::max(sheet_width, width_);
    }
    const std::string key = legend(bottom_of_panels + 68.0);
    return begin(std::max(sheet_width + left + right, narrowest), bottom_of_panels + bottom) +
           panels + key + "</svg>\n";
  }

 private:
  [[nodiscard]] double px(const Vec2& point) const {
    return left + scale_ * (point.x() - view_.low().x());
  }
  [[nodiscard]] double py(const Vec2& point) const {
    return top_ + height_ - scale_ * (point.y() - view_.low().y());
  }

  /// The unit vector down; where nothing pulls, down on the sheet.
  [[nodiscard]] Vec2 down() const {
    const double size = case_.gravity.norm();
    return size > 0.0 ? Vec2(case_.gravity / size) : Vec2(0.0, -1.0);
  }

  /// The lowest point of a cable that hangs.
  [[nodiscard]] Vec2 lowest(const Cable& cable, const State& state) const {
    const Vec2 end = attachment_point(state, cable);
    return 0.5 * (cable.anchor + end) + sag(cable.length, (end - cable.anchor).norm()) * down();
  }

  /// Makes `view` the world that is seen, below `from` on the sheet.
  void show(const Extent& view, double from) {
    view_ = view;
    top_ = from;
    scale_ = std::min((wide - left - right) / view_.size().x(), tallest / view_.size().y());
    width_ = scale_ * view_.size().x();
    height_ = scale_ * view_.size().y();
  }

  /// One view of the motion: "whole" leaves the crowd of impacts to "enlarged", "all" shows both.
  std::string panel(const std::string& kind) {
    out_ = axes(kind);
    cables(case_.initial, solution_.arcs().front().taut, "cable before");
    if (kind != "whole") {
      for (std::size_t index = std::min(faint_bodies, marks_.size()); index-- > 0;) {
        body(marks_[index].pose, "faint");
      }
    }
    cables(end_, solution_.arcs().back().taut, "cable");
    body(case_.initial, "start");
    body(end_, "end");
    anchors();
    path();  // over the bodies: it runs inside them
    if (kind != "whole") {
      impacts();
      labels();
    }
    return out_ + "</g>\n";
  }

  /// What the second panel enlarges, in the first.
  [[nodiscard]] std::string enlarged_frame() const {
    const Vec2 low = motion_.low();
    const Vec2 high = low + motion_.size();
    return fmt::format(
        "<rect class=\"frame\" stroke-dasharray=\"2 3\" x=\"{:.1f}\" y=\"{:.1f}\" "
        "width=\"{:.1f}\" height=\"{:.1f}\"/>\n",
        px(low), py(high), px(high) - px(low), py(low) - py(high));
  }

  [[nodiscard]] std::string heading() const {
    return fmt::format(
        "<text class=\"muted\" x=\"{:.1f}\" y=\"{:.1f}\">the dotted part, "
        "enlarged</text>\n",
        left, top_ - 10.0);
  }

  /// The sheet, its title and what it is.
  [[nodiscard]] std::string begin(double sheet_width, double sheet_height) const {
    constexpr std::size_t longest_title = 64;  // [bytes], what fits the sheet
    const std::string name = xml_text(printable(case_.name, longest_title));
    const std::string line =
        fmt::format("t = 0 to {:.6g} s, {} impact{}, ends {}", solution_.end_time(), marks_.size(),
                    marks_.size() == 1 ? "" : "s", ending_words());
    return fmt::format(
        "<svg xmlns=\"http://www.w3.org/2000/svg\" viewBox=\"0 0 {0:.0f} {1:.0f}\" "
        "width=\"{0:.0f}\" height=\"{1:.0f}\" role=\"img\">\n<title>{2}</title>\n<desc>Exact "
        "motion of a body on {3} cable{4}: {5}.</desc>\n{6}<rect class=\"paper\" width=\"100%\" "
        "height=\"100%\"/>\n<text class=\"title\" x=\"{7}\" y=\"26\">{2}</text>\n<text "
        "class=\"muted\" x=\"{7}\" y=\"47\">{5}</text>\n",
        sheet_width, sheet_height, name, case_.cables.size(), case_.cables.size() == 1 ? "" : "s",
        line, plot_style, left);
  }

  [[nodiscard]] std::string ending_words() const {
    switch (solution_.ending()) {
      case Ending::reached_duration:
        return "at its duration";
      case Ending::rest:
        return "at rest";
      case Ending::angle_limit:
        return "at the angle limit";
      case Ending::ceiling:
        return "at the ceiling";
      default:
        return std::string(to_string(solution_.ending()));
    }
  }

  /// The grid, its numbers and the frame; opens the group that the frame clips.
  [[nodiscard]] std::string axes(const std::string& clip) const {
    std::string out;
    for (const double x : ticks(view_.low().x(), view_.size().x())) {
      out += fmt::format(
          "<path class=\"grid\" d=\"M{0:.1f} {1:.1f}v{2:.1f}\"/><text class=\"muted\" "
          "text-anchor=\"middle\" x=\"{0:.1f}\" y=\"{3:.1f}\">{4:.6g}</text>\n",
          px({x, 0.0}), top_, height_, top_ + height_ + 18.0, x);
    }
    for (const double y : ticks(view_.low().y(), view_.size().y())) {
      const double at = py({0.0, y});
      out += fmt::format(
          "<path class=\"grid\" d=\"M{0:.1f} {1:.1f}h{2:.1f}\"/><text class=\"muted\" "
          "text-anchor=\"end\" x=\"{3:.1f}\" y=\"{4:.1f}\">{5:.6g}</text>\n",
          left, at, width_, left - 6.0, at + 4.0, y);
    }
    const std::string frame = fmt::format(
        "x=\"{:.1f}\" y=\"{:.1f}\" width=\"{:.1f}\" "
        "height=\"{:.1f}\"/>",
        left, top_, width_, height_);
    return out +
           fmt::format(
               "<rect class=\"frame\" {0}\n<text text-anchor=\"middle\" x=\"{1:.1f}\" "
               "y=\"{2:.1f}\">x [m]</text>\n<text text-anchor=\"middle\" transform=\"translate(14 "
               "{3:.1f}) rotate(-90)\">y [m]</text>\n<clipPath id=\"{4}\"><rect "
               "{0}</clipPath>\n<g clip-path=\"url(#{4})\">\n",
               frame, left + 0.5 * width_, top_ + height_ + 38.0, top_ + 0.5 * height_, clip);
  }

  void path() {
    out_ += "<path class=\"path\" d=\"";
    char move = 'M';
    for (const Vec2& point : path_) {
      if (point.allFinite()) {
        out_ += fmt::format("{}{:.1f} {:.1f}", move, px(point), py(point));
        move = 'L';
      }
    }
    out_ += "\"/>\n";
  }

  void cables(const State& state, CableSet taut, const std::string& kind) {
    for (std::size_t index = 0; index < case_.cables.size(); ++index) {
      const Cable& cable = case_.cables[index];
      const Vec2 end = attachment_point(state, cable);
      const bool is_taut = taut.contains(index) || gap(cable, state) <= gap_rounding * cable.length;
      // the control point of a parabola lies twice as deep as its vertex
      const Vec2 control = 2.0 * lowest(cable, state) - 0.5 * (cable.anchor + end);
      out_ += fmt::format("<path class=\"{}{}\" d=\"M{:.1f} {:.1f}", kind, is_taut ? "" : " slack",
                          px(cable.anchor), py(cable.anchor));
      out_ += is_taut ? fmt::format("L{:.1f} {:.1f}\"/>\n", px(end), py(end))
                      : fmt::format("Q{:.1f} {:.1f} {:.1f} {:.1f}\"/>\n", px(control), py(control),
                                    px(end), py(end));
    }
  }

  /// The body as the hull of its centre and attachments; a bar where those lie on one line.
  void body(const State& state, const std::string& kind) {
    std::vector<Vec2> points = {state.position};
    for (const Cable& cable : case_.cables) {
      points.push_back(attachment_point(state, cable));
    }
    const std::vector<Vec2> hull = convex_hull(points);
    std::string line;
    for (const Vec2& point : hull) {
      line += fmt::format("{}{:.1f} {:.1f}", line.empty() ? 'M' : 'L', px(point), py(point));
    }
    out_ += "<g class=\"" + kind + "\">";
    out_ += hull.size() > 2 ? "<path class=\"body\" d=\"" + line + "Z\"/>"
                            : "<path class=\"bar\" d=\"" + line + "\"/><path class=\"core\" d=\"" +
                                  line + "\"/>";
    out_ += fmt::format("<circle class=\"centre\" cx=\"{:.1f}\" cy=\"{:.1f}\" r=\"2.5\"/></g>\n",
                        px(state.position), py(state.position));
  }

  void impacts() {
    for (std::size_t index = 0; index < std::min(marked_impacts, marks_.size()); ++index) {
      const Vec2& at = marks_[index].pose.position;
      out_ += fmt::format("<circle class=\"impact\" cx=\"{:.1f}\" cy=\"{:.1f}\" r=\"2.5\"/>\n",
                          px(at), py(at));
    }
  }

  void anchors() {
    for (const Cable& cable : case_.cables) {
      const double x = px(cable.anchor);
      const double y = py(cable.anchor);
      out_ += fmt::format(
          "<rect class=\"anchor\" x=\"{:.1f}\" y=\"{:.1f}\" width=\"8\" "
          "height=\"8\"/>\n",
          x - 4.0, y - 4.0);
    }
  }

  /// A word below a body, away from the other one.
  void label(const State& state, double dy, const char* word) {
    const double x = std::clamp(px(state.position), left + 24.0, left + width_ - 24.0);
    const double y = std::clamp(py(state.position) + dy, top_ + 16.0, top_ + height_ - 8.0);
    out_ += fmt::format(
        "<text class=\"halo\" text-anchor=\"middle\" x=\"{:.1f}\" "
        "y=\"{:.1f}\">{}</text>\n",
        x, y, word);
  }

  void labels() {
    const bool start_above = case_.initial.position.y() > end_.position.y();
    label(case_.initial, start_above ? -14.0 : 24.0, "start");
    label(end_, start_above ? 24.0 : -14.0, "end");
  }

  /// What the lines mean, and the scale bar of the last panel.
  [[nodiscard]] std::string legend(double y) const {
    const double length = round_below(0.25 * view_.size().x());
    return fmt::format(
        "<path class=\"path\" d=\"M{0} {1:.1f}h26\"/><text x=\"{2}\" y=\"{3:.1f}\">centre of "
        "mass</text>\n<path class=\"cable\" d=\"M{4} {1:.1f}h26\"/><text x=\"{5}\" "
        "y=\"{3:.1f}\">taut</text>\n<path class=\"cable slack\" d=\"M{6} {1:.1f}h30\"/><text "
        "x=\"{7}\" y=\"{3:.1f}\">slack</text>\n<circle class=\"impact\" cx=\"{8}\" "
        "cy=\"{1:.1f}\" r=\"3\"/><text x=\"{9}\" y=\"{3:.1f}\">impact</text>\n<path "
        "class=\"scale\" d=\"M{10} {11:.1f}v8m0-4h{12:.1f}m0-4v8\"/><text x=\"{13:.1f}\" "
        "y=\"{3:.1f}\">{14:g} m</text>\n",
        left, y, left + 32.0, y + 4.0, left + 140.0, left + 172.0, left + 214.0, left + 250.0,
        left + 304.0, left + 313.0, left + 380.0, y - 4.0, scale_ * length,
        left + 388.0 + scale_ * length, length);
  }

  const Case& case_;
  const Solution& solution_;
  std::vector<Vec2> path_;
  std::vector<Mark> marks_;
  State end_;
  Extent whole_;
  Extent motion_;
  Extent view_;          // of the panel that is drawn
  double scale_ = 1.0;   // [px/m]
  double top_ = 0.0;     // [px]
  double width_ = 0.0;   // [px]
  double height_ = 0.0;  // [px]
  std::string out_;
};

}  // namespace

std::string plot_svg(const Case& the_case, const Solution& solution) {
  return Picture(the_case, solution).text();
}

}  // namespace tautline::bench
