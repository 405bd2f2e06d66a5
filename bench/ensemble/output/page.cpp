#include "bench/ensemble/output/output.hpp"

#include <fmt/format.h>

#include <optional>

#include "bench/base/atomic_file.hpp"
#include "bench/base/document.hpp"
#include "bench/base/html.hpp"
#include "bench/base/listed.hpp"
#include "bench/ensemble/output/atlas.hpp"
#include "bench/page/document.hpp"
#include "bench/plot/motion.hpp"
#include "tautline/solve.hpp"
#include "tautline/system_settling.hpp"
#include "tautline_bench_ensemble_words.inc"

namespace tautline::bench {
namespace {

using namespace fmt::literals;

void add_figure(Document& out, const DrawnFigure& figure, const Statistic& statistic) {
  out.html(figure_html(figure));
  out.paragraph(verbatim(statistic.heading) + ": " + verbatim(statistic.meaning) + ".", "note");
}

Document atlas_document(const EnsembleReport& report, const Atlas& atlas) {
  Document out;
  out.paragraph(atlas.draws.size() <= most_pictures
                    ? words::atlas
                    : fmt::format(words::large_atlas, "most"_a = most_pictures,
                                  "cells"_a = atlas.draws.size()),
                "note");
  for (const AtlasMap& map : atlas.maps) {
    const Statistic& statistic = report.findings.statistics[map.statistic];
    add_figure(out,
               {"tautline-atlas-" + statistic.name, "Atlas of " + statistic.heading,
                atlas_svg(atlas, map, statistic), atlas_csv(atlas, map, statistic)},
               statistic);
  }
  return out;
}

/// All that Markdown or a page says, but for the title.
Document document_of(const EnsembleReport& report, Medium medium) {
  const bool page = medium == Medium::page;
  Document out;
  out.list(listed(ensemble_sentences(report), markdown_text), "answer");
  if (Table table = comparison_table(report); !table.empty()) {
    out.section("comparisons", "Compared with exact",
                Document()
                    .table(std::move(table), "comparison-table",
                           "Each statistic compared with the exact motion.")
                    .paragraph(words::how_to_read_comparisons, "note"));
  }
  if (const auto atlas = page ? atlas_of(report) : std::nullopt) {
    out.section("atlas", "Atlas", atlas_document(report, *atlas));
  }
  Document inside;
  const std::vector<Statistic>& statistics = report.findings.statistics;
  for (std::size_t place = 0; page && place < statistics.size(); ++place) {
    if (const Statistic& statistic = statistics[place]; statistic.compared) {
      add_figure(inside,
                 {"tautline-distribution-" + statistic.name, "Distribution of " + statistic.heading,
                  distribution_svg(report, place), distribution_csv(report, place)},
                 statistic);
    }
  }
  inside.table(summary_table(report), "summary-table",
               "Each statistic of each setup: its median and spread.");
  inside.paragraph(words::how_to_read_summaries, "note");
  return out.section("distributions", "Distributions", inside);
}

std::string picture(const Case& the_case, const SolveOptions& options) {
  return plot_svg(the_case, solve(the_case, options));
}

template <int D>
std::string picture(const BasicSystem<double, D>& system, const SolveOptions& options) {
  const auto solution = solve(system, options);
  const SystemSettling settled = settling(system, solution);
  return plot_svg(BasicSystemMotion<D>{system, solution, settled, std::nullopt});
}

/// A picture of the first motion of each cell of the atlas.
void write_pictures(const std::filesystem::path& out, const EnsembleReport& report) {
  const std::optional<Atlas> atlas = atlas_of(report);
  if (!atlas) {
    return;
  }
  const EnsembleSetup& exact = report.request.setups.front();
  for (std::size_t cell = 0; cell < atlas->draws.size(); ++cell) {
    if (atlas->pictured[cell]) {
      const AnyCase any = named_case_of(report.request.spec, exact, atlas->draws[cell]);
      write_file(out / picture_name(cell),
                 std::visit([&](const auto& one) { return picture(one, options_of(exact)); }, any));
    }
  }
}

}  // namespace

std::string ensemble_markdown(const EnsembleReport& report) {
  return fmt::format("# Ensemble\n\n{}\n\n{}", markdown_text(ensemble_title(report)),
                     document_of(report, Medium::markdown).markdown());
}

std::string ensemble_html(const EnsembleReport& report, const PageAssets& assets) {
  const std::string title = "Ensemble of " + ensemble_title(report);
  PageAssets style_alone;
  style_alone.style = assets.style;
  return html_document(
      {.title = title,
       .content = fmt::format("<header>\n<h1>{}</h1>\n</header>\n<main>\n{}</main>\n",
                              html_text(title), document_of(report, Medium::page).html()),
       .command = "tautline ensemble",  // as typed it says nothing of the draws
       .data_id = "ensemble-data",
       .data = html_json(ensemble_json(report)),
       .scripts = assets.figure_scripts},
      style_alone);
}

void write_ensemble(const std::filesystem::path& out, const EnsembleReport& report) {
  write_pictures(out, report);
  write_file(out / "ensemble.json", ensemble_json(report));
  write_file(out / "ensemble.md", ensemble_markdown(report));
  write_file(out / "index.html", ensemble_html(report, page_assets()));
}

}  // namespace tautline::bench
