#include <fmt/format.h>

#include <CLI/CLI.hpp>
#include <memory>

#include "bench/gate/changes.hpp"
#include "bench/gate/changes_json.hpp"
#include "bench/gate/changes_text.hpp"
#include "bench/program/commands.hpp"
#include "bench/program/common.hpp"
#include "bench/report/reading.hpp"

namespace tautline::bench {
namespace {

/// What `tautline compare` was asked.
struct CompareCommand {
  std::string before;  // report.json
  std::string after;
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

int compare_command(const CompareCommand& command) {
  const ReportReading before = read_report(command.before);
  const ReportReading after = read_report(command.after);
  std::vector<std::string> problems = before.problems;
  problems.insert(problems.end(), after.problems.begin(), after.problems.end());
  if (problems.empty()) {
    problems = incomparable(*before.report, *after.report);
  }
  Changes found;
  if (problems.empty()) {
    found = changes(*before.report, *after.report);
    problems = nothing_compared(found);
  }
  if (!problems.empty()) {
    complain(problems);
    return exit_usage;
  }
  if (command.json != "-") {
    fmt::print("{}", changes_text(found));
  }
  if (!command.json.empty()) {
    write_output(command.json, changes_json(found));
  }
  return found.worse() ? exit_failed : exit_done;
}

}  // namespace

void add_compare(CLI::App& app, int& code) {
  CLI::App* const command =
      app.add_subcommand("compare", "What changed from one report to another beyond noise");
  const auto asked = std::make_shared<CompareCommand>();
  command->add_option("BEFORE", asked->before, "the report.json of one `tautline bench`")
      ->required();
  command->add_option("AFTER", asked->after, "the report.json of the other")->required();
  command->add_option("--json", asked->json,
                      "write the changes as JSON to this file, or to stdout: -");
  command->callback([asked, &code] { code = compare_command(*asked); });
}

}  // namespace tautline::bench
