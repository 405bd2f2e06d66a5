#include <algorithm>
#include <cmath>
#include <iterator>
#include <map>
#include <string>
#include <tuple>
#include <utility>

#include "bench/base/statistics.hpp"
#include "bench/report/report.hpp"

namespace tautline::bench {
namespace {

using nlohmann::ordered_json;

/// An error this small is rounding: it does not shrink with the step [m].
constexpr double rounding_error = 1e-9;

/// Rows with one engine, model and step, in the order of their first.
using Group = std::vector<const ordered_json*>;

template <class Key>
std::vector<Group> grouped(const ordered_json& rows, const Key& key) {
  std::vector<Group> groups;
  std::map<decltype(key(rows.front())), std::size_t> places;
  for (const ordered_json& row : rows) {
    const auto [place, added] = places.try_emplace(key(row), groups.size());
    if (added) {
      groups.emplace_back();
    }
    groups[place->second].push_back(&row);
  }
  return groups;
}

std::string text_of(const ordered_json& row, const char* key) { return row.at(key); }

/// Engine, model and step.
std::tuple<std::string, std::string, double> by_setup(const ordered_json& row) {
  return {text_of(row, "engine"), text_of(row, "model"), row.at("step").get<double>()};
}

bool did_its_work(const ordered_json& row) {
  return row.at("status") == "finished" || row.at("status") == "stopped";
}

/// The values of one metric over the rows that have it.
template <class Get>
std::vector<double> collect(const Group& rows, const Get& get) {
  std::vector<double> values;
  for (const ordered_json* row : rows) {
    const ordered_json& metrics = row->at("metrics");
    if (!metrics.is_null()) {
      const ordered_json& value = get(metrics);
      if (value.is_number()) {
        values.push_back(value);
      }
    }
  }
  return values;
}

ordered_json median_and_worst(const std::vector<double>& values) {
  if (values.empty()) {
    return nullptr;
  }
  return {{"median", median(values)}, {"worst", *std::max_element(values.begin(), values.end())}};
}

/// Over the runs that did their work: one that gave up at once has no error to speak of.
ordered_json position_error(const Group& rows, const char* window) {
  Group good;
  std::copy_if(rows.begin(), rows.end(), std::back_inserter(good),
               [](const ordered_json* row) { return did_its_work(*row); });
  return median_and_worst(collect(
      good, [window](const ordered_json& metrics) -> const auto& {
        return metrics.at(window).at("position_error");
      }));
}

std::size_t total(const Group& rows, const char* what) {
  std::size_t sum = 0;
  for (const double value : collect(
           rows, [what](const ordered_json& metrics) -> const auto& {
             return metrics.at("horizon").at("impacts").at(what);
           })) {
    sum += static_cast<std::size_t>(value);
  }
  return sum;
}

ordered_json worst(const std::vector<double>& values) {
  return values.empty() ? ordered_json(nullptr)
                        : ordered_json(*std::max_element(values.begin(), values.end()));
}

/// The last impact faster than the first threshold: in how many cases the exact motion and the run
/// have one, and how far apart they are.
ordered_json settling_of(const Group& rows) {
  std::size_t exact = 0;
  std::size_t found = 0;
  std::vector<double> errors;
  for (const ordered_json* row : rows) {
    if (row->at("metrics").is_null()) {
      continue;
    }
    const ordered_json& last = row->at("metrics").at("settling").at("last_impacts").at(0);
    exact += last.at("exact").is_number() ? 1U : 0U;
    found += last.at("found").is_number() ? 1U : 0U;
    if (last.at("exact").is_number() && last.at("found").is_number()) {
      errors.push_back(std::abs(last.at("found").get<double>() - last.at("exact").get<double>()));
    }
  }
  return {{"exact", exact}, {"found", found}, {"error", median_and_worst(errors)}};
}

ordered_json summary_of(const Group& rows) {
  static const ordered_json none = nullptr;
  const auto bad = std::count_if(rows.begin(), rows.end(),
                                 [](const ordered_json* row) { return !did_its_work(*row); });
  const auto restitution = [](const ordered_json& metrics) -> const ordered_json& {
    const ordered_json& measured = metrics.at("restitution");
    return measured.is_null() ? none : measured.at("worst_error");
  };
  const auto overstretch = [](const ordered_json& metrics) -> const auto& {
    return metrics.at("overstretch");
  };
  const auto gain = [](const ordered_json& metrics) -> const auto& {
    return metrics.at("energy").at("largest_gain");
  };
  return {{"engine", rows.front()->at("engine")},
          {"model", rows.front()->at("model")},
          {"step", rows.front()->at("step")},
          {"cases", rows.size()},
          {"failed", bad},
          {"early_position_error", position_error(rows, "early")},
          {"horizon_position_error", position_error(rows, "horizon")},
          {"impacts",
           {{"exact", total(rows, "exact")},
            {"found", total(rows, "found")},
            {"matched", total(rows, "matched")}}},
          {"settling", settling_of(rows)},
          {"worst_restitution_error", worst(collect(rows, restitution))},
          {"overstretch", worst(collect(rows, overstretch))},
          {"energy_gain", worst(collect(rows, gain))}};
}

/// Slopes over the steps, one per case; cases at rounding throughout are counted apart.
ordered_json convergence_of(const Group& rows) {
  std::map<std::string, std::pair<std::vector<double>, std::vector<double>>> by_case;
  for (const ordered_json* row : rows) {
    if (!row->at("metrics").is_null()) {
      auto& [steps, errors] = by_case[text_of(*row, "case")];
      const ordered_json& error = row->at("metrics").at("early").at("position_error");
      if (error.is_number()) {
        steps.push_back(row->at("step"));
        errors.push_back(error);
      }
    }
  }
  std::vector<double> slopes;
  std::size_t at_rounding = 0;
  for (const auto& [name, curve] : by_case) {
    const auto& [steps, errors] = curve;
    if (errors.empty()) {
      continue;
    }
    if (*std::max_element(errors.begin(), errors.end()) <= rounding_error) {
      ++at_rounding;
    } else if (steps.size() >= 2 &&
               *std::min_element(errors.begin(), errors.end()) > rounding_error) {
      slopes.push_back(slope(steps, errors));
    }
  }
  ordered_json json = {{"engine", rows.front()->at("engine")},
                       {"model", rows.front()->at("model")},
                       {"cases", slopes.size()},
                       {"cases_at_rounding", at_rounding},
                       {"slope", nullptr}};
  if (!slopes.empty()) {
    json["slope"] = {{"smallest", *std::min_element(slopes.begin(), slopes.end())},
                     {"median", median(slopes)},
                     {"largest", *std::max_element(slopes.begin(), slopes.end())}};
  }
  return json;
}

}  // namespace

ordered_json costs_json(const ordered_json& timing) {
  ordered_json costs = ordered_json::array();
  for (const Group& group : grouped(timing, by_setup)) {
    const auto median_of = [&group](const char* key) {
      std::vector<double> values;
      std::transform(group.begin(), group.end(), std::back_inserter(values),
                     [key](const ordered_json* row) { return row->at(key).get<double>(); });
      return median(std::move(values));
    };
    costs.push_back({{"engine", group.front()->at("engine")},
                     {"model", group.front()->at("model")},
                     {"step", group.front()->at("step")},
                     {"cost_ratio", median_of("cost_ratio")},
                     {"second_cost", median_of("second_cost")}});
  }
  return costs;
}

ordered_json summary_json(const ordered_json& runs) {
  ordered_json summary = ordered_json::array();
  for (const Group& group : grouped(runs, by_setup)) {
    summary.push_back(summary_of(group));
  }
  return summary;
}

ordered_json convergence_json(const ordered_json& runs) {
  const auto key = [](const ordered_json& row) {
    return std::tuple(text_of(row, "engine"), text_of(row, "model"));
  };
  ordered_json convergence = ordered_json::array();
  for (const Group& group : grouped(runs, key)) {
    convergence.push_back(convergence_of(group));
  }
  return convergence;
}

}  // namespace tautline::bench
