#include "bench/gate/broken.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cstddef>
#include <map>
#include <optional>
#include <string_view>

#include "bench/base/text.hpp"
#include "bench/gate/limits_on_run.hpp"
#include "bench/gate/verdict.hpp"
#include "bench/measure/metric_list.hpp"

namespace tautline::bench {
namespace {

std::string with_unit(double value, std::string_view metric) {
  const std::optional<std::size_t> place = place_of(metric);
  const std::string_view unit = place ? metric_list()[*place].unit : "1";
  return unit == "1" ? fmt::format("{:.3g}", value) : fmt::format("{:.3g} {}", value, unit);
}

/// Engines whose plug-in is there and does not work.
void add_engines(const Report& report, std::vector<BrokenRow>& rows) {
  for (const EngineRow& engine : report.engines) {
    if (engine.problem && !engine.missing) {
      rows.push_back({printable(engine.name), "", "", "", std::string(failure), "no runs", "",
                      printable(*engine.problem)});
    }
  }
}

std::string value_text(const RunRow& run, const Check& check) {
  if (check.value) {
    return with_unit(*check.value, check.metric);
  }
  return check.metric == failure ? to_string(run.status) : "found";
}

/// A check of a run that does not hold.
BrokenRow broken_row(const RunRow& run, const Check& check) {
  return {printable(run.key.engine),
          printable(run.key.model),
          printable(run.key.the_case),
          fmt::format("{:g}", run.key.step),
          printable(check.metric),
          value_text(run, check),
          check.limit ? with_unit(*check.limit, check.metric) : "",
          printable(check.reason)};
}

void add_runs(const Report& report, std::vector<BrokenRow>& rows) {
  for (const RunRow& run : report.runs) {
    const Verdict& verdict = run.verdict.value();
    for (const Check& check : verdict.checks) {
      // runs that are not judged may say what they like, but not fail
      const bool judged = verdict.word != Word::not_judged || check.metric == failure;
      if (judged && check.holds == Holds::no && !check.known) {
        rows.push_back(broken_row(run, check));
      }
    }
  }
}

/// What the runs of a report say of one known deviation.
struct Evidence {
  const RunKey* run = nullptr;  // the last one that it is about; or null
  bool limited = false;         // one of them has a limit on its metric, or needs none
  bool measured = false;        // and could be compared with it
  bool still = false;           // and breaks it
};

Evidence evidence_on(const KnownDeviation& known, const Report& report, const Limits& limits,
                     const Precisions& precisions) {
  Evidence evidence;
  for (const RunRow& run : report.runs) {
    const std::string precision = precisions.of(run.key);
    if (!known.runs.holds(run.key, precision)) {
      continue;
    }
    evidence.run = &run.key;
    evidence.limited =
        evidence.limited || known.metric == failure || is_finding(known.metric) ||
        std::any_of(limits.limits.begin(), limits.limits.end(), [&](const Limit& limit) {
          return limit.metric == known.metric && limit.runs.holds(run.key, precision);
        });
    for (const Check& check : run.verdict.value().checks) {
      if (is_about(known, check.metric) && check.holds != Holds::not_measured) {
        evidence.measured = true;
        evidence.still = evidence.still || check.holds == Holds::no;
      }
    }
  }
  return evidence;
}

/// Known deviations that the report could show and that no run of it does, or that no limit tells.
void add_passing(const Report& report, const Limits& limits, const Precisions& precisions,
                 std::vector<BrokenRow>& rows) {
  for (const KnownDeviation& known : limits.known) {
    const Evidence evidence = evidence_on(known, report, limits, precisions);
    const bool unlimited = evidence.run != nullptr && !evidence.limited;
    if (!unlimited && (!evidence.measured || evidence.still || known.in_some)) {
      continue;
    }
    rows.push_back({printable(evidence.run->engine), printable(evidence.run->model),
                    printable(known.runs.the_case),
                    known.runs.step ? fmt::format("{:g}", *known.runs.step) : "", known.metric,
                    unlimited ? "not checked" : "holds", unlimited ? "" : "known not to",
                    (unlimited ? "no limit is on this metric of these runs, so that it cannot be "
                                 "known to break one; there: "
                               : "has started to hold: delete it from the limits file; there: ") +
                        printable(known.reason)});
  }
}

/// How often a limit could be compared with the runs that it counts for.
struct Measured {
  std::size_t runs = 0;
  std::size_t of_them = 0;
  bool known = true;  // all runs without are known not to hold it
};

/// Limits that protect nothing, as no run that they count for could be measured: an engine that
/// stops to tell its impacts would break none.
void add_unmeasured(const Report& report, const Limits& limits, const Precisions& precisions,
                    std::vector<BrokenRow>& rows) {
  std::map<const Limit*, Measured> measured;
  for (const RunRow& run : report.runs) {
    const LimitsOnRun on_run(limits, run.key, precisions.of(run.key));
    for (const Check& check : run.verdict.value().checks) {
      if (!check.limit || !did_its_work(run.status) || on_run.unjudged() != nullptr) {
        continue;
      }
      Measured& of_limit = measured[on_run.limit(check.metric)];
      ++of_limit.runs;
      of_limit.of_them += check.holds != Holds::not_measured ? 1U : 0U;
      of_limit.known = of_limit.known && check.known;
    }
  }
  for (const Limit& limit : limits.limits) {
    const auto found = measured.find(&limit);
    if (found == measured.end() || found->second.of_them > 0 || found->second.known) {
      continue;
    }
    rows.push_back({printable(limit.runs.engine), printable(limit.runs.model),
                    printable(limit.runs.the_case),
                    limit.runs.step ? fmt::format("{:g}", *limit.runs.step) : "", limit.metric,
                    "not measured", "",
                    fmt::format("could be measured on none of the {} runs that it counts for: it "
                                "protects nothing; there: {}",
                                found->second.runs, printable(limit.reason))});
  }
}

/// A gate that judges nothing: no limit is on any run, as a name in the file is wrong, or the file
/// says of every run that it is not judged.
void add_idle(const Report& report, const Limits& limits, const Precisions& precisions,
              std::vector<BrokenRow>& rows) {
  bool checked = false;
  for (const RunRow& run : report.runs) {
    const auto& checks = run.verdict.value().checks;
    if (std::none_of(checks.begin(), checks.end(), [](const Check& check) {
          return check.limit || check.metric == failure;  // a finding alone judges nothing
        })) {
      continue;
    }
    checked = true;
    const std::string precision = precisions.of(run.key);
    const bool judged =
        std::none_of(limits.unjudged.begin(), limits.unjudged.end(),
                     [&](const Unjudged& entry) { return entry.runs.holds(run.key, precision); });
    if (judged) {
      return;
    }
  }
  rows.push_back({"", "", "", "", "", "no checks", "",
                  checked ? "the file says of every run that it is not judged"
                          : "no limit of the file is on any run: see its names of engines and "
                            "models"});
}

}  // namespace

std::vector<BrokenRow> broken_rows(const Report& report, const Limits& limits) {
  const Precisions precisions(report);
  std::vector<BrokenRow> rows;
  add_engines(report, rows);
  add_runs(report, rows);
  add_passing(report, limits, precisions, rows);
  add_unmeasured(report, limits, precisions, rows);
  add_idle(report, limits, precisions, rows);
  return rows;
}

}  // namespace tautline::bench
