// Of very many runs a report has fewer impacts each, or no page would hold it.

#include <algorithm>
#include <cstddef>
#include <numeric>
#include <set>
#include <utility>

#include "bench/report/replay_data.hpp"

namespace tautline::bench {
namespace {

using nlohmann::ordered_json;

/// The impacts of all runs may take so many bytes, each as a row of the columns and as a sample of
/// the path.
constexpr std::size_t impact_budget = 4'000'000;
constexpr std::size_t impact_size = 120;
constexpr std::size_t least_impacts = 24;

/// The places of the `most` impacts of `columns` that close fastest, in rising time.
std::vector<std::size_t> fastest(const ordered_json& columns, std::size_t most) {
  const auto speed = [&](std::size_t place) {
    const ordered_json& rate = columns.at("rate_before").at(place);
    return rate.is_number() ? -rate.get<double>() : 0.0;
  };
  std::vector<std::size_t> places(columns.at("time").size());
  std::iota(places.begin(), places.end(), std::size_t{0});
  std::stable_sort(places.begin(), places.end(),
                   [&](std::size_t a, std::size_t b) { return speed(a) > speed(b); });
  places.resize(std::min(places.size(), most));
  std::sort(places.begin(), places.end());
  return places;
}

/// Leaves the entries at `places` of every column of `table`.
void keep_rows(ordered_json& table, const std::vector<std::size_t>& places) {
  for (auto& [name, column] : table.items()) {
    if (column.is_array()) {
      ordered_json kept = ordered_json::array();
      for (const std::size_t place : places) {
        kept.push_back(std::move(column[place]));
      }
      column = std::move(kept);
    }
  }
}

/// The places in a path but for those at the times of `gone` that are not in `kept`.
std::vector<std::size_t> places_without(const ordered_json& times, const std::set<double>& gone,
                                        const std::set<double>& kept) {
  std::vector<std::size_t> places;
  for (std::size_t place = 0; place < times.size(); ++place) {
    const double time = times.at(place);
    const bool an_end = place == 0 || place + 1 == times.size();
    if (an_end || !gone.contains(time) || kept.contains(time)) {
      places.push_back(place);
    }
  }
  return places;
}

std::set<double> numbers(const ordered_json& column) {
  std::set<double> result;
  for (const ordered_json& value : column) {
    if (value.is_number()) {
      result.insert(value.get<double>());
    }
  }
  return result;
}

}  // namespace

void thin_impacts(ordered_json& report) {
  const std::size_t runs = std::max<std::size_t>(report.at("runs").size(), 1);
  const std::size_t most =
      std::clamp(impact_budget / runs / impact_size, least_impacts, most_impacts);
  for (ordered_json& run : report.at("runs")) {
    ordered_json& impacts = run.at("impacts");
    if (impacts.is_null() || impacts.at("time").size() <= most) {
      continue;
    }
    const std::set<double> all = numbers(impacts.at("time"));
    impacts["left_out"] =
        impacts.at("left_out").get<std::size_t>() + impacts.at("time").size() - most;
    keep_rows(impacts, fastest(impacts, most));
    ordered_json& path = run.at("path");
    keep_rows(path, places_without(path.at("time"), all, numbers(impacts.at("time"))));
  }
}

}  // namespace tautline::bench
