#pragma once

#include <chrono>
#include <cstdlib>
#include <filesystem>
#include <string>
#include <vector>

#include "tests/bench/program.hpp"

namespace tautline::test {

/// Where the children of tests/bench/fixtures/protocol lie.
inline const std::filesystem::path children_folder = TAUTLINE_CHILDREN;

/// True where the children, which are written in Python, can run.
[[nodiscard]] inline bool has_python() {
  static const bool found = std::system("command -v python3 >/dev/null") == 0;  // NOLINT
  return found;
}
inline constexpr const char* no_python = "python3 is not on PATH";

/// The text of an engine.toml.
[[nodiscard]] std::string engine_toml(const std::string& name,
                                      const std::vector<std::string>& command,
                                      const std::string& more = "");

/// Writes the engine.toml of the child that goes wrong in this way into a folder of `folder`, and
/// returns its path.
[[nodiscard]] std::string bad_child(const TemporaryFolder& folder, const std::string& way);

/// The same for the child that is sound.
[[nodiscard]] std::string sound_child(const TemporaryFolder& folder);

/// The same for the child that runs systems in space: it is sound, or goes wrong in this way.
[[nodiscard]] std::string space_child(const TemporaryFolder& folder, const std::string& way);

/// The processes whose environment has TAUTLINE_MARK=`mark`.
[[nodiscard]] std::vector<int> marked_processes(const std::string& mark);

/// The same, once none is left or some seconds are over: a killed process takes a moment to go.
[[nodiscard]] std::vector<int> left_of(const std::string& mark);

}  // namespace tautline::test
