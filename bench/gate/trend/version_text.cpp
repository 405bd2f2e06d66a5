#include "bench/gate/trend/version_text.hpp"

#include <fmt/format.h>

#include "bench/base/table.hpp"
#include "bench/gate/changes_text.hpp"
#include "bench/gate/trend/version_tables.hpp"

namespace tautline::bench {
namespace {

constexpr const char* how_to_read_moves =
    "Before and after are medians over the cases; worse and better are runs that changed beyond "
    "noise and tolerance.";
constexpr const char* how_to_read_costs =
    "Cost is processor time of a simulated second; it is noisy and judges nothing.";

std::string markdown_of(const Trend& trend) {
  std::string out;
  if (const Table table = moves_table(trend); !table.empty()) {
    out += fmt::format("### What moves\n\n{}\n{}\n\n", table.markdown(), how_to_read_moves);
  }
  out += markdown_text(latest_sentence(trend)) + "\n\n";
  for (const SetupTable& setup : setup_tables(trend, true)) {
    out += fmt::format("### {}\n\n{}\n", markdown_text(setup.title), setup.table.markdown());
  }
  return out + how_to_read_costs + "\n";
}

}  // namespace

std::string chart_name(const std::string& engine) { return "trend-" + engine + ".svg"; }

std::string version_text(const VersionTrend& versions, bool all, const TerminalStyle& style) {
  std::string out =
      wrapped(version_title(versions), style.text) + versions_table(versions).plain(style) + "\n";
  if (!versions.trend) {
    return out;
  }
  const Trend& trend = *versions.trend;
  if (const Table table = moves_table(trend); !table.empty()) {
    out += table.plain(style) + wrapped(how_to_read_moves, style.text) + "\n";
  }
  const std::vector<SetupTable> setups = setup_tables(trend, all);
  for (const SetupTable& setup : setups) {
    out += fmt::format("{}\n{}\n", setup.title, setup.table.plain(style));
  }
  out += setups.empty() ? "" : wrapped(how_to_read_costs, style.text) + "\n";
  return out + missing_text(trend.latest, style) + wrapped(latest_sentence(trend), style.text);
}

std::string version_markdown(const std::vector<VersionTrend>& trends) {
  std::string out = "# Accuracy and cost over versions\n";
  for (const VersionTrend& versions : trends) {
    out += fmt::format("\n## {}\n\n{}\n", markdown_text(version_title(versions)),
                       versions_table(versions).markdown());
    if (versions.trend) {
      out += fmt::format("![Error and cost of {0} over its versions]({1})\n\n{2}", versions.engine,
                         chart_name(versions.engine), markdown_of(*versions.trend));
    }
  }
  return out;
}

}  // namespace tautline::bench
