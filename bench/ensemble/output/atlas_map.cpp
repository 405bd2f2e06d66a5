#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <vector>

#include "bench/base/text.hpp"
#include "bench/ensemble/output/atlas.hpp"
#include "bench/page/document.hpp"
#include "bench/plot/svg.hpp"

namespace tautline::bench {
namespace {

// of the sheet [px]
constexpr double least_map = 360.0;
constexpr double least_cell = 24.0;  // that leads to a picture: a finger has to hit it
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

/// "velocity x [m/s]".
std::string axis_title(const Varied& axis) {
  std::string words = axis.quantity;
  std::replace(words.begin(), words.end(), '_', ' ');
  return words + fmt::format(" [{}]", axis.unit.empty() ? "-" : axis.unit);
}

/// The side of a map [px]: large enough for cells that lead to pictures.
double size_of_map(const Atlas& atlas) {
  const bool leads =
      std::find(atlas.pictured.begin(), atlas.pictured.end(), true) != atlas.pictured.end();
  const std::size_t cells = std::max(atlas.axes[0].distribution.numbers.size(),
                                     atlas.axes[1].distribution.numbers.size());
  return leads ? std::max(least_map, least_cell * static_cast<double>(cells)) : least_map;
}

/// The name of each axis, and the numbers of some cells at their middle.
std::string axes_svg(const Atlas& atlas, double map_size) {
  constexpr std::size_t most_numbers = 6;
  const auto& across = atlas.axes[0].distribution.numbers;
  const auto& up = atlas.axes[1].distribution.numbers;
  const double bottom = top + map_size;
  const auto middle = [&](std::size_t cell, std::size_t cells) {
    return map_size * (static_cast<double>(cell) + 0.5) / static_cast<double>(cells);
  };
  const auto stride = [](std::size_t cells) { return 1 + (cells - 1) / most_numbers; };
  std::string out;
  for (std::size_t cell = 0; cell < across.size(); cell += stride(across.size())) {
    out += muted_text(left + middle(cell, across.size()), bottom + 18.0,
                      fmt::format("{:.3g}", across[cell]), "middle");
  }
  for (std::size_t cell = 0; cell < up.size(); cell += stride(up.size())) {
    out += muted_text(left - 6.0, bottom - middle(cell, up.size()) + 4.0,
                      fmt::format("{:.3g}", up[cell]), "end");
  }
  return out +
         muted_text(left + map_size / 2.0, bottom + 40.0, axis_title(atlas.axes[0]), "middle") +
         turned_text(left - 64.0, top + map_size / 2.0, -90, axis_title(atlas.axes[1]), "middle");
}

/// The numbers between which the colours of a map go.
struct ColourRange {
  double least;  // of all cells
  double low;    // the first colour, and of all numbers below
  double high;   // the last one, and of all above
  double most;
  bool by_logarithm = false;
  /// Where a number lies between the first colour (0) and the last one (1).
  [[nodiscard]] double part(double number) const {
    if (!(high > low)) {
      return 0.5;
    }
    return by_logarithm ? std::log10(std::max(number, low) / low) / std::log10(high / low)
                        : (number - low) / (high - low);
  }
  [[nodiscard]] std::string colour(double number) const { return colour_of(part(number)); }
};

/// Amounts that span more than this go by their logarithm: most cells would have one dark tone [-].
constexpr double decade = 10.0;

/// Of amounts: but for one in a hundred at each end, as one cell alone would leave the others dark.
/// Of names: all that there are.
ColourRange range_of(const AtlasMap& map, const Statistic& statistic, std::vector<double> known) {
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
  const bool is_share = statistic.name == "captured";
  const auto positive = std::upper_bound(known.begin(), known.end(), std::max(range.low, 0.0));
  const double smallest = range.low > 0.0 ? range.low : positive == known.end() ? 0.0 : *positive;
  if (!is_share && range.least >= 0.0 && smallest > 0.0 && range.high > decade * smallest) {
    range.low = smallest;
    range.by_logarithm = true;
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

std::string beside(double map_size, double y, const std::string& words) {
  return muted_text(left + map_size + bar_gap + bar_width + 6.0, y, words);
}

std::string swatch(double map_size, double y, double height, const std::string& colour) {
  return fmt::format(
      "<rect x=\"{:.1f}\" y=\"{:.1f}\" width=\"{}\" height=\"{:.2f}\" fill=\"{}\"/>\n",
      left + map_size + bar_gap, y, bar_width, height, colour);
}

/// Round numbers for the bar, apart from those at its ends.
std::vector<double> numbers_between(const ColourRange& range) {
  constexpr double nearest = 0.06;  // to an end, or to each other [-] of the bar
  std::vector<double> wanted = ticks(range.low, range.high - range.low);
  if (range.by_logarithm) {
    wanted.clear();
    const bool finely = range.high < decade * decade * range.low;
    for (double power = std::pow(10.0, std::floor(std::log10(range.low))); power < range.high;
         power *= decade) {
      for (const double one : {1.0, 2.0, 5.0}) {
        if (one == 1.0 || finely) {
          wanted.push_back(one * power);
        }
      }
    }
  }
  std::vector<double> result;
  for (const double number : wanted) {
    const double part = range.part(number);
    const double before = result.empty() ? 0.0 : range.part(result.back());
    if (number > range.low && part - before > nearest && part < 1.0 - nearest) {
      result.push_back(number);
    }
  }
  return result;
}

/// The colours, with the numbers at both ends; a single one, if all cells have the same number.
std::string bar_svg(const ColourRange& range, double map_size) {
  const int parts = range.high > range.low ? 32 : 1;
  std::string out;
  for (int part = 0; part < parts; ++part) {
    out += swatch(map_size, top + map_size * (parts - 1 - part) / parts,
                  map_size / parts + (parts > 1 ? 0.5 : 0.0), colour_of((part + 0.5) / parts));
  }
  if (parts == 1) {
    return out + beside(map_size, top + map_size / 2 + 4.0, fmt::format("{:.4g}", range.high));
  }
  for (const double number : numbers_between(range)) {
    out += beside(map_size, top + map_size * (1.0 - range.part(number)) + 4.0,
                  fmt::format("{:.4g}", number));
  }
  if (range.by_logarithm) {
    out += muted_text(left + map_size + bar_gap, top - 8.0, "log scale");
  }
  return out +
         beside(map_size, top + 12.0,
                fmt::format("{}{:.4g}", range.most > range.high ? "≥ " : "", range.high)) +
         beside(map_size, top + map_size,
                fmt::format("{}{:.4g}", range.least < range.low ? "≤ " : "", range.low));
}

/// The colours of the names that occur, the first one below.
std::string names_svg(const AtlasMap& map, const ColourRange& range,
                      const std::vector<double>& known, double map_size) {
  std::string out;
  double y = top + map_size;
  for (std::size_t name = 0; name < map.names.size(); ++name) {
    const auto number = static_cast<double>(name);
    if (std::find(known.begin(), known.end(), number) != known.end()) {
      y -= name_height;
      out += swatch(map_size, y, bar_width, range.colour(number)) +
             beside(map_size, y + 12.0, map.names[name]);
    }
  }
  return out;
}

std::string cell_svg(const Atlas& atlas, std::size_t cell, const std::string& words,
                     const std::string& fill, double map_size) {
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

std::string atlas_csv(const Atlas& atlas, const AtlasMap& map, const Statistic& statistic) {
  const auto& across = atlas.axes[0].distribution.numbers;
  const auto& up = atlas.axes[1].distribution.numbers;
  std::string csv =
      csv_line({axis_title(atlas.axes[0]), axis_title(atlas.axes[1]), statistic_title(statistic)});
  for (std::size_t cell = 0; cell < map.cells.size(); ++cell) {
    csv += csv_line({fmt::format("{}", across[cell % across.size()]),
                     fmt::format("{}", up[cell / across.size()]),
                     map.cells[cell] ? words_of(map, map.cells[cell]) : ""});
  }
  return csv;
}

std::string atlas_svg(const Atlas& atlas, const AtlasMap& map, const Statistic& statistic) {
  std::vector<double> known;
  for (const std::optional<double>& value : map.cells) {
    if (value) {
      known.push_back(*value);
    }
  }
  const double map_size = size_of_map(atlas);
  const ColourRange range = known.empty() ? ColourRange{} : range_of(map, statistic, known);
  std::string drawn;
  for (std::size_t cell = 0; cell < map.cells.size(); ++cell) {
    const std::optional<double>& value = map.cells[cell];
    drawn += cell_svg(atlas, cell, words_of(map, value),
                      value ? range.colour(*value) : line_colours[grey_line], map_size);
  }
  drawn += axes_svg(atlas, map_size);
  if (!known.empty()) {
    drawn += map.names.empty() ? bar_svg(range, map_size) : names_svg(map, range, known, map_size);
  }
  return svg_sheet({.width = left + map_size + bar_gap + bar_width + numbers_room,
                    .height = top + map_size + labels_room,
                    .left = left,
                    .title = statistic_title(statistic),
                    .title_y = 24.0,
                    .has_links = true},
                   drawn);
}

}  // namespace tautline::bench
