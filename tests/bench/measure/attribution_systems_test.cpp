// What the deviation of a run of a system comes from: planted faults are named, and the parts are
// the whole.

#include <fmt/format.h>
#include <gtest/gtest.h>

#include <cmath>
#include <string>

#include "bench/measure/attribution/attribution.hpp"
#include "bench/measure/attribution/carry.hpp"
#include "bench/measure/reference.hpp"
#include "tautline/solve.hpp"
#include "tests/bench/spoilt_scheme.hpp"

namespace tautline::test {
namespace {

using namespace bench;

constexpr double step_of_runs = 1e-3;  // [s]

std::string described(const Attribution& found) {
  std::string text =
      fmt::format("{} m at {} s, {} arcs, {} impacts, remainder {}, {}\n", found.deviation,
                  found.until, found.arcs, found.impacts, found.remainder, found.reason);
  for (std::size_t index = 0; found.parts && index < causes.size(); ++index) {
    text += fmt::format("{}: {}\n", bench::to_string(causes[index]), (*found.parts)[index]);
  }
  return text;
}

/// The attribution of the scheme on `system`, spoilt; its parts are the whole.
Attribution attributed(const SpatialSystem& system, const Spoiled::Spoil& before = {},
                       const Spoiled::Spoil& after = {}, double step = step_of_runs) {
  const ReferenceSystem reference = solve_case(system, ImpactLaw::simultaneous);
  Spoiled simulation(system, before, after);
  const SystemTrajectory run = record(system, simulation, step);
  Attribution found = attribute(system, reference.solution, reference.horizon, run);
  EXPECT_TRUE(found.parts) << system.name << ": " << found.reason;
  double sum = found.remainder;
  for (const double part : found.parts.value_or(CauseParts{})) {
    sum += part;
  }
  EXPECT_NEAR(sum, found.deviation, 1e-12 * found.deviation) << system.name;
  EXPECT_LE(std::abs(found.remainder), 0.05 * found.deviation) << described(found);
  return found;
}

/// The size of the part of a cause [m].
double part(const Attribution& found, Cause cause) {
  return std::abs(found.parts.value_or(CauseParts{})[static_cast<std::size_t>(cause)]);
}

/// Its share in the sizes of all parts [-].
double share(const Attribution& found, Cause cause) {
  double all = 0.0;
  for (const Cause one : causes) {
    all += part(found, one);
  }
  return part(found, cause) / all;
}

TEST(AttributionOfSystems, NamesARotationWithoutTheGyroscopicTerm) {
  NoGyroscopicTerm fault;
  const Attribution found = attributed(
      shipped("tumbling-brick"), [&](SystemScheme& scheme, double) { fault.remember(scheme); },
      [&](SystemScheme& scheme, double) { fault.keep(scheme); });
  EXPECT_GT(share(found, Cause::rotation_in_flight), 0.5) << described(found);
  const Attribution plain = attributed(shipped("tumbling-brick"));
  constexpr double of_late_impacts = 0.2;  // [-]: the plain scheme is off by these alone
  EXPECT_LT(plain.deviation, of_late_impacts * found.deviation) << described(plain);
  EXPECT_LT(part(plain, Cause::rotation_in_flight), 0.1 * part(found, Cause::rotation_in_flight));
}

TEST(AttributionOfSystems, HasNoRotationOfABallAndOfPointMasses) {
  for (const char* name : {"tethered-ball", "spherical-slack"}) {
    const Attribution found = attributed(shipped(name));
    // the step of an impact is late, and turns the ball as before it
    EXPECT_LT(share(found, Cause::rotation_in_flight), 0.03) << name << '\n' << described(found);
  }
}

TEST(AttributionOfSystems, NamesAWrongRestitution) {
  const auto with_part = [](double part) {
    return attributed(shipped("tethered-ball"), [part](SystemScheme& scheme, double) {
      for (SpatialCable& cable : scheme.system().cables) {
        cable.restitution = part * 0.7;
      }
    });
  };
  const Attribution low = with_part(0.7);
  EXPECT_GT(share(low, Cause::solver_residual), 0.8) << described(low);
  const Attribution lost = with_part(0.0);
  EXPECT_GT(share(lost, Cause::restitution_ignored), 0.8) << described(lost);
}

TEST(AttributionOfSystems, NamesAWrongGravity) {
  const Attribution found = attributed(shipped("tethered-ball"), [](SystemScheme& scheme, double) {
    if (scheme.state().time == 0.0) {
      auto& gravity = scheme.system().gravity;
      gravity = Function<3>::constant(1.05 * gravity.at(0.0));
    }
  });
  EXPECT_GT(share(found, Cause::flight_bias), 0.6) << described(found);
}

TEST(AttributionOfSystems, FindsNoFaultInTheImpactsOfASoundScheme) {
  // in the step of an impact the scheme's impulse holds the body against gravity, too: the step
  // explains that, and a shorter one has less of it
  const SpatialSystem system = shipped("tethered-ball");
  const Attribution coarse = attributed(system);
  const Attribution fine = attributed(system, {}, {}, 0.1 * step_of_runs);
  EXPECT_LT(part(fine, Cause::solver_residual), 0.2 * part(coarse, Cause::solver_residual))
      << described(coarse) << described(fine);
}

TEST(AttributionOfSystems, KnowsCablesByNumberWhereOneIsCut) {
  SpatialSystem system = shipped("tethered-ball");
  const Attribution alone = attributed(system);
  SpatialCable cut = system.cables.front();
  cut.length = Function<1>::constant(100.0);
  cut.restitution = 0.0;
  cut.cut_at = 0.01;
  system.cables.insert(system.cables.begin(), cut);
  const Attribution found = attributed(system);
  for (const Cause cause : causes) {
    EXPECT_NEAR(part(found, cause), part(alone, cause), 1e-9 * alone.deviation)
        << bench::to_string(cause) << '\n'
        << described(found) << described(alone);
  }
}

TEST(AttributionOfSystems, NamesTautCables) {
  for (const char* name : {"conical", "bifilar"}) {
    const Attribution found = attributed(shipped(name));
    EXPECT_GT(share(found, Cause::taut_drift), 0.99) << name << '\n' << described(found);
  }
}

TEST(AttributionOfSystems, FollowsWhatIsGivenOverTime) {
  // restarted at another instant, a winch and a moving anchor go on as they did
  for (const char* name : {"winch", "two-bodies", "bouncer-stable", "tow"}) {
    const Attribution found = attributed(planar(name));
    EXPECT_LT(std::abs(found.remainder), 0.05 * found.deviation) << name << described(found);
    EXPECT_GT(found.arcs + found.impacts, 1U) << name;
  }
}

using Triple = Eigen::Vector3d;

/// One thing that a ball on a cable is given over time.
struct Given {
  const char* what;
  void (*give)(SpatialSystem& system);
};
constexpr Given given[] = {
    {"gravity",
     [](SpatialSystem& system) {
       system.gravity.waves = {{Triple(0.4, 0.0, 0.2), 3.0, 0.4}};
     }},
    {"a force",
     [](SpatialSystem& system) {
       system.bodies.front().force =
           Function<3>::linear({0.5, 1.5}, {Triple::Zero(), Triple(0.3, 0.2, 0.0)});
     }},
    {"a moment",
     [](SpatialSystem& system) {
       system.bodies.front().moment.waves = {{Triple(0.0, 0.02, 0.01), 2.0, 1.0}};
     }},
    {"a winch",
     [](SpatialSystem& system) {
       system.cables.front().length =
           Function<1>::linear({0.5, 1.5}, {Function<1>::Value(1.0), Function<1>::Value(0.7)});
     }},
    {"an anchor that moves",
     [](SpatialSystem& system) {
       system.cables.front().to.motion.waves = {{Triple(0.15, 0.0, 0.05), 1.5, -0.5}};
     }},
    {"a hook-up",
     [](SpatialSystem& system) {
       SpatialCable hooked = system.cables.front();
       hooked.to.at = Triple(0.0, -0.3, 0.0);
       hooked.from_time = 0.9;
       system.cables.push_back(hooked);
     }},
    {"a cut", [](SpatialSystem& system) { system.cables.front().cut_at = 1.4; }},
};

TEST(CarriedSystems, GoOnWithWhatIsGivenOverTime) {
  constexpr double until = 2.6;             // [s], after some impacts
  constexpr double grown_rounding = 1e-10;  // [m, rad, m/s, rad/s], over these impacts
  constexpr double least_effect = 0.1;      // likewise: what a start at time 0 changes
  for (const auto& [what, give] : given) {
    SpatialSystem system = shipped("tethered-ball");
    system.duration = until;
    give(system);
    const auto exact = solve(system);
    ASSERT_EQ(exact.end_time(), until) << what;
    const SpatialSystemState end = exact.at(until);
    for (const double time : {0.25, 1.1, 1.7}) {
      const SpatialSystemState state = exact.at(time);
      const auto carried =
          Carrier<SpatialSystem>(system, ImpactLaw::simultaneous, until).carry(state, time);
      ASSERT_TRUE(carried) << what << " from " << time;
      EXPECT_LE(difference(carried->end(), end).norm(), grown_rounding) << what << " from " << time;
      SpatialSystem anew = system;
      anew.initial = state;
      anew.initial.time = 0.0;
      anew.duration = until - time;
      const auto other = Carried<SpatialSystem>::by(anew, ImpactLaw::simultaneous);
      EXPECT_TRUE(!other || difference(other->end(), end).norm() > least_effect)
          << what << " from " << time << ": nothing depends on when it is given";
    }
  }
}

}  // namespace
}  // namespace tautline::test
