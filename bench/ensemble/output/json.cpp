#include <nlohmann/json.hpp>
#include <utility>

#include "bench/base/text.hpp"
#include "bench/ensemble/output/atlas.hpp"
#include "bench/ensemble/output/text.hpp"

namespace tautline::bench {
namespace {

using nlohmann::ordered_json;

constexpr int ensemble_schema = 1;

ordered_json or_null(const std::optional<double>& value) {
  return value ? ordered_json(*value) : ordered_json(nullptr);
}

ordered_json summary_json(const Summary& summary) {
  const bool some = summary.count > 0;
  ordered_json quantiles = ordered_json::array();
  for (std::size_t place = 0; place < quantile_parts.size(); ++place) {
    const Quantile& one = summary.quantiles[place];
    quantiles.push_back({{"part", quantile_parts[place]},
                         {"value", or_null(one.value)},
                         {"low", or_null(one.low)},
                         {"high", or_null(one.high)}});
  }
  return {{"count", summary.count},
          {"without", summary.without},
          {"mean", some ? ordered_json(summary.mean) : ordered_json(nullptr)},
          {"deviation", some ? ordered_json(summary.deviation) : ordered_json(nullptr)},
          {"quantiles", std::move(quantiles)}};
}

ordered_json setup_json(const EnsembleReport& report, std::size_t place) {
  const Setup& setup = report.request.setups[place];
  const Findings& findings = report.findings;
  ordered_json summaries = ordered_json::object();
  for (std::size_t index = 0; index < findings.statistics.size(); ++index) {
    const Statistic& statistic = findings.statistics[index];
    if (setup.engine ? statistic.of_engines : statistic.of_exact) {
      summaries[statistic.name] = summary_json(findings.summaries[place][index]);
    }
  }
  ordered_json engine = nullptr;
  if (setup.engine) {
    const RegisteredEngine& one = report.request.engines[*setup.engine];
    engine = {{"name", one.name},
              {"version", printable(one.info->version)},
              {"model", setup.model},
              {"step", setup.step}};
  }
  return {{"name", printable(setup.name)},
          {"law", to_string(setup.exact.law)},
          {"engine", std::move(engine)},
          {"draws", report.result.draws[place].size()},
          {"problems", findings.problems[place]},
          {"first_problem", printable(findings.first_problems[place])},
          {"statistics", std::move(summaries)}};
}

ordered_json test_json(const Test& test) {
  return {{"effect", test.effect}, {"probability", test.probability}, {"adjusted", test.adjusted}};
}

ordered_json comparison_json(const EnsembleReport& report, const Comparison& one) {
  return {{"setup", printable(report.request.setups[one.setup].name)},
          {"statistic", report.findings.statistics[one.statistic].name},
          {"differs", one.differs()},
          {"kolmogorov", test_json(one.kolmogorov)},
          {"energy", one.energy ? test_json(*one.energy) : ordered_json(nullptr)},
          {"median_change", or_null(one.median_change)},
          {"visible", one.visible},
          {"visible_shift", or_null(one.visible_shift)}};
}

ordered_json atlas_json(const EnsembleReport& report) {
  const std::optional<Atlas> atlas = atlas_of(report);
  if (!atlas) {
    return nullptr;
  }
  ordered_json axes = ordered_json::array();
  for (const Varied& axis : atlas->axes) {
    axes.push_back({{"quantity", axis.quantity}, {"values", axis.distribution.numbers}});
  }
  ordered_json means = ordered_json::object();
  for (std::size_t index = 0; index < atlas->statistics.size(); ++index) {
    ordered_json cells = ordered_json::array();
    for (const std::optional<double>& mean : atlas->means[index]) {
      cells.push_back(or_null(mean));
    }
    means[report.findings.statistics[atlas->statistics[index]].name] = std::move(cells);
  }
  return {{"axes", std::move(axes)}, {"means", std::move(means)}};
}

}  // namespace

std::string ensemble_json(const EnsembleReport& report) {
  const EnsembleSpec& spec = report.request.spec;
  ordered_json statistics = ordered_json::array();
  for (const Statistic& one : report.findings.statistics) {
    statistics.push_back({{"name", one.name},
                          {"heading", one.heading},
                          {"unit", one.unit},
                          {"meaning", one.meaning}});
  }
  ordered_json setups = ordered_json::array();
  for (std::size_t place = 0; place < report.request.setups.size(); ++place) {
    setups.push_back(setup_json(report, place));
  }
  ordered_json comparisons = ordered_json::array();
  for (const Comparison& one : report.findings.comparisons) {
    comparisons.push_back(comparison_json(report, one));
  }
  const ordered_json json = {{"schema", ensemble_schema},
                             {"case", printable(spec.the_case.name)},
                             {"until", spec.the_case.duration},
                             {"draws", draw_count(spec)},
                             {"seed", spec.seed},
                             {"sampling", spec.sampling == Sampling::sobol ? "sobol" : "random"},
                             {"speeds", spec.speeds},
                             {"interrupted", report.result.interrupted},
                             {"confidence", confidence},
                             {"error_rate", error_rate},
                             {"tests", report.findings.tests()},
                             {"statistics", std::move(statistics)},
                             {"setups", std::move(setups)},
                             {"comparisons", std::move(comparisons)},
                             {"atlas", atlas_json(report)}};
  return json.dump(2) + "\n";
}

}  // namespace tautline::bench
