#include "bench/report/tables.hpp"

#include <fmt/format.h>

#include <map>
#include <vector>

#include "bench/base/text.hpp"

namespace tautline::bench {
namespace {

using nlohmann::ordered_json;

const std::string dash = "–";  // where there is no number

/// Two digits are what an error is good for.
std::string error_text(const ordered_json& value) {
  return value.is_number() ? fmt::format("{:.1e}", value.get<double>()) : dash;
}

std::string fixed_text(const ordered_json& value, int digits) {
  return value.is_number() ? fmt::format("{:.{}f}", value.get<double>(), digits) : dash;
}

std::string step_text(const ordered_json& value) {
  return fmt::format("{:g}", value.get<double>());
}

std::string count_text(const ordered_json& value) { return std::to_string(value.get<int>()); }

const ordered_json& member(const ordered_json& object, const char* key) {
  static const ordered_json none = nullptr;
  return object.is_object() ? object.at(key) : none;
}

/// The thresholds of "the last impact faster than" [m/s].
std::vector<double> settling_speeds(const ordered_json& report) {
  std::vector<double> speeds;
  if (!report.at("cases").empty()) {
    for (const ordered_json& last : report.at("cases").at(0).at("settling").at("last_impacts")) {
      speeds.push_back(last.at("speed"));
    }
  }
  return speeds;
}

std::string cables_text(const ordered_json& cables) {
  std::string result;
  for (const ordered_json& cable : cables) {
    result += (result.empty() ? "" : "+") + count_text(cable);
  }
  return result.empty() ? dash : result;
}

/// What a body does once its final set of cables is taut.
std::string afterwards(const ordered_json& lock) {
  if (lock.is_null()) {
    return dash;
  }
  if (lock.at("rests").get<bool>()) {
    return "rests";
  }
  return lock.at("permanent").get<bool>() ? "swings for good" : "moves on";
}

/// What a run found, and what is exact.
std::string beside_exact(const ordered_json& pair, int digits) {
  return fixed_text(member(pair, "found"), digits) + " / " +
         fixed_text(member(pair, "exact"), digits);
}

std::string measured(const ordered_json& metrics) {
  const ordered_json& restitution = metrics.at("restitution");
  return restitution.is_null()
             ? dash
             : fmt::format("{:.4f} ({:.4f} to {:.4f})", restitution.at("mean").get<double>(),
                           restitution.at("smallest").get<double>(),
                           restitution.at("largest").get<double>());
}

/// The processor's cost of a step over that of a closed-form flight, by run.
std::map<std::string, double> cost_ratios(const ordered_json& report) {
  std::map<std::string, double> ratios;
  for (const ordered_json& row : report.at("context").at("timing")) {
    ratios[row.at("case").dump() + row.at("engine").dump() + row.at("model").dump() +
           row.at("step").dump()] = row.at("cost_ratio");
  }
  return ratios;
}

std::string cost_text(const ordered_json& row, const std::map<std::string, double>& ratios) {
  const auto found = ratios.find(row.at("case").dump() + row.at("engine").dump() +
                                 row.at("model").dump() + row.at("step").dump());
  return found == ratios.end() ? dash : fmt::format("{:.1f}", found->second);
}

/// The word, and the limits that matter.
std::string verdict_text(const ordered_json& run) {
  const ordered_json verdict = run.value("verdict", ordered_json(nullptr));
  if (verdict.is_null()) {
    return dash;
  }
  std::string out = report_text(verdict.at("word"));
  const char* separator = ": ";
  for (const ordered_json* check : telling_checks(verdict)) {
    out += fmt::format("{}{} {}, limit {}{}", separator, report_text(check->at("metric")),
                       error_text(check->at("value")), error_text(check->at("limit")),
                       check->at("known").get<bool>() ? " (known)" : "");
    separator = "; ";
  }
  return out;
}

}  // namespace

std::vector<const ordered_json*> telling_checks(const ordered_json& verdict) {
  std::vector<const ordered_json*> broken;
  const ordered_json* tightest = nullptr;
  double highest = -1.0;  // value over limit
  for (const ordered_json& check : verdict.at("checks")) {
    const ordered_json& value = check.at("value");
    const ordered_json& limit = check.at("limit");
    if (check.at("holds") == false) {
      broken.push_back(&check);
    } else if (value.is_number() && limit.is_number() && limit.get<double>() > 0.0 &&
               value.get<double>() / limit.get<double>() > highest) {
      highest = value.get<double>() / limit.get<double>();
      tightest = &check;
    }
  }
  if (broken.empty() && tightest != nullptr) {
    return {tightest};
  }
  return broken;
}

std::string report_text(const ordered_json& value) { return printable(value.get<std::string>()); }

Table summary_table(const ordered_json& report) {
  Table table({"engine", "model", "step", "early error", "worst", "horizon error", "matched",
               "exact", "found", "e error", "overstretch", "energy gain", "failed"},
              2);
  for (const ordered_json& row : report.at("summary")) {
    const ordered_json& impacts = row.at("impacts");
    const ordered_json& early = row.at("early_position_error");
    table.add({report_text(row.at("engine")), report_text(row.at("model")),
               step_text(row.at("step")), error_text(member(early, "median")),
               error_text(member(early, "worst")),
               error_text(member(row.at("horizon_position_error"), "median")),
               count_text(impacts.at("matched")), count_text(impacts.at("exact")),
               count_text(impacts.at("found")), error_text(row.at("worst_restitution_error")),
               error_text(row.at("overstretch")), error_text(row.at("energy_gain")),
               fmt::format("{} of {}", row.at("failed").get<int>(), row.at("cases").get<int>())});
  }
  return table;
}

Table convergence_table(const ordered_json& report) {
  Table table({"engine", "model", "slope: median", "smallest", "largest", "cases", "at rounding"},
              2);
  for (const ordered_json& row : report.at("convergence")) {
    const ordered_json& slope = row.at("slope");
    table.add({report_text(row.at("engine")), report_text(row.at("model")),
               fixed_text(member(slope, "median"), 2), fixed_text(member(slope, "smallest"), 2),
               fixed_text(member(slope, "largest"), 2), count_text(row.at("cases")),
               count_text(row.at("cases_at_rounding"))});
  }
  return table;
}

Table cases_table(const ordered_json& report) {
  std::vector<std::string> headings = {
      "case", "exact run ends", "at t", "horizon", "counted impacts", "energy: start", "end"};
  for (const double speed : settling_speeds(report)) {
    headings.push_back(fmt::format("last impact > {:g}", speed));
  }
  for (const char* heading : {"locked at", "cables", "then", "swing energy", "amplitude"}) {
    headings.emplace_back(heading);
  }
  Table table(headings, 2);
  for (const ordered_json& row : report.at("cases")) {
    std::vector<std::string> cells = {
        report_text(row.at("name")),           report_text(row.at("ending")),
        fixed_text(row.at("end_time"), 6),     fixed_text(row.at("horizon"), 3),
        count_text(row.at("counted_impacts")), fixed_text(row.at("start_energy"), 6),
        fixed_text(row.at("end_energy"), 6)};
    for (const ordered_json& last : row.at("settling").at("last_impacts")) {
      cells.push_back(fixed_text(last.at("time"), 4));
    }
    const ordered_json& lock = row.at("settling").at("lock");
    const ordered_json& swing = member(lock, "swing");
    cells.insert(
        cells.end(),
        {fixed_text(member(lock, "time"), 4), cables_text(member(lock, "cables")), afterwards(lock),
         fixed_text(member(swing, "energy"), 8), fixed_text(member(swing, "amplitude"), 5)});
    table.add(cells);
  }
  return table;
}

Table case_table(const ordered_json& report, const ordered_json& name) {
  const auto ratios = cost_ratios(report);
  std::vector<std::string> headings = {
      "engine",      "model",   "step",  "early error", "horizon error",       "whole",
      "angle error", "matched", "exact", "found",       "first impact off by", "worst"};
  for (const double speed : settling_speeds(report)) {
    headings.push_back(fmt::format("last > {:g} / exact", speed));
  }
  for (const char* heading : {"later", "swing energy / exact", "amplitude / exact", "restitution",
                              "overstretch", "energy gain", "cost"}) {
    headings.emplace_back(heading);
  }
  const bool judged = report.contains("limits") && report.at("limits").is_object();
  if (judged) {
    headings.emplace_back("verdict, limits");
  }
  Table table(headings, 2, judged ? 1 : 0);
  for (const ordered_json& row : report.at("runs")) {
    const ordered_json& metrics = row.at("metrics");
    if (row.at("case") != name || metrics.is_null()) {
      continue;
    }
    const ordered_json& horizon = metrics.at("horizon");
    const ordered_json& impacts = horizon.at("impacts");
    const ordered_json& settling = metrics.at("settling");
    const ordered_json& swing = settling.at("swing");
    std::vector<std::string> cells = {report_text(row.at("engine")),
                                      report_text(row.at("model")),
                                      step_text(row.at("step")),
                                      error_text(metrics.at("early").at("position_error")),
                                      error_text(horizon.at("position_error")),
                                      error_text(metrics.at("whole").at("position_error")),
                                      error_text(horizon.at("angle_error")),
                                      count_text(impacts.at("matched")),
                                      count_text(impacts.at("exact")),
                                      count_text(impacts.at("found")),
                                      error_text(impacts.at("first_time_error")),
                                      error_text(impacts.at("worst_time_error"))};
    for (const ordered_json& last : settling.at("last_impacts")) {
      cells.push_back(beside_exact(last, 4));
    }
    cells.insert(
        cells.end(),
        {count_text(settling.at("later_impacts")), beside_exact(member(swing, "energy"), 8),
         beside_exact(member(swing, "amplitude"), 5), measured(metrics),
         error_text(metrics.at("overstretch")), error_text(metrics.at("energy").at("largest_gain")),
         cost_text(row, ratios)});
    if (judged) {
      cells.push_back(verdict_text(row));
    }
    table.add(cells);
  }
  return table;
}

Table failures_table(const ordered_json& report) {
  Table table({"engine", "model", "case", "step", "what happened"}, 5);
  for (const ordered_json& engine : report.at("engines")) {
    if (!engine.at("problem").is_null()) {
      const std::string kind = engine.at("missing").get<bool>() ? "not here: " : "";
      table.add({report_text(engine.at("name")), dash, dash, dash,
                 kind + report_text(engine.at("problem"))});
    }
  }
  for (const ordered_json& row : report.at("runs")) {
    if (row.at("status") == "failed" || row.at("status") == "diverged") {
      table.add({report_text(row.at("engine")), report_text(row.at("model")),
                 report_text(row.at("case")), step_text(row.at("step")),
                 report_text(row.at("reason"))});
    }
  }
  return table;
}

}  // namespace tautline::bench
