#pragma once

#include <string>
#include <vector>

#include "bench/plot/motion.hpp"

namespace tautline::bench {

/// How an anchor and a ring look, at a place on the sheet [px].
[[nodiscard]] std::string anchor_at(double x, double y);
[[nodiscard]] std::string ring_at(double x, double y);

/// The colour of a body, and the dashes of its path, as a style.
[[nodiscard]] std::string style_of(std::size_t body, bool path);

/// One view of a motion: axes, cables, bodies and impacts.
class PlotPanel {
 public:
  /// Which part of the motion a panel shows: one that is enlarged takes the crowd of impacts.
  enum class Kind { all, whole, enlarged };

  /// Shows the part `shown` of what `view` sees of the world, with its left upper corner there on
  /// the sheet [px]. `motion`, as `view` sees it, must outlive this.
  PlotPanel(const PlotMotion& motion, const View& view, const Extent& shown, double left,
            double top, double scale)
      : motion_(motion),
        view_(view),
        shown_(shown),
        left_(left),
        top_(top),
        scale_(scale),
        width_(scale_ * shown.size().x()),
        height_(scale_ * shown.size().y()) {}

  [[nodiscard]] std::string text(Kind kind) const;

  /// A dotted frame around `part`.
  [[nodiscard]] std::string frame(const Extent& part) const;

  /// Where the last number of the x axis ends [px].
  [[nodiscard]] double labels_end() const;

  [[nodiscard]] double top() const { return top_; }
  [[nodiscard]] double bottom() const { return top_ + height_; }
  [[nodiscard]] double right() const { return left_ + width_; }
  [[nodiscard]] double scale() const { return scale_; }  // [px/m]
  [[nodiscard]] const Extent& shown() const { return shown_; }

 private:
  [[nodiscard]] double px(const Vec2& point) const;

  [[nodiscard]] double py(const Vec2& point) const;

  /// The lines of the grid up and down; every second or fifth has a number where there is no room
  /// for all.
  [[nodiscard]] std::string grid_of_x() const;

  /// The grid, its numbers and the frame; opens the group that the frame clips.
  [[nodiscard]] std::string axes(Kind kind) const;

  [[nodiscard]] std::string cables(const BasicPose<2>& pose, const char* kind) const;

  /// The style of body `index`; "" of one alone.
  [[nodiscard]] std::string look(std::size_t index, bool path) const;

  [[nodiscard]] std::string bodies(const BasicPose<2>& pose, const char* kind) const;

  /// A body as its box, or the hull of its centre and attachments; a bar where those lie on one
  /// line, and a dot where they are one point.
  [[nodiscard]] std::string body(const BasicDrawnBody<2>& drawn, const char* kind,
                                 const std::string& look) const;

  [[nodiscard]] std::string anchors() const;

  /// The points of a path as a line.
  [[nodiscard]] std::string line_of(const std::vector<Vec2>& points) const;

  [[nodiscard]] std::string paths() const;

  [[nodiscard]] std::string lines(const std::vector<std::vector<Vec2>>& all,
                                  const char* kind) const;

  [[nodiscard]] std::string impacts() const;

  /// A word at a place of the world, `dy` [px] below it.
  struct Label {
    Vec2 at;
    double dy;
    std::string word;
  };

  /// A word below the only body, away from the other one.
  [[nodiscard]] std::vector<Label> start_and_end() const;

  /// About the middle of what is seen of each cable at the end; those of one place together.
  [[nodiscard]] std::string cable_numbers(const std::vector<Label>& words) const;

  /// One of `points`, not near an end of them, at which a number runs into none of `words`.
  [[nodiscard]] Vec2 free_of(const std::vector<Vec2>& points,
                             const std::vector<Label>& words) const;

  [[nodiscard]] std::string label(const Label& label) const;

  const PlotMotion& motion_;
  View view_;
  Extent shown_;
  double left_;    // [px]
  double top_;     // [px]
  double scale_;   // [px/m]
  double width_;   // [px]
  double height_;  // [px]
};

}  // namespace tautline::bench
