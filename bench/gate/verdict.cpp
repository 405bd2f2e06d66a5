// Holds the rows of a report against the limits of a manifest.

#include "bench/gate/verdict.hpp"

#include <algorithm>
#include <utility>

namespace tautline::bench {
namespace {

using nlohmann::ordered_json;

/// The last entry on a run that `fits`, or null: the special stands behind the general.
template <class Entry, class Fits>
const Entry* last_on(const std::vector<Entry>& entries, const ordered_json& run,
                     const std::string& precision, const Fits& fits) {
  const auto found = std::find_if(entries.rbegin(), entries.rend(), [&](const Entry& entry) {
    return fits(entry) && entry.runs.holds(run, precision);
  });
  return found != entries.rend() ? &*found : nullptr;
}

const KnownDeviation* known_on(const Limits& limits, const ordered_json& run,
                               const std::string& precision, std::string_view metric) {
  return last_on(limits.known, run, precision,
                 [&](const KnownDeviation& known) { return known.metric == metric; });
}

bool went_wrong(const ordered_json& run) {
  return run.at("status") == "failed" || run.at("status") == "diverged";
}

/// A run that failed or diverged; one that is known to and did not says so as well.
void add_failure_check(ordered_json& checks, const ordered_json& run, const KnownDeviation* known) {
  if (!went_wrong(run) && known == nullptr) {
    return;
  }
  checks.push_back({{"metric", failure},
                    {"value", nullptr},
                    {"limit", nullptr},
                    {"holds", !went_wrong(run)},
                    {"known", known != nullptr},
                    {"reason", known != nullptr ? ordered_json(known->reason) : run.at("reason")}});
}

/// Every limit on a run whose metric was measured.
ordered_json checks_of(const Limits& limits, const ordered_json& run,
                       const std::string& precision) {
  ordered_json checks = ordered_json::array();
  add_failure_check(checks, run, known_on(limits, run, precision, failure));
  for (const LimitedMetric& metric : limited_metrics()) {
    const Limit* limit = last_on(limits.limits, run, precision,
                                 [&](const Limit& entry) { return entry.metric == metric.name; });
    const auto value = limit != nullptr ? metric.of(run) : std::nullopt;
    if (!value) {
      continue;
    }
    const KnownDeviation* known = known_on(limits, run, precision, metric.name);
    const double most = limit->at(run.at("step"));
    checks.push_back({{"metric", metric.name},
                      {"value", *value},
                      {"limit", most},
                      {"holds", *value <= most},
                      {"known", known != nullptr},
                      {"reason", known != nullptr ? known->reason : limit->reason}});
  }
  return checks;
}

std::string word_for(const ordered_json& run, const ordered_json& checks,
                     const Unjudged* unjudged) {
  if (unjudged != nullptr) {
    return unjudged->word;
  }
  const bool all_hold = std::all_of(checks.begin(), checks.end(), [](const ordered_json& check) {
    return check.at("holds").get<bool>();
  });
  if (!all_hold) {
    return "deviation-flagged";
  }
  if (run.at("status") == "stopped") {
    return "unsupported";
  }
  return checks.empty() ? "informative" : "pass";
}

ordered_json verdict_on(const Limits& limits, const ordered_json& run,
                        const std::string& precision) {
  ordered_json checks = checks_of(limits, run, precision);
  const Unjudged* unjudged =
      last_on(limits.unjudged, run, precision, [](const Unjudged&) { return true; });
  std::string word = word_for(run, checks, unjudged);
  return {{"word", std::move(word)}, {"checks", std::move(checks)}};
}

ordered_json limits_json(const Limits& limits) {
  ordered_json metrics = ordered_json::array();
  for (const LimitedMetric& metric : limited_metrics()) {
    metrics.push_back({{"name", metric.name}, {"unit", metric.unit}, {"meaning", metric.meaning}});
  }
  return {{"file", limits.file}, {"version", limits.version}, {"metrics", std::move(metrics)}};
}

}  // namespace

Precisions::Precisions(const ordered_json& report) {
  for (const ordered_json& engine : report.at("engines")) {
    by_name_[engine.at("name")] = engine.value("precision", "");
  }
}

std::string Precisions::of(const ordered_json& run) const {
  const auto found = by_name_.find(run.at("engine"));
  return found != by_name_.end() ? found->second : "";
}

void add_verdicts(ordered_json& report, const Limits& limits) {
  const Precisions precisions(report);
  for (ordered_json& run : report.at("runs")) {
    run["verdict"] = verdict_on(limits, run, precisions.of(run));
  }
  // "context" stays the last key: everything that differs from run to run is under it
  ordered_json context = std::move(report.at("context"));
  report.erase("context");
  report["limits"] = limits_json(limits);
  report["context"] = std::move(context);
}

}  // namespace tautline::bench
