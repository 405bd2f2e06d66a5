#include "bench/report/report.hpp"

#include <fmt/format.h>

#include <fstream>
#include <thread>

#include "bench/base/text.hpp"
#include "bench/measure/audit/audit.hpp"
#include "bench/report/attribution_json.hpp"
#include "bench/report/replay_data.hpp"
#include "bench/report/rows.hpp"
#include "bench/report/source_commit.hpp"
#include "bench/run/json.hpp"

namespace tautline::bench {
namespace {

using nlohmann::ordered_json;

std::string processor_name() {
  std::ifstream file("/proc/cpuinfo");
  for (std::string line; std::getline(file, line);) {
    const std::size_t colon = line.find(": ");
    if (line.starts_with("model name") && colon != std::string::npos) {
      return printable(line.substr(colon + 2));
    }
  }
  return "unknown";
}

ordered_json engines_json(const SuiteOptions& options) {
  ordered_json engines = ordered_json::array();
  for (const RegisteredEngine& engine : options.engines) {
    ordered_json row = engine.info ? ordered_json::parse(engine_json(*engine.info))
                                   : ordered_json{{"name", engine.name}};
    row["problem"] = nullptr;
    if (!engine.info) {
      row["problem"] = printable(engine.failure.empty() ? engine.missing : engine.failure);
    }
    row["missing"] = !engine.missing.empty();
    engines.push_back(std::move(row));
  }
  return engines;
}

ordered_json context_json(const ReportContext& context, const SuiteResult& result) {
  ordered_json timing = ordered_json::array();
  for (const RunResult& run : result.runs) {
    if (!run.timing.is_null()) {
      timing.push_back(run.timing);
      ordered_json& row = timing.back();
      row["second_cost"] = row.at("step_cost").get<double>() / row.at("step").get<double>();
    }
  }
  return {{"command", printable(context.command, 1000)},
          {"started", context.started},
          {"elapsed", context.elapsed},
          {"program_memory", context.program_memory},
          {"worker_memory", context.worker_memory},
          {"kept_runs", context.kept},
          {"processor", processor_name()},
          {"cores", std::thread::hardware_concurrency()},
          {"compiler", TAUTLINE_COMPILER},
          {"build_type", TAUTLINE_BUILD_TYPE},
          {"flags", TAUTLINE_FLAGS},
          {"commit", source_commit()},
          {"costs", costs_json(timing)},
          {"timing", std::move(timing)}};
}

}  // namespace

ordered_json report_json(const SuiteOptions& options, const std::vector<ReferenceCase>& references,
                         const SuiteResult& result, const ReportContext& context) {
  ordered_json runs = ordered_json::array();
  for (const RunResult& run : result.runs) {
    runs.push_back(run.row);
  }
  ordered_json cases = ordered_json::array();
  for (const ReferenceCase& reference : references) {
    cases.push_back(case_row(reference, options.compare));
  }
  ordered_json report = {{"schema", report_schema},
                         {"program", {{"name", "tautline"}, {"version", TAUTLINE_VERSION}}}};
  report["complete"] = result.runs.size() == result.planned;
  report["planned_runs"] = result.planned;
  report["options"] = {{"steps", options.steps},
                       {"law", to_string(options.law)},
                       {"count_speed", options.compare.count_speed},
                       {"early_impacts", options.compare.early_impacts},
                       {"time_limit", options.limits.time},
                       {"memory_limit", options.limits.memory}};
  report["engines"] = engines_json(options);
  report["cases"] = std::move(cases);
  report["summary"] = summary_json(runs);
  report["convergence"] = convergence_json(runs);
  report["findings"] = ordered_json::array();
  report["attribution_summary"] = attribution_summary_json(runs);
  report["runs"] = std::move(runs);
  add_audit(report);
  report["chapter"] = context.chapter;
  thin_impacts(report);
  report["context"] = context_json(context, result);
  return report;
}

}  // namespace tautline::bench
