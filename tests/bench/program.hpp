#pragma once

#include <filesystem>
#include <string>
#include <vector>

namespace tautline::test {

/// What the program did.
struct Outcome {
  int code = -1;       // exit code; 128 + signal if one ended it
  std::string output;  // standard output
  std::string errors;  // standard error
};

/// A new empty folder, removed with everything in it at the end.
class TemporaryFolder {
 public:
  TemporaryFolder();
  ~TemporaryFolder();
  TemporaryFolder(const TemporaryFolder&) = delete;
  TemporaryFolder& operator=(const TemporaryFolder&) = delete;
  [[nodiscard]] const std::filesystem::path& path() const { return path_; }

 private:
  std::filesystem::path path_;
};

/// Runs `tautline` with these arguments. `shell` goes before it on the command line: "ulimit -f
/// 8;".
[[nodiscard]] Outcome program(const std::vector<std::string>& arguments,
                              const std::string& shell = "");

/// The same in the background; its process id. Its output is thrown away.
[[nodiscard]] int start_program(const std::vector<std::string>& arguments);

/// Waits for a started program; its exit code, or 128 + signal.
int wait_for(int process);

/// The content of a file, or "" without one.
[[nodiscard]] std::string content_of_file(const std::filesystem::path& path);

/// The path of a plug-in made to go wrong: tests/bench/fixtures.
[[nodiscard]] std::string bad_engine(const std::string& way);

}  // namespace tautline::test
