#include "bench/gate/trend/version_output.hpp"

#include <fmt/format.h>

#include "bench/base/table.hpp"
#include "bench/gate/changes_output.hpp"
#include "bench/gate/trend/version_tables.hpp"

namespace tautline::bench {
namespace {

std::string markdown_of(const std::vector<TitledTable>& tables, const char* how_to_read) {
  std::string out;
  for (const TitledTable& one : tables) {
    out += fmt::format("### {}\n\n{}\n", markdown_text(one.title), one.table.markdown());
  }
  return tables.empty() ? "" : out + how_to_read + "\n\n";
}

std::string text_of(const std::vector<TitledTable>& tables, const char* how_to_read,
                    const TerminalStyle& style) {
  std::string out;
  for (const TitledTable& one : tables) {
    out += fmt::format("{}:\n{}\n", one.title, one.table.plain(style));
  }
  return tables.empty() ? "" : out + wrapped(how_to_read, style.text) + "\n";
}

}  // namespace

std::string chart_name(const std::string& engine) { return "trend-" + engine + ".svg"; }

std::string version_text(const VersionTrend& versions, bool all, const TerminalStyle& style) {
  std::string out =
      wrapped(version_title(versions), style.text) + versions_table(versions).plain(style) + "\n";
  if (const std::optional<Trend>& trend = versions.trend) {
    out += text_of(change_tables(*trend), how_to_read_changes, style);
    out += all ? text_of(setup_tables(*trend), how_to_read_setups, style) : "";
    out += missing_text(trend->latest, style);
  }
  return out + wrapped(newest_sentence(versions), style.text);
}

std::string version_markdown(const std::vector<VersionTrend>& trends) {
  std::string out = "# Accuracy and cost over versions\n";
  for (const VersionTrend& versions : trends) {
    out +=
        fmt::format("\n## {}\n\n{}\n\n{}\n", markdown_text(version_title(versions)),
                    markdown_text(newest_sentence(versions)), versions_table(versions).markdown());
    if (versions.trend) {
      out += markdown_of(change_tables(*versions.trend), how_to_read_changes);
      out += fmt::format("![Error and cost of {0} over its versions]({1})\n\n", versions.engine,
                         chart_name(versions.engine));
      out += markdown_of(setup_tables(*versions.trend), how_to_read_setups);
    }
  }
  return out;
}

}  // namespace tautline::bench
