#include "bench/gate/broken.hpp"

#include <fmt/format.h>

#include <algorithm>

#include "bench/base/text.hpp"
#include "bench/gate/verdict.hpp"

namespace tautline::bench {
namespace {

std::string step_text(const std::optional<double>& step) {
  return step ? fmt::format("{:g}", *step) : "";
}

/// Engines whose plug-in is there and does not work.
void add_engines(const Report& report, std::vector<BrokenRow>& rows) {
  for (const EngineRow& engine : report.engines) {
    if (engine.problem && !engine.missing) {
      rows.push_back({printable(engine.name), "", "", "", "failure",
                      "no runs: " + printable(*engine.problem)});
    }
  }
}

void add_runs(const Report& report, std::vector<BrokenRow>& rows) {
  for (const RunRow& run : report.runs) {
    for (const Problem& problem : run.verdict.value().problems) {
      if (!problem.listed) {
        rows.push_back({printable(run.key.engine), printable(run.key.model),
                        printable(run.key.the_case), step_text(run.key.step), problem.kind,
                        printable(problem.sentence)});
      }
    }
  }
}

/// Listed problems that runs of the report could show and none does.
void add_gone(const Report& report, const ListedProblems& listed, std::vector<BrokenRow>& rows) {
  for (const ListedProblem& problem : listed.problems) {
    bool could = false;
    bool shown = false;
    for (const RunRow& run : report.runs) {
      if (problem.runs.holds(run.key)) {
        const auto& problems = run.verdict.value().problems;
        could = could || could_show(run, problem.kind);
        shown = shown || std::any_of(problems.begin(), problems.end(),
                                     [&](const Problem& one) { return one.kind == problem.kind; });
      }
    }
    if (could && !shown && !problem.in_some) {
      rows.push_back({printable(problem.runs.engine), printable(problem.runs.model),
                      problem.runs.the_case == "*" ? "" : printable(problem.runs.the_case),
                      step_text(problem.runs.step), problem.kind,
                      "is listed and no run shows it any more: delete it from the file; there: " +
                          printable(problem.reason)});
    }
  }
}

}  // namespace

std::vector<BrokenRow> broken_rows(const Report& report, const ListedProblems& listed) {
  std::vector<BrokenRow> rows;
  add_engines(report, rows);
  add_runs(report, rows);
  add_gone(report, listed, rows);
  if (rows.empty() && std::none_of(report.runs.begin(), report.runs.end(),
                                   [](const RunRow& run) { return run.judgement.has_value(); })) {
    rows.push_back({"", "", "", "", "", "no run could be judged"});
  }
  return rows;
}

}  // namespace tautline::bench
