#include "bench/report/output.hpp"

#include <fmt/format.h>

#include <string_view>
#include <utility>

#include "bench/base/html.hpp"
#include "bench/page/document.hpp"
#include "bench/report/html/picture.hpp"
#include "bench/report/html/sections.hpp"
#include "bench/report/json/json.hpp"

namespace tautline::bench {
namespace {

constexpr std::string_view title = "Physics engines on slack cables, against the exact solution";

std::string contents(const Report& report) {
  struct Link {
    std::string_view id;
    std::string_view name;
  };
  constexpr Link links[] = {
      {"engines", "Engines"},    {"trust", "Trust"},       {"error", "Error and cost"},
      {"replay", "Replay"},      {"audit", "Restitution"}, {"distributions", "Settling"},
      {"attribution", "Causes"}, {"answers", "Numbers"},   {"cases", "Every run"},
      {"models", "Models"},      {"reading", "Reading"},   {"context", "Context"}};
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

}  // namespace

std::string report_html(const Report& report, const Replay& replay, const PageAssets& assets) {
  std::string out =
      fmt::format("<header>\n<h1>{}</h1>\n{}{}{}", title, picture_html(report, replay),
                  verdict_paragraph(report), folded("In sentences", answer_paragraph(report)));
  if (assets.plotly.empty()) {
    out +=
        "<p class=\"note\">Charts are not in this build of tautline: it was made without "
        "Plotly.</p>\n";
  }
  out += "</header>\n" + contents(report) + "<main>\n" + scorecards_section(report) +
         trust_section(report);
  out += error_section(report) + replay_section() + audit_section(report);
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

}  // namespace tautline::bench
