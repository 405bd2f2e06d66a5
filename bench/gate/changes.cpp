// Two reports side by side: which runs are in one alone, which fail now, which numbers changed by
// more than rounding, chaos and the clock explain.

#include "bench/gate/changes.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <limits>
#include <map>
#include <optional>
#include <utility>

#include "bench/base/statistics.hpp"
#include "bench/base/text.hpp"
#include "bench/gate/verdict.hpp"

namespace tautline::bench {
namespace {

std::map<RunKey, const RunRow*> runs_of(const Report& report) {
  std::map<RunKey, const RunRow*> runs;
  for (const RunRow& run : report.runs) {
    runs.emplace(run.key, &run);
  }
  return runs;
}

std::map<std::string, const CaseRow*> cases_of(const Report& report) {
  std::map<std::string, const CaseRow*> cases;
  for (const CaseRow& the_case : report.cases) {
    cases.emplace(the_case.name, &the_case);
  }
  return cases;
}

/// True where a run that ended as `before` does better as `after`, which is another.
bool recovers(Status before, Status after) {
  return did_its_work(after) && (!did_its_work(before) || before == Status::stopped);
}

/// Goes through the runs of two reports.
class Comparison {
 public:
  Comparison(const Report& before, const Report& after, const Noise& noise)
      : one_(runs_of(before)),
        two_(runs_of(after)),
        cases_(cases_of(before)),
        later_cases_(cases_of(after)),
        before_(before) {
    result_.noise = noise;
  }

  Changes result() && {
    for (const auto& [key, run] : one_) {
      const auto later = two_.find(key);
      if (later == two_.end()) {
        result_.only_before.push_back(key);
      } else if (!same_case(*cases_.at(key.the_case), *later_cases_.at(key.the_case))) {
        result_.other_case.push_back(key);
      } else {
        compare(*run, *later->second);
      }
    }
    for (const auto& [key, run] : two_) {
      if (!one_.contains(key)) {
        result_.only_after.push_back(key);
      }
    }
    return std::move(result_);
  }

 private:
  void compare(const RunRow& run, const RunRow& later) {
    ++result_.compared;
    if (run.status != later.status) {
      auto& rows = recovers(run.status, later.status) ? result_.recovered : result_.new_failures;
      rows.push_back({run.key, run.status, later.status, later.reason});
      return;
    }
    for (std::size_t place = 0; place < metric_list().size(); ++place) {
      if (metric_list()[place].noise != NoiseKind::any) {
        compare_metric(run, later, place);
      }
    }
  }

  void compare_metric(const RunRow& run, const RunRow& later, std::size_t place) {
    const MetricChange change = {run.key, place, run.metric(place), later.metric(place)};
    const auto& [key, metric, before, after] = change;
    if (before.has_value() != after.has_value()) {  // measured in one alone
      (before ? result_.got_worse : result_.got_better).push_back(change);
    } else if (before &&
               std::abs(*before - *after) > allowed_change(metric_list()[metric], *before, *after,
                                                           setting_of(run), result_.noise)) {
      (*after > *before ? result_.got_worse : result_.got_better).push_back(change);
    }
  }

  [[nodiscard]] NoiseSetting setting_of(const RunRow& run) const {
    const CaseRow& the_case = *cases_.at(run.key.the_case);
    NoiseSetting setting;
    setting.step = run.key.step;
    setting.precision = precision_of(before_, run.key) == "float32"
                            ? static_cast<double>(std::numeric_limits<float>::epsilon())
                            : std::numeric_limits<double>::epsilon();
    setting.energy = std::max(1.0, std::abs(the_case.start_energy));
    setting.exact_impacts = run.details ? run.details->in(Window::horizon).exact : 0;
    setting.beyond_horizon = the_case.horizon < the_case.duration;
    return setting;
  }

