#include <fmt/format.h>

#include <algorithm>
#include <vector>

#include "bench/base/table.hpp"
#include "bench/base/text.hpp"
#include "bench/report/attribution_json.hpp"
#include "bench/report/report.hpp"
#include "bench/report/tables.hpp"
#include "bench/report/terminal.hpp"

namespace tautline::bench {
namespace {

using nlohmann::ordered_json;

std::string engines_section(const ordered_json& report) {
  std::string out;
  for (const ordered_json& engine : report.at("engines")) {
    if (!engine.at("problem").is_null()) {
      continue;
    }
    out += fmt::format("### {} {}, {}\n\n", markdown_text(report_text(engine.at("name"))),
                       markdown_text(report_text(engine.at("version"))),
                       report_text(engine.at("precision")));
    for (const ordered_json& model : engine.at("models")) {
      out += fmt::format("**{}**: {}\n\n", markdown_text(report_text(model.at("name"))),
                         markdown_text(printable(model.at("sentence").get<std::string>(), 1000)));
      Table settings({"setting", "value", "reason"}, 3);
      for (const ordered_json& setting : model.at("settings")) {
        settings.add({report_text(setting.at("name")), report_text(setting.at("value")),
                      printable(setting.at("reason").get<std::string>(), 1000)});
      }
      out += settings.empty() ? "" : settings.markdown() + "\n";
    }
  }
  return out;
}

std::string context_section(const ordered_json& report) {
  const ordered_json& context = report.at("context");
  return fmt::format(
      "- tautline {}, built with {} as {}\n- {}, {} cores\n- started {}, {:.1f} s, {} of {} runs "
      "kept from before; at most {:.0f} MB in the program and {:.0f} MB in a worker\n"
      "- command: {}\n",
      report_text(report.at("program").at("version")), report_text(context.at("compiler")),
      report_text(context.at("build_type")), report_text(context.at("processor")),
      context.at("cores").get<int>(), report_text(context.at("started")),
      context.at("elapsed").get<double>(), context.at("kept_runs").get<int>(),
      report.at("planned_runs").get<int>(), context.at("program_memory").get<double>() / 1e6,
      context.at("worker_memory").get<double>() / 1e6,
      markdown_text(printable(context.at("command").get<std::string>(), 1000)));
}

}  // namespace

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
      "- The **horizon** is where an error of 1e-12 at the start of the exact motion can have "
      "grown "
      "to 1e-3, to first order, by the derivative of the state along the motion. Beyond it a "
      "difference says nothing about an engine.\n"
      "- **Impacts** are counted when faster than {:g}. *Matched* pairs an impact with an exact "
      "one of "
      "the same cable, each the other's nearest in time, up to the horizon.\n"
      "- **Settled** has three definitions. *Last > v* is the time of the last impact that closes "
      "faster than v: the run's over its whole length, then the exact one's; none where the exact "
      "motion does not lock, nor for a run that stopped before. The *lock* is when the final set "
      "of "
      "cables becomes taut in the exact motion; *later* counts the run's impacts after that. The "
      "*swing* is what remains then: its energy above the equilibrium, which the run has as a mean "
      "over its last period, and its amplitude, half the range of the angle, which the run has "
      "from "
      "its samples. There is none for a run without a whole period after the lock.\n"
      "- **Restitution** is measured at each counted impact of a single step, up to the exact "
      "lock, as rebound rate over closing rate of the cable: mean (smallest to largest). "
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
      "- A run that *stopped* was ended by its own simulation, which says why: an engine that does "
      "not follow the motion on taut cables, or one that can go no further. Such a run is compared "
      "up to its stop, and is a failure only if it stopped well before the exact motion has a taut "
      "cable or reaches its horizon.\n"
      "- A **verdict** holds one run against a file of limits; the limit that decides it stands "
      "beside the value. No engine is ranked: an error depends on the model, the step and what it "
      "is for.\n",
      options.at("early_impacts").get<int>(), options.at("count_speed").get<double>());
}

