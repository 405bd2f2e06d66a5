// A report in Markdown and as a page: what both say is written once.

#include <fmt/format.h>

#include <algorithm>
#include <cctype>
#include <cstddef>
#include <optional>
#include <string_view>
#include <utility>
#include <vector>

#include "bench/base/document.hpp"
#include "bench/base/html.hpp"
#include "bench/base/listed.hpp"
#include "bench/base/text.hpp"
#include "bench/cases/catalogue.hpp"
#include "bench/page/document.hpp"
#include "bench/replay/replay.hpp"
#include "bench/report/columns.hpp"
#include "bench/report/json/json.hpp"
#include "bench/report/output.hpp"
#include "bench/report/picture.hpp"
#include "bench/report/scorecard.hpp"
#include "bench/report/tables.hpp"
#include "bench/report/words.hpp"
#include "tautline_bench_report_words.inc"

namespace tautline::bench {
namespace {

using namespace fmt::literals;

constexpr const char* title = "Physics engines on slack cables, against the exact solution";

std::string sentence_text(const std::string& sentence) {
  return verbatim(sentence, longest_sentence);
}

/// Adds `table`, which a page folds where it is long.
void add_table(Document& out, const Report& report, const Table& table, const std::string& id,
               const std::string& caption) {
  constexpr std::size_t most_open_rows = 40;
  const std::size_t rows = table.rows().size();
  Document inside;
  inside.table(in_units_of(report, table), id, caption);
  rows <= most_open_rows
      ? out.add(std::move(inside))
      : out.fold(fmt::format("All {} rows", rows), std::move(inside), id + "-fold");
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

std::string contents_html(const Report& report) {
  struct Link {
    std::string_view id;
    std::string_view name;
  };
  constexpr Link links[] = {{"engines", "Engines"},        {"trust", "Trust"},
                            {"error", "Error and cost"},   {"steps", "Steps"},
                            {"replay", "Replay"},          {"audit", "Restitution"},
                            {"distributions", "Settling"}, {"attribution", "Causes"},
                            {"answers", "Numbers"},        {"cases", "Every run"},
                            {"models", "Models"},          {"reading", "Reading"},
                            {"context", "Context"}};
  std::string out = "<nav aria-label=\"Sections\">\n";
  for (const auto& [id, name] : links) {
    if (id != "distributions" || report.distributions) {
      out += fmt::format("<a href=\"#{}\">{}</a>\n", id, name);
    }
  }
  return out + "</nav>\n";
}

/// The motions that are in the page itself.
std::string own_motions(const Report& report, const Replay& replay) {
  std::string out;
  for (const CaseRow& row : report.cases) {
    out += row.motions ? "" : motions_json(report, replay, row.name);
  }
  return out;
}

/// With how many digits the cases are certified.
int digits_of_certificates(const Report& report) {
  const auto found = std::find_if(report.cases.begin(), report.cases.end(),
                                  [](const CaseRow& row) { return row.certified.has_value(); });
  return found != report.cases.end() ? found->certified->digits : 0;
}

/// A name and its meaning.
std::string entry_html(const std::string& name, const std::string& html) {
  return fmt::format("<div><dt>{}</dt><dd>{}</dd></div>\n", name, html);
}

Document engines_section(const Report& report) {
  const Table table = models_table(report);
  Document out;
  out.in(Medium::markdown).list(listed(worst_first_scorecards(report), [](const Scorecard& card) {
    return fmt::format("**{}**: {}", verbatim(card.engine), sentence_text(sentence_of(card)));
  }));
  out.paragraph(table.empty() ? "No engine has a run." : "");
  out.table(in_units_of(report, table), "scorecards-table",
            "Every model, by engine: its restitution and its position in words, at the smallest "
            "step.");
  out.fold("How to read it", Document().paragraph(how_to_read_models()));
  return Document().section("engines", "Engines", std::move(out));
}

Document answers_section(const Report& report) {
  Document out;
  out.in(Medium::markdown).paragraph("Over all cases, by engine, model and step.");
  add_table(out, report, answers_table(report), "answers-table", words::answers);
  out.paragraph(markdown_text(stopped_sentence(report)), "note");
  out.paragraph(markdown_text(systems_sentence(report)), "note");
  return Document().section("answers", "Every number over the cases", std::move(out), "Answers");
}

Document error_section(const Report& report) {
  Document out;
  out.html(chart_place("chart-cost", "Position error over the cost of a simulated second.") +
           chart_place("chart-step", "Position error over the step, with fitted slopes."));
  out.in(Medium::markdown).paragraph(words::convergence);
  add_table(out, report, convergence_table(report), "slopes-table", words::convergence);
  return Document().section("error", "Error and cost", std::move(out), "Convergence");
}

Document distributions_section(const Report& report) {
  if (!report.distributions) {
    return {};
  }
  Document out;
  out.paragraph(distributions_paragraph(report));
  out.paragraph(words::how_to_read_distributions);
  add_table(out, report, distributions_table(report), "distributions-table",
            "D of each statistic, by engine, model and step.");
  const std::string& page = report.distributions->page;
  out.in(Medium::markdown).paragraph("[All distributions over each other](" + page + ")");
  out.html(
      fmt::format("<p class=\"note\"><a href=\"{}\">All distributions over each other</a>, "
                  "with quantiles over quantiles.</p>\n",
                  html_text(page)));
  return Document().section("distributions", "Settling, as distributions", std::move(out));
}

Document causes_section(const Report& report) {
  const std::string heading = "What the errors come from";
  const Table table = causes_table(report);
  const auto told = causes_of(report.causes);
  Document out;
  if (table.empty()) {
    out.paragraph(report.has_contacts()
                      ? "No deviation was taken apart: causes go by impacts, and elastic cables "
                        "have none."
                      : "No deviation was taken apart.");
    return Document().in(Medium::page).section("attribution", heading, std::move(out));
  }
  out.in(Medium::page).paragraph(words::how_to_read_causes);
  add_table(out, report, table, "attribution-table",
            "What deviations come from, by engine, model and step, over all cases.");
  out.in(Medium::markdown).paragraph(words::how_to_read_causes);
  out.html(chart_place("chart-attribution", "Shares of the causes, by engine, model and step."));
  out.in(Medium::markdown).list(listed(told, [](Cause cause) {
    return fmt::format("*{}*: {}.", in_words(to_string(cause)), meaning_of(cause));
  }));
  std::string meanings;
  for (const Cause cause : told) {
    meanings += entry_html(in_words(to_string(cause)), meaning_of(cause));
  }
  out.html("<dl>\n" + meanings + "</dl>\n");
  return Document().section("attribution", heading, std::move(out), "Where errors come from");
}

std::string finding_html(const Finding& finding) {
  return fmt::format(
      "<li data-kind=\"{0}\" data-engine=\"{1}\" data-model=\"{2}\"><b>{1} {2}</b> {3} <span "
      "class=\"evidence\">{4}</span></li>\n",
      html_text(finding.kind), html_text(finding.engine), html_text(finding.model),
      html_prose(finding.sentence), evidence_text(finding));
}

Document audit_section(const Report& report) {
  Document out;
  out.in(Medium::markdown).paragraph(words::audit);
  if (report.findings.empty()) {
    out.paragraph("Nothing was found in the impacts of these runs.");
  } else {
    out.html(
        fmt::format("<p>Found by program in the impacts of the runs, of all cases:</p>\n"
                    "<ul class=\"findings\">\n{}</ul>\n",
                    fmt::join(listed(report.findings, finding_html), "")));
    out.in(Medium::markdown).list(listed(report.findings, [](const Finding& finding) {
      return fmt::format("**{} {}**: {} ({}).", verbatim(finding.engine), verbatim(finding.model),
                         sentence_text(finding.sentence), evidence_text(finding));
    }));
  }
  out.html(
      "<div id=\"audit-app\"><p class=\"no-script\">The charts of single impacts need script. "
      "The impacts are in <code>report.json</code>.</p></div>\n");
  return Document().section("audit", "Restitution, impact by impact", std::move(out),
                            "Restitution audit");
}

Document runs_section(const Report& report) {
  Document out;
  out.paragraph(words::runs);
  add_table(out, report, in_five_digits(runs_table(report)), "cases-table", words::runs_table);
  out.html("<script type=\"application/json\" id=\"run-folders\">" + folders_json(report) +
           "</script>\n");
  return Document().section("cases", "Every run", std::move(out));
}

Document runs_by_case(const Report& report) {
  Document out;
  out.heading(2, "Case by case");
  for (const CaseRow& row : report.cases) {
    out.titled(runs_table(report, row.name), "",
               fmt::format("{}: {}", verbatim(row.name), verbatim(row.title)));
  }
  return out;
}

void add_model(Document& out, const std::string& engine, const Model& model, std::size_t number) {
  Table settings = settings_table(model);
  const std::string sentence = sentence_text(model.sentence);
  out.in(Medium::markdown).paragraph(fmt::format("**{}**: {}", verbatim(model.name), sentence));
  out.html(fmt::format("<h4>{}, {}</h4>\n", html_text(model.name), words_of(model.maker)));
  out.in(Medium::page).paragraph(sentence);
  out.in(Medium::page)
      .paragraph(settings.empty() ? "Every setting is left alone: the engine’s default." : "",
                 "note");
  out.table(std::move(settings), fmt::format("settings-{}", number),
            fmt::format("Settings of {} {} that are not left alone, and whose choice each is.",
                        verbatim(engine), verbatim(model.name)));
}

Document models_section(const Report& report) {
  Document out;
  std::size_t number = 0;
  for (const EngineRow& engine : report.engines) {
    out.html(fmt::format("<h3 id=\"settings-of-{0}\">{0}</h3>\n", html_text(engine.name)));
    out.in(Medium::page)
        .paragraph(engine.problem
                       ? (engine.missing ? "Not available: " : "") + verbatim(*engine.problem)
                       : "",
                   "note");
    if (!engine.info) {
      continue;
    }
    const std::string version = verbatim(engine.info->version);
    const std::string precision = verbatim(engine.info->precision);
    out.in(Medium::markdown)
        .heading(3, fmt::format("{} {}, {}", verbatim(engine.name), version, precision));
    out.in(Medium::page).paragraph(fmt::format("Version {}, {}.", version, precision), "note");
    for (const Model& model : engine.info->models) {
      add_model(out, engine.name, model, ++number);
    }
  }
  return Document().section("models", "How each engine models a cable",
                            Document().fold("Every model and its settings", std::move(out)));
}

Document reading_section(const Report& report) {
  Document out;
  out.fold("Every word of it", Document().list(how_to_read(report), "reading"));
  out.in(Medium::page).paragraph(words::chapter);
  return Document().section("reading", "How to read this page", std::move(out),
                            "How to read this report");
}

Document context_section(const Report& report) {
  const std::vector<Fact> facts = context_facts(report);
  std::string entries = entry_html(
      "data", "<a href=\"report.json\">report.json</a>, <a href=\"report.md\">report.md</a>");
  for (const Fact& fact : facts) {
    const std::string text = html_text(fact.text, longest_sentence);
    entries += entry_html(fact.name, fact.as_typed ? "<code>" + text + "</code>" : text);
  }
  Document out;
  out.in(Medium::markdown).list(listed(facts, [](const Fact& fact) {
    return fact.name + ": " + markdown_text(fact.text);
  }));
  out.html("<dl>\n" + entries + "</dl>\n");
  return Document().section("context", "Context", std::move(out));
}

/// What the comparison makes of the exact motion itself.
void add_control(Document& out, const Report& report) {
  if (std::none_of(report.runs.begin(), report.runs.end(),
                   [](const RunRow& run) { return run.key.engine == control; })) {
    out.paragraph(words::no_control);
    return;
  }
  Table table = sampled_table(report);
  out.paragraph(table.empty() ? words::control
                              : fmt::format("{} {}", words::control, words::sampled));
  out.table(std::move(table), "sampled-table",
            "Worst over the cases of `exact sampled`, the exact motion seen at steps.");
}

Document trust_section(const Report& report) {
  Table certified = in_units_of(report, certified_table(report));
  Document out;
  out.paragraph(certified.empty() ? fmt::format("{} {}", words::certified, words::not_certified)
                                  : words::certified);
  out.table(std::move(certified), "certified-table",
            fmt::format("The exact motion against the same in {} digits, of the same doubles.",
                        digits_of_certificates(report)));
  if (!report.cases.empty()) {
    out.paragraph("One case, and all that is sure of it:");
    out.html(fmt::format(
        "<p><span class=\"command\"><code>tautline solve {} --certify</code></span></p>\n",
        html_text(report.cases.front().name)));
  }
  out.paragraph(words::horizon);
  add_control(out, report);
  return Document().section("trust", "Can the reference be believed?", std::move(out));
}

/// Which step each case needs.
Document steps_section(const Report& report) {
  Document out;
  if (const Table table = steps_table(report); !table.empty()) {
    out.section(
        "steps", "Which step does a case need?",
        Document().table(in_units_of(report, table), "steps-table",
                         fmt::format(words::how_to_read_steps, "part"_a = 100.0 * usual_part,
                                     "window"_a = usual_window)));
  }
  return out;
}

Document replay_section() {
  Document out;
  out.paragraph(words::replay);
  out.html(
      "<div id=\"replay-app\">\n<p class=\"no-script\">The replay needs script. The motion of a "
      "run is in <code>trajectory.csv</code> in its folder.</p>\n</div>\n");
  return Document().section("replay", "Replay", std::move(out));
}

std::string main_findings_html(const Report& report) {
  constexpr std::size_t enough = 5;
  const auto& findings = report.findings;
  std::string out;
  for (std::size_t index = 0; index < std::min(enough, findings.size()); ++index) {
    out += fmt::format("<li>{} {}: {}</li>\n", html_text(findings[index].engine),
                       html_text(findings[index].model), html_prose(findings[index].sentence));
  }
  if (findings.size() > enough) {
    out += fmt::format("<li><a href=\"#audit\">and {} more</a></li>\n", findings.size() - enough);
  }
  return out.empty() ? "" : "<ul class=\"findings\">\n" + out + "</ul>\n";
}

/// A sentence for each engine, the worst first.
std::string verdicts_html(const Report& report) {
  std::string out;
  for (const Scorecard& card : worst_first_scorecards(report)) {
    const EngineWords words = words_of(card);
    out += fmt::format(
        "<li data-engine=\"{0}\" data-model=\"{1}\" data-use=\"{2}\"><b class=\"{3}\"><span>{0}"
        "</span></b><p class=\"fault\">{4}</p><p class=\"advice\">{5}</p></li>\n",
        html_text(card.engine), html_text(words.model), html_text(card.use ? card.use->model : ""),
        verdict_kind(words.word), html_text(words.fault, longest_sentence),
        html_text(words.advice, longest_sentence));
  }
  return out.empty() ? "" : "<ul class=\"engines\">\n" + out + "</ul>\n";
}

}  // namespace

std::string report_markdown(const Report& report) {
  Document out;
  out.paragraph(fmt::format(
      "{}, {}{}.", counted(report.cases.size(), "case"), counted(report.runs.size(), "run"),
      report.complete ? "" : fmt::format(" of {} (INCOMPLETE)", report.planned_runs)));
  out.add(engines_section(report)).add(answers_section(report)).add(error_section(report));
  out.add(distributions_section(report)).add(causes_section(report));
  const Table failures = failures_table(report);
  out.heading(2, "Failures").paragraph(failures.empty() ? "None." : "").table(failures, "", "");
  out.add(audit_section(report));
  out.heading(2, "The exact solutions").table(in_units_of(report, cases_table(report)), "", "");
  if (const Table certified = certified_table(report); !certified.empty()) {
    out.paragraph("Compared with the same motions in many digits:");
    out.table(in_units_of(report, certified), "", "");
  }
  out.add(runs_by_case(report)).add(models_section(report)).add(reading_section(report));
  out.add(context_section(report));
  return fmt::format("# {}\n\n{}", title, out.markdown());
}

std::string report_html(const Report& report, const Replay& replay, const PageAssets& assets) {
  const std::optional<ImpactStills> stills = impact_stills(report, replay);
  Document head;
  head.html(fmt::format("<h1>{}</h1>\n", title)).paragraph(lead_sentence(report), "lead-in");
  head.html(picture_html(stills ? &*stills : nullptr) + verdicts_html(report));
  head.fold("How many runs, and how they ended",
            Document().paragraph(answer_text(report), "answer").html(main_findings_html(report)));
  head.paragraph(assets.plotly.empty() ? words::no_charts : "", "note");
  Document out;
  out.add(engines_section(report)).add(trust_section(report)).add(error_section(report));
  out.add(steps_section(report)).add(replay_section()).add(audit_section(report));
  out.add(distributions_section(report)).add(causes_section(report)).add(answers_section(report));
  out.add(runs_section(report)).add(models_section(report)).add(reading_section(report));
  out.add(context_section(report));
  return html_document(
      {.title = title,
       .content = fmt::format("<header>\n{}</header>\n{}<main>\n{}</main>\n", head.html(),
                              contents_html(report), out.html()),
       .command = "tautline bench",
       .data_id = "report-data",
       .data = html_json(page_json(report, replay)),
       .scripts = assets.scripts,
       .motions = html_json(own_motions(report, replay)),
       .files_beside = report.cases.size() > most_cases_in_page,
       .in_space = std::any_of(report.cases.begin(), report.cases.end(),
                               [](const CaseRow& row) { return row.system.has_value(); })},
      assets);
}

}  // namespace tautline::bench
