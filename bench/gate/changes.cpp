// Two reports side by side: which runs are in one alone, which fail now, which numbers changed by
// more than rounding, chaos and the clock explain.

#include "bench/gate/changes.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>
#include <map>
#include <tuple>
#include <utility>

namespace tautline::bench {
namespace {

using nlohmann::ordered_json;
using Key = std::tuple<std::string, std::string, std::string, double>;  // as in a row
using Rows = std::map<Key, const ordered_json*>;

Key key_of(const ordered_json& row) {
  return {row.at("case"), row.at("engine"), row.at("model"), row.at("step").get<double>()};
}

Rows rows_of(const ordered_json& list) {
  Rows rows;
  for (const ordered_json& row : list) {
    rows.emplace(key_of(row), &row);
  }
  return rows;
}

ordered_json who(const Key& key) {
  return {{"case", std::get<0>(key)},
          {"engine", std::get<1>(key)},
          {"model", std::get<2>(key)},
          {"step", std::get<3>(key)}};
}

/// How much of a metric's change is noise.
enum class Kind { early, horizon, extreme, count };

struct ComparedMetric {
  const char* name;
  const char* unit;
  const char* place;  // below a run's metrics
  Kind kind;
};

constexpr std::array compared_metrics = {
    ComparedMetric{"early_position_error", "m", "/early/position_error", Kind::early},
    ComparedMetric{"early_angle_error", "rad", "/early/angle_error", Kind::early},
    ComparedMetric{"first_impact_error", "s", "/horizon/impacts/first_time_error", Kind::early},
    ComparedMetric{"horizon_position_error", "m", "/horizon/position_error", Kind::horizon},
    ComparedMetric{"missed_impacts", "1", "/horizon/impacts/missed", Kind::count},
    ComparedMetric{"restitution_error", "1", "/restitution/worst_error", Kind::extreme},
    ComparedMetric{"overstretch", "m", "/overstretch", Kind::extreme},
    ComparedMetric{"energy_gain", "J", "/energy/largest_gain", Kind::extreme}};

const ordered_json& value_at(const ordered_json& run, const char* place) {
  static const ordered_json none = nullptr;
  const ordered_json& metrics = run.at("metrics");
  const ordered_json::json_pointer pointer(place);
  return metrics.is_object() && metrics.contains(pointer) ? metrics.at(pointer) : none;
}

/// What a run's noise depends on beside its numbers.
struct Setting {
  double precision;      // [-], distance from 1 to the next number of the engine
  double energy;         // [J], the case's scale of energies
  double exact_impacts;  // up to the horizon
  bool beyond_horizon;   // the run goes on after it
};

/// How far two values of `metric` may be apart and still be the same.
double allowed(const ComparedMetric& metric, double one, double two, double step,
               const Setting& setting, const Noise& noise) {
  const double larger = std::max(std::abs(one), std::abs(two));
  double rounding = noise.early_rounding * setting.precision / step;
  switch (metric.kind) {
    case Kind::early:
      break;
    case Kind::horizon:
      rounding *= noise.growth;
      break;
    case Kind::count:
      return std::max(1.0, noise.impacts * setting.exact_impacts);
    case Kind::extreme:
      rounding *= std::string_view(metric.unit) == "J" ? setting.energy : 1.0;
      return rounding +
             larger * (setting.beyond_horizon ? 1.0 - 1.0 / noise.extremes : noise.relative);
  }
  return rounding + noise.relative * larger;
}

/// By name, what a report says of its engines or cases.
std::map<std::string, const ordered_json*> by_name(const ordered_json& list) {
  std::map<std::string, const ordered_json*> result;
  for (const ordered_json& entry : list) {
    result.emplace(entry.at("name"), &entry);
  }
  return result;
}

/// Equal up to the rounding of another compiler in any number.
bool same_values(const ordered_json& one, const ordered_json& two) {
  constexpr double rounding = 1e-9;  // [-]
  if (one.is_number() && two.is_number()) {
    const double a = one;
    const double b = two;
    return std::abs(a - b) <= rounding * std::max(1.0, std::abs(a));
  }
  if (one.is_structured() && one.type() == two.type()) {
    return std::equal(one.begin(), one.end(), two.begin(), two.end(), same_values);
  }
  return one == two;
}

/// What a case asks of its runs; a case of a suite may be changed and keep its name.
bool same_case(const ordered_json& one, const ordered_json& two) {
  constexpr std::array places = {"/cables",   "/duration", "/start_energy",
                                 "/body",     "/gravity",  "/geometry",
                                 "/path/x/0", "/path/y/0", "/path/angle/0"};
  return std::all_of(places.begin(), places.end(), [&](const char* place) {
    const ordered_json::json_pointer pointer(place);
    return same_values(one.at(pointer), two.at(pointer));
  });
}

class Comparison {
 public:
  Comparison(const ordered_json& before, const ordered_json& after, const Noise& noise)
      : before_(before),
        after_(after),
        noise_(noise),
        engines_(by_name(before.at("engines"))),
        cases_(by_name(before.at("cases"))),
        later_cases_(by_name(after.at("cases"))) {}

