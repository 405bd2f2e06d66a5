#include "bench/suite/report_of.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <thread>
#include <utility>
#include <variant>

#include "bench/base/atomic_file.hpp"
#include "bench/base/text.hpp"
#include "bench/cases/catalogue.hpp"
#include "bench/measure/audit.hpp"
#include "bench/replay/motion.hpp"
#include "bench/report/json/json.hpp"
#include "bench/report/summary.hpp"
#include "bench/store/manifest.hpp"
#include "bench/store/source_commit.hpp"
#include "bench/suite/rows.hpp"
#include "tautline/model_table.hpp"

namespace tautline::bench {
namespace {

/// What is said of the models, and what is found in the audits of all runs.
void judge_models(const std::vector<RunRecord>& runs, Report& report) {
  std::vector<JudgedRun> judged;
  for (const RunRecord& run : runs) {
    if (run.audit && run.row.judgement) {
      const RunKey& key = run.row.key;
      judged.push_back(
          {{key.the_case, key.engine, key.model, key.step, &*run.audit}, &*run.row.judgement});
    }
  }
  report.models = models_of(judged);
  report.findings = rebound_findings(report.models, judged);
  std::vector<Finding> others = findings({judged.begin(), judged.end()});
  std::move(others.begin(), others.end(), std::back_inserter(report.findings));
}

/// Tells what models do with systems, where there is one, and leaves out those of elastic cables
/// where there is none.
void tell_of_systems(const SuiteOptions& options, Report& report) {
  const bool any =
      std::any_of(options.cases.begin(), options.cases.end(),
                  [](const BenchCase& one) { return std::holds_alternative<SpatialSystem>(one); });
  const bool any_elastic = std::ranges::any_of(options.cases, [](const BenchCase& one) {
    return std::visit([](const auto& any_case) { return first_elastic(any_case).has_value(); },
                      one);
  });
  for (EngineRow& engine : report.engines) {
    if (!engine.info) {
      continue;
    }
    std::vector<std::string> not_run;
    for (Model& model : engine.info->models) {
      if (any && !model.in_space && options.models.empty()) {
        not_run.push_back(model.name);
      }
      model.in_space = any ? model.in_space : std::nullopt;
    }
    if (any && not_run.size() == engine.info->models.size() && !not_run.empty()) {
      report.in_the_plane_alone.push_back(engine.name + ": all");
    } else if (!not_run.empty()) {
      report.in_the_plane_alone.push_back(
          fmt::format("{}: {}", engine.name, fmt::join(not_run, ", ")));
    }
    std::erase_if(engine.info->models, [&](const Model& model) {
      return model.cables == Cables::elastic && !any_elastic && options.models.empty();
    });
  }
}

Context filled(Context context, const SuiteResult& result) {
  context.command = printable(context.command, longest_command);
  context.kept_runs = result.kept;
  if (context.shards.empty()) {
    context.processor = processor_name();
    context.cores = std::thread::hardware_concurrency();
  }
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

Report report_of(const SuiteOptions& options, const Expectations& expectations,
                 const std::vector<std::optional<CertifiedDigits>>& certified,
                 const SuiteResult& result, Context context) {
  Report report;
  report.version = TAUTLINE_VERSION;
  report.complete = result.runs.size() == result.planned;
  report.planned_runs = result.planned;
  report.options = report_options(options);
  report.engines = engine_rows(options.engines);
  tell_of_systems(options, report);
  for (std::size_t place = 0; place < expectations.size(); ++place) {
    CaseRow& row =
        report.cases.emplace_back(case_row(expectations[place], options.compare, options.steps));
    if (expectations.size() > most_cases_in_page) {
      row.motions = motion_file(row.name);
    }
    row.certified = certified.at(place);
  }
  for (const RunRecord& run : result.runs) {
    report.runs.push_back(run.row);
  }
  report.summary = summary(report.runs);
  report.convergence = convergence(report);
  report.causes = causes_of(report.runs);
  judge_models(result.runs, report);
  report.context = filled(std::move(context), result);
  return report;
}

Replay replay_of(const Expectations& expectations, const SuiteResult& result) {
  Replay replay;
  for (const AnyExpectation& expected : expectations) {
    std::visit([&](const auto& one) { replay.cases.push_back(exact_replay(one.reference())); },
               expected);
  }
  for (const RunRecord& run : result.runs) {
    replay.runs.push_back(run.replay);
  }
  return replay;
}

std::string motion_file(const std::string& case_name) {
  return ("motions" / folder_name(case_name)).generic_string() + ".js";
}

void write_motions(const std::filesystem::path& out, const Report& report, const Replay& replay) {
  for (const CaseRow& row : report.cases) {
    if (row.motions) {
      // the file's name names the case: it needs no quoting
      write_file(out / *row.motions,
                 fmt::format("tautline.motionsCame(\"{}\", {});\n", *row.motions,
                             motions_json(report, replay, row.name)));
    }
  }
}

}  // namespace tautline::bench
