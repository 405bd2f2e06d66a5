#pragma once

#include <cstddef>
#include <string>

#include "bench/solution/plot_motion.hpp"
#include "bench/solution/plot_view.hpp"

namespace tautline::bench {

/// So many of the fastest impacts are marked in a picture: more is a smear.
inline constexpr std::size_t marked_impacts = 400;

/// Left of a panel is room for the numbers of its axis [px].
inline constexpr double panel_left = 64.0;

/// Room for `text` in letters of `size` [px], as wide as sans-serif fonts have them at most.
[[nodiscard]] double room_for(const std::string& text, double size);
inline constexpr double letters = 13.0;  // [px], the size of all words but the title

/// One view of a motion: axes, cables, bodies and impacts, as SVG.
class PlotPanel {
 public:
  /// Shows the part `view` of the world, below `top` [px] on the sheet. `motion` must outlive it.
  PlotPanel(const PlotMotion& motion, const Extent& view, double top);

  /// Which part of the motion a panel shows: one that is enlarged takes the crowd of impacts.
  enum class Kind { all, whole, enlarged };
  [[nodiscard]] std::string text(Kind kind) const;

  /// A dotted frame around `part`.
  [[nodiscard]] std::string frame(const Extent& part) const;

  [[nodiscard]] double top() const { return top_; }
  [[nodiscard]] double bottom() const { return top_ + height_; }
  [[nodiscard]] double width() const { return width_; }
  /// Where the last number of the x axis ends [px].
  [[nodiscard]] double labels_end() const;
  [[nodiscard]] double scale() const { return scale_; }  // [px/m]
  [[nodiscard]] const Extent& view() const { return view_; }

 private:
  [[nodiscard]] double px(const Vec2& point) const;
  [[nodiscard]] double py(const Vec2& point) const;

  [[nodiscard]] std::string axes(Kind kind) const;
  [[nodiscard]] std::string cables(const State& state, CableSet taut, const char* kind) const;
  [[nodiscard]] std::string body(const State& state, const char* kind) const;
  [[nodiscard]] std::string anchors() const;
  [[nodiscard]] std::string path() const;
  [[nodiscard]] std::string impacts() const;
  [[nodiscard]] std::string label(const State& state, double dy, const char* word) const;

  const PlotMotion& motion_;
  Extent view_;
  double top_;     // [px]
  double scale_;   // [px/m]
  double width_;   // [px]
  double height_;  // [px]
};

}  // namespace tautline::bench
