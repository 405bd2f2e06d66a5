// Holds the runs of a report against the limits of a file.

#include "bench/gate/verdict.hpp"

#include <algorithm>
#include <cstddef>
#include <optional>
#include <string_view>
#include <utility>
#include <vector>

#include "bench/gate/limits_on_run.hpp"
#include "bench/measure/metric_list.hpp"

namespace tautline::bench {
namespace {

Holds holds_if(bool it_does) { return it_does ? Holds::yes : Holds::no; }

/// A run that failed or diverged; one that is known to and did not says so as well.
std::optional<Check> failure_check(const RunRow& run, const LimitsOnRun& limits) {
  const bool worked = did_its_work(run.status);
  const KnownDeviation* known = limits.known(failure);
  if (worked && known == nullptr) {
    return std::nullopt;
  }
  return Check{std::string(failure), std::nullopt,
               std::nullopt,         holds_if(worked),
               known != nullptr,     known != nullptr ? known->reason : run.reason};
}

/// The limit on the metric at this place of the list, if there is one.
std::optional<Check> metric_check(const RunRow& run, const LimitsOnRun& limits, std::size_t place) {
  const std::string_view metric = metric_list()[place].name;
  const Limit* limit = limits.limit(metric);
  if (limit == nullptr) {
    return std::nullopt;
  }
  const double most = limit->at(run.key.step);
  const std::optional<double> value = run.metric(place);
  const KnownDeviation* known = limits.known(metric);
  return Check{std::string(metric),
               value,
               most,
               value ? holds_if(*value <= most) : Holds::not_measured,
               known != nullptr,
               known != nullptr ? known->reason : limit->reason};
}

/// What was found in the run, whatever its numbers are.
Check finding_check(const Finding& finding, const LimitsOnRun& limits) {
  const KnownDeviation* known = limits.known(finding.kind);
  return Check{finding.kind, std::nullopt,     std::nullopt,
               Holds::no,    known != nullptr, known != nullptr ? known->reason : finding.sentence};
}

/// The findings by the runs that they are about, of those kinds that contradict a pass.
using FindingsOnRuns = std::map<RunKey, std::vector<const Finding*>>;

FindingsOnRuns findings_on_runs(const std::vector<Finding>& findings) {
  FindingsOnRuns result;
  for (const Finding& finding : findings) {
    for (const RunOfModel& run : finding.shown_in) {
      if (contradicts_a_pass(finding.kind)) {
        result[{run.the_case, finding.engine, finding.model, run.step}].push_back(&finding);
      }
    }
  }
  return result;
}

std::vector<Check> checks_of(const RunRow& run, const std::vector<const Finding*>& findings,
                             const LimitsOnRun& limits) {
  std::vector<Check> checks;
  const auto add = [&](std::optional<Check> check) {
    if (check) {
      checks.push_back(std::move(*check));
    }
  };
  add(failure_check(run, limits));
  for (const Finding* finding : findings) {
    add(finding_check(*finding, limits));
  }
  // a run without metrics has failed, which its check says
  for (std::size_t place = 0; run.metrics && place < metric_list().size(); ++place) {
    add(metric_check(run, limits, place));
  }
  return checks;
}

bool held(const Check& check) { return check.holds == Holds::yes; }
bool broken(const Check& check) { return check.holds == Holds::no; }
bool unknown(const Check& check) { return broken(check) && !check.known; }
bool failed(const Check& check) { return broken(check) && check.metric == failure; }
bool limited(const Check& check) { return check.limit.has_value(); }

/// Failing is judged of every run, and limits of those that the file judges.
Verdict verdict_on(const RunRow& run, std::vector<Check> checks, const Unjudged* unjudged) {
  const auto any = [&](bool (*what)(const Check&)) {
    return std::any_of(checks.begin(), checks.end(), what);
  };
  const auto with = [&](Word word, std::string reason = "") {
    return Verdict{word, std::move(reason), std::move(checks)};
  };
  if (unjudged != nullptr && !any(failed)) {
    return with(Word::not_judged, unjudged->reason);
  }
  if (!any(limited) && !any(failed)) {  // there is no pass that a finding could contradict
    return with(Word::not_judged, "no limit is on it");
  }
  if (any(broken)) {
    return with(any(unknown) ? Word::breaks_limit : Word::known_deviation);
  }
  if (run.status == Status::stopped) {
    return with(Word::not_judged, "the model goes no further: " + run.reason);
  }
  return any(held) ? with(Word::pass)
                   : with(Word::not_judged, "nothing that has a limit could be measured");
}

}  // namespace

Precisions::Precisions(const Report& report) {
  for (const EngineRow& engine : report.engines) {
    by_name_[engine.name] = engine.info ? engine.info->precision : "";
  }
}

std::string Precisions::of(const RunKey& run) const {
  const auto found = by_name_.find(run.engine);
  return found != by_name_.end() ? found->second : "";
}

void add_verdicts(Report& report, const Limits& limits) {
  const Precisions precisions(report);
  FindingsOnRuns findings = findings_on_runs(report.findings);
  for (RunRow& run : report.runs) {
    const LimitsOnRun on_run(limits, run.key, precisions.of(run.key));
    run.verdict = verdict_on(run, checks_of(run, findings[run.key], on_run), on_run.unjudged());
  }
  report.limits = LimitsSource{limits.file, limits.version};
}

}  // namespace tautline::bench
