// What the page says of errors over steps and costs, of restitution, and of what errors come from.
#include <fmt/format.h>

#include "bench/report/html/page.hpp"
#include "bench/report/html/parts.hpp"

namespace tautline::bench {
namespace {

using nlohmann::ordered_json;

/// A cause of deviations: its name in the report and on the page.
struct Cause {
  const char* name;
  const char* heading;
  const char* meaning;
};

constexpr Cause causes[] = {
    {"flight_bias", "flight bias",
     "free flight whose position is half a step of gravity off, g·dt·t/2"},
    {"event_lag", "event lag", "an impact dealt with before or after its instant"},
    {"late_rate", "late rate",
     "a restitution taken from the velocity of a later or overstretched pose"},
    {"position_correction", "position correction", "overstretch pulled back through the velocity"},
    {"threshold", "threshold", "an impact too slow for the engine to bounce"},
    {"solver_residual", "solver residual", "what else the impulse did: a wrong size or direction"},
    {"taut_drift", "taut drift", "the motion on taut cables"},
    {"amplification", "amplification",
     "what the motion makes of errors beyond first order, or of rounding"}};

std::string slopes_table(const ordered_json& report) {
  HtmlTable table(
      "slopes-table",
      "Slope of log error over log step of the early position error, over the cases: 1 is first "
      "order, 0 does not converge.",
      {{"engine", "engine", "", "", false},
       {"model", "model", "", "", false},
       {"median", "median", "", "slope"},
       {"smallest", "smallest", "", "slope"},
       {"largest", "largest", "", "slope"},
       {"cases", "with a slope", "", "cases"},
       {"rounding", "at rounding", "", "cases"}});
  for (const bool of_control : {true, false}) {
    table.begin_body(of_control ? "control" : "");
    for (const ordered_json& row : report.at("convergence")) {
      if ((row.at("engine") == control) == of_control) {
        const ordered_json& slope = row.at("slope");
        table.add({row_heading(row.at("engine").get<std::string>()),
                   word_cell(row.at("model").get<std::string>()),
                   fixed_cell(member(slope, "median"), 2), fixed_cell(member(slope, "smallest"), 2),
                   fixed_cell(member(slope, "largest"), 2), plain_cell(row.at("cases")),
                   plain_cell(row.at("cases_at_rounding"))});
      }
    }
  }
  return table.html();
}

std::string finding_item(const ordered_json& finding) {
  const ordered_json& evidence = member(finding, "evidence");
  std::string seen;
  if (evidence.is_object()) {
    const auto count = [&](const char* what, const char* one, const char* several) {
      const std::string number = evidence.at(what).dump();
      return fmt::format("{} {}", number, number == "1" ? one : several);
    };
    const std::string runs = count("runs", "run", "runs");
    seen = fmt::format(
        " <span class=\"evidence\">{}</span>",
        evidence.at("impacts") == 0 ? runs : count("impacts", "impact", "impacts") + " of " + runs);
  }
  return fmt::format("<li data-kind=\"{}\"><b>{} {}</b> {}{}</li>\n",
                     html_text(finding.at("kind").get<std::string>()),
                     html_text(finding.at("engine").get<std::string>()),
                     html_text(finding.at("model").get<std::string>()),
                     html_prose(finding.at("sentence").get<std::string>()), seen);
}

std::string attribution_table(const ordered_json& summary) {
  std::vector<HtmlColumn> columns = {{"engine", "engine", "", "", false},
                                     {"model", "model", "", "", false},
                                     {"step", "step", "s", ""},
                                     {"median", "median", "m", "deviation"},
                                     {"worst", "worst", "m", "deviation"}};
  for (const Cause& cause : causes) {
    columns.push_back({cause.name, cause.heading, "", "share of the parts"});
  }
  columns.push_back({"remainder", "remainder", "", ""});
  columns.push_back({"cases", "cases", "", ""});
  HtmlTable table("attribution-table", "What deviations come from, by engine, model and step.",
                  columns);
  for (const bool of_control : {true, false}) {
    table.begin_body(of_control ? "control" : "");
    for (const ordered_json& row : summary) {
      if ((row.at("engine") != control) == of_control) {
        continue;
      }
      const ordered_json& deviation = member(row, "deviation");
      std::vector<std::string> cells = {
          row_heading(row.at("engine").get<std::string>()),
          word_cell(row.at("model").get<std::string>()), plain_cell(row.at("step")),
          error_cell(member(deviation, "median")), error_cell(member(deviation, "worst"))};
      for (const Cause& cause : causes) {
        cells.push_back(fixed_cell(member(member(row, "shares"), cause.name), 3));
      }
      cells.push_back(error_cell(member(row, "remainder")));
      cells.push_back(plain_cell(member(row, "cases")));
      table.add(cells);
    }
  }
  return table.html();
}

}  // namespace

std::string error_section(const ordered_json& report) {
  return "<section id=\"error\">\n<h2>Error and cost</h2>\n" +
         chart_place("chart-cost", "Position error over the cost of a simulated second.") +
         chart_place("chart-step", "Position error over the step, with fitted slopes.") +
         slopes_table(report) + "</section>\n";
}

std::string audit_section(const ordered_json& report) {
  const ordered_json& findings = member(report, "findings");
  std::string list;
  for (const ordered_json& finding : findings) {
    list += finding_item(finding);
  }
  const std::string said =
      findings.is_null() ? "<p>This report has no audit of single impacts.</p>\n"
      : list.empty()
          ? "<p>No threshold, sleeping or lost restitution was found in these runs.</p>\n"
          : "<p>Found in the impacts of these runs, by program:</p>\n<ul class=\"findings\">\n" +
                list + "</ul>\n";
  return "<section id=\"audit\">\n<h2>Restitution, impact by impact</h2>\n" + said +
         "<div id=\"audit-app\"><p class=\"no-script\">The charts of single impacts need script. "
         "The "
         "impacts are in <code>report.json</code>.</p></div>\n</section>\n";
}

std::string attribution_section(const ordered_json& report) {
  const ordered_json& summary = member(report, "attribution_summary");
  std::string out = "<section id=\"attribution\">\n<h2>What the errors come from</h2>\n";
  if (summary.empty()) {
    return out + "<p>This report does not split deviations into causes.</p>\n</section>\n";
  }
  out +=
      "<p>The exact solver starts again from the engine’s own state after each event, and one arc "
      "and "
      "one impact at a time are compared. A share is the part of a cause in the sum of the parts’ "
      "sizes; over the cases it is the median, so a row need not add up to 1.</p>\n";
  out += attribution_table(summary);
  out += chart_place("chart-attribution", "Shares of the causes, by engine, model and step.");
  out += "<dl>\n";
  for (const Cause& cause : causes) {
    out += fmt::format("<div><dt>{}</dt><dd>{}</dd></div>\n", cause.heading, cause.meaning);
  }
  return out + "</dl>\n</section>\n";
}

}  // namespace tautline::bench
