#include "bench/report/html/page.hpp"

#include <fmt/format.h>

#include <algorithm>

#include "bench/base/html.hpp"

namespace tautline::bench {
namespace {

using nlohmann::ordered_json;

// Nothing is fetched from anywhere: what the page may do is what stands in it.
constexpr std::string_view policy =
    "default-src 'none'; script-src 'unsafe-inline'; style-src 'unsafe-inline'; img-src data: "
    "blob:; "
    "base-uri 'none'; form-action 'none'";

constexpr std::string_view title = "Physics engines on slack cables, against the exact solution";

std::string head(const PageAssets& assets) {
  return fmt::format(
      "<!DOCTYPE html>\n<html lang=\"en\">\n<head>\n<meta charset=\"utf-8\">\n"
      "<meta http-equiv=\"Content-Security-Policy\" content=\"{}\">\n"
      "<meta name=\"viewport\" content=\"width=device-width, initial-scale=1\">\n"
      "<meta name=\"color-scheme\" content=\"light dark\">\n<title>{}</title>\n"
      "<link rel=\"icon\" href=\"data:,\">\n<style>\n{}</style>\n</head>\n",
      policy, title, assets.style);
}

std::string contents() {
  struct Link {
    std::string_view id;
    std::string_view name;
  };
  constexpr Link links[] = {
      {"answers", "Answers"}, {"cases", "Every run"},        {"error", "Error and cost"},
      {"replay", "Replay"},   {"audit", "Restitution"},      {"attribution", "Causes"},
      {"models", "Models"},   {"reading", "How to read it"}, {"context", "Context"}};
  std::string out = "<nav aria-label=\"Sections\">\n";
  for (const auto& [id, name] : links) {
    out += fmt::format("<a href=\"#{}\">{}</a>\n", id, name);
  }
  return out + "</nav>\n";
}

std::string replay_section() {
  return "<section id=\"replay\">\n<h2>Replay</h2>\n"
         "<p>The motion of one case: the exact one, and what engines make of it. Past the "
         "predictability horizon, where a difference says nothing about an engine, everything is "
         "grey.</p>\n<div id=\"replay-app\">\n<p class=\"no-script\">The replay needs script. The "
         "motions are in <code>report.json</code>, and as <code>trajectory.csv</code> in the "
         "folder of "
         "each run.</p>\n</div>\n</section>\n";
}

/// What the scripts read of `report`: the verdicts of all runs are in the tables already, and take
/// a tenth of a large page.
ordered_json data_of(ordered_json report) {
  for (ordered_json& run : report.at("runs")) {
    run.erase("verdict");
    run.erase("output_tail");
  }
  return report;
}

/// The scripts, after the data that they read. The parser comes to them last: the page is legible
/// before.
std::string scripts(const ordered_json& report, const PageAssets& assets) {
  std::string out = "<script type=\"application/json\" id=\"report-data\">" +
                    html_json(data_of(report)) + "</script>\n";
  if (!assets.plotly.empty()) {
    out += fmt::format("<script id=\"plotly\">{}</script>\n", assets.plotly);
  }
  return out + fmt::format("<script id=\"page-scripts\">\n{}</script>\n", assets.scripts);
}

/// A multi-line text as it stands.
std::string preformatted(std::string_view text) {
  std::string out = "<pre>";
  while (!text.empty()) {
    const std::size_t end = std::min(text.find('\n'), text.size());
    out += html_text(text.substr(0, end)) + "\n";
    text.remove_prefix(std::min(end + 1, text.size()));
  }
  return out + "</pre>";
}

std::string foot(const ordered_json& report, const PageAssets& assets) {
  std::string out = fmt::format(
      "<footer>\n<p>Made by <code>tautline bench</code> {}. The source chapter has a page of its "
      "own: "
      "<code>tautline reproduce</code> makes it, <a href=\"chapter.html\">chapter.html</a> if it "
      "was "
      "made in the same folder.</p>\n",
      html_text(report.at("program").at("version").get<std::string>()));
  if (!assets.plotly.empty()) {
    out += "<details><summary>Charts are drawn by Plotly.js, under the MIT licence.</summary>\n" +
           preformatted(assets.licence) + "</details>\n";
  }
  return out + "</footer>\n";
}

}  // namespace

std::string report_html(const ordered_json& report, const PageAssets& assets) {
  std::string out = head(assets);
  out += fmt::format("<body{}>\n<header>\n<h1>{}</h1>\n{}",
                     assets.plotly.empty() ? " class=\"no-charts\"" : "", title,
                     answer_paragraph(report));
  if (assets.plotly.empty()) {
    out +=
        "<p class=\"note\">Charts are not in this build of tautline: it was made without "
        "Plotly.</p>\n";
  }
  out += "</header>\n" + contents() + "<main>\n";
  out += answers_section(report) + cases_section(report) + error_section(report) + replay_section();
  out += audit_section(report) + attribution_section(report);
  out += models_section(report) + reading_section(report) + context_section(report);
  out += "</main>\n" + foot(report, assets) + scripts(report, assets);
  return out + "</body>\n</html>\n";
}

}  // namespace tautline::bench
