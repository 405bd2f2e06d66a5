// Every run of the suite, a row each.
#include <fmt/format.h>

#include <algorithm>

#include "bench/report/html/page.hpp"
#include "bench/report/html/parts.hpp"
#include "bench/report/tables.hpp"

namespace tautline::bench {
namespace {

using nlohmann::ordered_json;

/// The restitution that a case asks for, if all its cables have one and the same; or null.
ordered_json restitution_of(const ordered_json& the_case) {
  const ordered_json& cables = member(the_case, "geometry");
  if (cables.empty()) {
    return nullptr;
  }
  const ordered_json& first = member(cables.at(0), "restitution");
  const bool same = std::all_of(cables.begin(), cables.end(), [&](const ordered_json& cable) {
    return member(cable, "restitution") == first;
  });
  return same ? first : ordered_json();
}

std::vector<HtmlColumn> columns_of(const ordered_json& report, bool judged) {
  const std::string settled = settled_heading(report);
  std::vector<HtmlColumn> columns = {{"case", "case", "", "", false},
                                     {"engine", "engine", "", "", false},
                                     {"model", "model", "", "", false},
                                     {"step", "step", "s", ""}};
  if (judged) {
    columns.push_back({"verdict", "verdict, limits", "", "", false});
  }
  const std::vector<HtmlColumn> metrics = {
      {"early", "early", "m", "position error"},
      {"horizon", "to the horizon", "m", "position error"},
      {"exact", "exact", "", "impacts to the horizon"},
      {"found", "found", "", "impacts to the horizon"},
      {"matched", "matched", "", "impacts to the horizon"},
      {"settled-exact", "exact", "s", settled},
      {"settled-found", "found", "s", settled},
      {"restitution-asked", "asked", "", "restitution e"},
      {"restitution-mean", "mean", "", "restitution e"},
      {"restitution-worst", "worst error", "", "restitution e"},
      {"overstretch", "overstretch", "m", ""},
      {"gain", "energy gain", "J", ""},
      {"cost", "cost", "flights", ""},
      {"status", "how it ended", "", "", false}};
  columns.insert(columns.end(), metrics.begin(), metrics.end());
  return columns;
}

/// The word, and each limit that matters beside its value; why, where it does not hold.
std::string verdict_cell(const ordered_json& verdict) {
  if (!verdict.is_object()) {
    return "<td>–";
  }
  const std::string word = verdict.at("word");
  std::string out = fmt::format("<td class=\"verdict {0}\"><span>{0}</span>", html_text(word));
  const auto line = [](const ordered_json& check) {
    const auto number = [](const ordered_json& value) {
      return value.is_number() ? fmt::format("<span data-value=\"{}\">{:.2g}</span>",
                                             value.is_number_float() ? shortest(value.get<double>())
                                                                     : value.dump(),
                                             value.get<double>())
                               : std::string("–");
    };
    const ordered_json& reason = member(check, "reason");
    return fmt::format(
        "<br>{} {}, limit {}{}{}", html_text(check.at("metric").get<std::string>()),
        number(check.at("value")), number(check.at("limit")),
        check.value("known", false) ? " (known)" : "",
        check.at("holds") == false && reason.is_string() && !reason.get<std::string>().empty()
            ? ": " + html_text(reason.get<std::string>())
            : "");
  };
  for (const ordered_json* check : telling_checks(verdict)) {
    out += line(*check);
  }
  return out;
}

/// "finished", or the word and why.
std::string ending(const ordered_json& run) {
  const std::string word = run.at("status");
  const std::string reason = run.at("reason");
  return reason.empty() ? word : word + ": " + reason;
}

std::vector<std::string> metric_cells(const ordered_json& metrics, const ordered_json& restitution,
                                      const ordered_json& cost) {
  const ordered_json& horizon = metrics.at("horizon");
  const ordered_json& impacts = horizon.at("impacts");
  const ordered_json& last = metrics.at("settling").at("last_impacts").at(0);
  const ordered_json& measured = metrics.at("restitution");
  constexpr int instant = 4;  // digits of times and coefficients
  return {error_cell(metrics.at("early").at("position_error")),
          error_cell(horizon.at("position_error")),
          plain_cell(impacts.at("exact")),
          plain_cell(impacts.at("found")),
          plain_cell(impacts.at("matched")),
          fixed_cell(last.at("exact"), instant),
          fixed_cell(last.at("found"), instant),
          plain_cell(restitution),
          fixed_cell(member(measured, "mean"), instant),
          error_cell(member(measured, "worst_error")),
          error_cell(metrics.at("overstretch")),
          error_cell(metrics.at("energy").at("largest_gain")),
          fixed_cell(cost, 1)};
}

}  // namespace

std::string cases_section(const ordered_json& report) {
  const ordered_json& runs = report.at("runs");
  const bool judged = std::any_of(runs.begin(), runs.end(), [](const ordered_json& run) {
    return member(run, "verdict").is_object();
  });
  std::map<std::string, ordered_json> restitution;
  for (const ordered_json& the_case : report.at("cases")) {
    restitution[key_of(the_case, {"name"})] = restitution_of(the_case);
  }
  const auto cost =
      costs(report.at("context").at("timing"), "cost_ratio", {"case", "engine", "model", "step"});
  const std::vector<HtmlColumn> columns = columns_of(report, judged);
  constexpr std::size_t metric_columns = 13;
  HtmlTable table(
      "cases-table",
      "By case, engine, model and step; the exact motion as a control below. Cost: of one step, in "
      "closed-form flights.",
      columns);
  for (const bool of_control : {false, true}) {
    table.begin_body(of_control ? "control" : "");
    for (const ordered_json& run : runs) {
      if ((run.at("engine") == control) != of_control) {
        continue;
      }
      std::vector<std::string> cells = {row_heading(run.at("case").get<std::string>()),
                                        word_cell(run.at("engine").get<std::string>()),
                                        word_cell(run.at("model").get<std::string>()),
                                        plain_cell(run.at("step"))};
      if (judged) {
        cells.push_back(verdict_cell(member(run, "verdict")));
      }
      if (run.at("metrics").is_null()) {
        cells.push_back(fmt::format("<td class=\"reason\" colspan=\"{}\">{}", metric_columns + 1,
                                    html_text(ending(run))));
      } else {
        const auto more =
            metric_cells(run.at("metrics"), found_in(restitution, key_of(run, {"case"})),
                         found_in(cost, key_of(run, {"case", "engine", "model", "step"})));
        cells.insert(cells.end(), more.begin(), more.end());
        cells.push_back(word_cell(ending(run)));
      }
      const std::string status = run.at("status");
      table.add(cells, status == "finished" ? "" : "class=\"" + html_text(status) + "\"");
    }
  }
  return "<section id=\"cases\">\n<h2>Every run</h2>\n" + table.html() + "</section>\n";
}

}  // namespace tautline::bench
