#include "bench/gate/trend/trend.hpp"

#include <algorithm>
#include <cassert>
#include <map>
#include <set>
#include <utility>

#include "bench/base/listed.hpp"
#include "bench/base/statistics.hpp"
#include "bench/gate/changes.hpp"

namespace tautline::bench {
namespace {

/// The runs of one engine, model and step in one report, by case.
using Runs = std::map<std::string, const RunRow*>;

/// One report, as a trend looks at it.
struct Stage {
  std::map<SetupKey, Runs> setups;
  std::map<std::string, const CaseRow*> cases;
  std::map<std::string, std::string> versions;              // by engine
  std::map<SetupKey, std::map<std::string, double>> costs;  // [s], of a simulated second, by case
};

Stage stage_of(const Report& report) {
  Stage stage;
  for (const RunRow& run : report.runs) {
    stage.setups[setup_of(run.key)].emplace(run.key.the_case, &run);
  }
  for (const CaseRow& the_case : report.cases) {
    stage.cases.emplace(the_case.name, &the_case);
  }
  for (const EngineRow& engine : report.engines) {
    stage.versions[engine.name] = engine.info ? engine.info->version : "";
  }
  for (const TimingRow& timing : report.context.timing) {
    if (timing.second_cost > 0.0) {
      stage.costs[setup_of(timing.key)][timing.key.the_case] = timing.second_cost;
    }
  }
  return stage;
}

/// How many runs got worse and better, by engine, model and step and by metric.
struct Moves {
  std::size_t worse = 0;
  std::size_t better = 0;
};
using MovesByRow = std::map<std::pair<SetupKey, std::size_t>, Moves>;

MovesByRow moves_of(const Changes& changes) {
  MovesByRow result;
  for (const MetricChange& change : changes.got_worse) {
    ++result[{setup_of(change.key), change.metric}].worse;
  }
  for (const MetricChange& change : changes.got_better) {
    ++result[{setup_of(change.key), change.metric}].better;
  }
  return result;
}

/// Goes through the reports once for each row.
class Trends {
 public:
  Trends(const std::vector<Report>& reports, const Noise& noise) {
    std::transform(reports.begin(), reports.end(), std::back_inserter(stages_), stage_of);
    moves_.resize(1);
    for (std::size_t index = 1; index < reports.size(); ++index) {
      changes_.push_back(changes(reports[index - 1], reports[index], noise));
      moves_.push_back(moves_of(changes_.back()));
    }
  }

  [[nodiscard]] const std::vector<Changes>& all_changes() const { return changes_; }

  [[nodiscard]] std::vector<TrendCost> costs() const {
    std::map<SetupKey, std::map<std::string, std::size_t>> found;
    std::map<SetupKey, std::size_t> with_runs;
    for (const Stage& stage : stages_) {
      for (const auto& [key, cases] : stage.costs) {
        ++with_runs[key];
        for (const auto& [name, cost] : cases) {
          ++found[key][name];
        }
      }
    }
    std::vector<TrendCost> result;
    for (auto& [key, cases] : found) {
      std::erase_if(cases,
                    [&, all = with_runs[key]](const auto& one) { return one.second != all; });
      if (!cases.empty()) {
        result.push_back({key, cases.size(), cost_points(key, cases)});
      }
    }
    return result;
  }

  [[nodiscard]] std::vector<TrendRow> rows() const {
    std::set<SetupKey> keys;
    for (const Stage& stage : stages_) {
      for (const auto& [key, runs] : stage.setups) {
        keys.insert(key);
      }
    }
    std::vector<TrendRow> result;
    for (const SetupKey& key : keys) {
      for (std::size_t metric = 0; metric < metric_list().size(); ++metric) {
        if (is_asked_first(metric_list()[metric])) {
          result.push_back(row(key, metric));
        }
      }
    }
    std::erase_if(result, [](const TrendRow& one) { return one.cases == 0; });
    return result;
  }

 private:
  [[nodiscard]] TrendRow row(const SetupKey& key, std::size_t metric) const {
    const std::vector<std::string> cases = common_cases(key, metric);
    TrendRow result{key, metric, cases.size(), {}};
    for (std::size_t index = 0; index < stages_.size(); ++index) {
      const auto runs = stages_[index].setups.find(key);
      const bool none = runs == stages_[index].setups.end() || cases.empty();
      result.points.push_back(none ? std::nullopt
                                   : std::optional(point(index, key, metric, runs->second, cases)));
    }
    return result;
  }

  /// The cases of `key` in which every report that has such runs could measure `metric`.
  [[nodiscard]] std::vector<std::string> common_cases(const SetupKey& key,
                                                      std::size_t metric) const {
    std::map<std::string, std::size_t> found;
    std::map<std::string, const CaseRow*> first;
    std::size_t with_runs = 0;
    for (const Stage& stage : stages_) {
      const auto runs = stage.setups.find(key);
      if (runs == stage.setups.end()) {
        continue;
      }
      ++with_runs;
      for (const auto& [name, run] : runs->second) {
        const CaseRow* own = stage.cases.at(name);
        const bool same = same_case(*first.try_emplace(name, own).first->second, *own);
        found[name] += same && did_its_work(run->status) && run->metric(metric) ? 1U : 0U;
      }
    }
    std::vector<std::string> result;
    for (const auto& [name, count] : found) {
      if (count == with_runs) {
        result.push_back(name);
      }
    }
    return result;
  }

  [[nodiscard]] TrendPoint point(std::size_t index, const SetupKey& key, std::size_t metric,
                                 const Runs& runs, const std::vector<std::string>& cases) const {
    const std::vector<double> values = listed(
        cases, [&](const std::string& name) { return runs.at(name)->metric(metric).value(); });
    TrendPoint result{stages_[index].versions.at(key.engine), median(values),
                      quantile(values, 0.25), quantile(values, 0.75)};
    if (const auto moves = moves_[index].find({key, metric}); moves != moves_[index].end()) {
      result.worse = moves->second.worse;
      result.better = moves->second.better;
    }
    return result;
  }

  [[nodiscard]] std::vector<std::optional<double>> cost_points(
      const SetupKey& key, const std::map<std::string, std::size_t>& cases) const {
    std::vector<std::optional<double>> points;
    for (const Stage& stage : stages_) {
      const auto own = stage.costs.find(key);
      if (own == stage.costs.end()) {
        points.emplace_back();
        continue;
      }
      const std::vector<double> values =
          listed(cases, [&](const auto& one) { return own->second.at(one.first); });
      points.emplace_back(median(values));
    }
    return points;
  }

  std::vector<Stage> stages_;
  std::vector<MovesByRow> moves_;  // since the report before; of the first none
  std::vector<Changes> changes_;
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
  }
  const Trends trends(reports, noise);
  result.rows = trends.rows();
  result.costs = trends.costs();
  result.changes = trends.all_changes();
  if (!result.changes.empty()) {
    result.latest = result.changes.back();
  }
  return result;
}

}  // namespace tautline::bench
