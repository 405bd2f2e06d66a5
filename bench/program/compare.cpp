#include <fmt/format.h>

#include <CLI/CLI.hpp>
#include <cstddef>
#include <memory>
#include <utility>

#include "bench/base/terminal.hpp"
#include "bench/base/text.hpp"
#include "bench/gate/changes.hpp"
#include "bench/gate/changes_output.hpp"
#include "bench/gate/noise.hpp"
#include "bench/gate/trend.hpp"
#include "bench/program/commands.hpp"
#include "bench/program/common.hpp"
#include "bench/report/json/json.hpp"

namespace tautline::bench {
namespace {

/// What `tautline compare` was asked.
struct CompareCommand {
  std::vector<std::string> reports;  // report.json of two benches or more
  double tolerance = Noise().tolerance;
  bool all = false;  // rows of a trend, not only those that move
  std::string json;
};

/// Why `changes` say nothing: reports without a run in common, as those of two engines.
std::vector<std::string> nothing_compared(const Changes& changes) {
  if (changes.compared != 0) {
    return {};
  }
  return {changes.other_case.empty()
              ? "no run is in both reports: there is nothing to compare"
              : "no run is in both reports: those of the same name are of cases that have changed"};
}

/// The reports, or everything that is wrong with them.
struct Reading {
  std::vector<Report> reports;
  std::vector<std::string> problems;
};

Reading read_all(const std::vector<std::string>& files) {
  Reading result;
  for (const std::string& file : files) {
    ReportReading reading = read_report(file);
    append(result.problems, reading.problems);
    if (reading.report) {
      result.reports.push_back(std::move(*reading.report));
    }
  }
  for (std::size_t index = 1; result.problems.empty() && index < result.reports.size(); ++index) {
    result.problems = incomparable(result.reports[index - 1], result.reports[index]);
  }
  return result;
}

std::vector<std::string> usage_problems(const CompareCommand& command) {
  std::vector<std::string> broken = missing_folder("--json", command.json);
  if (command.reports.size() < 2) {
    broken.push_back(fmt::format("compare: {} is one report; give two or more, the older first",
                                 printable(command.reports.front(), 1024)));
  }
  if (!(command.tolerance >= 0.0 && command.tolerance < 1.0)) {
    broken.push_back(fmt::format("--tolerance {}: must be at least 0 and below 1, as 0.05 for 5 %",
                                 command.tolerance));
  }
  return broken;
}

/// Prints `text` and writes `json` as the command asks.
int give(const CompareCommand& command, const std::string& text, const std::string& json,
         bool worse) {
  if (command.json != "-") {
    fmt::print("{}", text);
  }
  if (!command.json.empty()) {
    write_output(command.json, json);
  }
  return worse ? exit_failed : exit_done;
}

int compare_command(const CompareCommand& command) {
  if (complain(usage_problems(command))) {
    return exit_usage;
  }
  const Reading read = read_all(command.reports);
  if (complain(read.problems)) {
    return exit_usage;
  }
  Noise noise;
  noise.tolerance = command.tolerance;
  if (read.reports.size() > 2) {
    const Trend found = trend(read.reports, command.reports, noise);
    return give(command, trend_text(found, command.all, output_style()), trend_json(found),
                found.latest.worse());
  }
  const Changes found = changes(read.reports.front(), read.reports.back(), noise);
  if (complain(nothing_compared(found))) {
    return exit_usage;
  }
  return give(command, changes_text(found, output_style()), changes_json(found), found.worse());
}

}  // namespace

void add_compare(CLI::App& app, int& code) {
  CLI::App* const command = app.add_subcommand(
      "compare", "What changed from one report to another, or a trend over several");
  const auto asked = std::make_shared<CompareCommand>();
  command
      ->add_option("REPORTS", asked->reports,
                   "report.json of two `tautline bench`, the older first; or of more, for a trend "
                   "by version of the engines")
      ->required()
      ->expected(1, CLI::detail::expected_max_vector_size);
  command
      ->add_option("--tolerance", asked->tolerance,
                   "ignore relative changes up to this size, in addition to noise")
      ->capture_default_str();
  command->add_flag("--all", asked->all, "print all rows of a trend, not only those that move");
  add_target(*command, "--json", asked->json, "write the changes or the trend as JSON");
  add_schema(*command, compare_schema_json);
  command->footer(
      "tautline compare before.json after.json\n"
      "tautline compare 3.23.json 3.24.json 3.25.json --all");
  command->callback([asked, &code] { code = compare_command(*asked); });
}

}  // namespace tautline::bench
