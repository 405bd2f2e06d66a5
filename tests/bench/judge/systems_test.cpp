// What is said of runs of systems in space: nothing of a plain correct scheme, and each planted
// fault.

#include <gtest/gtest.h>

#include <cmath>
#include <string>

#include "bench/judge/judgement.hpp"
#include "bench/measure/audit_impacts.hpp"
#include "tests/bench/spoilt_scheme.hpp"

namespace tautline::test {
namespace {

using namespace bench;
using Scheme = SystemScheme;

/// The judgement of the scheme on `system`, spoilt.
Judgement judged(const SpatialSystem& system, double step, const Spoiled::Spoil& before = {},
                 const Spoiled::Spoil& after = {}) {
  const ReferenceSystem reference = solve_case(system, ImpactLaw::simultaneous);
  const SystemExpectation expectation(reference);
  Spoiled simulation(system, before, after);
  const SystemTrajectory run = record(system, simulation, step);
  return judge(expectation, run, audited_impacts(reference, run), "float64");
}

constexpr double step = 1e-3;  // [s]

TEST(JudgementOfSystems, IsWithoutAFaultOfAPlainScheme) {
  for (const SpatialSystem& system :
       {shipped("tethered-ball"), shipped("spherical-slack"), shipped("bifilar"), planar("winch"),
        planar("two-bodies"), shipped("tumbling-brick")}) {
    const std::string& name = system.name;
    const Judgement found = judged(system, step);
    EXPECT_FALSE(found.rebounds.wrong()) << name;
    EXPECT_LE(found.following.ratio.value_or(0.0), 1.0) << name;
    EXPECT_EQ(found.impacts.missed, 0U) << name;
    EXPECT_LE(found.overstretch, 1.1) << name;
    EXPECT_LE(found.energy.value_or(0.0), 0.5) << name;
    EXPECT_LE(found.flight, 1e-9) << name;
    EXPECT_LE(found.rotation.value_or(0.0), 1.0) << name;
  }
}

TEST(JudgementOfSystems, TellsARebound) {
  const auto rebounds = [](double part) {
    return judged(shipped("tethered-ball"), step,
                  [part](Scheme& scheme, double) {
                    for (SpatialCable& cable : scheme.system().cables) {
                      cable.restitution = part * 0.7;
                    }
                  })
        .rebounds;
  };
  ASSERT_EQ(shipped("tethered-ball").cables.front().restitution, 0.7);
  EXPECT_EQ(rebounds(1.0).word, Rebound::kept);
  const Rebounds low = rebounds(0.7);
  EXPECT_EQ(low.word, Rebound::off);
  EXPECT_NEAR(low.deviation.value_or(0.0), -0.21, 0.02);
  EXPECT_EQ(rebounds(0.0).word, Rebound::none);
}

TEST(JudgementOfSystems, TellsAWrongGravity) {
  const Judgement found = judged(shipped("tethered-ball"), step, [](Scheme& scheme, double) {
    if (scheme.state().time == 0.0) {
      auto& gravity = scheme.system().gravity;
      gravity = Function<3>::constant(1.01 * gravity.at(0.0));
    }
  });
  EXPECT_NEAR(found.flight, 0.01, 1e-6);
}

TEST(JudgementOfSystems, TellsARotationWithoutTheGyroscopicTerm) {
  NoGyroscopicTerm fault;
  const Judgement found = judged(
      shipped("tumbling-brick"), step, [&](Scheme& scheme, double) { fault.remember(scheme); },
      [&](Scheme& scheme, double) { fault.keep(scheme); });
  EXPECT_GT(found.rotation.value_or(0.0), most_rotation);
  EXPECT_LE(found.flight, 1e-9);
}

TEST(JudgementOfSystems, TellsAWinchThatAnEngineLeavesOut) {
  const Judgement found = judged(planar("winch"), step, [](Scheme& scheme, double) {
    for (SpatialCable& cable : scheme.system().cables) {
      cable.length = Function<1>::constant(cable.length.at(0.0)[0]);
    }
  });
  EXPECT_GT(found.following.ratio.value_or(0.0), most_ratio);
}

TEST(JudgementOfSystems, TellsEnergyThatComesFromNowhere) {
  const auto pushed = [](const SpatialSystem& system) {
    return judged(system, step, {}, [](Scheme& scheme, double dt) {
      for (SpatialState& body : scheme.state().bodies) {
        body.velocity *= 1.0 + 0.1 * dt;
      }
    });
  };
  EXPECT_GT(pushed(shipped("spherical-slack")).energy, most_energy);
  EXPECT_FALSE(pushed(planar("winch")).energy);  // which gives energy itself
}

}  // namespace
}  // namespace tautline::test
