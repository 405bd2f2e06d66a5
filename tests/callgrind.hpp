#pragma once

#include <array>
#include <cstdio>
#include <cstdlib>
#include <string>

namespace tautline::test {

/// What a program did, and what it took: the same at any load, and nearly so for one compiler and
/// mathematical library.
struct Counted {
  double instructions = -1.0;  // -1: callgrind does not run
  double things = -1.0;        // that the program says it did
};

/// Runs `program` with the argument `what` in callgrind; it prints a number before `word`.
inline Counted counted(const std::string& program, const std::string& what,
                       const std::string& word) {
  const std::string command = "valgrind --tool=callgrind --callgrind-out-file=/dev/null '" +
                              program + "' " + what + " 2>&1";
  Counted result;
  FILE* const output = popen(command.c_str(), "r");  // NOLINT(cert-env33-c): nobody's input
  if (output == nullptr) {
    return result;
  }
  std::array<char, 512> line{};
  while (std::fgets(line.data(), line.size(), output) != nullptr) {
    const std::string text = line.data();
    if (const auto at = text.find("Collected : "); at != std::string::npos) {
      result.instructions = std::strtod(text.c_str() + at + 12, nullptr);
    } else if (text.find(word) != std::string::npos) {
      result.things = std::strtod(text.c_str(), nullptr);
    }
  }
  pclose(output);
  return result;
}

}  // namespace tautline::test
