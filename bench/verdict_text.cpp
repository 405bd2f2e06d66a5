// Which rows break the gate, and how they are printed.

#include <fmt/format.h>

#include <algorithm>
#include <map>

#include "bench/text.hpp"
#include "bench/verdict.hpp"

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

/// A gate that judges nothing, because no limit is on any run: a name in the file is wrong.
void add_idle(const ordered_json& report, std::vector<BrokenRow>& rows) {
  const auto& runs = report.at("runs");
  const bool idle = std::all_of(runs.begin(), runs.end(), [](const ordered_json& run) {
    return run.at("verdict").at("checks").empty();
  });
  if (idle) {
    rows.push_back({"", "", "", "", "", "no checks", "",
                    "no limit of the file is on any run: see its names of engines and models"});
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

/// Known deviations that the report could show and that no run of it does.
void add_passing(const ordered_json& report, const Limits& limits, std::vector<BrokenRow>& rows) {
  std::map<std::string, std::string> precision;
  for (const ordered_json& engine : report.at("engines")) {
    precision[engine.at("name")] = engine.value("precision", "");
  }
  for (const KnownDeviation& known : limits.known) {
    const ordered_json* passing = nullptr;
    bool still = false;
    for (const ordered_json& run : report.at("runs")) {
      if (!known.runs.holds(run, precision[run.at("engine")])) {
        continue;
      }
      if (const auto found = deviates(run, known)) {
        passing = &run;
        still = still || *found;
      }
    }
    if (passing != nullptr && !still) {
      rows.push_back(
          {word(*passing, "engine"), word(*passing, "model"), printable(known.runs.the_case),
           known.runs.step ? fmt::format("{:g}", *known.runs.step) : "", known.metric, "holds",
           "known not to",
           "has started to hold: take it out of the manifest; there: " + printable(known.reason)});
    }
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
  add_idle(report, rows);
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
