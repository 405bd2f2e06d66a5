// Holds the runs of a report against the limits of a file.

#include "bench/gate/verdict.hpp"

#include <algorithm>
#include <cstddef>
#include <optional>
#include <string_view>
#include <utility>
#include <vector>

#include "bench/measure/metric_list.hpp"

namespace tautline::bench {
namespace {

/// What the limits say of one run: of several entries the last counts, as the special stands behind
/// the general.
class LimitsOnRun {
 public:
  LimitsOnRun(const Limits& limits, const RunKey& run, std::string precision)
      : limits_(limits), run_(run), precision_(std::move(precision)) {}

  // each is null without one

  [[nodiscard]] const Limit* limit(std::string_view metric) const {
    return last(limits_.limits, [&](const Limit& limit) { return limit.metric == metric; });
  }
  [[nodiscard]] const KnownDeviation* known(std::string_view metric) const {
    return last(limits_.known, [&](const KnownDeviation& known) { return known.metric == metric; });
  }
  [[nodiscard]] const Unjudged* unjudged() const {
    return last(limits_.unjudged, [](const Unjudged&) { return true; });
  }

 private:
  template <class Entry, class Fits>
  [[nodiscard]] const Entry* last(const std::vector<Entry>& entries, const Fits& fits) const {
    const auto found = std::find_if(entries.rbegin(), entries.rend(), [&](const Entry& entry) {
      return fits(entry) && entry.runs.holds(run_, precision_);
    });
    return found != entries.rend() ? &*found : nullptr;
  }

  const Limits& limits_;
  const RunKey& run_;
  std::string precision_;
};

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

/// The limit on the metric at this place of the list; none too where that could not be measured.
std::optional<Check> metric_check(const RunRow& run, const LimitsOnRun& limits, std::size_t place) {
  const std::string_view metric = metric_list()[place].name;
  const std::optional<double> value = run.metric(place);
  const Limit* limit = value ? limits.limit(metric) : nullptr;
  if (limit == nullptr) {
    return std::nullopt;
  }
  const double most = limit->at(run.key.step);
  const KnownDeviation* known = limits.known(metric);
  return Check{std::string(metric),
               value,
               most,
               holds_if(*value <= most),
               known != nullptr,
               known != nullptr ? known->reason : limit->reason};
}

std::vector<Check> checks_of(const RunRow& run, const LimitsOnRun& limits) {
  std::vector<Check> checks;
  const auto add = [&](std::optional<Check> check) {
    if (check) {
      checks.push_back(std::move(*check));
    }
  };
  add(failure_check(run, limits));
  for (std::size_t place = 0; place < metric_list().size(); ++place) {
    add(metric_check(run, limits, place));
  }
  return checks;
}

bool broken(const Check& check) { return check.holds == Holds::no; }
bool unknown(const Check& check) { return broken(check) && !check.known; }
bool failed(const Check& check) { return broken(check) && check.metric == failure; }

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
  if (any(broken)) {
    return with(any(unknown) ? Word::breaks_limit : Word::known_deviation);
  }
  if (run.status == Status::stopped) {
    return with(Word::not_judged, "the model goes no further: " + run.reason);
  }
  return checks.empty() ? with(Word::not_judged, "no limit is on what could be measured of it")
                        : with(Word::pass);
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
  for (RunRow& run : report.runs) {
    const LimitsOnRun on_run(limits, run.key, precisions.of(run.key));
    run.verdict = verdict_on(run, checks_of(run, on_run), on_run.unjudged());
  }
  report.limits = LimitsSource{limits.file, limits.version};
}

}  // namespace tautline::bench
