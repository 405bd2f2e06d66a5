// Which rows break the gate, and how they are printed.

#include <fmt/format.h>

#include <algorithm>
#include <iterator>

#include "bench/base/text.hpp"
#include "bench/gate/verdict.hpp"

namespace tautline::bench {
namespace {

using nlohmann::ordered_json;

std::string word(const ordered_json& row, const char* key) {
  return printable(row.at(key).get<std::string>());
}

std::string number(double value, const std::string& metric) {
  const auto all = limited_metrics();
  const auto found = std::find_if(all.begin(), all.end(),
                                  [&](const LimitedMetric& entry) { return entry.name == metric; });
  const std::string unit =
      found == all.end() || found->unit == "1" ? "" : " " + std::string(found->unit);
  return fmt::format("{:.3g}{}", value, unit);
}

/// A check of a run that does not hold.
BrokenRow row_of(const ordered_json& run, const ordered_json& check) {
  const std::string metric = check.at("metric");
  const bool is_number = check.at("value").is_number();
  return {word(run, "engine"),
          word(run, "model"),
          word(run, "case"),
          fmt::format("{:g}", run.at("step").get<double>()),
          metric,
          is_number ? number(check.at("value"), metric) : word(run, "status"),
          is_number ? number(check.at("limit"), metric) : "",
          word(check, "reason")};
}

/// Engines whose plug-in is there and does not work.
void add_engines(const ordered_json& report, std::vector<BrokenRow>& rows) {
  for (const ordered_json& engine : report.at("engines")) {
    if (!engine.at("problem").is_null() && !engine.at("missing").get<bool>()) {
      rows.push_back({word(engine, "name"), "", "", "", std::string(failure), "no runs", "",
                      word(engine, "problem")});
    }
  }
}

void add_runs(const ordered_json& report, std::vector<BrokenRow>& rows) {
  for (const ordered_json& run : report.at("runs")) {
    const ordered_json& verdict = run.at("verdict");
    for (const ordered_json& check : verdict.at("checks")) {
      // runs that are not judged may say what they like, but not fail
      const bool judged =
          verdict.at("word") == "deviation-flagged" || check.at("metric") == failure;
      if (judged && !check.at("holds").get<bool>() && !check.at("known").get<bool>()) {
        rows.push_back(row_of(run, check));
      }
    }
  }
}

/// Whether any of `entries` is about `run`.
template <class Entry>
bool any_on(const std::vector<Entry>& entries, const ordered_json& run,
            const Precisions& precisions) {
  return std::any_of(entries.begin(), entries.end(),
                     [&](const Entry& entry) { return entry.runs.holds(run, precisions.of(run)); });
}

/// A gate that judges nothing: no limit is on any run, as a name in the file is wrong, or the file
/// says of every run that it is not judged.
void add_idle(const ordered_json& report, const Limits& limits, std::vector<BrokenRow>& rows) {
  const Precisions precisions(report);
  bool checked = false;
  bool judged = false;
  for (const ordered_json& run : report.at("runs")) {
    const bool has_checks = !run.at("verdict").at("checks").empty();
    checked = checked || has_checks;
    judged = judged || (has_checks && !any_on(limits.unjudged, run, precisions));
  }
  if (!judged) {
    rows.push_back({"", "", "", "", "", "no checks", "",
                    checked ? "every run is informative or unsupported: the file judges none"
                            : "no limit of the file is on any run: see its names of engines and "
                              "models"});
  }
}

/// Whether one check of `run` is what `known` speaks of, and then whether it still deviates.
std::optional<bool> deviates(const ordered_json& run, const KnownDeviation& known) {
  for (const ordered_json& check : run.at("verdict").at("checks")) {
    if (check.at("metric") == known.metric) {
      return !check.at("holds").get<bool>();
    }
  }
  return std::nullopt;
}

/// What the runs of a report say of one known deviation.
struct Evidence {
  const ordered_json* run = nullptr;  // the last one that it is about; or null
  bool limited = false;               // one of them has a limit on its metric
  bool measured = false;              // and could be held against it
  bool still = false;                 // and breaks it
};

Evidence evidence_on(const KnownDeviation& known, const ordered_json& report, const Limits& limits,
                     const Precisions& precisions) {
  std::vector<Limit> on_metric;
  std::copy_if(limits.limits.begin(), limits.limits.end(), std::back_inserter(on_metric),
               [&](const Limit& limit) { return limit.metric == known.metric; });
  Evidence evidence;
  for (const ordered_json& run : report.at("runs")) {
    if (!known.runs.holds(run, precisions.of(run))) {
      continue;
    }
    evidence.run = &run;
    evidence.limited =
        evidence.limited || known.metric == failure || any_on(on_metric, run, precisions);
    if (const auto found = deviates(run, known)) {
      evidence.measured = true;
      evidence.still = evidence.still || *found;
    }
  }
  return evidence;
}

/// Known deviations that the report could show and that no run of it does, or that no limit tells.
void add_passing(const ordered_json& report, const Limits& limits, std::vector<BrokenRow>& rows) {
  const Precisions precisions(report);
  for (const KnownDeviation& known : limits.known) {
    const Evidence evidence = evidence_on(known, report, limits, precisions);
    const bool unlimited = evidence.run != nullptr && !evidence.limited;
    if (!unlimited && (!evidence.measured || evidence.still)) {
      continue;
    }
    rows.push_back({word(*evidence.run, "engine"), word(*evidence.run, "model"),
                    printable(known.runs.the_case),
                    known.runs.step ? fmt::format("{:g}", *known.runs.step) : "", known.metric,
                    unlimited ? "not checked" : "holds", unlimited ? "" : "known not to",
                    (unlimited ? "no limit is on this metric of these runs, so that it cannot be "
                                 "known to break one; there: "
                               : "has started to hold: take it out of the manifest; there: ") +
                        printable(known.reason)});
  }
}

/// "3 pass, 1 deviation-flagged"
std::string counts(const ordered_json& report) {
  std::string result;
  for (const char* wanted : {"pass", "deviation-flagged", "informative", "unsupported"}) {
    const auto& runs = report.at("runs");
    const auto count = std::count_if(runs.begin(), runs.end(), [&](const ordered_json& run) {
      return run.at("verdict").at("word") == wanted;
    });
    if (count > 0) {
      result += fmt::format("{}{} {}", result.empty() ? "" : ", ", count, wanted);
    }
  }
  return result.empty() ? "no runs" : result;
}

}  // namespace

std::vector<BrokenRow> broken_rows(const ordered_json& report, const Limits& limits) {
  std::vector<BrokenRow> rows;
  add_engines(report, rows);
  add_runs(report, rows);
  add_passing(report, limits, rows);
  add_idle(report, limits, rows);
  return rows;
}

std::string gate_text(const ordered_json& report, const Limits& limits,
                      const std::vector<BrokenRow>& rows) {
  constexpr std::size_t enough = 100;  // rows that anyone reads; the report has them all
  std::string result;
  if (!rows.empty()) {
    Table table({"engine", "model", "case", "step", "metric", "value", "limit", "reason"}, 5, 1);
    for (std::size_t index = 0; index < std::min(enough, rows.size()); ++index) {
      const BrokenRow& row = rows[index];
      table.add({row.engine, row.model, row.the_case, row.step, row.metric, row.value, row.limit,
                 row.reason});
    }
    result = table.plain() + "\n";
    if (rows.size() > enough) {
      result += fmt::format("and {} more, all in the report\n", rows.size() - enough);
    }
  }
  const std::string source = printable(limits.file) + ", version " + printable(limits.version);
  return result + (rows.empty()
                       ? fmt::format("The gate holds ({}): {}.\n", source, counts(report))
                       : fmt::format("The gate is broken by {} row{} ({}): {}.\n", rows.size(),
                                     rows.size() == 1 ? "" : "s", source, counts(report)));
}

}  // namespace tautline::bench
