#include "bench/report/sections.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cctype>
#include <cstddef>
#include <string>
#include <utility>
#include <vector>

#include "bench/base/html.hpp"
#include "bench/cases/catalogue.hpp"
#include "bench/replay/replay.hpp"
#include "bench/report/columns.hpp"
#include "bench/report/scorecard.hpp"
#include "bench/report/tables.hpp"
#include "bench/report/words.hpp"

namespace tautline::bench {
namespace {

std::string section(const std::string& id, const std::string& heading, const std::string& html) {
  return fmt::format("<section id=\"{}\">\n<h2>{}</h2>\n{}</section>\n", id, heading, html);
}

std::string paragraph(const std::string& html) { return "<p>" + html + "</p>\n"; }

std::string note(const std::string& html) { return "<p class=\"note\">" + html + "</p>\n"; }

/// A name and what it means.
std::string entry(const std::string& name, const std::string& html) {
  return fmt::format("<div><dt>{}</dt><dd>{}</dd></div>\n", name, html);
}

/// A table with more rows than this is folded, with their number.
constexpr std::size_t most_open_rows = 40;

/// `table` as it stands, or folded where it is long.
std::string table_html(const Report& report, const Table& table, const std::string& id,
                       const std::string& caption) {
  const std::string html = html_table(in_units_of(report, table), id, caption);
  const std::size_t rows = table.rows().size();
  return rows <= most_open_rows
             ? html
             : fmt::format(
                   "<details class=\"fold\" id=\"{}-fold\"><summary>All {} rows</summary>\n"
                   "{}</details>\n",
                   id, rows, html);
}

/// `table` with its numbers in five digits, or in as many as it shows: a page of thousands of runs
/// would be a third larger with all of them, which stand in the report.
Table in_five_digits(const Table& table) {
  constexpr std::ptrdiff_t least = 5;
  Table result(table.columns());
  for (Row row : table.rows()) {
    for (Cell& cell : row.cells) {
      const auto shown = std::count_if(cell.text.begin(), cell.text.end(),
                                       [](unsigned char one) { return std::isdigit(one) != 0; });
      if (cell.number) {
        cell.number = rounded(*cell.number, static_cast<int>(std::max(least, shown)));
      }
    }
    result.add(std::move(row));
  }
  return result;
}

/// Where the files of each run lie: the names of the folders of cases, of engines and of their
/// models, in the report's order.
std::string folders_json(const Report& report) {
  std::vector<std::string> cases;
  std::vector<std::string> engines;
  std::vector<std::string> models;
  const auto quoted = [](const std::string& name) {
    // such a name has nothing that JSON or HTML reads as its own
    return "\"" + folder_name(name).string() + "\"";
  };
  for (const CaseRow& the_case : report.cases) {
    cases.push_back(quoted(the_case.name));
  }
  for (const EngineRow& engine : report.engines) {
    engines.push_back(quoted(engine.name));
    std::vector<std::string> of_engine;
    for (const Model& model : engine.info ? engine.info->models : std::vector<Model>()) {
      of_engine.push_back(quoted(model.name));
    }
    models.push_back(fmt::format("[{}]", fmt::join(of_engine, ",")));
  }
  return fmt::format("{{\"cases\":[{}],\"engines\":[{}],\"models\":[{}]}}", fmt::join(cases, ","),
                     fmt::join(engines, ","), fmt::join(models, ","));
}

/// A place for a chart: what it shows, which a reader without script is told.
std::string chart_place(const std::string& id, const std::string& shows) {
  return fmt::format(
      "<div class=\"chart\" id=\"{0}\" role=\"figure\" aria-label=\"{1}\">"
      "<p class=\"no-script\">{1} Drawn by script only.</p></div>\n",
      id, html_text(shows));
}

std::string finding_item(const Finding& finding) {
  return fmt::format(
      "<li data-kind=\"{0}\" data-engine=\"{1}\" data-model=\"{2}\"><b>{1} {2}</b> {3} <span "
      "class=\"evidence\">{4}</span></li>\n",
      html_text(finding.kind), html_text(finding.engine), html_text(finding.model),
      html_prose(finding.sentence), evidence_text(finding));
}

std::string model_html(const std::string& engine, const Model& model, const std::string& id) {
  const Table settings = settings_table(model);
  return fmt::format("<h4>{}, {}</h4>\n", html_text(model.name), words_of(model.maker)) +
         paragraph(html_text(model.sentence, longest_sentence)) +
         (settings.empty()
              ? note("Every setting is left alone: the engine’s default.")
              : html_table(settings, id,
                           fmt::format("Settings of {} {} that are not left alone, and whose "
                                       "choice each is.",
                                       engine, model.name)));
}

}  // namespace

std::string answers_section(const Report& report) {
  constexpr std::size_t longest_list = 2000;  // [bytes], of all models that stopped
  const std::string stopped = stopped_sentence(report);
  return section(
      "answers", "Every number over the cases",
      table_html(report, answers_table(report), "answers-table",
                 "Over all cases, by engine, model and step; the verdict is the worst. The exact "
                 "motion is below, as a control. Cost: of one step, in closed-form flights.") +
          (stopped.empty() ? "" : note(html_text(stopped, longest_list))));
}

std::string runs_section(const Report& report) {
  return section(
      "cases", "Every run",
      paragraph("The button of a row leads on: to its replay, its settings, the causes of "
                "its errors, its files, and the command that repeats it.") +
          table_html(report, in_five_digits(runs_table(report)), "cases-table",
                     "By case, engine, model and step; the exact motion as a control "
                     "below. Cost: of one step, in closed-form flights. A case whose gravity is "
                     "one has units of its own.") +
          "<script type=\"application/json\" id=\"run-folders\">" + folders_json(report) +
          "</script>\n");
}

std::string error_section(const Report& report) {
  return section(
      "error", "Error and cost",
      chart_place("chart-cost", "Position error over the cost of a simulated second.") +
          chart_place("chart-step", "Position error over the step, with fitted slopes.") +
          table_html(report, convergence_table(report), "slopes-table",
                     "Slope of log error over log step of the early position error, over all "
                     "cases and steps: 1 is first order, 0 does not converge. *At rounding*: "
                     "cases whose error is rounding, which has no slope."));
}

std::string audit_section(const Report& report) {
  std::string list;
  for (const Finding& finding : report.findings) {
    list += finding_item(finding);
  }
  const std::string found =
      list.empty() ? paragraph("Nothing was found in the impacts of these runs.")
                   : paragraph("Found by program in the impacts of the runs, of all cases:") +
                         "<ul class=\"findings\">\n" + list + "</ul>\n";
  return section("audit", "Restitution, impact by impact",
                 found +
                     "<div id=\"audit-app\"><p class=\"no-script\">The charts of single impacts "
                     "need script. The impacts are in <code>report.json</code>.</p></div>\n");
}

std::string causes_section(const Report& report) {
  const std::string heading = "What the errors come from";
  const Table table = causes_table(report);
  if (table.empty()) {
    return section("attribution", heading, paragraph("No deviation was taken apart."));
  }
  std::string meanings;
  for (const Cause cause : causes) {
    meanings += entry(in_words(to_string(cause)), meaning_of(cause));
  }
  return section(
      "attribution", heading,
      paragraph(html_prose(how_to_read_causes())) +
          table_html(report, table, "attribution-table",
                     "What deviations come from, by engine, model and step, over all cases.") +
          chart_place("chart-attribution", "Shares of the causes, by engine, model and step.") +
          "<dl>\n" + meanings + "</dl>\n");
}

std::string distributions_section(const Report& report) {
  if (!report.distributions) {
    return "";
  }
  return section("distributions", "Settling, as distributions",
                 paragraph(html_prose(distributions_paragraph(report))) +
                     paragraph(html_prose(how_to_read_distributions)) +
                     table_html(report, distributions_table(report), "distributions-table",
                                "D of each statistic, by engine, model and step.") +
                     note(fmt::format("<a href=\"{}\">All distributions over each other</a>, with "
                                      "quantiles over quantiles.",
                                      html_text(report.distributions->page))));
}

std::string models_section(const Report& report) {
  std::string out;
  std::size_t table = 0;
  for (const EngineRow& engine : report.engines) {
    out += fmt::format("<h3 id=\"settings-of-{}\">{}</h3>\n", html_text(engine.name),
                       html_text(engine.name));
    if (engine.problem) {
      out += note((engine.missing ? "Not available: " : "") + html_text(*engine.problem));
    }
    if (!engine.info) {
      continue;
    }
    out += note(fmt::format("Version {}, {}.", html_text(engine.info->version),
                            html_text(engine.info->precision)));
    for (const Model& model : engine.info->models) {
      out += model_html(engine.name, model, fmt::format("settings-{}", ++table));
    }
  }
  return section("models", "How each engine models a cable",
                 folded("Every model and its settings", out));
}

std::string reading_section(const Report& report) {
  std::string items;
  for (const std::string& item : how_to_read(report)) {
    items += "<li>" + html_prose(item) + "</li>\n";
  }
  return section("reading", "How to read this page",
                 folded("Every word of it", "<ul class=\"reading\">\n" + items + "</ul>\n") +
                     paragraph("The source chapter has a page of its own: <code>tautline "
                               "reproduce</code> makes <code>chapter.html</code>."));
}

std::string context_section(const Report& report) {
  std::string list =
      entry("data", "<a href=\"report.json\">report.json</a>, <a href=\"report.md\">report.md</a>");
  for (const Fact& fact : context_facts(report)) {
    const std::string text = html_text(fact.text, longest_sentence);
    list += entry(fact.name, fact.as_typed ? "<code>" + text + "</code>" : text);
  }
  return section("context", "Context", "<dl>\n" + list + "</dl>\n");
}

}  // namespace tautline::bench
