#include <utility>

#include "bench/base/json_list.hpp"
#include "bench/base/text.hpp"
#include "bench/ensemble/output/atlas.hpp"
#include "bench/ensemble/output/output.hpp"
#include "bench/report/json/writer.hpp"

namespace tautline::bench {
namespace {

constexpr int ensemble_schema = 1;

Json summary_json(const Summary& summary) {
  const bool some = summary.count > 0;
  Json quantiles = Json::array();
  for (std::size_t place = 0; place < quantile_parts.size(); ++place) {
    const Quantile& one = summary.quantiles[place];
    quantiles.push_back({{"part", quantile_parts[place]},
                         {"value", json_of(one.value)},
                         {"low", json_of(one.low)},
                         {"high", json_of(one.high)}});
  }
  return {{"count", summary.count},
          {"without", summary.without},
          {"mean", some ? Json(summary.mean) : Json(nullptr)},
          {"deviation", some ? Json(summary.deviation) : Json(nullptr)},
          {"quantiles", std::move(quantiles)}};
}

Json setup_json(const EnsembleReport& report, std::size_t place) {
  const EnsembleSetup& setup = report.request.setups[place];
  const Findings& findings = report.findings;
  Json summaries = Json::object();
  for (std::size_t index = 0; index < findings.statistics.size(); ++index) {
    const Statistic& statistic = findings.statistics[index];
    const Summary& summary = findings.summaries[place][index];
    if (tells(setup, statistic, summary)) {
      summaries[statistic.name] = summary_json(summary);
    }
  }
  Json engine = nullptr;
  if (setup.engine) {
    const RegisteredEngine& one = report.request.engines[*setup.engine];
    engine = {{"name", one.name},
              {"version", printable(one.info->version)},
              {"model", setup.model},
              {"step", setup.step}};
  }
  return {{"name", printable(setup.name)},
          {"law", to_string(setup.exact.law)},
          {"completion", setup.exact.completion},
          {"engine", std::move(engine)},
          {"draws", report.result.draws[place].ended()},
          {"problems", findings.problems[place]},
          {"first_problem", printable(findings.first_problems[place])},
          {"statistics", std::move(summaries)}};
}

Json test_json(const Test& test) {
  return {{"effect", test.effect}, {"probability", test.probability}, {"adjusted", test.adjusted}};
}

Json comparison_json(const EnsembleReport& report, const Comparison& one) {
  return {{"setup", printable(report.request.setups[one.setup].name)},
          {"statistic", report.findings.statistics[one.statistic].name},
          {"draws", one.draws},
          {"differs", one.differs()},
          {"kolmogorov", test_json(one.kolmogorov)},
          {"energy", one.energy ? test_json(*one.energy) : Json(nullptr)},
          {"median_change", json_of(one.median_change)},
          {"visible", one.visible},
          {"visible_shift", json_of(one.visible_shift)}};
}

Json statistic_json(const Statistic& one) {
  return {
      {"name", one.name}, {"heading", one.heading}, {"unit", one.unit}, {"meaning", one.meaning}};
}

Json atlas_json(const EnsembleReport& report) {
  const std::optional<Atlas> atlas = atlas_of(report);
  if (!atlas) {
    return nullptr;
  }
  const auto axis_json = [](const Varied& axis) -> Json {
    return {{"quantity", axis.quantity}, {"values", axis.distribution.numbers}};
  };
  Json maps = Json::object();
  for (const AtlasMap& map : atlas->maps) {
    maps[report.findings.statistics[map.statistic].name] = json_of(map.cells);
  }
  return {{"axes", json_list(atlas->axes, axis_json)}, {"maps", std::move(maps)}};
}

}  // namespace

std::string ensemble_json(const EnsembleReport& report) {
  const EnsembleSpec& spec = report.request.spec;
  Json setups = Json::array();
  for (std::size_t place = 0; place < report.request.setups.size(); ++place) {
    setups.push_back(setup_json(report, place));
  }
  const auto of_comparison = [&](const Comparison& one) { return comparison_json(report, one); };
  const Json json = {{"schema", ensemble_schema},
                     {"case", printable(spec.the_case.name)},
                     {"until", spec.the_case.duration},
                     {"draws", draw_count(spec)},
                     {"seed", spec.seed},
                     {"sampling", spec.sampling == Sampling::sobol ? "sobol" : "random"},
                     {"speeds", spec.speeds},
                     {"interrupted", report.result.interrupted || report.result.goes_on},
                     {"confidence", confidence},
                     {"error_rate", error_rate},
                     {"tests", report.findings.tests()},
                     {"statistics", json_list(report.findings.statistics, statistic_json)},
                     {"setups", std::move(setups)},
                     {"comparisons", json_list(report.findings.comparisons, of_comparison)},
                     {"atlas", atlas_json(report)}};
  return json.dump(2) + "\n";
}

}  // namespace tautline::bench
