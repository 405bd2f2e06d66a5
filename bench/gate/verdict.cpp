// Finds the problems of each run of a report in its judgement, and those that are listed.

#include "bench/gate/verdict.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <map>
#include <utility>
#include <vector>

#include "bench/judge/models.hpp"

namespace tautline::bench {
namespace {

using Problems = std::vector<Problem>;

void add(Problems& problems, std::string_view kind, std::string sentence,
         std::optional<double> value = std::nullopt) {
  problems.push_back({std::string(kind), std::move(sentence), value, false, ""});
}

/// How far the run is from the exact motion.
void add_position(const Following& following, Problems& problems) {
  if (following.ratio && *following.ratio > most_ratio) {
    add(problems, "position",
        fmt::format("off by {:.2g} m at {:.3g} s, {:.2g} times a plain scheme", following.error,
                    following.time, *following.ratio),
        following.ratio);
  }
}

/// A run that locates its impacts is exact but for rounding, and where cables are taut far better
/// than a step allows.
void add_events(const Following& following, bool in_doubles, Problems& problems) {
  if (following.located && following.rounding.value_or(0.0) > most_rounding) {
    add(problems, "events",
        fmt::format("locates its impacts, and is off by {:.2g} times what rounding explains",
                    *following.rounding),
        following.rounding);
  } else if (following.located && in_doubles && following.ratio.value_or(0.0) > exact_ratio) {
    add(problems, "events",
        fmt::format("locates its impacts, and is off by {:.2g} m at {:.3g} s, {:.2g} times what a "
                    "plain scheme of this step may be",
                    following.error, following.time, *following.ratio),
        following.ratio);
  }
}

/// Problems of what was measured on a run.
void add_judged(const Judgement& judgement, bool in_doubles, Problems& problems) {
  if (judgement.rebounds.wrong()) {
    add(problems, "restitution", words_of(judgement.rebounds), judgement.rebounds.deviation);
  }
  add_position(judgement.following, problems);
  add_events(judgement.following, in_doubles, problems);
  if (judgement.impacts.missed > 0) {
    add(problems, "missed-impacts",
        fmt::format("misses {} of {} sure impacts", judgement.impacts.missed,
                    judgement.impacts.due),
        static_cast<double>(judgement.impacts.missed));
  }
  if (judgement.overstretch > most_overstretch) {
    add(problems, "overstretch",
        fmt::format("a cable is overstretched by {:.2g} times what a step explains",
                    judgement.overstretch),
        judgement.overstretch);
  }
  if (judgement.energy.value_or(0.0) > most_energy) {
    add(problems, "energy",
        fmt::format("gains energy in flight, {:.2g} times what a step explains", *judgement.energy),
        judgement.energy);
  }
  if (judgement.flight > most_flight) {
    add(problems, "flight", flight_text(judgement.flight), judgement.flight);
  }
  if (judgement.rotation.value_or(0.0) > most_rotation) {
    add(problems, "rotation", rotation_text(*judgement.rotation), judgement.rotation);
  }
}

/// The findings by the runs that they are about, of those that no judgement has.
using FindingsOnRuns = std::map<RunKey, std::vector<const Finding*>>;

FindingsOnRuns findings_on_runs(const std::vector<Finding>& findings) {
  FindingsOnRuns result;
  for (const Finding& finding : findings) {
    if (is_problem(finding.kind)) {
      for (const RunOfModel& run : finding.shown_in) {
        result[{run.the_case, finding.engine, finding.model, run.step}].push_back(&finding);
      }
    }
  }
  return result;
}

/// True if the run could show a problem of this kind: it was measured.
bool could_show(const RunRow& run, const std::string& kind) {
  if (kind == "failure") {
    return true;
  }
  if (!run.judgement) {
    return false;
  }
  const Judgement& judgement = *run.judgement;
  return kind == "restitution"
             ? judgement.rebounds.wrong() || judgement.rebounds.word == Rebound::kept
         : kind == "events"         ? judgement.following.located
         : kind == "position"       ? judgement.following.ratio.has_value()
         : kind == "missed-impacts" ? judgement.impacts.due > 0
         : kind == "rotation"       ? judgement.rotation.has_value()
         : kind == "energy"         ? judgement.energy.has_value()
                                    : true;
}

Word word_on(const RunRow& run, const Problems& problems) {
  if (!problems.empty()) {
    return std::all_of(problems.begin(), problems.end(),
                       [](const Problem& problem) { return problem.listed; })
               ? Word::listed_problem
               : Word::problem;
  }
  const bool told =
      run.judgement && run.judgement->rebounds.well() && run.judgement->following.ratio;
  return told ? Word::sound : Word::too_few;
}

}  // namespace

std::string precision_of(const Report& report, const RunKey& run) {
  const auto found = std::find_if(report.engines.begin(), report.engines.end(),
                                  [&](const EngineRow& one) { return one.name == run.engine; });
  return found != report.engines.end() && found->info ? found->info->precision : "";
}

void add_verdicts(Report& report, const ListedProblems& listed) {
  FindingsOnRuns findings = findings_on_runs(report.findings);
  for (RunRow& run : report.runs) {
    Problems problems;
    if (!did_its_work(run.status)) {
      add(problems, "failure", std::string(to_string(run.status)) + ": " + run.reason);
    }
    for (const Finding* finding : findings[run.key]) {
      add(problems, finding->kind, finding->sentence, finding->value);
    }
    if (run.judgement) {
      add_judged(*run.judgement, precision_of(report, run.key) != "float32", problems);
    }
    for (Problem& problem : problems) {
      const ListedProblem* const found = listed.find(run.key, problem.kind);
      problem.listed = found != nullptr;
      if (problem.listed) {
        problem.reason = found->reason.empty() ? "no reason is given yet" : found->reason;
      }
    }
    const Word word = word_on(run, problems);
    run.verdict = Verdict{word, std::move(problems)};
  }
  report.listed = ProblemsSource{listed.file, listed.version};
}

bool shows(const RunRow& run, std::string_view kind) {
  const Problems& problems = run.verdict.value().problems;
  return std::any_of(problems.begin(), problems.end(),
                     [&](const Problem& one) { return one.kind == kind; });
}

bool is_gone(const ListedProblem& problem, const Report& report) {
  bool could = false;
  for (const RunRow& run : report.runs) {
    if (problem.runs.holds(run.key)) {
      could = could || could_show(run, problem.kind);
      if (shows(run, problem.kind)) {
        return false;
      }
    }
  }
  return could && !problem.in_some;
}

}  // namespace tautline::bench
