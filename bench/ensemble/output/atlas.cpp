#include "bench/ensemble/output/atlas.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cassert>
#include <numeric>

#include "bench/base/text.hpp"
#include "bench/ensemble/draw/draw.hpp"
#include "bench/ensemble/spec/quantity.hpp"
#include "bench/solution/plot_style.hpp"

namespace tautline::bench {
namespace {

// of the sheet [px]
constexpr double map_size = 360.0;
constexpr double left = 84.0;
constexpr double top = 40.0;
constexpr double bar_width = 16.0;
constexpr double bar_gap = 18.0;
constexpr double numbers_room = 80.0;
constexpr double labels_room = 52.0;

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
  const auto text = [](double x, double y, const char* anchor, const std::string& words) {
    return fmt::format(
        "<text class=\"muted\" text-anchor=\"{}\" x=\"{:.1f}\" y=\"{:.1f}\">{}"
        "</text>\n",
        anchor, x, y, xml_text(words));
  };
  return text(left, bottom + 18.0, "start", fmt::format("{:.4g}", across.front())) +
         text(left + map_size, bottom + 18.0, "end", fmt::format("{:.4g}", across.back())) +
         text(left + map_size / 2.0, bottom + 38.0, "middle", axis_title(atlas.axes[0])) +
         text(left - 6.0, bottom, "end", fmt::format("{:.4g}", up.front())) +
         text(left - 6.0, top + 12.0, "end", fmt::format("{:.4g}", up.back())) +
         fmt::format(
             "<text class=\"muted\" text-anchor=\"middle\" transform=\"translate({:.1f} "
             "{:.1f}) rotate(-90)\">{}</text>\n",
             left - 60.0, top + map_size / 2.0, xml_text(axis_title(atlas.axes[1])));
}

/// The colour of a number, of those that are known.
std::string colour_between(double number, double least, double most) {
  return colour_of(most > least ? (number - least) / (most - least) : 0.5);
}

/// The colours, with the numbers at both ends; a single one, where all cells have the same number.
std::string bar_svg(double least, double most) {
  const double x = left + map_size + bar_gap;
  std::string out;
  const int parts = most > least ? 32 : 1;
  for (int part = 0; part < parts; ++part) {
    out += fmt::format(
        "<rect x=\"{:.1f}\" y=\"{:.1f}\" width=\"{}\" height=\"{:.2f}\" "
        "fill=\"{}\"/>\n",
        x, top + map_size * (parts - 1 - part) / parts, bar_width,
        map_size / parts + (parts > 1 ? 0.5 : 0.0), colour_of((part + 0.5) / parts));
  }
  const auto number = [&](double y, double value) {
    out += fmt::format("<text class=\"muted\" x=\"{:.1f}\" y=\"{:.1f}\">{:.4g}</text>\n",
                       x + bar_width + 6.0, y, value);
  };
  if (parts == 1) {
    number(top + map_size / 2 + 4.0, most);
  } else {
    number(top + 12.0, most);
    number(top + map_size, least);
  }
  return out;
}

std::string cell_svg(const Atlas& atlas, std::size_t cell, std::optional<double> value,
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
      value ? fmt::format("{:.6g}", *value) : "none");
  if (!atlas.pictured[cell]) {
    return rect + "\n";
  }
  return fmt::format("<a href=\"{}\">{}</a>\n", picture_name(cell), rect);
}

}  // namespace

std::string picture_name(std::size_t cell) { return fmt::format("cells/{:04}.svg", cell); }

std::optional<Atlas> atlas_of(const EnsembleReport& report) {
  const EnsembleSpec& spec = report.request.spec;
  const std::vector<std::size_t> axes = grid_axes(spec);
  if (axes.size() < 2) {
    return std::nullopt;
  }
  Atlas atlas{{spec.varied[axes[0]], spec.varied[axes[1]]}, {}, {}, {}, {}};
  const std::size_t cells =
      atlas.axes[0].distribution.numbers.size() * atlas.axes[1].distribution.numbers.size();
  assert(cells > 0 && "a grid has two points at least");
  atlas.draws.resize(cells);
  std::iota(atlas.draws.begin(), atlas.draws.end(), std::size_t{0});  // two grids go fastest
  const DrawTable& draws = report.result.draws.front();
  for (const std::size_t draw : atlas.draws) {
    atlas.pictured.push_back(cells <= most_pictures && !report.result.interrupted &&
                             draws.solved(draw));
  }
  for (const char* name : {"impacts", "settled_fast", "swing_energy", "captured", "first_cable"}) {
    const std::size_t place = place_of_statistic(report.findings.statistics, name);
    std::vector<double> sums(cells, 0.0);
    std::vector<double> counts(cells, 0.0);
    for (std::size_t draw = 0; draw < draws.size(); ++draw) {
      if (const std::optional<double> value = draws.value(draw, place)) {
        const std::size_t cell = grid_point(spec, draw) % cells;
        sums[cell] += *value;
        counts[cell] += 1.0;
      }
    }
    auto& means = atlas.means.emplace_back();
    for (std::size_t cell = 0; cell < cells; ++cell) {
      means.push_back(counts[cell] > 0.0 ? std::optional(sums[cell] / counts[cell]) : std::nullopt);
    }
    atlas.statistics.push_back(place);
  }
  return atlas;
}

std::string atlas_svg(const Atlas& atlas, std::size_t index, const Statistic& statistic) {
  const auto& means = atlas.means[index];
  std::vector<double> known;
  for (const std::optional<double>& mean : means) {
    if (mean) {
      known.push_back(*mean);
    }
  }
  const auto [least, most] = std::minmax_element(known.begin(), known.end());
  std::string cells;
  for (std::size_t cell = 0; cell < means.size(); ++cell) {
    const std::optional<double>& mean = means[cell];
    cells += cell_svg(atlas, cell, mean, mean ? colour_between(*mean, *least, *most) : "#8a8a8a");
  }
  return fmt::format(
             "<svg xmlns=\"http://www.w3.org/2000/svg\" viewBox=\"0 0 {0:.0f} {1:.0f}\" "
             "width=\"{0:.0f}\" height=\"{1:.0f}\" role=\"img\">\n<title>{2}</title>\n{3}<rect "
             "class=\"paper\" width=\"100%\" height=\"100%\"/>\n<text class=\"title\" "
             "x=\"{4}\" y=\"24\">{2}</text>\n",
             left + map_size + bar_gap + bar_width + numbers_room, top + map_size + labels_room,
             xml_text(statistic_title(statistic)), plot_style, left) +
         cells + axes_svg(atlas) + (known.empty() ? "" : bar_svg(*least, *most)) + "</svg>\n";
}

}  // namespace tautline::bench
