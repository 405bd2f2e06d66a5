#include "bench/ensemble/output/atlas.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cassert>
#include <numeric>

#include "bench/ensemble/draw.hpp"

namespace tautline::bench {
namespace {

/// The values of one statistic that the draws of each cell have.
std::vector<std::vector<double>> values_by_cell(const EnsembleReport& report, std::size_t place,
                                                std::size_t cells) {
  const DrawTable& draws = report.result.draws.front();
  std::vector<std::vector<double>> result(cells);
  for (std::size_t draw = 0; draw < draws.size(); ++draw) {
    if (const std::optional<double> value = draws.value(draw, place)) {
      result[grid_point(report.request.spec, draw) % cells].push_back(*value);
    }
  }
  return result;
}

double mean(const std::vector<double>& values) {
  return std::accumulate(values.begin(), values.end(), 0.0) / static_cast<double>(values.size());
}

/// The one that most of `values` are, the least of those.
double most_frequent(std::vector<double> values) {
  std::sort(values.begin(), values.end());
  double result = values.front();
  std::ptrdiff_t most = 0;
  for (auto first = values.begin(); first != values.end();) {
    const auto end = std::upper_bound(first, values.end(), *first);
    if (end - first > most) {
      most = end - first;
      result = *first;
    }
    first = end;
  }
  return result;
}

/// The map of the statistic of this name.
AtlasMap map_of(const EnsembleReport& report, const std::string& name, std::size_t cells) {
  AtlasMap map{place_of_statistic(report.findings.statistics, name), {}, {}};
  const bool is_cable = name == "first_cable";
  bool is_whole = true;  // no cell is a share
  for (const std::vector<double>& values : values_by_cell(report, map.statistic, cells)) {
    auto& cell = map.cells.emplace_back();
    if (!values.empty()) {
      cell = is_cable ? most_frequent(values) : mean(values);
      is_whole = is_whole && (*cell == 0.0 || *cell == 1.0);  // exactly: so many draws of as many
    }
  }
  if (is_cable) {
    for (std::size_t cable = 0; cable < cables_of(report.request.spec.the_case); ++cable) {
      map.names.push_back(fmt::format("cable {}", cable));
    }
  } else if (name == "captured" && is_whole) {
    map.names = {"released", "captured"};
  }
  return map;
}

}  // namespace

std::string picture_name(std::size_t cell) { return fmt::format("cells/{:04}.svg", cell); }

std::optional<Atlas> atlas_of(const EnsembleReport& report) {
  const EnsembleSpec& spec = report.request.spec;
  const std::vector<std::size_t> axes = grid_axes(spec);
  if (axes.size() < 2) {
    return std::nullopt;
  }
  Atlas atlas{{spec.varied[axes[0]], spec.varied[axes[1]]}, {}, {}, {}};
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
  const std::vector<std::string> of_case = {"impacts", "settled_fast", "swing_energy", "captured",
                                            "first_cable"};
  const std::vector<std::string> of_system = {
      "impacts",          "settled_fast", "largest_impulse", "largest_tension",
      "impacts_a_period", "repeats",      "first_cable"};
  for (const std::string& name : is_system(spec.the_case) ? of_system : of_case) {
    atlas.maps.push_back(map_of(report, name, cells));
  }
  return atlas;
}

}  // namespace tautline::bench