std::string stopped_sentence(const ordered_json& report) {
  std::size_t count = 0;
  std::map<std::string, std::string> reasons;  // of each model
  for (const ordered_json& row : report.at("runs")) {
    if (row.at("status") == "stopped") {
      ++count;
      reasons.emplace(report_text(row.at("engine")) + " " + report_text(row.at("model")),
                      report_text(row.at("reason")));
    }
  }
  std::vector<std::string> models;
  models.reserve(reasons.size());
  for (const auto& [model, reason] : reasons) {
    models.push_back(fmt::format("{} ({})", model, reason));
  }
  return count == 0 ? ""
                    : fmt::format(
                          "{} of {} runs stopped before their end, are compared up to there, and "
                          "are no failures: {}.",
                          count, report.at("runs").size(), joined(models, "and"));
}

std::string report_markdown(const ordered_json& report) {
  std::string out = "# Physics engines on slack cables, against the exact solution\n\n";
  out +=
      fmt::format("{} cases, {} runs{}.\n\n", report.at("cases").size(), report.at("runs").size(),
                  report.at("complete").get<bool>() ? "" : " (INCOMPLETE: interrupted)");
  out += "## Answers\n\nOver all cases, by engine, model and step.\n\n";
  out += summary_table(report).markdown();
  if (const std::string stopped = stopped_sentence(report); !stopped.empty()) {
    out += "\n" + markdown_text(stopped) + "\n";
  }
  out +=
      "\n## Convergence\n\nSlope of log error over log step of the early position error, case by "
      "case: 1 is first order, 0 does not converge.\n\n";
  out += convergence_table(report).markdown();
  if (const Table attribution = attribution_table(report); !attribution.empty()) {
    out += "\n## Where errors come from\n\n" + attribution.markdown() + "\n";
    out += attribution_reading();
  }
  const Table failures = failures_table(report);
  out += "\n## Failures\n\n" + (failures.empty() ? "None.\n" : failures.markdown());
  out += "\n## Restitution audit\n\nWhat the models do to impacts, found from their runs.\n\n" +
         findings_list(report) +
         "\nEffective less requested restitution, of the impacts of one cable alone that are fast "
         "enough for the step:\n\n" +
         scatter_table(report).markdown();
  out += "\n## The exact solutions\n\n" + cases_table(report).markdown();
  out += "\n## Case by case\n";
  for (const ordered_json& row : report.at("cases")) {
    out += fmt::format("\n### {}\n\n", markdown_text(report_text(row.at("name"))));
    out += case_table(report, row.at("name")).markdown();
  }
  out += "\n## How each engine models a cable\n\n" + engines_section(report);
  out += "## How to read this report\n\n" + how_to_read(report);
  out += "\n## Context\n\n" + context_section(report);
  return out;
}

std::string report_summary(const ordered_json& report, const TerminalStyle& style) {
  std::string out = terminal_answers(report, style);
  out += fmt::format(
      "\nearly, horizon: largest distance from the exact position up to impact {} and up to the\n"
      "predictability horizon, median over the cases. impacts: matched of exact, up to the "
      "horizon.\ne error, stretch, gain: worst restitution, overstretch and energy gain of any "
      "case.\n",
      report.at("options").at("early_impacts").get<int>());
  if (report.contains("limits") && report.at("limits").is_object()) {
    out += fmt::format(
        "verdict: by {}, version {}; flagged: breaks a limit, known: as the limits say.\n",
        report_text(report.at("limits").at("file")),
        report_text(report.at("limits").at("version")));
  }
  if (const std::string stopped = stopped_sentence(report); !stopped.empty()) {
    out += stopped + "\n";
  }
  const Table failures = failures_table(report);
  return failures.empty() ? out : out + "\n" + failures.plain();
}

}  // namespace tautline::bench
