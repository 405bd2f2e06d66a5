// What a cable costs in a step, beside the engine's own ball joint in the same place: instructions,
// which callgrind counts.

#include <gtest/gtest.h>

#include <cstdio>
#include <string>

#include "callgrind.hpp"
#include "engines/cables/scene.hpp"

namespace tautline::test {
namespace {

double allowed_ratio() { return Scene::engine == "ode" ? 1.3 : 1.0; }

/// Instructions of a step with what `holds` the loads; -1 without callgrind.
double cost(const std::string& holds, const std::string& motion) {
  const Counted made = counted(TAUTLINE_TAKE_STEPS, holds + " " + motion + " made", " steps");
  const Counted all = counted(TAUTLINE_TAKE_STEPS, holds + " " + motion, " steps");
  if (made.instructions < 0.0 || all.things <= 0.0) {
    return -1.0;
  }
  return (all.instructions - made.instructions) / all.things;
}

class Overhead : public ::testing::TestWithParam<const char*> {};

TEST_P(Overhead, OfACableIsAllowed) {
  const double joints = cost("joint", GetParam());
  if (joints < 0.0) {
    GTEST_SKIP() << "valgrind is not here, or does not know this processor";
  }
  const double cables = cost("cable", GetParam());
  std::printf("%s: a step with cables takes %.0f instructions, %.3f of one with ball joints\n",
              Scene::engine.c_str(), cables, cables / joints);
  EXPECT_GT(cables, 0.0);
  EXPECT_LE(cables / joints, allowed_ratio());
}

INSTANTIATE_TEST_SUITE_P(Many, Overhead, ::testing::Values("taut", "bouncing"),
                         [](const auto& test) { return std::string(test.param); });

}  // namespace
}  // namespace tautline::test
