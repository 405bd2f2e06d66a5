#include "bench/gate/trend/version_output.hpp"

#include <fmt/format.h>

#include <string_view>

#include "bench/base/html.hpp"
#include "bench/gate/changes_output.hpp"
#include "bench/gate/trend/version_tables.hpp"
#include "bench/page/document.hpp"
#include "bench/report/words.hpp"

namespace tautline::bench {
namespace {

constexpr std::string_view page_title = "Accuracy and cost over versions";

/// Tables whose names begin with `id`, and how to read them.
std::string tables_html(const std::vector<TitledTable>& tables, const std::string& id,
                        std::string_view how_to_read) {
  std::string out;
  for (std::size_t index = 0; index < tables.size(); ++index) {
    out += html_table(tables[index].table, fmt::format("{}-{}", id, index), tables[index].title);
  }
  return tables.empty() ? "" : fmt::format("{}<p class=\"note\">{}</p>\n", out, how_to_read);
}

/// The chart in a box that scrolls: its words stay legible on a narrow page.
std::string chart_html(const VersionTrend& versions) {
  return fmt::format(
      "<figure style=\"overflow-x:auto\" tabindex=\"0\" role=\"region\" aria-label=\"Error and "
      "cost of "
      "{} over its versions\">\n{}</figure>\n",
      html_text(versions.engine), version_svg(versions));
}

std::string section(const VersionTrend& versions) {
  const std::string id = html_text(versions.engine);
  std::string out = fmt::format("<section id=\"{}\">\n<h2>{}</h2>\n<p class=\"answer\">{}</p>\n",
                                id, html_text(version_title(versions)),
                                html_text(newest_sentence(versions), longest_sentence)) +
                    html_table(versions_table(versions), id + "-versions",
                               "Worse and better are changes since the version before.");
  if (const std::optional<Trend>& trend = versions.trend) {
    out += tables_html(change_tables(*trend), id + "-changes", how_to_read_changes);
    out += chart_html(versions);
    out += "<details class=\"fold\"><summary>Every model and step</summary>\n" +
           tables_html(setup_tables(*trend), id + "-setups", how_to_read_setups) + "</details>\n";
  }
  return out + "</section>\n";
}

}  // namespace

std::string version_html(const std::vector<VersionTrend>& trends, const PageAssets& assets) {
  std::string out = fmt::format("<header>\n<h1>{}</h1>\n</header>\n<main>\n", page_title);
  for (const VersionTrend& versions : trends) {
    out += section(versions);
  }
  PageAssets style_alone;
  style_alone.style = assets.style;
  return html_document({.title = page_title,
                        .content = out + "</main>\n",
                        .command = "tautline trend",
                        .data_id = "trend-data",
                        .data = html_json(version_trends_json(trends)),
                        .scripts = ""},
                       style_alone);
}

}  // namespace tautline::bench
