#pragma once

#include <array>
#include <cstddef>
#include <string>
#include <string_view>
#include <vector>

namespace tautline::bench {

// The pieces that pictures are made of, as SVG. Lengths are in [px]; words are plain text.

/// Colours that are told apart by those who see fewer, too (Okabe and Ito 2008), on light and dark.
inline constexpr std::array line_colours = {"#0072b2", "#d55e00", "#009e73", "#cc79a7",
                                            "#e69f00", "#56b4e9", "#8a8a8a", "#a6761d"};
inline constexpr std::size_t grey_line = 6;  // the place of the one that is no colour

inline constexpr std::array line_dashes = {"none", "8 3", "2 3", "10 3 2 3", "5 5"};

/// How a line looks, as attributes. Dashes tell lines apart without colour, and let one be seen
/// below another. Both numbers go round.
[[nodiscard]] std::string line_look(std::size_t colour, std::size_t dashes);

/// A picture as a file of its own, legible on light and dark paper.
struct SvgSheet {
  double width;
  double height;
  double left;  // where its words begin
  std::string title;
  std::string description = {};  // for a reader who does not see it
  std::string line = {};         // below the title
  double title_y = 26.0;
  bool has_links = false;  // a picture of one piece has none that a reader could reach
};
[[nodiscard]] std::string svg_sheet(const SvgSheet& sheet, const std::string& drawn);

/// The first tag of such a file, with more attributes.
[[nodiscard]] std::string svg_start(double width, double height, const std::string& more = "");

/// Words at a place; `anchor` is "start", "middle" or "end", and without one the start is there.
[[nodiscard]] std::string muted_text(double x, double y, const std::string& words,
                                     const char* anchor = "");

/// The same, turned clockwise by so many degrees.
[[nodiscard]] std::string turned_text(double x, double y, int degrees, const std::string& words,
                                      const char* anchor);

/// A rectangle; `look` is its other attributes, with a space after each.
[[nodiscard]] std::string rectangle(const std::string& look, double x, double y, double width,
                                    double height);
inline constexpr const char* frame_look = "class=\"frame\" ";

/// A line of the grid, from the top down.
[[nodiscard]] std::string grid_down(double x, double top, double height);

/// A line of the grid to the right, and its number left of it: a longer number than there is room
/// for is set narrower.
[[nodiscard]] std::string grid_across(double left, double y, double width,
                                      const std::string& number);

/// A line of a legend: how it looks, and its name.
[[nodiscard]] std::string legend_entry(double x, double y, const std::string& look,
                                       const std::string& name);

/// Entries of a legend in rows as wide as a panel.
class LegendRows {
 public:
  explicit LegendRows(double y) : y_(y) {}

  /// The next entry begins a row.
  void skip();
  /// A mark drawn from 0 to 26 to the right and about 0 down, and its name.
  void add(const std::string& mark, const std::string& name);

  [[nodiscard]] const std::string& drawn() const { return drawn_; }
  [[nodiscard]] double bottom() const { return y_; }

 private:
  double x_ = 0.0;
  double y_;
  std::string drawn_;
};

/// Goes on to a point; the first one begins the path.
void add_point(std::string& path, double x, double y);

/// Room for `text` in letters of `size`, as wide as sans-serif fonts have them at most.
[[nodiscard]] double room_for(const std::string& text, double size);
inline constexpr double letters = 13.0;  // the size of all words but the title
inline constexpr double title_letters = 16.0;

/// Left of a panel is room for the numbers of its axis.
inline constexpr double panel_left = 64.0;
inline constexpr double panel_width = 636.0;  // at most

/// Round numbers in [low, low + size]: 3 to 8 of them, 1, 2 or 5 times a power of ten apart.
[[nodiscard]] std::vector<double> ticks(double low, double size);

/// The largest of 1, 2 or 5 times a power of ten that is at most `length` > 0.
[[nodiscard]] double round_below(double length);

/// True if this build can make PNG pictures: it has librsvg.
[[nodiscard]] bool makes_png();

/// The picture `svg` as a PNG file, two pixels for each of its own. Throws std::runtime_error where
/// that fails, and where `makes_png` is false.
[[nodiscard]] std::string png_of(const std::string& svg);

}  // namespace tautline::bench
