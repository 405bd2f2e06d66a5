#include "bench/gate/trend.hpp"

#include <algorithm>
#include <cassert>
#include <map>
#include <set>
#include <utility>

#include "bench/base/listed.hpp"
#include "bench/base/statistics.hpp"

namespace tautline::bench {
namespace {

/// A number for each case, in each report; none of a report without such runs.
using NumbersByCase = std::vector<std::optional<std::map<std::string, double>>>;

/// Those of the cases that all reports with such runs have.
struct CommonNumbers {
  std::size_t cases = 0;
  std::vector<std::optional<std::vector<double>>> reports;
};

CommonNumbers common_numbers(const NumbersByCase& reports) {
  std::map<std::string, std::size_t> found;
  std::size_t with_runs = 0;
  for (const auto& report : reports) {
    if (report) {
      ++with_runs;
      for (const auto& [name, number] : *report) {
        ++found[name];
      }
    }
  }
  std::erase_if(found, [&](const auto& one) { return one.second != with_runs; });
  CommonNumbers result{found.size(), {}};
  for (const auto& report : reports) {
    auto& numbers = result.reports.emplace_back();
    if (report && result.cases > 0) {
      numbers = listed(found, [&](const auto& one) { return report->at(one.first); });
    }
  }
  return result;
}

/// Several reports, row by row.
class Trends {
 public:
  Trends(const std::vector<Report>& reports, Trend& trend) : reports_(reports), trend_(trend) {
    for (std::size_t index = 0; index < reports.size(); ++index) {
      auto& cases = cases_.emplace_back();
      for (const CaseRow& the_case : reports[index].cases) {
        cases.emplace(the_case.name, &the_case);
      }
      for (const RunRow& run : reports[index].runs) {
        auto& runs = runs_.try_emplace(setup_of(run.key), reports.size()).first->second;
        runs[index].emplace(run.key.the_case, &run);
      }
      for (const TimingRow& timing : reports[index].context.timing) {
        if (timing.second_cost > 0.0) {
          auto& costs = costs_.try_emplace(setup_of(timing.key), reports.size()).first->second;
          auto& own = costs[index] ? *costs[index] : costs[index].emplace();
          own[timing.key.the_case] = timing.second_cost;
        }
      }
    }
    for (std::size_t index = 0; index < trend.changes.size(); ++index) {
      for (const MetricChange& change : trend.changes[index].got_worse) {
        ++moves_[{setup_of(change.key), change.metric, index + 1}].first;
      }
      for (const MetricChange& change : trend.changes[index].got_better) {
        ++moves_[{setup_of(change.key), change.metric, index + 1}].second;
      }
    }
  }

  void find_costs() {
    for (const auto& [key, numbers] : costs_) {
      const CommonNumbers common = common_numbers(numbers);
      if (common.cases > 0) {
        trend_.costs.push_back({key, common.cases, listed(common.reports, [](const auto& report) {
                                  return report ? std::optional(median(*report)) : std::nullopt;
                                })});
      }
    }
  }

  void find_rows() {
    for (const auto& [key, runs] : runs_) {
      for (std::size_t metric = 0; metric < metric_list().size(); ++metric) {
        const CommonNumbers common = is_asked_first(metric_list()[metric])
                                         ? common_numbers(numbers_of(runs, metric))
                                         : CommonNumbers();
        if (common.cases > 0) {
          trend_.rows.push_back({key, metric, common.cases, points_of(key, metric, common)});
        }
      }
    }
  }

 private:
  /// The runs of one engine, model and step in each report, by case.
  using Runs = std::vector<std::map<std::string, const RunRow*>>;

  /// What was measured of `metric`; of a case that a later report changes, only in the first.
  [[nodiscard]] NumbersByCase numbers_of(const Runs& runs, std::size_t metric) const {
    NumbersByCase result(runs.size());
    std::map<std::string, const CaseRow*> first;
    for (std::size_t index = 0; index < runs.size(); ++index) {
      if (!runs[index].empty()) {
        result[index].emplace();
      }
      for (const auto& [name, run] : runs[index]) {
        const CaseRow* const own = cases_[index].at(name);
        const auto value = did_its_work(run->status) ? run->metric(metric) : std::nullopt;
        if (same_case(*first.try_emplace(name, own).first->second, *own) && value) {
          result[index]->emplace(name, *value);
        }
      }
    }
    return result;
  }

  [[nodiscard]] std::vector<std::optional<TrendPoint>> points_of(
      const SetupKey& key, std::size_t metric, const CommonNumbers& common) const {
    std::vector<std::optional<TrendPoint>> points(common.reports.size());
    for (std::size_t index = 0; index < points.size(); ++index) {
      if (const auto& values = common.reports[index]) {
        const EngineRow& engine = *find_by(reports_[index].engines, &EngineRow::name, key.engine);
        const auto moves = moves_.find({key, metric, index});
        const auto [worse, better] = moves == moves_.end() ? Moves() : moves->second;
        points[index] = {engine.info ? engine.info->version : "",
                         median(*values),
                         quantile(*values, 0.25),
                         quantile(*values, 0.75),
                         worse,
                         better};
      }
    }
    return points;
  }

  /// How many runs got worse, and better.
  using Moves = std::pair<std::size_t, std::size_t>;

  const std::vector<Report>& reports_;
  Trend& trend_;
  std::map<SetupKey, Runs> runs_;
  std::map<SetupKey, NumbersByCase> costs_;                   // [s], of a simulated second
  std::vector<std::map<std::string, const CaseRow*>> cases_;  // of each report
  std::map<std::tuple<SetupKey, std::size_t, std::size_t>, Moves> moves_;  // by metric and report
};

}  // namespace

bool TrendRow::moves() const {
  return std::any_of(points.begin(), points.end(), [](const std::optional<TrendPoint>& point) {
    return point && point->worse + point->better > 0;
  });
}

Trend trend(const std::vector<Report>& reports, const std::vector<std::string>& names,
            const Noise& noise) {
  assert(!reports.empty() && reports.size() == names.size());
  Trend result;
  for (std::size_t index = 0; index < reports.size(); ++index) {
    const Report& report = reports[index];
    result.reports.push_back(
        {names[index], report.context.started, report.version, report.runs.size()});
    if (index > 0) {
      result.changes.push_back(changes(reports[index - 1], report, noise));
      result.latest = result.changes.back();
    }
  }
  Trends trends(reports, result);
  trends.find_rows();
  trends.find_costs();
  return result;
}

}  // namespace tautline::bench