  ordered_json result() {
    const Rows one = rows_of(before_.at("runs"));
    const Rows two = rows_of(after_.at("runs"));
    for (const auto& [key, row] : one) {
      const auto other = two.find(key);
      if (other == two.end()) {
        gone_.push_back(who(key));
      } else if (!same_case(*cases_.at(std::get<0>(key)), *later_cases_.at(std::get<0>(key)))) {
        other_case_.push_back(who(key));
      } else {
        compare_runs(key, *row, *other->second);
      }
    }
    for (const auto& [key, row] : two) {
      if (!one.contains(key)) {
        added_.push_back(who(key));
      }
    }
    return as_json();
  }

 private:
  static bool went_wrong(const ordered_json& run) {
    return run.at("status") == "failed" || run.at("status") == "diverged";
  }

  void compare_runs(const Key& key, const ordered_json& one, const ordered_json& two) {
    ++compared_;
    if (one.at("status") != two.at("status")) {
      ordered_json row = who(key);
      row["before"] = one.at("status");
      row["after"] = two.at("status");
      row["reason"] = two.at("reason");
      const bool better = went_wrong(one) || (!went_wrong(two) && one.at("status") == "stopped");
      (better && !went_wrong(two) ? recovered_ : failures_).push_back(std::move(row));
      return;
    }
    for (const ComparedMetric& metric : compared_metrics) {
      compare_metric(key, metric, one, two);
    }
  }

  [[nodiscard]] Setting setting_of(const ordered_json& run) const {
    const ordered_json& engine = *engines_.at(run.at("engine"));
    const ordered_json& the_case = *cases_.at(run.at("case"));
    const ordered_json& impacts = value_at(run, "/horizon/impacts/exact");
    return {engine.value("precision", "") == "float32"
                ? static_cast<double>(std::numeric_limits<float>::epsilon())
                : std::numeric_limits<double>::epsilon(),
            std::max(1.0, std::abs(the_case.at("start_energy").get<double>())),
            impacts.is_number() ? impacts.get<double>() : 0.0,
            the_case.at("horizon").get<double>() < the_case.at("duration").get<double>()};
  }

  void compare_metric(const Key& key, const ComparedMetric& metric, const ordered_json& run,
                      const ordered_json& later) {
    const ordered_json& one = value_at(run, metric.place);
    const ordered_json& two = value_at(later, metric.place);
    if (one == two) {
      return;
    }
    ordered_json row = who(key);
    row["metric"] = metric.name;
    row["unit"] = metric.unit;
    row["before"] = one;
    row["after"] = two;
    if (!one.is_number() || !two.is_number()) {  // measured in one alone
      (one.is_number() ? worse_ : better_).push_back(std::move(row));
      return;
    }
    const double a = one;
    const double b = two;
    if (std::abs(a - b) > allowed(metric, a, b, std::get<3>(key), setting_of(run), noise_)) {
      (b > a ? worse_ : better_).push_back(std::move(row));
    }
  }

