#include "bench/report/output.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <limits>
#include <map>
#include <optional>
#include <set>
#include <string_view>
#include <utility>
#include <vector>

#include "bench/base/html.hpp"
#include "bench/base/listed.hpp"
#include "bench/base/table.hpp"
#include "bench/page/document.hpp"
#include "bench/report/columns.hpp"
#include "bench/report/json/json.hpp"
#include "bench/report/picture.hpp"
#include "bench/report/scorecard.hpp"
#include "bench/report/sections.hpp"
#include "bench/report/tables.hpp"
#include "bench/report/words.hpp"

namespace tautline::bench {
namespace {

constexpr std::string_view title = "Physics engines on slack cables, against the exact solution";

std::string contents(const Report& report) {
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

std::string replay_section() {
  return "<section id=\"replay\">\n<h2>Replay</h2>\n"
         "<p>The motion of one case: the exact one, and what engines make of it. Past the "
         "predictability horizon, where a difference says nothing about an engine, everything is "
         "grey.</p>\n<div id=\"replay-app\">\n<p class=\"no-script\">The replay needs script. "
         "The motion of a run is in <code>trajectory.csv</code> in its "
         "folder.</p>\n</div>\n</section>\n";
}

/// The motions that are in the page itself.
std::string own_motions(const Report& report, const Replay& replay) {
  std::string out;
  for (const CaseRow& row : report.cases) {
    out += row.motions ? "" : motions_json(report, replay, row.name);
  }
  return out;
}

/// The model of the control that gives only what a model with fixed steps gives.
constexpr const char* sampled = "sampled";

/// The control's own errors where it is only sampled, by metric and step; those that are zero
/// throughout are left out.
Table sampled_table(const Report& report) {
  std::map<double, const SummaryRow*, std::greater<>> rows;
  for (const SummaryRow& row : report.summary) {
    if (row.key.engine == control && row.key.model == sampled) {
      rows.emplace(row.key.step, &row);
    }
  }
  std::vector<Column> columns = {word_column("metric", ""), word_column("unit", "")};
  for (const auto& [step, row] : rows) {
    columns.push_back(
        number_column(fmt::format("step {}", number_text(step, as_count)), "", "", ""));
  }
  Table table(std::move(columns));
  for (std::size_t place = 0; place < metric_list().size(); ++place) {
    const Metric& metric = metric_list()[place];
    std::vector<Cell> cells = {in_words(metric.name), shown_unit(metric, report)};
    bool any = false;
    for (const auto& [step, row] : rows) {
      const auto& value = row->metrics.at(place);
      any = any || (value && value->worst != 0.0);
      cells.push_back(
          number_cell(value ? std::optional(value->worst) : std::nullopt, metric.digits));
    }
    if (any) {
      table.add(std::move(cells));
    }
  }
  return table;
}

/// What the comparison makes of the exact motion itself.
std::string control_paragraph(const Report& report) {
  const bool there = std::any_of(report.runs.begin(), report.runs.end(),
                                 [](const RunRow& run) { return run.key.engine == control; });
  if (!there) {
    return "<p>The control is not in this report; <code>--engines</code> with <code>exact</code> "
           "brings it.</p>\n";
  }
  std::string out =
      "<p><b>The control</b>, <code>exact</code>, is the same solver as the reference: it shows "
      "what "
      "the comparison itself costs, and nothing of whether the reference is right.";
  const Table table = sampled_table(report);
  if (table.empty()) {
    return out + "</p>\n";
  }
  return out +
         " Its model <code>sampled</code> gives only what a model with fixed steps gives: the "
         "state "
         "and the impulses of each step. What it has of an error, no such model can be blamed "
         "for:</p>\n" +
         html_table(table, "sampled-table",
                    "Worst over the cases of `exact sampled`, the exact motion seen at steps.");
}

/// With how many digits the cases are certified.
int digits_of_certificates(const Report& report) {
  const auto found = std::find_if(report.cases.begin(), report.cases.end(),
                                  [](const CaseRow& row) { return row.certified.has_value(); });
  return found != report.cases.end() ? found->certified->digits : 0;
}

/// The smallest and the largest of some numbers.
struct Range {
  double smallest;
  double largest;
};

/// The median errors up to the horizon at the smallest step, of the control or of the others; none
/// without a number.
std::optional<Range> median_errors(const Report& report, bool of_control) {
  double step = std::numeric_limits<double>::infinity();
  for (const SummaryRow& row : report.summary) {
    step = std::min(step, row.key.step);
  }
  const auto place = place_of("horizon_position_error");
  std::optional<Range> result;
  for (const SummaryRow& row : report.summary) {
    const auto& error = row.metrics.at(place.value());
    if (row.key.step == step && (row.key.engine == control) == of_control && error &&
        error->median) {
      const double value = *error->median;
      result = result ? Range{std::min(result->smallest, value), std::max(result->largest, value)}
                      : Range{value, value};
    }
  }
  return result;
}

/// How the runs ended; what did not happen is not said.
std::string endings_sentence(const Report& report) {
  const auto count = [&](auto... statuses) {
    return std::count_if(report.runs.begin(), report.runs.end(),
                         [&](const RunRow& run) { return ((run.status == statuses) || ...); });
  };
  std::vector<std::string> parts = {fmt::format("{} ran to the end", count(Status::finished))};
  if (const auto stopped = count(Status::stopped); stopped > 0) {
    parts.push_back(fmt::format("{} stopped where the engine goes no further", stopped));
  }
  if (const auto bad = count(Status::failed, Status::diverged); bad > 0) {
    parts.push_back(fmt::format("{} failed or diverged", bad));
  }
  if (const auto refused = count(Status::unsupported); refused > 0) {
    parts.push_back(fmt::format("{} the engine does not support", refused));
  }
  return joined(parts, "and") + ".";
}

/// What the comparison makes of the exact motion itself.
std::string control_clause(double largest) {
  return "the exact motion, compared with itself as a control, " +
         (largest == 0.0 ? "shows no deviation"
                         : fmt::format("deviates by up to {} m", number_text(largest, as_error)));
}

std::string errors_sentence(const Report& report) {
  const auto engines = median_errors(report, false);
  const auto exact = median_errors(report, true);
  if (!engines) {
    return "";
  }
  return fmt::format(
             " At the smallest step the median distance from the exact position, up to the "
             "predictability horizon, is between {} and {} m, by engine and model",
             number_text(engines->smallest, as_error), number_text(engines->largest, as_error)) +
         (exact ? "; " + control_clause(exact->largest) + "." : ".");
}

std::string missing_sentence(const Report& report) {
  std::vector<std::string> names;
  for (const EngineRow& engine : report.engines) {
    if (engine.problem) {
      names.push_back(html_text(engine.name));
    }
  }
  return names.empty() ? "" : " Not compared: " + joined(names, "and") + ", for the reasons below.";
}

std::string main_findings(const Report& report) {
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

/// "2 cases on 3 engines with 7 models, at steps 0.01 and 0.001 s: 42 runs (40 of engines, 2 of the
/// control)".
std::string scope(const Report& report) {
  std::set<std::string> engines;
  std::set<std::pair<std::string, std::string>> models;
  for (const SummaryRow& row : report.summary) {
    engines.insert(row.key.engine);
    models.emplace(row.key.engine, row.key.model);
  }
  const std::vector<std::string> steps =
      listed(report.options.steps, [](double step) { return number_text(step, as_count); });
  const auto controls = std::count_if(report.runs.begin(), report.runs.end(),
                                      [](const RunRow& run) { return run.key.engine == control; });
  const auto all = static_cast<std::ptrdiff_t>(report.runs.size());
  return fmt::format(
      "{} on {} with {}, at {} of {} s: {}{}", counted(report.cases.size(), "case"),
      counted(engines.size(), "engine"), counted(models.size(), "model"),
      steps.size() == 1 ? "a step" : "steps", joined(steps, "and"),
      counted(report.runs.size(), "run"),
      controls == 0 || controls == all
          ? ""
          : fmt::format(" ({} of engines, {} of the control)", all - controls, controls));
}

/// What the page is about, for one who has never seen it.
std::string lead_paragraph(const Report& report) {
  std::set<std::string> engines;
  for (const RunRow& run : report.runs) {
    if (run.key.engine != control) {
      engines.insert(run.key.engine);
    }
  }
  return fmt::format(
      "<p class=\"lead-in\">{} {} a body on cables that are slack or taut, in {} whose exact "
      "motion is known. Each is compared with it; the worst comes first.</p>\n",
      counted(engines.size(), "physics engine"), engines.size() == 1 ? "simulates" : "simulate",
      counted(report.cases.size(), "case"));
}

/// Which step each case needs.
std::string steps_section(const Report& report) {
  const Table table = steps_table(report);
  return table.empty()
             ? ""
             : "<section id=\"steps\">\n<h2>Which step does a case need?</h2>\n" +
                   html_table(in_units_of(report, table), "steps-table", how_to_read_steps()) +
                   "</section>\n";
}

}  // namespace

std::string report_html(const Report& report, const Replay& replay, const PageAssets& assets) {
  const std::optional<ImpactStills> stills = impact_stills(report, replay);
  std::string out =
      fmt::format("<header>\n<h1>{}</h1>\n{}{}{}{}", title, lead_paragraph(report),
                  picture_html(stills ? &*stills : nullptr), verdict_paragraph(report),
                  folded("How many runs, and how they ended", answer_paragraph(report)));
  if (assets.plotly.empty()) {
    out +=
        "<p class=\"note\">Charts are not in this build of tautline: it was made without "
        "Plotly.</p>\n";
  }
  out += "</header>\n" + contents(report) + "<main>\n" + scorecards_section(report) +
         trust_section(report);
  out += error_section(report) + steps_section(report) + replay_section() + audit_section(report);
  out += distributions_section(report) + causes_section(report);
  out += answers_section(report) + runs_section(report);
  out += models_section(report);
  out += reading_section(report) + context_section(report) + "</main>\n";
  return html_document({.title = title,
                        .content = std::move(out),
                        .command = "tautline bench",
                        .data_id = "report-data",
                        .data = html_json(page_json(report, replay)),
                        .scripts = assets.scripts,
                        .motions = html_json(own_motions(report, replay)),
                        .files_beside = report.cases.size() > most_cases_in_page},
                       assets);
}

std::string command_html(const std::string& command) {
  return fmt::format("<span class=\"command\"><code>{}</code></span>", html_text(command));
}

std::string folded(const std::string& summary, const std::string& html) {
  return "<details class=\"fold\"><summary>" + summary + "</summary>\n" + html + "</details>\n";
}

std::string verdict_paragraph(const Report& report) {
  const std::vector<Scorecard> cards = worst_first_scorecards(report);
  std::string out;
  for (const Scorecard& card : cards) {
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

std::string scorecards_section(const Report& report) {
  const Table table = in_units_of(report, models_table(report));
  std::string out = "<section id=\"engines\">\n<h2>Engines</h2>\n";
  out += table.empty() ? "<p>No engine has a run.</p>\n"
                       : html_table(table, "scorecards-table",
                                    "Every model, by engine: its restitution and its position in "
                                    "words, at the smallest step.");
  return out + folded("How to read it", "<p>" + html_prose(how_to_read_models()) + "</p>\n") +
         "</section>\n";
}

std::string trust_section(const Report& report) {
  std::string out =
      "<section id=\"trust\">\n<h2>Can the reference be believed?</h2>\n"
      "<p><b>Against many digits.</b> The exact motion is computed in double precision. The same "
      "motion in many digits says until when 9, 6 and 3 digits of it are right";
  if (const Table table = in_units_of(report, certified_table(report)); !table.empty()) {
    out += ":</p>\n" + html_table(table, "certified-table",
                                  fmt::format("The exact motion against the same in {} digits, of "
                                              "the same doubles.",
                                              digits_of_certificates(report)));
  } else {
    out += ": <code>--certify</code> brings the figures into this report, in seconds a case.</p>\n";
  }
  if (!report.cases.empty()) {
    out += "<p>One case, and all that is sure of it:</p>\n<p>" +
           command_html("tautline solve " + report.cases.front().name + " --certify") + "</p>\n";
  }
  out +=
      "<p><b>The horizon.</b> Errors of 1e-12 grow to 1e-3 by the predictability horizon of each "
      "case; beyond it a difference says nothing about an engine.</p>\n";
  return out + control_paragraph(report) + "</section>\n";
}

std::string answer_paragraph(const Report& report) {
  std::string out =
      fmt::format("<p class=\"answer\">{}, each compared with the exact motion of its case. {}",
                  scope(report), endings_sentence(report));
  if (!report.complete) {
    out += fmt::format(
        " <strong>This report is incomplete: {} planned.</strong>",
        counted(report.planned_runs, "run") + (report.planned_runs == 1 ? " was" : " were"));
  }
  return out + errors_sentence(report) + missing_sentence(report) + "</p>\n" +
         main_findings(report);
}

}  // namespace tautline::bench