  std::map<RunKey, const RunRow*> one_;
  std::map<RunKey, const RunRow*> two_;
  std::map<std::string, const CaseRow*> cases_;
  std::map<std::string, const CaseRow*> later_cases_;
  const Report& before_;
  Changes result_;
};

/// By name, the versions of a report's engines; none of one that is not there.
std::map<std::string, std::optional<std::string>> engine_versions(const Report& report) {
  std::map<std::string, std::optional<std::string>> versions;
  for (const EngineRow& engine : report.engines) {
    versions[engine.name] =
        engine.info ? std::optional<std::string>(engine.info->version) : std::nullopt;
  }
  return versions;
}

/// The names and versions of what made the reports, where they differ.
std::vector<VersionChange> version_changes(const Report& before, const Report& after) {
  std::vector<VersionChange> result = {
      {"tautline", before.version, after.version},
      {"compiler", before.context.compiler, after.context.compiler},
      {"build_type", before.context.build_type, after.context.build_type},
      {"processor", before.context.processor, after.context.processor}};
  auto engines = engine_versions(before);
  auto later = engine_versions(after);
  for (const auto& [name, version] : later) {
    engines.try_emplace(name, std::nullopt);
  }
  for (const auto& [name, version] : engines) {
    result.push_back({name, version, later[name]});
  }
  std::erase_if(result, [](const VersionChange& row) { return row.before == row.after; });
  return result;
}

/// The median cost ratio of each engine, model and step over the runs that both reports have.
std::vector<CostChange> cost_changes(const Report& before, const Report& after, double noise) {
  std::map<RunKey, double> later;
  for (const TimingRow& row : after.context.timing) {
    later.emplace(row.key, row.cost_ratio);
  }
  std::map<SetupKey, std::vector<double>> factors;
  for (const TimingRow& row : before.context.timing) {
    const auto other = later.find(row.key);
    if (other != later.end() && row.cost_ratio > 0.0 && other->second > 0.0) {
      factors[setup_of(row.key)].push_back(other->second / row.cost_ratio);
    }
  }
  std::vector<CostChange> result;
  for (const auto& [key, of_cases] : factors) {
    const double factor = median(of_cases);
    if (factor > noise || factor < 1.0 / noise) {
      result.push_back({key, of_cases.size(), factor});
    }
  }
  return result;
}

using Number = std::optional<double>;

/// Every number that decides the motion: body, cables, start and duration.
std::vector<Number> numbers_of(const CaseRow& the_case) {
  std::vector<Number> numbers = {the_case.duration, the_case.start_energy};
  if (the_case.plane) {
    numbers.insert(numbers.end(), {the_case.plane->body.mass, the_case.plane->body.inertia,
                                   the_case.plane->gravity.x(), the_case.plane->gravity.y()});
  }
  if (the_case.system) {  // as a number, of the digits that a double has
    numbers.push_back(static_cast<double>(std::stoull(the_case.system->hash, nullptr, 16) >> 11U));
  }
  for (const CableRow& cable : the_case.geometry()) {
    numbers.insert(numbers.end(), {cable.anchor.x(), cable.anchor.y(), cable.attachment.x(),
                                   cable.attachment.y(), cable.length, cable.restitution});
  }
  for (const Eigen::Index coordinate : {0, 1, 2}) {
    numbers.push_back(the_case.start ? Number((*the_case.start)[coordinate]) : std::nullopt);
  }
  return numbers;
}

bool same_number(const Number& one, const Number& two) {
  constexpr double rounding = 1e-9;  // [-]
  if (!one || !two) {
    return one.has_value() == two.has_value();
  }
  return std::abs(*one - *two) <= rounding * std::max(1.0, std::abs(*one));
}

}  // namespace

bool same_case(const CaseRow& one, const CaseRow& two) {
  const std::vector<Number> its = numbers_of(one);
  const std::vector<Number> others = numbers_of(two);
  return std::equal(its.begin(), its.end(), others.begin(), others.end(), same_number);
}

std::vector<std::string> incomparable(const Report& before, const Report& after) {
  std::vector<std::string> problems;
  const auto add = [&](const char* option, const std::string& one, const std::string& two) {
    if (one != two) {
      problems.push_back(fmt::format(
          "the reports measure different things: {} is {} in the first and {} in the second",
          option, printable(one), printable(two)));
    }
  };
  const ReportOptions& one = before.options;
  const ReportOptions& two = after.options;
  add("law", "\"" + one.law + "\"", "\"" + two.law + "\"");
  add("count_speed", shortest(one.count_speed), shortest(two.count_speed));
  add("early_impacts", std::to_string(one.early_impacts), std::to_string(two.early_impacts));
  return problems;
}

Changes changes(const Report& before, const Report& after, const Noise& noise) {
  Changes result = Comparison(before, after, noise).result();
  result.versions = version_changes(before, after);
  result.costs = cost_changes(before, after, noise.cost);
  return result;
}

}  // namespace tautline::bench
