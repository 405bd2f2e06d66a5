// What is said of runs of systems in space: nothing of a plain correct scheme, and each planted
// fault.

#include <gtest/gtest.h>

#include <cmath>
#include <string>

#include "bench/judge/judgement.hpp"
#include "bench/measure/attribution/attribution.hpp"
#include "bench/measure/audit_impacts.hpp"
#include "bench/measure/compare.hpp"
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

/// A load of 1 kg that falls into two cables: an elastic one with the restitution 0.5 of a contact,
/// and, unless it is `alone`, one without a stiffness, of restitution 0.5, that it reaches while it
/// rises.
SpatialSystem load_on_a_spring(ElasticCut cut, bool alone = false) {
  SpatialSystem result;
  result.name = "load-on-a-spring";
  result.gravity = Function<3>::constant({0.0, -9.81, 0.0});
  SpatialBody load;
  load.mass = 1.0;
  result.bodies = {load};
  SpatialCable spring;
  spring.from.at = {0.0, 0.0, 0.0};
  spring.to.body = 0;
  spring.length = Function<1>::constant(1.0);
  spring.elasticity = Elasticity{{1e4}, 0.0, damping_ratio_of(0.5)};
  spring.elasticity->cut = cut;
  SpatialCable rigid = spring;
  rigid.from.at = {0.0, -2.4, 0.0};
  rigid.length = Function<1>::constant(1.5);
  rigid.restitution = 0.5;
  rigid.elasticity.reset();
  result.cables = {spring};
  if (!alone) {
    result.cables.push_back(rigid);
  }
  SpatialState start;
  start.position = {0.0, -0.95, 0.0};
  start.velocity = {0.0, -3.0, 0.0};
  result.initial.bodies = {start};
  result.duration = 0.3;
  return result;
}

/// What is measured of the scheme on that load in steps of `dt` [s].
struct Measured {
  ContactMatch contacts;
  Metrics metrics;
  Judgement judgement;
  SystemTrajectory run;
  Attribution attribution;
};
Measured measured(const SpatialSystem& system, double dt, const Spoiled::Spoil& before = {}) {
  const ReferenceSystem reference = solve_case(system, ImpactLaw::simultaneous);
  const SystemExpectation expectation(reference);
  Spoiled simulation(system, before, {});
  Measured result;
  result.run = record(system, simulation, dt);
  result.metrics = compare(system, reference.solution, reference.settling, reference.horizon,
                           result.run, CompareOptions());
  result.contacts = result.metrics.contacts.value();
  result.judgement =
      judge(expectation, result.run, audited_impacts(reference, result.run), "float64");
  result.attribution =
      attribute(system, reference.solution, reference.horizon, result.run, AttributionOptions());
  return result;
}

Measured measured_on_a_spring(double dt, const Spoiled::Spoil& before = {},
                              ElasticCut cut = ElasticCut::force) {
  return measured(load_on_a_spring(cut), dt, before);
}

TEST(JudgementOfSystems, TellsARunOnElasticCablesByItsPositionOnceAContactIsOver) {
  SpatialSystem system = load_on_a_spring(ElasticCut::force, true);
  const auto word = [&](double duration) {
    system.duration = duration;
    return measured(system, 1e-4).judgement.rebounds.word;
  };
  const std::vector<ElasticContact> contacts =
      elastic_contacts(solve_case(system, ImpactLaw::simultaneous).solution);
  ASSERT_FALSE(contacts.empty());
  const double exit = contacts.front().exit.value();
  EXPECT_EQ(word(0.3), Rebound::elastic);
  EXPECT_EQ(word(exit + 2e-3), Rebound::elastic);
  EXPECT_EQ(word(0.5 * contacts.front().entry), Rebound::too_few) << "it never pulled";
  system.duration = 0.3;
  const Judgement wrong = measured(system, 1e-4, [](Scheme& scheme, double) {
                            scheme.system().cables[0].elasticity->stiffness = {4e4};
                          }).judgement;
  EXPECT_GT(wrong.following.ratio.value_or(0.0), most_ratio);
  system.cables[0].elasticity.reset();
  system.cables[0].restitution = 0.5;
  EXPECT_EQ(judged(system, 1e-4).rebounds.word, Rebound::too_few)
      << "an inextensible cable has impacts";
}

TEST(JudgementOfSystems, FindsNoFaultInASpringThatIsFollowed) {
  const Measured found = measured_on_a_spring(1e-4);
  ASSERT_GE(found.run.contacts.size(), 2U);
  EXPECT_LT(found.judgement.overstretch, most_overstretch);
  EXPECT_LT(found.run.overstretch, found.run.contacts.front().greatest_stretch);
  EXPECT_FALSE(found.judgement.rebounds.wrong());
  EXPECT_LE(found.judgement.following.ratio.value_or(0.0), 1.0);
  EXPECT_FALSE(found.judgement.energy) << "a spring stores some";
  for (const auto& impact : found.run.impacts) {
    EXPECT_EQ(impact.cable, 1U) << "a contact is no impact";
  }
  EXPECT_FALSE(found.run.impacts.empty());
  EXPECT_EQ(found.attribution.reason, "elastic cables have no impacts, which attribution goes by");
}

/// What a contact is off by is of the first order of the frequency times the step, 0.04 and 0.01;
/// where in a step it begins may double that.
TEST(JudgementOfSystems, ComparesContactsOfElasticCables) {
  using enum ElasticCut;
  for (const auto& [dt, cut] :
       {std::pair(4e-4, force), {1e-4, force}, {1e-4, stretch}, {1e-4, never}}) {
    const ContactMatch contacts = measured_on_a_spring(dt, {}, cut).contacts;
    EXPECT_GE(contacts.exact, 1U);
    EXPECT_EQ(contacts.matched, contacts.exact) << dt;
    EXPECT_EQ(contacts.found, contacts.exact) << dt;
    ASSERT_TRUE(contacts.peak);
    const double allowed = 4.0 * 100.0 * dt;  // [-]
    EXPECT_NEAR(contacts.peak->found, contacts.peak->exact, allowed * contacts.peak->exact) << dt;
    for (const auto& error : {contacts.peak_error, contacts.impulse_error, contacts.time_error}) {
      EXPECT_LT(error.value_or(1e3), 100.0 * allowed) << dt;
    }
    EXPECT_LT(contacts.restitution_error.value_or(1e3), allowed) << dt;
  }
}

/// Of a cable four times as stiff a contact lasts half as long, with twice the tension.
TEST(JudgementOfSystems, TellsASpringThatIsTooStiff) {
  const ContactMatch contacts = measured_on_a_spring(1e-4, [](Scheme& scheme, double) {
                                  scheme.system().cables[0].elasticity->stiffness = {4e4};
                                }).contacts;
  EXPECT_NEAR(contacts.peak_error.value_or(0.0), 100.0, 5.0);
  EXPECT_NEAR(contacts.time_error.value_or(0.0), 50.0, 5.0);
}

}  // namespace
}  // namespace tautline::test
