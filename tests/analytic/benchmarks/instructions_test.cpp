#include <gtest/gtest.h>

#include <array>
#include <cstdio>
#include <cstdlib>
#include <string>

// The cost of the solver in instructions, which callgrind counts: the same at any load, and nearly
// so for one compiler and mathematical library.

namespace tautline {
namespace {

/// [instructions per impact], with all that comes between two: the shipped cases swing on taut
/// cables for most of their time. 12,060 when it was set, with Eigen's assertions; compilers differ
/// by a tenth.
constexpr double most_per_impact = 13'900.0;

/// [instructions per impact], what the bounds of a solution take besides: 10,970 when it was set.
constexpr double most_of_bounds = 12'600.0;

/// What `solve_shipped` prints and callgrind counts; -1 where it does not run.
struct Cost {
  double instructions = -1.0;
  double impacts = -1.0;
};

Cost cost(const std::string& what) {
  const std::string command =
      "valgrind --tool=callgrind --callgrind-out-file=/dev/null '" TAUTLINE_SOLVE_SHIPPED "' " +
      what + " 2>&1";
  Cost result;
  FILE* const output = popen(command.c_str(), "r");  // NOLINT(cert-env33-c): nobody's input
  if (output == nullptr) {
    return result;
  }
  std::array<char, 512> line{};
  while (std::fgets(line.data(), line.size(), output) != nullptr) {
    const std::string text = line.data();
    if (const auto at = text.find("Collected : "); at != std::string::npos) {
      result.instructions = std::strtod(text.c_str() + at + 12, nullptr);
    } else if (text.find(" impacts") != std::string::npos) {
      result.impacts = std::strtod(text.c_str(), nullptr);
    }
  }
  pclose(output);
  return result;
}

TEST(Counts, ASolutionAndItsBoundsTakeTheirInstructions) {
  const Cost load = cost("load");
  if (load.instructions < 0.0) {
    GTEST_SKIP() << "valgrind is not here, or does not know this processor";
  }
  const Cost plain = cost("plain");
  const Cost bounds = cost("bounds");
  ASSERT_GT(plain.impacts, 0.0);
  ASSERT_GT(plain.instructions, load.instructions);
  const double solving = plain.instructions - load.instructions;
  const double bounding = bounds.instructions - plain.instructions;
  std::printf("%.0f instructions per impact, %.0f more with bounds\n", solving / plain.impacts,
              bounding / plain.impacts);
  EXPECT_LE(solving / plain.impacts, most_per_impact);
  EXPECT_GT(bounding, 0.0);
  EXPECT_LE(bounding / plain.impacts, most_of_bounds);
}

}  // namespace
}  // namespace tautline
