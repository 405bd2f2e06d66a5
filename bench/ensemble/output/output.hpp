#pragma once

#include <filesystem>
#include <string>

#include "bench/base/table.hpp"
#include "bench/base/terminal.hpp"
#include "bench/ensemble/output/words.hpp"
#include "bench/page/page_assets.hpp"

namespace tautline::bench {

/// Writes index.html, ensemble.md, ensemble.json and the pictures of an atlas into `out`. The
/// same draws give the same bytes. Throws FileError if one cannot be written.
void write_ensemble(const std::filesystem::path& out, const EnsembleReport& report);

/// One page that needs no other file but the pictures of an atlas' cells: what differs, each
/// distribution over the others, and the atlas.
[[nodiscard]] std::string ensemble_html(const EnsembleReport& report, const PageAssets& assets);

/// For a terminal: the tables, and what they say.
[[nodiscard]] std::string ensemble_text(const EnsembleReport& report, const TerminalStyle& style);

/// The same as Markdown.
[[nodiscard]] std::string ensemble_markdown(const EnsembleReport& report);

/// As `ensemble_schema_json` describes it, indented, with a line break at its end.
[[nodiscard]] std::string ensemble_json(const EnsembleReport& report);
[[nodiscard]] std::string ensemble_schema_json();

/// Each statistic of each setup: its median and spread.
[[nodiscard]] Table summary_table(const EnsembleReport& report);

/// Each statistic of each setup but the first, compared with it; empty without another. `brief` has
/// verdicts of few words, for a terminal.
[[nodiscard]] Table comparison_table(const EnsembleReport& report, bool brief = false);

/// The distribution functions of one statistic, those of all setups over each other, and, where
/// another has values too, next to them their quantiles over those of the first setup: where both
/// are alike, on the diagonal.
[[nodiscard]] std::string distribution_svg(const EnsembleReport& report, std::size_t statistic);

/// The numbers of that picture: 201 points of the distribution function of each setup.
[[nodiscard]] std::string distribution_csv(const EnsembleReport& report, std::size_t statistic);

}  // namespace tautline::bench
