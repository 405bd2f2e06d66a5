#include "bench/plot/panel.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <utility>

#include "bench/plot/svg.hpp"

namespace tautline::bench {

static constexpr std::array axis_names = {"x", "y", "z"};

std::string anchor_at(double x, double y) {
  return fmt::format(
      "<rect class=\"anchor\" x=\"{:.1f}\" y=\"{:.1f}\" width=\"8\" height=\"8\"/>\n", x - 4.0,
      y - 4.0);
}

std::string ring_at(double x, double y) {
  return fmt::format("<circle class=\"ring\" cx=\"{:.1f}\" cy=\"{:.1f}\" r=\"4.5\"/>\n", x, y);
}

std::string style_of(std::size_t body, bool path) {
  return fmt::format(
      " style=\"stroke:{}{}\"", line_colours[body % line_colours.size()],
      path ? fmt::format(";stroke-dasharray:{}", line_dashes[body % line_dashes.size()]) : "");
}

std::string PlotPanel::text(Kind kind) const {
  std::string out = axes(kind) + cables(motion_.start, "cable before");
  if (kind != Kind::whole) {
    out += lines(motion_.traces, "trace");
    for (std::size_t index = motion_.fastest.size(); index-- > 0;) {
      out += bodies(motion_.fastest[index], "faint");
    }
  }
  out += cables(motion_.end, "cable");
  out += bodies(motion_.start, "start") + bodies(motion_.end, "end") + anchors();
  out += paths() + lines(motion_.moving, "moving");  // over the bodies: they run inside them
  if (kind != Kind::whole) {
    const std::vector<Label> words = start_and_end();
    out += impacts();
    for (const Label& word : words) {
      out += label(word);
    }
    out += motion_.numbers_cables ? cable_numbers(words) : "";
  }
  return out + "</g>\n";
}

std::string PlotPanel::frame(const Extent& part) const {
  const Vec2 low = part.low();
  const Vec2 high = low + part.size();
  return rectangle("class=\"frame\" stroke-dasharray=\"2 3\" ", px(low), py(high),
                   px(high) - px(low), py(low) - py(high)) +
         "\n";
}

double PlotPanel::labels_end() const {
  double end = right();
  for (const double x : ticks(shown_.low().x(), shown_.size().x())) {
    end = std::max(end, px({x, 0.0}) + 0.5 * room_for(fmt::format("{:.6g}", x), letters));
  }
  return end;
}

double PlotPanel::px(const Vec2& point) const {
  return left_ + scale_ * (point.x() - shown_.low().x());
}

double PlotPanel::py(const Vec2& point) const {
  return top_ + height_ - scale_ * (point.y() - shown_.low().y());
}

std::string PlotPanel::grid_of_x() const {
  const std::vector<double> all = ticks(shown_.low().x(), shown_.size().x());
  const double step = all.size() > 1 ? all[1] - all[0] : 1.0;
  double room = 0.0;  // [px]
  for (const double x : all) {
    room = std::max(room, room_for(fmt::format("{:.6g}", x), letters));
  }
  const double each = all.size() < 2 || room <= scale_ * step ? 1.0
                      : room <= 2.0 * scale_ * step           ? 2.0
                                                              : 5.0;
  std::string out;
  for (const double x : all) {
    out += grid_down(px({x, 0.0}), top_, height_);
    if (std::fmod(std::round(x / step), each) == 0.0) {
      out += muted_text(px({x, 0.0}), bottom() + 18.0, fmt::format("{:.6g}", x), "middle");
    }
  }
  return out;
}

std::string PlotPanel::axes(Kind kind) const {
  constexpr std::array kinds = {"all", "whole", "enlarged"};
  std::string name = kinds.at(static_cast<std::size_t>(kind));
  std::string out = grid_of_x();
  for (const double y : ticks(shown_.low().y(), shown_.size().y())) {
    out += grid_across(left_, py({0.0, y}), width_, fmt::format("{:.6g}", y));
  }
  if (!motion_.side.empty()) {
    name += fmt::format("-{}{}", axis_names.at(view_.right), axis_names.at(view_.up));
    out +=
        fmt::format("<text x=\"{:.1f}\" y=\"{:.1f}\">{}</text>\n", left_, top_ - 8.0, motion_.side);
  }
  return out + rectangle(frame_look, left_, top_, width_, height_) +
         fmt::format(
             "\n<text text-anchor=\"middle\" x=\"{0:.1f}\" y=\"{1:.1f}\">{5} [m]</text>\n<text "
             "text-anchor=\"middle\" transform=\"translate({7:.0f} {2:.1f}) rotate(-90)\">{6} "
             "[m]</text>\n<clipPath id=\"{4}\">{3}</clipPath>\n<g clip-path=\"url(#{4})\">\n",
             left_ + 0.5 * width_, bottom() + 38.0, top_ + 0.5 * height_,
             rectangle("", left_, top_, width_, height_), name, axis_names.at(view_.right),
             axis_names.at(view_.up), left_ - 50.0);
}

std::string PlotPanel::cables(const BasicPose<2>& pose, const char* kind) const {
  std::string out;
  for (const BasicDrawnCable<2>& cable : pose.cables) {
    out += fmt::format("<path class=\"{}{}\" d=\"M{:.1f} {:.1f}", kind, cable.taut ? "" : " slack",
                       px(cable.points.front()), py(cable.points.front()));
    for (std::size_t i = 1; i < cable.points.size(); ++i) {
      const Vec2& to = cable.points[i];
      // the control point of a parabola lies twice as deep as its vertex
      const Vec2 control = 2.0 * cable.lowest[i - 1] - 0.5 * (cable.points[i - 1] + to);
      out += cable.taut ? fmt::format("L{:.1f} {:.1f}", px(to), py(to))
                        : fmt::format("Q{:.1f} {:.1f} {:.1f} {:.1f}", px(control), py(control),
                                      px(to), py(to));
    }
    out += "\"/>\n";
  }
  return out;
}

std::string PlotPanel::look(std::size_t index, bool path) const {
  return motion_.bodies.empty() ? "" : style_of(index, path);
}

std::string PlotPanel::bodies(const BasicPose<2>& pose, const char* kind) const {
  std::string out;
  for (std::size_t index = 0; index < pose.bodies.size(); ++index) {
    out += body(pose.bodies[index], kind, look(index, false));
  }
  return out;
}

std::string PlotPanel::body(const BasicDrawnBody<2>& drawn, const char* kind,
                            const std::string& look) const {
  std::vector<Vec2> points = {drawn.centre};
  points.insert(points.end(), drawn.points.begin(), drawn.points.end());
  const std::vector<Vec2> hull = drawn.faces.empty() ? convex_hull(points) : std::vector<Vec2>();
  std::string line;
  bool dot = !look.empty() && drawn.faces.empty();
  for (const Vec2& point : hull) {
    add_point(line, px(point), py(point));
    dot = dot && (point - drawn.centre).norm() * scale_ < 0.5;
  }
  std::string out = fmt::format("<g class=\"{}\">", kind);
  for (const std::vector<Vec2>& face : drawn.faces) {
    out += "<path class=\"body box\"" + look + " d=\"" + line_of(face) + "Z\"/>";
  }
  for (const Vec2& point : drawn.faces.empty() ? std::vector<Vec2>() : drawn.points) {
    out += "<path class=\"arm\"" + look + " d=\"" + line_of({drawn.centre, point}) + "\"/>";
  }
  if (dot || drawn.is_point) {
    out += fmt::format("<circle class=\"body\"{} cx=\"{:.1f}\" cy=\"{:.1f}\" r=\"5\"/>", look,
                       px(drawn.centre), py(drawn.centre));
  } else if (drawn.faces.empty()) {
    out += hull.size() > 2 ? "<path class=\"body\"" + look + " d=\"" + line + "Z\"/>"
                           : "<path class=\"bar\"" + look + " d=\"" + line +
                                 "\"/><path class=\"core\" d=\"" + line + "\"/>";
  }
  out += fmt::format("<circle class=\"centre\" cx=\"{:.1f}\" cy=\"{:.1f}\" r=\"2.5\"/></g>\n",
                     px(drawn.centre), py(drawn.centre));
  return out;
}

std::string PlotPanel::anchors() const {
  std::string out;
  for (const Vec2& anchor : motion_.anchors) {
    out += anchor_at(px(anchor), py(anchor));
  }
  for (const Vec2& ring : motion_.rings) {
    out += ring_at(px(ring), py(ring));
  }
  return out;
}

std::string PlotPanel::line_of(const std::vector<Vec2>& points) const {
  std::string line;
  for (const Vec2& point : points) {
    if (point.allFinite()) {
      add_point(line, px(point), py(point));
    }
  }
  return line;
}

std::string PlotPanel::paths() const {
  std::string out;
  for (std::size_t index = 0; index < motion_.paths.size(); ++index) {
    out += "<path class=\"path\"" + look(index, true) + " d=\"" + line_of(motion_.paths[index]) +
           "\"/>\n";
  }
  return out;
}

std::string PlotPanel::lines(const std::vector<std::vector<Vec2>>& all, const char* kind) const {
  std::string out;
  for (const std::vector<Vec2>& one : all) {
    out += fmt::format("<path class=\"{}\" d=\"{}\"/>\n", kind, line_of(one));
  }
  return out;
}

std::string PlotPanel::impacts() const {
  std::string out;
  for (std::size_t index = 0; index < std::min(marked_impacts, motion_.marks.size()); ++index) {
    for (const Vec2& at : motion_.marks[index].places) {
      out += fmt::format("<circle class=\"impact\" cx=\"{:.1f}\" cy=\"{:.1f}\" r=\"2.5\"/>\n",
                         px(at), py(at));
    }
  }
  return out;
}

std::vector<PlotPanel::Label> PlotPanel::start_and_end() const {
  if (!motion_.bodies.empty()) {
    return {};
  }
  const Vec2& start = motion_.start.bodies.front().centre;
  const Vec2& end = motion_.end.bodies.front().centre;
  const bool start_above = start.y() > end.y();
  return {{start, start_above ? -14.0 : 24.0, "start"}, {end, start_above ? 24.0 : -14.0, "end"}};
}

std::string PlotPanel::cable_numbers(const std::vector<Label>& words) const {
  std::vector<std::pair<Vec2, std::string>> labels;
  const Vec2 high = shown_.low() + shown_.size();
  for (const BasicDrawnCable<2>& cable : motion_.end.cables) {
    std::vector<Vec2> seen;
    for (std::size_t i = 1; i < cable.points.size(); ++i) {
      const Vec2& from = cable.points[i - 1];
      const Vec2& to = cable.points[i];
      const Vec2 hang = cable.lowest[i - 1] - 0.5 * (from + to);
      constexpr int pieces = 40;
      for (int k = 0; k <= pieces; ++k) {
        const double part = static_cast<double>(k) / pieces;
        const Vec2 point = from + part * (to - from) + 4.0 * part * (1.0 - part) * hang;
        if ((point.array() >= shown_.low().array() && point.array() <= high.array()).all()) {
          seen.push_back(point);
        }
      }
    }
    if (seen.empty()) {
      continue;
    }
    const Vec2 at = free_of(seen, words);
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
    out += label({at, 5.0, word});
  }
  return out;
}

Vec2 PlotPanel::free_of(const std::vector<Vec2>& points, const std::vector<Label>& words) const {
  const auto is_free = [&](const Vec2& point) {
    return std::none_of(words.begin(), words.end(), [&](const Label& word) {
      return std::abs(px(point) - px(word.at)) < 34.0 &&
             std::abs(py(point) + 5.0 - py(word.at) - word.dy) < 16.0;
    });
  };
  for (const std::size_t fifths : {2U, 3U, 1U, 4U}) {  // not the middle: a ring may be there
    const Vec2& point = points[fifths * points.size() / 5];
    if (is_free(point)) {
      return point;
    }
  }
  return points[2 * points.size() / 5];
}

std::string PlotPanel::label(const Label& label) const {
  const auto& [at, dy, word] = label;
  const double x = std::clamp(px(at), left_ + 24.0, left_ + width_ - 24.0);
  const double y = std::clamp(py(at) + dy, top_ + 16.0, top_ + height_ - 8.0);
  return fmt::format(
      "<text class=\"halo\" text-anchor=\"middle\" x=\"{:.1f}\" "
      "y=\"{:.1f}\">{}</text>\n",
      x, y, word);
}

}  // namespace tautline::bench
