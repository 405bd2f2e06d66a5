#include <fmt/format.h>

#include <map>

#include "bench/report.hpp"
#include "bench/table.hpp"
#include "bench/text.hpp"

namespace tautline::bench {
namespace {

using nlohmann::ordered_json;

const std::string dash = "–";  // where there is no number

std::string text(const ordered_json& value) { return printable(value.get<std::string>()); }

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

Table summary_table(const ordered_json& report) {
  Table table({"engine", "model", "step", "early error", "worst", "horizon error", "matched",
               "exact", "found", "e error", "overstretch", "energy gain", "failed"},
              2);
  for (const ordered_json& row : report.at("summary")) {
    const ordered_json& impacts = row.at("impacts");
    const ordered_json& early = row.at("early_position_error");
    table.add({text(row.at("engine")), text(row.at("model")), step_text(row.at("step")),
               error_text(member(early, "median")), error_text(member(early, "worst")),
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
    table.add({text(row.at("engine")), text(row.at("model")),
               fixed_text(member(slope, "median"), 2), fixed_text(member(slope, "smallest"), 2),
               fixed_text(member(slope, "largest"), 2), count_text(row.at("cases")),
               count_text(row.at("cases_at_rounding"))});
  }
  return table;
}

Table cases_table(const ordered_json& report) {
  Table table({"case", "exact run ends", "at t", "horizon", "counted impacts", "energy: start",
               "end", "accumulation"},
              2);
  for (const ordered_json& row : report.at("cases")) {
    const ordered_json& time = member(row.at("accumulation"), "time");
    table.add({text(row.at("name")), text(row.at("ending")), fixed_text(row.at("end_time"), 6),
               fixed_text(row.at("horizon"), 3), count_text(row.at("counted_impacts")),
               fixed_text(row.at("start_energy"), 6), fixed_text(row.at("end_energy"), 6),
               time.is_number() ? fmt::format("t = {:.6f}", time.get<double>()) : dash});
  }
  return table;
}

std::string settled(const ordered_json& metrics) {
  const ordered_json& settling = metrics.at("settling_time");
  return fixed_text(settling.at("found"), 4) + " / " + fixed_text(settling.at("exact"), 4);
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

Table case_table(const ordered_json& report, const ordered_json& name,
                 const std::map<std::string, double>& ratios) {
  Table table({"engine", "model", "step", "early error", "horizon error", "whole", "angle error",
               "matched", "exact", "found", "first impact off by", "worst", "settled / exact",
               "later", "restitution", "overstretch", "energy gain", "cost"},
              2);
  for (const ordered_json& row : report.at("runs")) {
    const ordered_json& metrics = row.at("metrics");
    if (row.at("case") != name || metrics.is_null()) {
      continue;
    }
    const ordered_json& horizon = metrics.at("horizon");
    const ordered_json& impacts = horizon.at("impacts");
    table.add({text(row.at("engine")), text(row.at("model")), step_text(row.at("step")),
               error_text(metrics.at("early").at("position_error")),
               error_text(horizon.at("position_error")),
               error_text(metrics.at("whole").at("position_error")),
               error_text(horizon.at("angle_error")), count_text(impacts.at("matched")),
               count_text(impacts.at("exact")), count_text(impacts.at("found")),
               error_text(impacts.at("first_time_error")),
               error_text(impacts.at("worst_time_error")), settled(metrics),
               count_text(metrics.at("settling_time").at("later_impacts")), measured(metrics),
               error_text(metrics.at("overstretch")),
               error_text(metrics.at("energy").at("largest_gain")), cost_text(row, ratios)});
  }
  return table;
}

Table failures_table(const ordered_json& report) {
  Table table({"engine", "model", "case", "step", "what happened"}, 5);
  for (const ordered_json& engine : report.at("engines")) {
    if (!engine.at("problem").is_null()) {
      const std::string kind = engine.at("missing").get<bool>() ? "not here: " : "";
      table.add({text(engine.at("name")), dash, dash, dash, kind + text(engine.at("problem"))});
    }
  }
  for (const ordered_json& row : report.at("runs")) {
    if (row.at("status") == "failed" || row.at("status") == "diverged") {
      table.add({text(row.at("engine")), text(row.at("model")), text(row.at("case")),
                 step_text(row.at("step")), text(row.at("reason"))});
    }
  }
  return table;
}

std::string engines_section(const ordered_json& report) {
  std::string out;
  for (const ordered_json& engine : report.at("engines")) {
    if (!engine.at("problem").is_null()) {
      continue;
    }
    out += fmt::format("### {} {}, {}\n\n", markdown_text(text(engine.at("name"))),
                       markdown_text(text(engine.at("version"))), text(engine.at("precision")));
    for (const ordered_json& model : engine.at("models")) {
      out += fmt::format("**{}**: {}\n\n", markdown_text(text(model.at("name"))),
                         markdown_text(printable(model.at("sentence").get<std::string>(), 1000)));
      Table settings({"setting", "value", "reason"}, 3);
      for (const ordered_json& setting : model.at("settings")) {
        settings.add({text(setting.at("name")), text(setting.at("value")),
                      printable(setting.at("reason").get<std::string>(), 1000)});
      }
      out += settings.empty() ? "" : settings.markdown() + "\n";
    }
  }
  return out;
}

std::string how_to_read(const ordered_json& report) {
  const ordered_json& options = report.at("options");
  return fmt::format(
      "- The **exact** engine is the control: the exact solution through the same loop and "
      "comparison "
      "as every engine. Its `event` model names its impacts, as the engines' `event` models do. "
      "Its "
      "`sampled` model gives only the states and impulses of each step, as models with fixed steps "
      "do: "
      "what it misses, the detector cannot tell apart at that step, and its e error is what "
      "gravity "
      "within a step does to velocities that are exact.\n"
      "- An **error** is the largest distance from the exact position, in the case's length unit: "
      "*early* up to the exact solution's impact {} (and before the next), *horizon* up to the "
      "predictability horizon, *whole* up to the end of the exact solution or of the run. Over all "
      "cases: the median, and for the early one the worst too.\n"
      "- The **horizon** is where exact runs started 1e-12 apart have moved 1e-3 apart. Beyond it "
      "a difference says nothing about an engine.\n"
      "- **Impacts** are counted when faster than {:g}. *Matched* pairs an impact with an exact "
      "one of "
      "the same cable, each the other's nearest in time, up to the horizon.\n"
      "- **Settled** is the time of the last counted impact up to the end of the exact solution, "
      "where "
      "its impacts accumulate; *later* counts the run's impacts after that.\n"
      "- **Restitution** is measured at each counted impact of a single step, up to the end of the "
      "exact solution, as rebound rate over closing rate of the cable: mean (smallest to largest). "
      "The "
      "rates are of the velocities the engine has before and after the step, at the pose before "
      "it. The "
      "*e error* is the worst distance from the cable's own restitution.\n"
      "- **Overstretch** is how far the most overstretched cable exceeds its length, **energy "
      "gain** "
      "how far the energy rises above its start; both over every step of the run, for models with "
      "fixed "
      "steps also after the exact solution has ended. A scheme whose velocities belong to the "
      "middle of "
      "a step shows an offset of half a step of gravity here, even when it gains nothing.\n"
      "- **Cost** is the processor time of one step over that of one closed-form flight with its "
      "gaps, measured side by side in the same process; the start of the run is shared out over "
      "the steps.\n"
      "- A run that *stopped* reached an accumulation of impacts: the exact solution and the event "
      "models end there.\n",
      options.at("early_impacts").get<int>(), options.at("count_speed").get<double>());
}

std::string context_section(const ordered_json& report) {
  const ordered_json& context = report.at("context");
  return fmt::format(
      "- tautline {}, built with {} as {}\n- {}, {} cores\n- started {}, {:.1f} s, {} of {} runs "
      "kept from before; at most {:.0f} MB in the program and {:.0f} MB in a worker\n"
      "- command: {}\n",
      text(report.at("program").at("version")), text(context.at("compiler")),
      text(context.at("build_type")), text(context.at("processor")), context.at("cores").get<int>(),
      text(context.at("started")), context.at("elapsed").get<double>(),
      context.at("kept_runs").get<int>(), report.at("planned_runs").get<int>(),
      context.at("program_memory").get<double>() / 1e6,
      context.at("worker_memory").get<double>() / 1e6,
      markdown_text(printable(context.at("command").get<std::string>(), 1000)));
}

}  // namespace

std::string report_markdown(const ordered_json& report) {
  std::string out = "# Physics engines on slack cables, against the exact solution\n\n";
  out +=
      fmt::format("{} cases, {} runs{}.\n\n", report.at("cases").size(), report.at("runs").size(),
                  report.at("complete").get<bool>() ? "" : " (INCOMPLETE: interrupted)");
  out += "## Answers\n\nOver all cases, by engine, model and step.\n\n";
  out += summary_table(report).markdown();
  out +=
      "\n## Convergence\n\nSlope of log error over log step of the early position error, case by "
      "case: 1 is first order, 0 does not converge.\n\n";
  out += convergence_table(report).markdown();
  const Table failures = failures_table(report);
  out += "\n## Failures\n\n" + (failures.empty() ? "None.\n" : failures.markdown());
  out += "\n## The exact solutions\n\n" + cases_table(report).markdown();
  out += "\n## Case by case\n";
  const auto ratios = cost_ratios(report);
  for (const ordered_json& row : report.at("cases")) {
    out += fmt::format("\n### {}\n\n", markdown_text(text(row.at("name"))));
    out += case_table(report, row.at("name"), ratios).markdown();
  }
  out += "\n## How each engine models a cable\n\n" + engines_section(report);
  out += "## How to read this report\n\n" + how_to_read(report);
  out += "\n## Context\n\n" + context_section(report);
  return out;
}

std::string report_summary(const ordered_json& report) {
  std::string out = summary_table(report).plain();
  out += fmt::format(
      "\nerror: largest distance from the exact position, median over the cases; early: up to "
      "impact "
      "{}; horizon: up to\nthe predictability horizon. matched, exact, found: impacts up to the "
      "horizon. "
      "e error: worst restitution error.\n",
      report.at("options").at("early_impacts").get<int>());
  const Table failures = failures_table(report);
  return failures.empty() ? out : out + "\n" + failures.plain();
}

}  // namespace tautline::bench
