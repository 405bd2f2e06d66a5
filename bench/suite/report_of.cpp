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

/// "engine: all", or the names of the models of `engine` that `is` chooses, if any.
template <class Is>
void add_names(std::vector<std::string>& list, const EngineRow& engine, const Is& is) {
  std::vector<std::string> names;
  for (const Model& model : engine.info->models) {
    if (is(model)) {
      names.push_back(model.name);
    }
  }
  if (!names.empty()) {
    const bool all = names.size() == engine.info->models.size();
    list.push_back(engine.name + ": " +
                   (all ? std::string("all") : fmt::format("{}", fmt::join(names, ", "))));
  }
}

/// Leaves out models of elastic cables where no case has one, and tells what models do with
/// systems, where there is one.
void tell_of_systems(const SuiteOptions& options, Report& report) {
  const bool any =
      std::any_of(options.cases.begin(), options.cases.end(),
                  [](const BenchCase& one) { return std::holds_alternative<SpatialSystem>(one); });
  const bool any_elastic = std::ranges::any_of(options.cases, [](const BenchCase& one) {
    return std::visit([](const auto& any_case) { return first_elastic(any_case).has_value(); },
                      one);
  });
  const bool all_models = options.models.empty();
  for (EngineRow& engine : report.engines) {
    if (!engine.info) {
      continue;
    }
    if (!any_elastic && all_models) {
      std::erase_if(engine.info->models,
                    [](const Model& model) { return model.cables == Cables::elastic; });
    }
    if (any && all_models) {
      add_names(report.in_the_plane_alone, engine,
                [](const Model& model) { return !model.in_space; });
    }
    if (any_elastic && all_models) {
      add_names(report.inextensible_alone, engine, [](const Model& model) {
        return model.in_space && model.cables == Cables::inextensible;
      });
    }
    for (Model& model : engine.info->models) {
      model.in_space = any ? model.in_space : std::nullopt;
      model.cables = any_elastic ? model.cables : Cables::inextensible;
    }
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
