#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <ctime>

#include "support.hpp"
#include "system/elastic_systems.hpp"
#include "tautline/elastic_contacts.hpp"
#include "tautline/solve.hpp"
#include "tautline/system_geometry.hpp"
#include "tautline/system_settling.hpp"

namespace tautline::test {
namespace {

SystemSettling settled(const System& system) { return settling(system, solve(system)); }

/// A point on a cable of length 1 at `angle` [rad] from the plumb line, at rest.
System pendulum(double angle, double drag) {
  System system;
  system.bodies.resize(1);
  system.bodies[0].drag = drag;
  system.cables = {to_world<double>(0, {0.0, 0.0}, {0.0, 0.0}, 1.0, 0.5)};
  system.initial.bodies = {{{std::sin(angle), -std::cos(angle)}, 0.0, {0.0, 0.0}, 0.0}};
  system.duration = 40.0;
  return system;
}

TEST(SystemSettlingOf, AStableBouncerRepeatsEveryPeriod) {
  const SystemSettling result = settled(bouncer<double>(0.14, 1e-3));
  ASSERT_TRUE(result.forced);
  EXPECT_DOUBLE_EQ(result.forced->period, 2.0);
  EXPECT_DOUBLE_EQ(result.forced->impacts, 1.0);
  EXPECT_EQ(result.forced->repeats, 1U);
  EXPECT_FALSE(result.lock);  // the anchor moves for ever
  ASSERT_TRUE(result.cables[0].impulse);
  EXPECT_NEAR(result.cables[0].impulse->value, 2.0, 1e-2);  // the push makes one larger
  EXPECT_EQ(result.cables[0].taut_share, 0.0);
}

TEST(SystemSettlingOf, AnUnstableBouncerDoesNotRepeat) {
  const SystemSettling result = settled(bouncer<double>(0.3, 1e-3));
  ASSERT_TRUE(result.forced);
  EXPECT_FALSE(result.forced->repeats == 1U);
}

TEST(SystemSettlingOf, APendulumKeepsItsEnergyAboveTheEquilibrium) {
  const SystemSettling result = settled(pendulum(0.5, 0.0));
  ASSERT_TRUE(result.lock);
  EXPECT_EQ(result.lock->time, 0.0);
  EXPECT_FALSE(result.lock->certain);
  ASSERT_TRUE(result.lock->residual_energy);
  EXPECT_NEAR(*result.lock->residual_energy, 1.0 - std::cos(0.5), 1e-13);
  EXPECT_FALSE(result.lock->one_percent);
  EXPECT_DOUBLE_EQ(result.cables[0].taut_share, 1.0);
  ASSERT_TRUE(result.cables[0].tension);
  // at the bottom, where m g + m v^2 / L is largest
  EXPECT_NEAR(result.cables[0].tension->value, 3.0 - 2.0 * std::cos(0.5), 1e-12);
}

TEST(SystemSettlingOf, DragTakesAHundredthOfTheEnergyWhenItsClosedFormSays) {
  constexpr double drag = 0.4;
  constexpr double small = 1e-4;  // [rad]: the motion is that of a linear oscillator
  const SystemSettling result = settled(pendulum(small, drag));
  ASSERT_TRUE(result.lock);
  ASSERT_TRUE(result.lock->one_percent);
  // angle and rate of a damped oscillator, and its energy, by bisection
  const double rate = std::sqrt(1.0 - drag * drag / 4.0);
  const auto part = [&](double t) {
    const double decay = std::exp(-drag * t / 2.0);
    const double angle = decay * (std::cos(rate * t) + drag / (2.0 * rate) * std::sin(rate * t));
    const double speed = -decay / rate * std::sin(rate * t);
    return angle * angle + speed * speed;
  };
  double low = 0.0;
  double high = 40.0;
  for (int k = 0; k < 100; ++k) {
    const double middle = (low + high) / 2.0;
    (part(middle) > 0.01 ? low : high) = middle;
  }
  EXPECT_NEAR(*result.lock->one_percent, low, 1e-5);
}

TEST(SystemSettlingOf, ARestIsCertain) {
  System system = pendulum(0.0, 0.0);
  system.initial.bodies[0].position.y() = -0.5;
  const SystemSettling result = settled(system);
  ASSERT_TRUE(result.lock);
  EXPECT_TRUE(result.lock->certain);
  EXPECT_NEAR(result.lock->time, 3.0, 1e-12);  // 1 + 2 (1/2 + 1/4 + ...)
  EXPECT_EQ(result.lock->residual_energy, 0.0);
  ASSERT_TRUE(result.last_impacts[0].time);
  EXPECT_NEAR(*result.last_impacts[0].time, 2.96875, 1e-12);
}

/// The equilibrium of a pendulum that a spring pulls aside is where its potential energy is least.
TEST(SystemSettlingOf, SpringsTakePartInTheEquilibrium) {
  constexpr double k = 5.0;            // [N/m]
  constexpr double unstretched = 0.3;  // [m]
  const Vec2 anchor(0.8, -1.0);
  System system = pendulum(0.1, 0.2);
  CableOfSystem spring = to_world<double>(0, {0.0, 0.0}, anchor, unstretched, 1.0);
  spring.elasticity.emplace().stiffness = {k};
  system.cables.push_back(spring);
  const auto potential = [&](double angle) {
    const Vec2 place(std::sin(angle), -std::cos(angle));
    const double stretch = std::max(0.0, (place - anchor).norm() - unstretched);
    return place.y() + 0.5 * k * stretch * stretch;
  };
  double low = 0.0;  // [rad], around the least energy
  double high = 0.8;
  while (high - low > 1e-9) {
    const double part = (high - low) / 3.0;
    const bool rises = potential(low + part) > potential(high - part);
    (rises ? low : high) += rises ? part : -part;
  }
  const auto solution = solve(system);
  const SystemSettling result = settling(system, solution);
  ASSERT_TRUE(result.lock);
  ASSERT_TRUE(result.lock->residual_energy);
  const double left = energy(system, solution.at(system.duration)) - potential(low);
  EXPECT_GT(left, 1e-6);
  EXPECT_NEAR(*result.lock->residual_energy, left, 1e-9);

  // too stiff for the 300 scales of time of that search, not for its own duration
  system.cables[1].length = Function<1>::constant(0.7);
  system.cables[1].elasticity = Elasticity{{1e9}, 0.0, 1.0};
  system.duration = 0.1;
  const SystemSettling stiff = settled(system);
  ASSERT_TRUE(stiff.lock);
  EXPECT_FALSE(stiff.lock->residual_energy);
}

TEST(SystemSettlingOf, ACableIsTautForTheTimeUntilItIsCut) {
  System system = pendulum(1.0, 0.0);
  system.cables[0].cut_at = 10.0;
  const SystemSettling result = settled(system);
  EXPECT_DOUBLE_EQ(result.cables[0].taut_share, 0.25);
  EXPECT_FALSE(result.lock);  // no cable is taut
}

/// A load hangs beyond a ring from another load, three times as heavy, which falls.
TEST(SystemSettlingOf, ALoadThatAnotherPullsToARingHasNoEquilibrium) {
  System system;
  system.bodies.resize(2);
  system.bodies[0].inertia = 0.05;
  system.bodies[1].mass = 3.0;
  system.bodies[1].inertia = 0.2;
  system.cables = {to_world<double>(0, {0.02, 0.2}, {-0.2, -0.2}, 3.4, 0.2)};
  system.cables[0].to.body = 1;
  system.cables[0].through = {{std::nullopt, {-1.4, 0.8}, {}}};
  system.initial.bodies = {{{-0.8, -0.2}, -0.9, {0.4, 0.0}, -0.3},
                           {{-0.7, 0.0}, 0.7, {0.2, -0.3}, 0.4}};
  system.duration = 2.0;
  const auto solution = solve(system);
  ASSERT_FALSE(solution.arcs().back().taut.empty());
  constexpr int solves = 20;
  const std::clock_t start = std::clock();
  for (int repeat = 0; repeat < solves; ++repeat) {
    EXPECT_FALSE(solve(system).arcs().empty());
  }
  const std::clock_t solved = std::clock();
  const SystemSettling result = settling(system, solution);
  const std::clock_t end = std::clock();
  ASSERT_TRUE(result.lock);
  EXPECT_FALSE(result.lock->residual_energy);
  constexpr double most = 5.0;  // of these solves [-]: it turned around the ring for hundreds
  EXPECT_LE(static_cast<double>(end - solved), most * static_cast<double>(solved - start));
}

/// A mass of 1 kg on a cable of 400 N/m with this `energy` [J] above its equilibrium, whose share
/// of stretch and speed is given by `phase` [rad].
System on_a_spring(double ratio, double energy, double phase) {
  constexpr double k = 400.0;
  const double amplitude = std::sqrt(2.0 * energy / k);
  return drop<double>(with_ratio(k, ratio), 9.81, std::sqrt(k) * amplitude * std::sin(phase),
                      -9.81 / k - amplitude * std::cos(phase));
}

TEST(SystemSettlingOf, AnElasticCableStaysEngagedBelowItsLeastEnergy) {
  for (const double ratio : {0.0, 0.1, 0.5, 2.0}) {
    const double least = 9.81 * 9.81 / (2.0 * 400.0 * (1.0 + 4.0 * ratio * ratio));
    for (const double part : {0.999, 1.001}) {
      System system = on_a_spring(ratio, part * least, 0.5 * pi<double>());
      system.duration = 1e-6;
      const SystemSettling result = settled(system);
      ASSERT_EQ(result.lock.has_value(), part < 1.0) << ratio;
      if (!result.lock) {
        continue;
      }
      EXPECT_TRUE(result.lock->certain) << ratio;
      EXPECT_FALSE(result.lock->at_rest) << ratio;
      EXPECT_EQ(result.lock->time, 0.0) << ratio;
      EXPECT_NEAR(*result.lock->residual_energy / (part * least), 1.0, 1e-3) << ratio;
      const double slower = ratio > 1.0 ? ratio - std::sqrt(ratio * ratio - 1.0) : ratio;
      EXPECT_EQ(result.lock->ring_down.has_value(), ratio > 0.0);
      EXPECT_NEAR(result.lock->ring_down.value_or(0.0) * slower * 20.0, ratio > 0.0 ? 1.0 : 0.0,
                  1e-12);
    }
  }
}

TEST(SystemSettlingOf, AnElasticCableThatIsCertainDoesNotLetGo) {
  constexpr int phases = 12;
  for (const double ratio : {0.05, 0.4}) {
    const double least = 9.81 * 9.81 / (2.0 * 400.0 * (1.0 + 4.0 * ratio * ratio));
    int exits = 0;
    for (int i = 0; i < phases; ++i) {
      const double phase = 2.0 * pi<double>() * i / phases;
      const auto below = elastic_contacts(solve(on_a_spring(ratio, 0.999 * least, phase)));
      ASSERT_EQ(below.size(), 1U) << ratio << ", " << phase;
      EXPECT_FALSE(below[0].exit) << ratio << ", " << phase;
      for (const auto& contact : elastic_contacts(solve(on_a_spring(ratio, 20.0 * least, phase)))) {
        exits += contact.exit ? 1 : 0;
      }
    }
    EXPECT_GT(exits, 0) << ratio;  // with more it may
  }
}

TEST(SystemSettlingOf, AMassThatDropsOnAnElasticCableLocksAtItsLastEntry) {
  System system = drop<double>(with_ratio(1e3, 0.2), 9.81, 1.0, 0.1);
  system.duration = 3.0;
  const auto solution = solve(system);
  const auto contacts = elastic_contacts(solution);
  const SystemSettling result = settling(system, solution);
  ASSERT_TRUE(result.lock);
  EXPECT_TRUE(result.lock->certain);
  EXPECT_EQ(result.lock->time, contacts.back().entry);
  EXPECT_FALSE(contacts.back().exit);
  EXPECT_NEAR(*result.lock->ring_down, 1.0 / (0.2 * std::sqrt(1e3)), 1e-12);
  EXPECT_LE(*result.lock->residual_energy, 1e-12);
  ASSERT_TRUE(result.lock->one_percent);
  EXPECT_LT(*result.lock->one_percent, result.lock->time + 1.0);
  system.duration = contacts[0].entry + 1e-3;  // in the midst of its first contact
  EXPECT_FALSE(settled(system).lock);
}

TEST(CommonPeriod, IsTheLeastThatHoldsAllWaves) {
  const auto period = common_period(waves<double>());  // 1.7 and 3.1 rad/s
  ASSERT_TRUE(period);
  EXPECT_NEAR(*period, 20.0 * pi<double>(), 1e-12);
  EXPECT_FALSE(common_period(pendulum(0.1, 0.0)));
  System system = waves<double>();
  system.bodies[0].force.waves[0].frequency = 1.7 * std::sqrt(2.0);
  EXPECT_FALSE(common_period(system));
}

}  // namespace
}  // namespace tautline::test
