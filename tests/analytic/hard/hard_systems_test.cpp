#include <gtest/gtest.h>

#include <cmath>
#include <ctime>
#include <numbers>

#include "hard_cases.hpp"
#include "stopwatch.hpp"
#include "support.hpp"
#include "tautline/detail/projection.hpp"
#include "tautline/geometry.hpp"
#include "tautline/impact.hpp"
#include "tautline/solve.hpp"

// Systems at the edge of what a double can tell end quickly and truthfully.

namespace tautline::test {
namespace {

/// The most that an impact adds to the energy [J], and the largest overstretch [m] after an event.
struct Soundness {
  double gain = 0.0;
  double overstretch = 0.0;
};
Soundness soundness(const Case& the_case, const Solution& solution) {
  Soundness result;
  for (const Event& event : solution.events()) {
    result.gain =
        std::max(result.gain, energy(the_case, event.after) - energy(the_case, event.before));
    for (const Cable& cable : the_case.cables) {
      result.overstretch = std::max(result.overstretch, -gap(cable, event.after));
    }
  }
  return result;
}

/// No system of these takes longer than so many standard cases; one that hangs does [-]. The light
/// body's takes as long as 1,400.
constexpr double most_of_a_hard_system = 5000.0;

/// Solves in time.
Solution solved(const Case& the_case, ImpactLaw law = ImpactLaw::simultaneous) {
  SolveOptions options;
  options.law = law;
  const std::clock_t begin = std::clock();
  Solution solution = solve(the_case, options);
  const double taken = seconds_since(begin);
  expect_within(the_case.name + ": processor time, of the standard case's",
                taken / time_of_standard_case(), most_of_a_hard_system);
  return solution;
}

TEST(HardSystems, ALightBodyLetsGoOfACableOfWhichTheTensionFallsToZero) {
  const Case the_case = light_on_two_cables();
  const Solution solution = solved(the_case);
  EXPECT_EQ(solution.ending(), Ending::reached_duration) << to_string(solution.ending());
  double first_release = 0.0;
  for (const Event& event : solution.events()) {
    if (event.kind == EventKind::slack && event.time > 0.78) {
      first_release = event.time;
      EXPECT_EQ(event.cables, CableSet::of(1));
      break;
    }
  }
  EXPECT_NEAR(first_release, 0.7835, 1e-4);  // four decimals, where it once got stuck
  const Soundness sound = soundness(the_case, solution);
  expect_within("energy gain of an event [J]", sound.gain, 1e-13);
  expect_within("overstretch [m]", sound.overstretch, 1e-12);
}

TEST(HardSystems, AnElasticCableBesideAnInelasticOneIsTautOnceItsBouncesAreBelowRounding) {
  for (const double e : {1.0, 0.999999999}) {
    const Case the_case = elastic_beside_inelastic(e);
    const Solution solution = solved(the_case);
    EXPECT_EQ(solution.ending(), Ending::reached_duration) << to_string(solution.ending());
    EXPECT_LE(solution.events().size(), 1000U);
    expect_within("energy gain of an event [J]", soundness(the_case, solution).gain, 1e-13);
  }
}

TEST(HardSystems, ACableThatOpensFromAWedgeDoesNotKeepTheOtherBouncing) {
  const Case the_case = sliding_off_a_wedge();
  const Solution solution = solved(the_case);
  EXPECT_EQ(solution.ending(), Ending::rest) << to_string(solution.ending());
  EXPECT_LE(solution.events().size(), 2000U);
  expect_within("energy gain of an event [J]", soundness(the_case, solution).gain, 1e-15);
}

TEST(HardSystems, ABodyComesToRestFarFromTheOriginAsItDoesNearIt) {
  const Solution near = solved(resting_at(Vec2(0.0, 0.0)));
  ASSERT_EQ(near.ending(), Ending::rest);
  const double when = near.arcs().back().start;
  EXPECT_NEAR(when, 2.175, 1e-3);  // three decimals, as first found
  for (const Vec2& away : {Vec2(2000.0, 500.0), Vec2(-1e6, 1e6)}) {
    const Solution far = solved(resting_at(away));
    ASSERT_EQ(far.ending(), Ending::rest) << to_string(far.ending());
    EXPECT_LE(far.events().size(), 1000U);
    // three decimals of the input remain 1e6 away, to 1e-10 m; the motion multiplies that
    EXPECT_NEAR(far.arcs().back().start, when, 1e-2);
  }
}

TEST(HardSystems, ABodyWithHardlyAnyInertiaLeavesNoCableClosing) {
  const Case the_case = hardly_any_inertia();
  const Solution solution = solved(the_case);
  EXPECT_EQ(solution.ending(), Ending::reached_duration) << to_string(solution.ending());
  double closing = 0.0;
  for (const Event& event : solution.events()) {
    if (event.kind == EventKind::impact) {
      const double speed = speed_scale(the_case, event.before);
      closing =
          std::max(closing, -gap_rates(the_case, event.after, event.cables).minCoeff() / speed);
    }
  }
  expect_within("closing rate after an impact, of the speed", closing, 1e-12);
  expect_within("energy gain of an event [J]", soundness(the_case, solution).gain, 1e-12);
}

TEST(HardSystems, ImpactsOfAlmostOpposedCablesGainNoEnergy) {
  // two cables that pull a body apart, up to an angle: the Gram matrix has a condition up to 1e14
  Random random(14);
  double gain = 0.0;
  double closing = 0.0;
  for (int sample = 0; sample < 2000; ++sample) {
    const double angle = random.log_uniform(1e-7, 1e-1);
    Case wedge;
    wedge.body = {1.0, random.log_uniform(1e-9, 1e9)};
    for (const double direction : {0.3, 0.3 + std::numbers::pi + angle}) {
      const Vec2 arm(0.2 * std::cos(direction), 0.2 * std::sin(direction));
      wedge.cables.push_back({6.0 * arm, arm, 1.0, random.uniform(0.0, 1.0)});
    }
    const double along = 0.3 + 0.5 * (std::numbers::pi + angle);
    wedge.initial.velocity = -Vec2(std::cos(along), std::sin(along));
    for (const ImpactLaw law : {ImpactLaw::simultaneous, ImpactLaw::poisson}) {
      const Impact impact =
          resolve_impact(law, wedge, wedge.initial, CableSet::of(0) | CableSet::of(1));
      ASSERT_TRUE(impact.impulses.allFinite()) << "sample " << sample << " angle " << angle;
      gain = std::max(gain, energy(wedge, impact.after) / energy(wedge, wedge.initial) - 1.0);
      closing = std::max(closing, -gap_rates(wedge, impact.after, all_cables(wedge)).minCoeff());
    }
  }
  expect_within("energy gained, of that before", gain, 1e-13);
  expect_within("closing rate after [m/s]", closing, 1e-13);
}

TEST(HardSystems, IdenticalCablesPullAsTheOneThatGivesBackMost) {
  const Case one = side_by_side_cables({0.9});
  for (const ImpactLaw law : impact_laws) {
    const Solution single = solved(one, law);
    const std::vector<std::vector<double>> orders = {
        {0.9, 0.0, 0.5}, {0.9, 0.0}, {0.0, 0.9}, {0.5, 0.9, 0.9}};
    for (const std::vector<double>& order : orders) {
      const Solution many = solved(side_by_side_cables(order), law);
      for (std::size_t k = 0; k < 10; ++k) {
        // the search for a contact ends a rounding earlier or later; ten impacts multiply that
        EXPECT_NEAR(many.events().at(k).time, single.events().at(k).time, 1e-12);
        EXPECT_LE(difference(many.events().at(k).after, single.events().at(k).after), 1e-12)
            << to_string(law) << " event " << k;
      }
    }
  }
}

TEST(HardSystems, AnUnstableEquilibriumIsNotRest) {
  const Solution exact = solved(standing_on_its_cable(0.0));
  EXPECT_EQ(exact.ending(), Ending::unstable_rest) << to_string(exact.ending());
  const Solution leaning = solved(standing_on_its_cable(1e-13));
  EXPECT_EQ(leaning.ending(), Ending::reached_duration) << to_string(leaning.ending());
  EXPECT_GT(std::abs(leaning.at(leaning.end_time()).angle), 0.01);
  Case hanging = standing_on_its_cable(0.0);
  hanging.cables.front().attachment.y() = 0.5;
  hanging.initial.position.y() = -1.5;
  EXPECT_EQ(solved(hanging).ending(), Ending::rest);
}

TEST(HardSystems, ABodyThatTurnsAboutItsCentreRestsThere) {
  for (const double spin : {3.0, 1e7}) {
    const Case the_case = turning_on_its_centre(spin);
    const Solution solution = solved(the_case);
    EXPECT_EQ(solution.ending(), Ending::rest) << to_string(solution.ending());
    EXPECT_LE(solution.events().size(), 1U);
    const State end = solution.at(the_case.duration);
    EXPECT_EQ(end.spin, spin);
    EXPECT_EQ(end.angle, spin * the_case.duration);
    EXPECT_EQ(end.position.norm(), 0.0);
  }
  Case in_reach = turning_on_its_centre(3.0);
  in_reach.duration = 3.0;
  in_reach.cables[1].length = 1.2;  // the distance of the centre is 1.118, and the arm 0.224
  const Solution solution = solved(in_reach);
  ASSERT_GE(solution.events().size(), 2U);
  EXPECT_TRUE(solution.events()[1].cables.contains(1));
}

TEST(HardSystems, ABodyThatTurnsThousandsOfTimesIsHitTheFirstTimeThatItCan) {
  // the centre leaves the anchor at 0.1 m/s: from 15 s on, at 1.5 m, the arm of 0.5 m reaches the
  // cable's 2 m where it points away, which it does within a turn
  constexpr double spin = 2000.0;  // [rad/s]
  constexpr double turn = 2.0 * std::numbers::pi / spin;
  Case the_case;
  the_case.duration = 20.0;
  the_case.gravity = Vec2(0.0, 0.0);
  the_case.body = {1.0, 0.1};
  the_case.cables = {{Vec2(0.0, 0.0), Vec2(0.5, 0.0), 2.0, 0.5}};
  the_case.initial.velocity = Vec2(0.0, 0.1);
  the_case.initial.spin = spin;
  const Solution hit = solved(the_case);
  ASSERT_FALSE(hit.events().empty());
  EXPECT_GE(hit.events().front().time, 15.0);
  EXPECT_LE(hit.events().front().time, 15.0 + turn);

  the_case.ceiling = 1.0;  // half a metre above the centre after five seconds
  const Solution risen = solved(the_case);
  ASSERT_EQ(risen.ending(), Ending::ceiling);
  EXPECT_GE(risen.end_time(), 5.0);
  EXPECT_LE(risen.end_time(), 5.0 + turn);
}

TEST(HardSystems, SaysWhichLimitEndedARun) {
  const Case the_case = table_case("1910121100");
  SolveOptions options;
  options.max_events = 5;
  const Solution by_events = solve(the_case, options);
  EXPECT_EQ(by_events.ending(), Ending::event_limit);
  EXPECT_EQ(by_events.events().size(), 5U);
  options = {};
  options.max_steps = 5;
  EXPECT_EQ(solve(the_case, options).ending(), Ending::step_limit);

  // the springs of one impact take as many steps, and the body is still where it was
  Case struck = light_on_two_cables();
  struck.initial = {Vec2(0.0, 0.0), 0.0, Vec2(0.3, -1.0), 0.2};
  for (Cable& cable : struck.cables) {
    cable.length = (attachment_point(struck.initial, cable) - cable.anchor).norm();
    cable.restitution = 0.5;
  }
  options.law = ImpactLaw::energetic;
  const Solution by_springs = solve(struck, options);
  EXPECT_EQ(by_springs.ending(), Ending::step_limit);
  EXPECT_EQ(by_springs.events().size(), 1U);
  EXPECT_EQ(by_springs.end_time(), 0.0);

  // an elastic point mass between three taut cables is thrown to and fro within the instant
  Case caught;
  caught.body = {1.0, 0.0};
  for (const double direction : {0.3, 2.4, 4.5}) {  // [rad]
    caught.cables.push_back(
        {Vec2(std::cos(direction), std::sin(direction)), Vec2(0.0, 0.0), 1.0, 1.0});
  }
  caught.initial.velocity = Vec2(0.7, -0.4);
  EXPECT_EQ(solved(caught).ending(), Ending::no_progress);
}

}  // namespace
}  // namespace tautline::test
