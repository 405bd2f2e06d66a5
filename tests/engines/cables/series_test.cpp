// The cases in which cables once lost their loads: loads in series, chains, and high mass ratios.

#include <gtest/gtest.h>

#include <algorithm>

#include "engines/cables/measure.hpp"
#include "engines/cables/worlds/cases.hpp"

namespace tautline::test {
namespace {

#ifdef TAUTLINE_SANITIZED
constexpr double seconds = 15.0;
#else
constexpr double seconds = 60.0;
#endif

class CableCases : public testing::TestWithParam<Stepping> {
 protected:
  /// Of the cases whose name begins with `name`, the first `starts`.
  void expect_kept(const std::string& name, int starts) const {
    const Playing playing{60.0, GetParam()};
    int done = 0;
    for (const Case& the_case : cases()) {
      if (the_case.name.rfind(name, 0) != 0 || done == starts) {
        continue;
      }
      ++done;
      const testing::ScopedTrace trace(
          __FILE__, __LINE__, the_case.name + ", start " + std::to_string(the_case.world.seed));
      expect_kept(the_case, findings_of(the_case, playing, seconds));
    }
    EXPECT_GT(done, 0) << name;
  }

 private:
  static void expect_kept(const Case& the_case, const CaseFindings& found) {
    const Claims allowed = claims(GetParam(), !the_case.world.hooks.empty());
    EXPECT_FALSE(broken(found.findings, allowed).number);
    EXPECT_LE(found.findings.beyond.value, allowed.way_allowance);
    EXPECT_LE(found.findings.gain_part(), allowed.gain_part);
    EXPECT_LE(found.findings.restitution.value, allowed.restitution);
    if (the_case.rests) {
      EXPECT_LE(found.off, allowed_off);
      EXPECT_LE(found.tension_error, allowed_tension_error);
    }
  }
};

TEST_P(CableCases, TwoBallsInSeriesHangAndSettle) { expect_kept("two balls", 2); }

TEST_P(CableCases, ACirclingBallIsHeld) { expect_kept("ball circling", 1); }

TEST_P(CableCases, AThrownBoxIsHeldAtItsCorner) { expect_kept("box at a corner", 6); }

TEST_P(CableCases, AThrownBoxIsHeldByTwoCablesAndByFour) {
  expect_kept("box on two", 4);
  expect_kept("box on four", 4);
}

TEST_P(CableCases, AChainOfTenHangsAndSettles) { expect_kept("chain of 10", 3); }

TEST_P(CableCases, AMovingPlatformIsHeld) { expect_kept("moving platform", 1); }

TEST_P(CableCases, MassRatiosInSeriesHangAndSettle) {
  expect_kept("1:100 ", 8);
  expect_kept("1:1000 ", 8);
}

INSTANTIATE_TEST_SUITE_P(Stepped, CableCases, testing::Values(Stepping::fixed, Stepping::by_events),
                         [](const auto& instance) {
                           return instance.param == Stepping::fixed ? "Fixed" : "ByEvents";
                         });

/// The work of hooks is counted on that line, and impacts are looked at on it. (Bullet has a hook
/// at its new place while it solves: cables have to take it back.)
TEST(MovingHook, PullsOnTheLineThatThereIsWhenTheStepBegins) {
  World world;
  world.loads.push_back({2.0, 0.1, Vec3(0, 4, 0), Vec3::Zero(), Vec3::Zero(), false});
  world.hooks.push_back({Vec3(0, 6, 0), Vec3(0.5, 0, 0), 2.0, 0.0});
  tie(world, {0, Vec3::Zero()}, {1, Vec3::Zero()}, 0.0, 0.0);
  const auto scene = play(world, 60.0);
  int pulls = 0;
  for (int step = 1; step <= 120; ++step) {
    const auto before = bodies_of(*scene, 2);
    move_hooks(*scene, world, step * scene->dt());
    scene->step();
    const auto after = bodies_of(*scene, 2);
    const Vec3 gained =
        after[0].velocity - before[0].velocity + world_gravity * scene->dt() * Vec3::UnitY();
    const Vec3 pull = scene->impulse(0) * line_of(world.cables[0], before).towards;
    // in coordinates of 6 m, on a line of 2 m
    EXPECT_LE((2.0 * gained - pull).norm(), 100.0 * Scene::rounding) << "step " << step;
    pulls += scene->impulse(0) > 0.0 ? 1 : 0;
  }
  EXPECT_GT(pulls, 60);
}

}  // namespace
}  // namespace tautline::test
