#include "bench/ensemble/output/output.hpp"

#include <fmt/format.h>

#include <optional>

#include "bench/base/atomic_file.hpp"
#include "bench/base/html.hpp"
#include "bench/base/table.hpp"
#include "bench/ensemble/output/atlas.hpp"
#include "bench/page/document.hpp"
#include "bench/plot/motion.hpp"
#include "tautline/solve.hpp"

namespace tautline::bench {
namespace {

/// A sentence may name every statistic [bytes].
constexpr std::size_t longest_answer = 2000;

std::string meaning_note(const Statistic& statistic) {
  return fmt::format("<p class=\"note\">{}: {}.</p>\n", html_text(statistic.heading),
                     html_text(statistic.meaning));
}

std::string answers(const EnsembleReport& report) {
  std::string out;
  for (const std::string& sentence : ensemble_sentences(report)) {
    out += fmt::format("<p class=\"answer\">{}</p>\n", html_text(sentence, longest_answer));
  }
  return out;
}

std::string comparisons(const EnsembleReport& report) {
  const Table table = comparison_table(report);
  return table.empty()
             ? ""
             : "<section id=\"comparisons\">\n<h2>Compared with exact</h2>\n" +
                   html_table(table, "comparison-table",
                              "Each statistic compared with the exact motion.") +
                   fmt::format("<p class=\"note\">{}</p>\n</section>\n", how_to_read_comparisons);
}

std::string distributions(const EnsembleReport& report) {
  std::string out = "<section id=\"distributions\">\n<h2>Distributions</h2>\n";
  for (std::size_t place = 0; place < report.findings.statistics.size(); ++place) {
    const Statistic& statistic = report.findings.statistics[place];
    if (statistic.compared) {
      out += figure_html({"tautline-distribution-" + statistic.name,
                          "Distribution of " + statistic.heading, distribution_svg(report, place),
                          distribution_csv(report, place)}) +
             meaning_note(statistic);
    }
  }
  return out +
         html_table(summary_table(report), "summary-table",
                    "Each statistic of each setup: its median and spread.") +
         fmt::format("<p class=\"note\">{}</p>\n</section>\n", how_to_read_summaries);
}

std::string atlas(const EnsembleReport& report) {
  const std::optional<Atlas> made = atlas_of(report);
  if (!made) {
    return "";
  }
  std::string out =
      "<section id=\"atlas\">\n<h2>Atlas</h2>\n<p class=\"note\">Of the exact motion the mean over "
      "the draws of each cell, and the first cable of most of them; grey: none has the number. The "
      "colours leave out the least and the largest hundredth. " +
      (made->draws.size() <= most_pictures
           ? std::string(
                 "A cell leads to a picture of the motion of its first draw, where there is one.")
           : fmt::format("Cells of up to {} lead to pictures of their motion; these are {}.",
                         most_pictures, made->draws.size())) +
      "</p>\n";
  for (const AtlasMap& map : made->maps) {
    const Statistic& statistic = report.findings.statistics[map.statistic];
    out += figure_html({"tautline-atlas-" + statistic.name, "Atlas of " + statistic.heading,
                        atlas_svg(*made, map, statistic), atlas_csv(*made, map, statistic)}) +
           meaning_note(statistic);
  }
  return out + "</section>\n";
}

}  // namespace

std::string ensemble_html(const EnsembleReport& report, const PageAssets& assets) {
  const std::string title = "Ensemble of " + ensemble_title(report);
  PageAssets style_alone;
  style_alone.style = assets.style;
  return html_document(
      {.title = title,
       .content = fmt::format("<header>\n<h1>{}</h1>\n</header>\n<main>\n", html_text(title)) +
                  answers(report) + comparisons(report) + atlas(report) + distributions(report) +
                  "</main>\n",
       .command = "tautline ensemble",  // as typed it says nothing of the draws
       .data_id = "ensemble-data",
       .data = html_json(ensemble_json(report)),
       .scripts = assets.figure_scripts},
      style_alone);
}

namespace {

/// A picture of the first motion of each cell of the atlas.
void write_pictures(const std::filesystem::path& out, const EnsembleReport& report) {
  const std::optional<Atlas> atlas = atlas_of(report);
  if (!atlas) {
    return;
  }
  const EnsembleSetup& exact = report.request.setups.front();
  for (std::size_t cell = 0; cell < atlas->draws.size(); ++cell) {
    if (atlas->pictured[cell]) {
      const Case the_case = named_case_of(report.request.spec, exact, atlas->draws[cell]);
      write_file(out / picture_name(cell), plot_svg(the_case, solve(the_case, options_of(exact))));
    }
  }
}

}  // namespace

void write_ensemble(const std::filesystem::path& out, const EnsembleReport& report) {
  write_pictures(out, report);
  write_file(out / "ensemble.json", ensemble_json(report));
  write_file(out / "ensemble.md", ensemble_markdown(report));
  write_file(out / "index.html", ensemble_html(report, page_assets()));
}

}  // namespace tautline::bench
