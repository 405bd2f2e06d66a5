#include <fmt/format.h>

#include <CLI/CLI.hpp>
#include <memory>

#include "bench/base/text.hpp"
#include "bench/gate/changes.hpp"
#include "bench/program/commands.hpp"
#include "bench/program/common.hpp"

namespace tautline::bench {
namespace {

/// What `tautline compare` was asked.
struct CompareCommand {
  std::string before;  // report.json
  std::string after;
  std::string json;
};

using nlohmann::ordered_json;

/// Why `changes` say nothing: reports without a run in common, as those of two engines.
std::vector<std::string> nothing_compared(const ordered_json& changes) {
  if (changes.at("compared") != 0) {
    return {};
  }
  return {changes.at("other_case").empty()
              ? "no run is in both reports: there is nothing to compare"
              : "no run is in both reports: those of the same name are of cases that have changed"};
}

int compare_command(const CompareCommand& command) {
  ReportReading before = read_report(command.before);
  ReportReading after = read_report(command.after);
  std::vector<std::string> problems = before.problems;
  problems.insert(problems.end(), after.problems.begin(), after.problems.end());
  ordered_json changes;
  if (problems.empty()) {
    try {
      problems = incomparable(*before.report, *after.report);
      if (problems.empty()) {
        changes = compared_reports(*before.report, *after.report);
        problems = nothing_compared(changes);
      }
    } catch (const nlohmann::json::exception& error) {  // a row that no bench has written
      problems.push_back("one of the files is not a whole report of `tautline bench`: " +
                         printable(error.what()));
    }
  }
  if (!problems.empty()) {
    complain(problems);
    return exit_usage;
  }
  if (command.json != "-") {
    fmt::print("{}", comparison_text(changes));
  }
  if (!command.json.empty()) {
    write_output(command.json, changes.dump(2) + "\n");
  }
  return changes.at("worse").get<bool>() ? exit_failed : exit_done;
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
