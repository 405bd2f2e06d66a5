#include "bench/suite/report_of.hpp"

#include <algorithm>
#include <fstream>
#include <string>
#include <thread>
#include <utility>

#include "bench/base/text.hpp"
#include "bench/measure/audit/audit.hpp"
#include "bench/report/rows.hpp"
#include "bench/report/summary.hpp"
#include "bench/suite/motion_files.hpp"
#include "bench/suite/source_commit.hpp"

namespace tautline::bench {
namespace {

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

EngineRow engine_row(const RegisteredEngine& engine) {
  EngineRow row;
  row.name = engine.info ? engine.info->name : engine.name;
  row.info = engine.info;
  if (!engine.info) {
    row.problem = printable(engine.failure.empty() ? engine.missing : engine.failure);
  }
  row.missing = !engine.missing.empty();
  return row;
}

/// What is found in the audits of all runs.
std::vector<Finding> findings_in(const std::vector<RunRecord>& runs) {
  std::vector<AuditedRun> audited;
  for (const RunRecord& run : runs) {
    if (run.audit) {
      const RunKey& key = run.row.key;
      audited.push_back({key.the_case, key.engine, key.model, &*run.audit, key.step});
    }
  }
  return findings(audited);
}

Context filled(Context context, const SuiteResult& result) {
  context.command = printable(context.command, 1000);
  context.kept_runs = result.kept;
  context.processor = processor_name();
  context.cores = std::thread::hardware_concurrency();
  context.compiler = TAUTLINE_COMPILER;
  context.build_type = TAUTLINE_BUILD_TYPE;
  context.flags = TAUTLINE_FLAGS;
  context.commit = source_commit();
  for (const RunRecord& run : result.runs) {
    if (run.timing) {
      context.timing.push_back(*run.timing);
      context.worker_memory = std::max(context.worker_memory, run.timing->memory);
    }
  }
  context.costs = costs(context.timing);
  return context;
}

}  // namespace

Report report_of(const SuiteOptions& options, const std::vector<ReferenceCase>& references,
                 const SuiteResult& result, Context context) {
  Report report;
  report.version = TAUTLINE_VERSION;
  report.complete = result.runs.size() == result.planned;
  report.planned_runs = result.planned;
  report.options = {options.steps,
                    std::string(to_string(options.law)),
                    options.compare.count_speed,
                    options.compare.early_impacts,
                    options.limits.time,
                    static_cast<double>(options.limits.memory)};
  for (const RegisteredEngine& engine : options.engines) {
    report.engines.push_back(engine_row(engine));
  }
  for (const ReferenceCase& reference : references) {
    report.cases.push_back(case_row(reference, options.compare));
    if (references.size() > most_cases_in_page) {
      report.cases.back().motions = motion_file(reference.the_case.name);
    }
  }
  for (const RunRecord& run : result.runs) {
    report.runs.push_back(run.row);
  }
  report.summary = summary(report.runs);
  report.convergence = convergence(report.runs);
  report.causes = causes_of(report.runs);
  report.findings = findings_in(result.runs);
  report.context = filled(std::move(context), result);
  return report;
}

}  // namespace tautline::bench
