#include <fmt/format.h>

#include <algorithm>

#include "bench/base/text.hpp"
#include "bench/ensemble/output/atlas.hpp"
#include "bench/ensemble/quantity.hpp"
#include "bench/plot/svg.hpp"

namespace tautline::bench {
namespace {

// of the sheet [px]
constexpr double map_size = 360.0;
constexpr double left = 84.0;
constexpr double top = 40.0;
constexpr double bar_width = 16.0;
constexpr double bar_gap = 18.0;
constexpr double numbers_room = 100.0;
constexpr double labels_room = 52.0;
constexpr double name_height = 24.0;

/// Viridis at 0, 1/4, ..., 1: it rises in lightness, for those who see fewer colours too.
constexpr std::array<std::array<double, 3>, 5> viridis = {
    {{68, 1, 84}, {59, 82, 139}, {33, 145, 140}, {94, 201, 98}, {253, 231, 37}}};

std::string colour_of(double part) {
  const double place = std::clamp(part, 0.0, 1.0) * (viridis.size() - 1);
  const auto low = std::min(static_cast<std::size_t>(place), viridis.size() - 2);
  const double rest = place - static_cast<double>(low);
  std::array<int, 3> mixed{};
  for (std::size_t c = 0; c < 3; ++c) {
    mixed[c] = static_cast<int>(viridis[low][c] + rest * (viridis[low + 1][c] - viridis[low][c]));
  }
  return fmt::format("rgb({},{},{})", mixed[0], mixed[1], mixed[2]);
}

std::string axis_title(const Varied& axis) {
  const std::string_view unit = unit_of_quantity(axis.quantity);
  return axis.quantity + (unit.empty() ? "" : fmt::format(" [{}]", unit));
}

/// Both ends of each axis, and its name.
std::string axes_svg(const Atlas& atlas) {
  const auto& across = atlas.axes[0].distribution.numbers;
  const auto& up = atlas.axes[1].distribution.numbers;
  const double bottom = top + map_size;
  const double middle = left + map_size / 2.0;
  const auto number = [](double x, double y, double value, const char* anchor) {
    return muted_text(x, y, fmt::format("{:.4g}", value), anchor);
  };
  return number(left, bottom + 18.0, across.front(), "start") +
         number(left + map_size, bottom + 18.0, across.back(), "end") +
         muted_text(middle, bottom + 38.0, axis_title(atlas.axes[0]), "middle") +
         number(left - 6.0, bottom, up.front(), "end") +
         number(left - 6.0, top + 12.0, up.back(), "end") +
         turned_text(left - 60.0, top + map_size / 2.0, -90, axis_title(atlas.axes[1]), "middle");
}

/// The numbers between which the colours of a map go.
struct ColourRange {
  double least;  // of all cells
  double low;    // the first colour, and of all numbers below
  double high;   // the last one, and of all above
  double most;
  [[nodiscard]] std::string colour(double number) const {
    return colour_of(high > low ? (number - low) / (high - low) : 0.5);
  }
};

/// Of amounts: but for one in a hundred at each end, as one cell alone would leave the others dark.
/// Of names: all that there are.
ColourRange range_of(const AtlasMap& map, std::vector<double> known) {
  std::sort(known.begin(), known.end());
  if (!map.names.empty()) {
    const double last = static_cast<double>(map.names.size()) - 1.0;
    return {known.front(), 0.0, last, known.back()};
  }
  ColourRange range{known.front(), nearest_value(known, 0.01), nearest_value(known, 0.99),
                    known.back()};
  if (!(range.low < range.high)) {  // few cells differ
    range.low = range.least;
    range.high = range.most;
  }
  return range;
}

std::string words_of(const AtlasMap& map, std::optional<double> value) {
  if (!value) {
    return "none";
  }
  return map.names.empty() ? fmt::format("{:.6g}", *value)
                           : map.names.at(static_cast<std::size_t>(*value));
}

std::string beside(double y, const std::string& words) {
  return muted_text(left + map_size + bar_gap + bar_width + 6.0, y, words);
}

std::string swatch(double y, double height, const std::string& colour) {
  return fmt::format(
      "<rect x=\"{:.1f}\" y=\"{:.1f}\" width=\"{}\" height=\"{:.2f}\" fill=\"{}\"/>\n",
      left + map_size + bar_gap, y, bar_width, height, colour);
}

/// The colours, with the numbers at both ends; a single one, where all cells have the same number.
std::string bar_svg(const ColourRange& range) {
  const int parts = range.high > range.low ? 32 : 1;
  std::string out;
  for (int part = 0; part < parts; ++part) {
    out += swatch(top + map_size * (parts - 1 - part) / parts,
                  map_size / parts + (parts > 1 ? 0.5 : 0.0), colour_of((part + 0.5) / parts));
  }
  if (parts == 1) {
    return out + beside(top + map_size / 2 + 4.0, fmt::format("{:.4g}", range.high));
  }
  return out +
         beside(top + 12.0,
                fmt::format("{}{:.4g}", range.most > range.high ? "≥ " : "", range.high)) +
         beside(top + map_size,
                fmt::format("{}{:.4g}", range.least < range.low ? "≤ " : "", range.low));
}

/// The colours of the names that occur, the first one below.
std::string names_svg(const AtlasMap& map, const ColourRange& range,
                      const std::vector<double>& known) {
  std::string out;
  double y = top + map_size;
  for (std::size_t name = 0; name < map.names.size(); ++name) {
    const auto number = static_cast<double>(name);
    if (std::find(known.begin(), known.end(), number) != known.end()) {
      y -= name_height;
      out += swatch(y, bar_width, range.colour(number)) + beside(y + 12.0, map.names[name]);
    }
  }
  return out;
}

std::string cell_svg(const Atlas& atlas, std::size_t cell, const std::string& words,
                     const std::string& fill) {
  const auto& across = atlas.axes[0].distribution.numbers;
  const auto& up = atlas.axes[1].distribution.numbers;
  const double width = map_size / static_cast<double>(across.size());
  const double height = map_size / static_cast<double>(up.size());
  const std::size_t column = cell % across.size();
  const std::size_t row = cell / across.size();
  const std::string rect = fmt::format(
      "<rect x=\"{:.2f}\" y=\"{:.2f}\" width=\"{:.2f}\" height=\"{:.2f}\" fill=\"{}\"><title>{} "
      "{:.4g}, {} {:.4g}: {}</title></rect>",
      left + width * static_cast<double>(column),
      top + map_size - height * static_cast<double>(row + 1), width, height, fill,
      xml_text(atlas.axes[0].quantity), across[column], xml_text(atlas.axes[1].quantity), up[row],
      xml_text(words));
  if (!atlas.pictured[cell]) {
    return rect + "\n";
  }
  return fmt::format("<a href=\"{}\">{}</a>\n", picture_name(cell), rect);
}

}  // namespace

std::string atlas_svg(const Atlas& atlas, const AtlasMap& map, const Statistic& statistic) {
  std::vector<double> known;
  for (const std::optional<double>& value : map.cells) {
    if (value) {
      known.push_back(*value);
    }
  }
  const ColourRange range = known.empty() ? ColourRange{} : range_of(map, known);
  std::string drawn;
  for (std::size_t cell = 0; cell < map.cells.size(); ++cell) {
    const std::optional<double>& value = map.cells[cell];
    drawn += cell_svg(atlas, cell, words_of(map, value),
                      value ? range.colour(*value) : line_colours[grey_line]);
  }
  drawn += axes_svg(atlas);
  if (!known.empty()) {
    drawn += map.names.empty() ? bar_svg(range) : names_svg(map, range, known);
  }
  return svg_sheet({.width = left + map_size + bar_gap + bar_width + numbers_room,
                    .height = top + map_size + labels_room,
                    .left = left,
                    .title = statistic_title(statistic),
                    .title_y = 24.0},
                   drawn);
}

}  // namespace tautline::bench
