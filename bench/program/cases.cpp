#include <fmt/format.h>

#include <CLI/CLI.hpp>
#include <memory>

#include "bench/base/table.hpp"
#include "bench/base/terminal.hpp"
#include "bench/cases/title.hpp"
#include "bench/program/commands.hpp"
#include "bench/program/common.hpp"
#include "bench/tools/reproduce/source.hpp"
#include "tautline/case_file.hpp"
#include "tautline/scenarios.hpp"

namespace tautline::bench {
namespace {

/// What `tautline cases` was asked: the list of what ships, or one of it as a case file.
struct CasesCommand {
  std::string the_case;
};

std::string case_list(const TerminalStyle& style) {
  Table table({"case", "inertia", "duration", "title"}, 1, 1);
  for (const Case& the_case : shipped_cases()) {
    table.add({the_case.name, fmt::format("{:.4g}", the_case.body.inertia),
               fmt::format("{:g}", the_case.duration), title_of(the_case)});
  }
  return table.plain(style);
}

/// The systems, a paragraph each: its name, and the first of the two sentences on it.
std::string system_list(const TerminalStyle& style) {
  std::string result = "systems\n";
  each_shipped_system(
      [&](const auto& one) { result += fmt::format("{}: {}\n", one.system.name, title_of(one)); });
  return wrapped_lines(result, style.text, 2);
}

/// The file of a shipped system, below comments on what it shows; "" for any other name.
std::string system_file(const std::string& name) {
  std::string result;
  each_shipped_system([&](const auto& one) {
    if (one.system.name == name) {
      const std::string title = title_of(one);
      result = fmt::format("# {}\n#{}\n{}", title, one.shows.substr(title.size()),
                           write_system(one.system));
    }
  });
  return result;
}

int cases_command(const CasesCommand& command) {
  if (command.the_case.empty()) {
    const TerminalStyle style = output_style();
    fmt::print("{}\n{}\n{}", case_list(style), wrapped_lines(case_number_text(), style.text),
               system_list(style));
    return exit_done;
  }
  if (const std::string file = system_file(command.the_case); !file.empty()) {
    fmt::print("{}", file);
    return exit_done;
  }
  const std::optional<Case> the_case = one_case(command.the_case);
  if (!the_case) {
    return exit_usage;
  }
  fmt::print("{}", write_case(*the_case));
  return exit_done;
}

}  // namespace

void add_cases(CLI::App& app, int& code) {
  CLI::App* const command =
      app.add_subcommand("cases", "The shipped cases and systems, or one as a file to start from");
  const auto asked = std::make_shared<CasesCommand>();
  command->add_option("CASE", asked->the_case, "the name of a shipped case or system");
  command->callback([asked, &code] { code = cases_command(*asked); });
}

}  // namespace tautline::bench
