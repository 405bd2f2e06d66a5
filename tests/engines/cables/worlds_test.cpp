// A slice of the random worlds in every run of the tests; `cable_<engine>_worlds` runs them all.

#include <gtest/gtest.h>

#include <ostream>
#include <string>

#include "engines/cables/worlds/random_world.hpp"
#include "engines/cables/worlds/run.hpp"

namespace tautline::test {
namespace {

#ifdef TAUTLINE_SANITIZED
constexpr double part = 0.1;  // of the time
#else
constexpr double part = 1.0;
#endif

/// The kinds of worlds take turns: ten have one of each.
struct Slice {
  std::string name;
  Playing playing;
  int worlds;
  double seconds;  // of each
};
void PrintTo(const Slice& slice, std::ostream* out) { *out << slice.name; }

class CableWorlds : public testing::TestWithParam<Slice> {
 protected:
  /// Calls `check` with the findings of each world.
  template <typename Check>
  void for_each_world(const Check& check) const {
    for (int number = 1; number <= GetParam().worlds; ++number) {
      const auto seed = static_cast<std::uint64_t>(number);
      const World world = random_world(seed);
      const Claims allowed = claims(GetParam().playing.stepping, !world.hooks.empty());
      const Findings found = findings_of(world, GetParam().playing, part * GetParam().seconds);
      const testing::ScopedTrace trace(__FILE__, __LINE__,
                                       "seed " + std::to_string(seed) + ", " + world.kind);
      EXPECT_FALSE(broken(found, allowed).number);
      check(found, allowed);
    }
  }
};

TEST_P(CableWorlds, NeverStretchBeyondAStepsWay) {
  for_each_world([](const Findings& found, const Claims& claims) {
    EXPECT_LE(found.beyond.value, claims.way_allowance)
        << "cable " << found.beyond.cable << " at " << found.beyond.time << " s";
  });
}

TEST_P(CableWorlds, NeverGainEnergy) {
  for_each_world([](const Findings& found, const Claims& claims) {
    EXPECT_LE(found.gain_part(), claims.gain_part)
        << found.gain.value << " J at " << found.gain.time << " s";
  });
}

TEST_P(CableWorlds, ReboundAsTheirCablesSay) {
  int impacts = 0;
  for_each_world([&impacts](const Findings& found, const Claims& claims) {
    EXPECT_LE(found.restitution.value, claims.restitution)
        << "cable " << found.restitution.cable << " at " << found.restitution.time << " s";
    impacts += found.impacts;
  });
  EXPECT_GT(impacts, 0);
}

INSTANTIATE_TEST_SUITE_P(Stepped, CableWorlds,
                         testing::Values(Slice{"Fixed60", {60.0, Stepping::fixed}, 40, 20.0},
                                         Slice{"Fixed240", {240.0, Stepping::fixed}, 10, 20.0},
                                         Slice{
                                             "ByEvents60", {60.0, Stepping::by_events}, 10, 10.0}),
                         [](const auto& instance) { return instance.param.name; });

}  // namespace
}  // namespace tautline::test
