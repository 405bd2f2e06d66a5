#include <fmt/format.h>

#include "bench/commands.hpp"
#include "bench/reports_compared.hpp"
#include "bench/text.hpp"

namespace tautline::bench {

int compare_command(const CompareCommand& command) {
  ReportReading before = read_report(command.before);
  ReportReading after = read_report(command.after);
  std::vector<std::string> problems = before.problems;
  problems.insert(problems.end(), after.problems.begin(), after.problems.end());
  nlohmann::ordered_json changes;
  if (problems.empty()) {
    try {
      problems = incomparable(*before.report, *after.report);
      changes = problems.empty() ? compared_reports(*before.report, *after.report) : changes;
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

}  // namespace tautline::bench
