#include <gtest/gtest.h>

#include <cmath>

#include "support.hpp"
#include "system/systems.hpp"
#include "tautline/solve.hpp"
#include "tautline/system_geometry.hpp"

// Motions that cannot go on, and motions that only look so.

namespace tautline::test {
namespace {

using SystemSolution = BasicSolution<System>;

/// A point between a cable to the left and one to the right, both taut.
System stretched() {
  System system;
  system.bodies.resize(1);
  system.gravity = Function<2>::constant(Vec2(0.0, 0.0));
  system.cables = {to_world<double>(0, {0.0, 0.0}, {-1.0, 0.0}, 1.0, 0.5),
                   to_world<double>(0, {0.0, 0.0}, {1.0, 0.0}, 1.0, 0.5)};
  system.initial.bodies = {{{0.0, 0.0}, 0.0, {0.0, 0.0}, 0.0}};
  system.duration = 3.0;
  return system;
}

TEST(SystemEndings, AWinchThatPullsABodyThatCannotMoveIsSingular) {
  System system = stretched();
  system.cables[0].length =
      Function<1>::linear({1.0, 2.0}, {Function<1>::Value(1.0), Function<1>::Value(0.5)});
  const SystemSolution solution = solve(system);
  EXPECT_EQ(solution.ending(), Ending::singular);
  EXPECT_EQ(solution.end_time(), 1.0);
}

TEST(SystemEndings, ACableThatIsHookedUpOverstretchedIsSingular) {
  System system;
  system.bodies.resize(1);
  system.cables = {to_world<double>(0, {0.0, 0.0}, {0.0, 0.0}, 1.0, 0.5)};
  system.cables[0].from_time = 2.0;  // the body has fallen by two
  system.initial.bodies = {{{0.0, 0.0}, 0.0, {0.0, 0.0}, 0.0}};
  system.duration = 3.0;
  const SystemSolution solution = solve(system);
  EXPECT_EQ(solution.ending(), Ending::singular);
  EXPECT_EQ(solution.end_time(), 2.0);
}

TEST(SystemEndings, ABodyComesToRestOnlyWhereNothingChangesAnyMore) {
  System system;
  system.bodies.resize(1);
  system.cables = {to_world<double>(0, {0.0, 0.0}, {0.0, 0.0}, 1.0, 0.0)};
  system.initial.bodies = {{{0.0, -1.0}, 0.0, {0.0, 0.0}, 0.0}};
  system.duration = 3.0;
  EXPECT_EQ(solve(system).ending(), Ending::rest);
  system.cables[0].length =
      Function<1>::linear({1.0, 2.0}, {Function<1>::Value(1.0), Function<1>::Value(0.5)});
  system.duration = 2.9;
  const SystemSolution lifted = solve(system);
  EXPECT_EQ(lifted.ending(), Ending::reached_duration);
  // the winch stops at 2: the body flies up at 0.5 m/s, and is back a second later
  EXPECT_NEAR(lifted.at(2.5).bodies[0].position.y(), -0.5 + 0.25 - 0.125, 1e-12);
}

TEST(SystemEndings, AWaveThatDoesNotMoveLetsABodyRest) {
  System system;
  system.bodies.resize(1);
  auto cable = to_world<double>(0, {0.0, 0.0}, {0.0, 0.0}, 1.0, 0.0);
  cable.length.waves = {{Function<1>::Value(0.25), 0.0, 0.0}};
  cable.to.motion.waves = {{Vec2(0.0, 0.0), 3.0, 0.0}};
  system.cables = {cable};
  system.initial.bodies = {{{0.0, -1.25}, 0.0, {0.0, 0.0}, 0.0}};
  system.duration = 3.0;
  EXPECT_EQ(solve(system).ending(), Ending::rest);
  system.cables[0].length.waves[0].frequency = 1e-3;
  EXPECT_EQ(solve(system).ending(), Ending::reached_duration);
}

TEST(SystemEndings, ABodyThatIsPulledIntoARingIsSingular) {
  // without gravity a ball pulls a lighter one up to the ring that their cable runs through
  System system;
  system.bodies.resize(2);
  system.bodies[1].mass = 3.0;
  system.gravity = Function<2>::constant(Vec2(0.0, 0.0));
  CableOfSystem cable;
  cable.from.body = 0;
  cable.through = {{std::nullopt, {0.0, 1.0}, {}}};
  cable.to.body = 1;
  cable.length = Function<1>::constant(3.0);
  cable.restitution = 0.0;
  system.cables = {cable};
  system.initial.bodies = {{{-1.0, 1.0}, 0.0, {0.0, 0.0}, 0.0}, {{2.0, 1.0}, 0.0, {1.0, 0.0}, 0.0}};
  system.duration = 3.0;
  const SystemSolution solution = solve(system);
  EXPECT_EQ(solution.ending(), Ending::singular) << to_string(solution.ending());
  // 3 m/s kg on 4 kg: both run at 0.75 m/s
  expect_within("time [s]", std::abs(solution.end_time() - 4.0 / 3.0), 1e-6);
}

TEST(SystemEndings, ABodyAtRestFallsPastARingAndIntoItsCable) {
  for (const double beside : {1e-3, 1e-6, 1e-9}) {
    System system;
    system.bodies.resize(1);
    CableOfSystem cable;
    cable.from.body = 0;
    cable.through = {{std::nullopt, {0.0, 0.0}, {}}};
    cable.to.motion = Function<2>::constant(Vec2(0.0, 1.0));
    cable.length = Function<1>::constant(3.0);
    cable.restitution = 0.5;
    system.cables = {cable};
    system.initial.bodies = {{{beside, 1.0}, 0.0, {0.0, 0.0}, 0.0}};
    system.duration = 2.5;  // it falls 1 m to the ring and 2 m more in sqrt(6) s
    const SystemSolution solution = solve(system);
    ASSERT_EQ(solution.events().size(), 1U) << beside;
    EXPECT_NEAR(solution.events()[0].time, std::sqrt(6.0), beside * beside + 1e-14) << beside;
  }
}

TEST(SystemEndings, AnAnchorMayPassTheAttachmentOfASlackCable) {
  System system;
  system.bodies.resize(1);
  system.gravity = Function<2>::constant(Vec2(0.0, 0.0));
  auto cable = to_world<double>(0, {0.0, 0.0}, {-1.0, 0.0}, 2.0, 0.5);
  cable.to.motion = Function<2>::linear({0.0, 2.0}, {Vec2(0.0, 0.0), Vec2(2.0, 0.0)});
  system.cables = {cable};
  system.initial.bodies = {{{0.0, 0.0}, 0.0, {0.0, 0.0}, 0.0}};
  system.duration = 2.0;
  const SystemSolution solution = solve(system);
  EXPECT_EQ(solution.ending(), Ending::reached_duration);
  EXPECT_TRUE(solution.events().empty());
}

TEST(SystemEndings, EightCablesThatFitExactlyHoldABodyAtOnce) {
  System system;
  system.bodies.resize(1);
  system.bodies[0].inertia = 0.1;
  system.initial.bodies = {{{0.0, 0.0}, 0.0, {0.0, 0.0}, 0.0}};
  for (int i = 0; i < 8; ++i) {
    const double angle = 0.7853981633974483 * i + 0.2;
    const Vec2 direction(std::cos(angle), std::sin(angle));
    const Vec2 attachment(0.2 * direction.y(), 0.3 * direction.x());
    system.cables.push_back(to_world<double>(0, attachment, 1.5 * direction,
                                             (1.5 * direction - attachment).norm(), 0.5));
  }
  system.duration = 5.0;
  const SystemSolution solution = solve(system);
  EXPECT_EQ(solution.ending(), Ending::rest) << to_string(solution.ending());
  EXPECT_LT(solution.events().size(), 10U);
  expect_within("way of the body [m]", solution.at(solution.end_time()).bodies[0].position.norm(),
                1e-9);
}

}  // namespace
}  // namespace tautline::test
