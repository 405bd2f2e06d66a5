#include <CLI/CLI.hpp>
#include <cerrno>
#include <csignal>
#include <cstdio>
#include <cstring>
#include <exception>
#include <string>
#include <system_error>

#include "bench/program/commands.hpp"
#include "bench/program/common.hpp"
#include "bench/run/worker_process.hpp"

namespace {

using namespace tautline::bench;

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

int run_program(int count, char** arguments) {
  CLI::App app{
      "The exact motion of rigid bodies on slack cables, and a bench that compares physics engines "
      "with it"};
  app.require_subcommand(1);
  app.set_version_flag("--version", "tautline " TAUTLINE_VERSION);
  int code = exit_done;
  add_solve(app, code);
  add_run(app, code);
  add_bench(app, code, typed(count, arguments));
  add_merge(app, code, typed(count, arguments));
  add_compare(app, code);
  add_check(app, code);
  add_reproduce(app, code);
  add_engines(app, code);
  add_cases(app, code);
  try {
    app.parse(count, arguments);
  } catch (const CLI::ParseError& error) {
    const int cli_code = app.exit(error);
    return cli_code == 0 ? exit_done : exit_usage;
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
