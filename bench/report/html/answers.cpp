// The first of what the page says: the answer in words, over all cases, and run by run.
#include <fmt/format.h>

#include <algorithm>
#include <limits>
#include <optional>
#include <set>

#include "bench/base/html.hpp"
#include "bench/report/html/page.hpp"
#include "bench/report/html/parts.hpp"
#include "bench/report/tables.hpp"

namespace tautline::bench {
namespace {

using nlohmann::ordered_json;

std::size_t count_status(const ordered_json& report, std::string_view word) {
  const ordered_json& runs = report.at("runs");
  return static_cast<std::size_t>(std::count_if(
      runs.begin(), runs.end(), [&](const ordered_json& run) { return run.at("status") == word; }));
}

std::string counted(std::size_t count, const std::string& one) {
  return fmt::format("{} {}{}", count, one, count == 1 ? "" : "s");
}

/// The smallest and largest median error up to the horizon at the smallest step, of the control or
/// of the others; none without a number.
std::optional<std::pair<double, double>> median_errors(const ordered_json& report,
                                                       bool of_control) {
  double step = std::numeric_limits<double>::infinity();
  for (const ordered_json& row : report.at("summary")) {
    step = std::min(step, row.at("step").get<double>());
  }
  std::optional<std::pair<double, double>> result;
  for (const ordered_json& row : report.at("summary")) {
    const ordered_json& error = member(row.at("horizon_position_error"), "median");
    if (row.at("step") == step && (row.at("engine") == control) == of_control &&
        error.is_number()) {
      const double value = error;
      result = result ? std::pair(std::min(result->first, value), std::max(result->second, value))
                      : std::pair(value, value);
    }
  }
  return result;
}

/// How the runs ended; what did not happen is not said.
std::string endings_sentence(const ordered_json& report) {
  std::vector<std::string> parts = {
      fmt::format("{} ran to the end", count_status(report, "finished"))};
  if (const std::size_t stopped = count_status(report, "stopped"); stopped > 0) {
    parts.push_back(fmt::format("{} stopped where the engine goes no further", stopped));
  }
  if (const std::size_t bad = count_status(report, "failed") + count_status(report, "diverged");
      bad > 0) {
    parts.push_back(fmt::format("{} failed or diverged", bad));
  }
  return joined(parts, "and") + ".";
}

std::string small_number(double value) {
  return value == 0.0 ? "0" : fmt::format("{:.1e}", value);  // exactly: no digits to show
}

std::string errors_sentence(const ordered_json& report) {
  const auto engines = median_errors(report, false);
  const auto exact = median_errors(report, true);
  std::string out;
  if (engines) {
    out += fmt::format(
        " At the smallest step the median distance from the exact position, up to the "
        "predictability "
        "horizon, is between {} and {} m, by engine and model",
        small_number(engines->first), small_number(engines->second));
    out += exact ? fmt::format(
                       "; the exact motion, put through the same comparison as a control, is at "
                       "most {} m off.",
                       small_number(exact->second))
                 : ".";
  }
  return out;
}

std::string missing_sentence(const ordered_json& report) {
  std::vector<std::string> names;
  for (const ordered_json& engine : report.at("engines")) {
    if (!engine.at("problem").is_null()) {
      names.push_back(report_text(engine.at("name")));
    }
  }
  return names.empty() ? ""
                       : " Not compared: " + html_text(joined(names, "and"), 1000) +
                             ", for the reasons below.";
}

std::string main_findings(const ordered_json& report) {
  constexpr std::size_t enough = 5;
  const ordered_json& findings = member(report, "findings");
  std::string out;
  for (std::size_t index = 0; index < std::min(enough, findings.size()); ++index) {
    const ordered_json& one = findings.at(index);
    out += fmt::format("<li>{} {}: {}</li>\n", html_text(one.at("engine").get<std::string>()),
                       html_text(one.at("model").get<std::string>()),
                       html_prose(one.at("sentence").get<std::string>()));
  }
  if (findings.size() > enough) {
    out += fmt::format("<li><a href=\"#audit\">and {} more</a></li>\n", findings.size() - enough);
  }
  return out.empty() ? "" : "<ul class=\"findings\">\n" + out + "</ul>\n";
}

std::vector<HtmlColumn> answers_columns(const ordered_json& report) {
  const std::string settled = settled_heading(report);
  return {{"engine", "engine", "", "", false},
          {"model", "model", "", "", false},
          {"step", "step", "s", ""},
          {"early", "median", "m", "early error"},
          {"early-worst", "worst", "m", "early error"},
          {"horizon", "median", "m", "error to the horizon"},
          {"horizon-worst", "worst", "m", "error to the horizon"},
          {"exact", "exact", "", "impacts to the horizon"},
          {"found", "found", "", "impacts to the horizon"},
          {"matched", "matched", "", "impacts to the horizon"},
          {"settled-exact", "exact", "cases", settled},
          {"settled-found", "found", "cases", settled},
          {"settled-error", "median off by", "s", settled},
          {"restitution", "worst e error", "", ""},
          {"overstretch", "overstretch", "m", ""},
          {"gain", "energy gain", "J", ""},
          {"cost", "cost", "flights", ""},
          {"failed", "failed", "", "runs"},
          {"runs", "all", "", "runs"}};
}

std::vector<std::string> answers_cells(const ordered_json& row, const ordered_json& cost) {
  const ordered_json& impacts = row.at("impacts");
  const ordered_json& early = row.at("early_position_error");
  const ordered_json& horizon = row.at("horizon_position_error");
  const ordered_json& settling = member(row, "settling");
  return {row_heading(row.at("engine").get<std::string>()),
          word_cell(row.at("model").get<std::string>()),
          plain_cell(row.at("step")),
          error_cell(member(early, "median")),
          error_cell(member(early, "worst")),
          error_cell(member(horizon, "median")),
          error_cell(member(horizon, "worst")),
          plain_cell(impacts.at("exact")),
          plain_cell(impacts.at("found")),
          plain_cell(impacts.at("matched")),
          plain_cell(member(settling, "exact")),
          plain_cell(member(settling, "found")),
          error_cell(member(member(settling, "error"), "median")),
          error_cell(row.at("worst_restitution_error")),
          error_cell(row.at("overstretch")),
          error_cell(row.at("energy_gain")),
          fixed_cell(cost, 1),
          plain_cell(row.at("failed")),
          plain_cell(row.at("cases"))};
}

}  // namespace

std::string answer_paragraph(const ordered_json& report) {
  std::set<std::string> engines;
  std::set<std::string> models;
  for (const ordered_json& row : report.at("summary")) {
    engines.insert(key_of(row, {"engine"}));
    models.insert(key_of(row, {"engine", "model"}));
  }
  std::vector<std::string> steps;
  for (const ordered_json& step : report.at("options").at("steps")) {
    steps.push_back(fmt::format("{:g}", step.get<double>()));
  }
  std::string out = fmt::format(
      "<p class=\"answer\">{} on {} with {}, at {} of {} s: {}, each held against the exact motion "
      "of its case. {}",
      counted(report.at("cases").size(), "case"), counted(engines.size(), "engine"),
      counted(models.size(), "model"), steps.size() == 1 ? "a step" : "steps", joined(steps, "and"),
      counted(report.at("runs").size(), "run"), endings_sentence(report));
  if (!report.at("complete").get<bool>()) {
    out += fmt::format(" <strong>The suite was interrupted: {} were planned.</strong>",
                       counted(report.at("planned_runs").get<std::size_t>(), "run"));
  }
  return out + errors_sentence(report) + missing_sentence(report) + "</p>\n" +
         main_findings(report);
}

std::string answers_section(const ordered_json& report) {
  const std::vector<HtmlColumn> columns = answers_columns(report);
  HtmlTable table("answers-table",
                  "Over all cases, by engine, model and step. The exact motion through the same "
                  "comparison, as a "
                  "control, stands apart. Cost: of one step, in closed-form flights.",
                  columns);
  const auto cost =
      costs(member(report.at("context"), "costs"), "cost_ratio", {"engine", "model", "step"});
  for (const bool of_control : {true, false}) {
    table.begin_body(of_control ? "control" : "");
    for (const ordered_json& row : report.at("summary")) {
      if ((row.at("engine") == control) == of_control) {
        table.add(answers_cells(row, found_in(cost, key_of(row, {"engine", "model", "step"}))));
      }
    }
  }
  table.begin_body("missing");
  for (const ordered_json& engine : report.at("engines")) {
    if (!engine.at("problem").is_null()) {
      table.add({row_heading(engine.at("name").get<std::string>()),
                 fmt::format("<td colspan=\"{}\">{}{}", columns.size() - 1,
                             engine.at("missing").get<bool>() ? "not here: " : "",
                             html_text(engine.at("problem").get<std::string>()))});
    }
  }
  const std::string stopped = stopped_sentence(report);
  constexpr std::size_t longest_sentence = 2000;
  return "<section id=\"answers\">\n<h2>Answers</h2>\n" + table.html() +
         (stopped.empty()
              ? ""
              : "<p class=\"note\">" + html_text(stopped, longest_sentence) + "</p>\n") +
         "</section>\n";
}

}  // namespace tautline::bench
