#pragma once

#include <set>
#include <string>
#include <vector>

#include "tests/bench/support.hpp"

namespace tautline::test {

/// What the program did.
struct Outcome {
  int code = -1;       // exit code; 128 + signal if one ended it
  std::string output;  // standard output
  std::string errors;  // standard error
};

using bench::test::content_of;
using bench::test::file_as_json;
using bench::test::TemporaryFolder;

/// Runs `tautline` with these arguments. `shell` goes before it on the command line: "ulimit -f
/// 8;".
[[nodiscard]] Outcome program(const std::vector<std::string>& arguments,
                              const std::string& shell = "");

/// The same in the background; its process id. Its output is thrown away.
[[nodiscard]] int start_program(const std::vector<std::string>& arguments);

/// Waits for a started program; its exit code, or 128 + signal.
int wait_for(int process);

/// The names of the engines that are built.
[[nodiscard]] std::set<std::string> built_engines();

/// The path of a plug-in made to go wrong: tests/bench/fixtures.
[[nodiscard]] std::string bad_engine(const std::string& way);

}  // namespace tautline::test
