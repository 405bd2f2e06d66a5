#include <fmt/format.h>

#include <CLI/CLI.hpp>
#include <cerrno>
#include <csignal>
#include <cstdio>
#include <cstring>
#include <exception>
#include <string>
#include <system_error>

#include "bench/base/terminal.hpp"
#include "bench/program/commands.hpp"
#include "bench/program/common.hpp"
#include "bench/program/manual.hpp"
#include "bench/run/wire.hpp"

namespace {

using namespace tautline::bench;

constexpr const char* first_steps =
    "tautline solve bouncing-ball           an exact motion, solved now";

/// A word in single quotes, for a shell.
std::string quoted(const std::string& word) {
  std::string result = "'";
  for (const char letter : word) {
    result += letter == '\'' ? std::string("'\\''") : std::string(1, letter);
  }
  return result + "'";
}

/// The command line as it was typed, quoted where a shell would need it.
std::string typed(int count, char** arguments) {
  std::string result;
  for (int index = 0; index < count; ++index) {
    const std::string word = arguments[index];
    const bool plain = word.find_first_not_of(
                           "abcdefghijklmnopqrstuvwxyzABCDEFGHIJKLMNOPQRSTUVWXYZ0123456789"
                           "-_./,:=+@%") == std::string::npos;
    result += (index == 0 ? "" : " ") + (plain && !word.empty() ? word : quoted(word));
  }
  return result;
}

/// Help as this program writes it, instead of the parser's own.
std::string help_of(const CLI::App* app, const std::string& /*name*/, CLI::AppFormatMode /*mode*/) {
  const std::size_t width = output_style().text;
  return app->get_parent() == nullptr ? help_text(outline_of(*app), width)
                                      : help_text(command_of(*app), width);
}

void add_commands(CLI::App& app, int& code, const std::string& command_line) {
  add_solve(app, code);
  add_vector(app, code);
  add_run(app, code);
  add_bench(app, code, command_line);
  add_merge(app, code, command_line);
  add_compare(app, code);
  add_trend(app, code, command_line);
  add_ensemble(app, code);
  add_bridge(app, code);
  add_check(app, code);
  add_calibrate(app, code);
  add_reproduce(app, code);
  add_engines(app, code);
  add_cases(app, code);
  add_schema_command(app);
  add_help(app, code);
}

int run_program(int count, char** arguments) {
  CLI::App app{"The exact motion of rigid bodies on slack cables, and engines compared with it"};
  app.formatter_fn(help_of);  // before the commands, which take it over
  app.require_subcommand(0, 1);
  app.set_help_flag("-h,--help", "print this help, and end");
  app.set_version_flag("--version", "tautline " TAUTLINE_VERSION, "print the version, and end");
  int code = exit_done;
  add_commands(app, code, typed(count, arguments));
  app.footer(first_steps);  // after the commands, which would take it over
  if (count > 1 && std::string(arguments[1]) == "--complete") {  // a shell asks, not its user
    fmt::print("{}", completions(outline_of(app), {arguments + 2, arguments + count}));
    return exit_done;
  }
  try {
    app.parse(count, arguments);
  } catch (const CLI::ParseError& error) {
    if (error.get_exit_code() == 0) {  // --help and the like
      return app.exit(error);
    }
    complain({mistake(app, error)});
    return exit_usage;
  }
  if (app.get_subcommands().empty()) {  // asked for nothing: what there is to ask for
    fmt::print("{}", app.help());
  }
  return code;
}

}  // namespace

int main(int count, char** arguments) {
  if (count == 2 && std::string(arguments[1]) == worker_command) {
    return worker_main();
  }
  std::signal(SIGPIPE, SIG_IGN);
  std::signal(SIGXFSZ, SIG_IGN);  // a file that may not grow is a failed write, not the end
  try {
    const int code = run_program(count, arguments);
    if (std::fflush(stdout) != 0 || std::ferror(stdout) != 0) {
      complain({std::string("cannot write to standard output: ") + std::strerror(errno)});
      return exit_failed;
    }
    return code;
  } catch (const std::system_error& error) {  // fmt's, which does not tell what it wrote to
    const bool of_output = std::ferror(stdout) != 0;
    complain({of_output ? "cannot write to standard output: " + error.code().message()
                        : std::string(error.what())});
    return exit_failed;
  } catch (const std::exception& error) {
    complain({error.what()});
    return exit_failed;
  }
}