  /// The names and versions of what made the reports, where they differ.
  [[nodiscard]] ordered_json versions() const {
    ordered_json result = ordered_json::array();
    const auto add = [&](const std::string& what, const ordered_json& one,
                         const ordered_json& two) {
      if (one != two) {
        result.push_back({{"what", what}, {"before", one}, {"after", two}});
      }
    };
    add("tautline", before_.at("program").at("version"), after_.at("program").at("version"));
    for (const char* what : {"compiler", "build_type", "processor"}) {
      add(what, before_.at("context").at(what), after_.at("context").at(what));
    }
    auto later = by_name(after_.at("engines"));
    for (const auto& [name, engine] : engines_) {
      const auto other = later.find(name);
      add(name, engine->value("version", ordered_json(nullptr)),
          other == later.end() ? ordered_json(nullptr)
                               : other->second->value("version", ordered_json(nullptr)));
      later.erase(name);
    }
    for (const auto& [name, engine] : later) {
      add(name, nullptr, engine->value("version", ordered_json(nullptr)));
    }
    return result;
  }

  /// The median cost ratio of each engine, model and step over the runs that both reports have.
  [[nodiscard]] ordered_json costs() const {
    std::map<std::tuple<std::string, std::string, double>, std::vector<double>> factors;
    const Rows later = rows_of(after_.at("context").at("timing"));
    for (const auto& [key, row] : rows_of(before_.at("context").at("timing"))) {
      const auto other = later.find(key);
      const double one = row->at("cost_ratio");
      const double two = other == later.end() ? 0.0 : other->second->at("cost_ratio").get<double>();
      if (one > 0.0 && two > 0.0) {
        factors[{std::get<1>(key), std::get<2>(key), std::get<3>(key)}].push_back(two / one);
      }
    }
    ordered_json result = ordered_json::array();
    for (auto& [key, of_cases] : factors) {
      const auto middle = of_cases.begin() + static_cast<std::ptrdiff_t>(of_cases.size() / 2);
      std::nth_element(of_cases.begin(), middle, of_cases.end());
      if (*middle > noise_.cost || *middle < 1.0 / noise_.cost) {
        result.push_back({{"engine", std::get<0>(key)},
                          {"model", std::get<1>(key)},
                          {"step", std::get<2>(key)},
                          {"cases", of_cases.size()},
                          {"factor", *middle}});
      }
    }
    return result;
  }

  [[nodiscard]] ordered_json as_json() const {
    return {{"schema", 1},
            {"compared", compared_},
            {"worse", !(failures_.empty() && worse_.empty() && gone_.empty())},
            {"noise",
             {{"relative", noise_.relative},
              {"early_rounding", noise_.early_rounding},
              {"growth", noise_.growth},
              {"extremes", noise_.extremes},
              {"impacts", noise_.impacts},
              {"cost", noise_.cost}}},
            {"versions", versions()},
            {"new_failures", failures_},
            {"recovered", recovered_},
            {"got_worse", worse_},
            {"got_better", better_},
            {"only_before", gone_},
            {"only_after", added_},
            {"other_case", other_case_},
            {"costs", costs()}};
  }

  const ordered_json& before_;
  const ordered_json& after_;
  Noise noise_;
  std::map<std::string, const ordered_json*> engines_;
  std::map<std::string, const ordered_json*> cases_;
  std::map<std::string, const ordered_json*> later_cases_;
  std::size_t compared_ = 0;
  ordered_json failures_ = ordered_json::array();
  ordered_json recovered_ = ordered_json::array();
  ordered_json worse_ = ordered_json::array();
  ordered_json better_ = ordered_json::array();
  ordered_json gone_ = ordered_json::array();
  ordered_json added_ = ordered_json::array();
  ordered_json other_case_ = ordered_json::array();
};

}  // namespace

ordered_json compared_reports(const ordered_json& before, const ordered_json& after,
                              const Noise& noise) {
  return Comparison(before, after, noise).result();
}

}  // namespace tautline::bench
