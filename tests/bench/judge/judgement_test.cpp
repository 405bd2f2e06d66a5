// What the exact motion of a case says of its runs: how far a correct scheme may be off, until
// when, and what is a fault. The rebounds alone are tested in audit_test.cpp, faults of whole
// engines in verdict_test.cpp.

#include "bench/judge/judgement.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <functional>

#include "bench/cases/catalogue.hpp"
#include "bench/judge/models.hpp"
#include "bench/judge/step_needed.hpp"
#include "bench/measure/compare.hpp"
#include "tautline/geometry.hpp"

namespace tautline::bench {
namespace {

ReferenceCase reference_of(const std::string& name) {
  return solve_cases(select_cases({&name, 1}).cases, ImpactLaw::simultaneous).front();
}

/// The exact motion as a run that locates its impacts, in steps of `step` [s].
Trajectory exact_run(const ReferenceCase& reference, double step) {
  Trajectory run;
  run.step = step;
  const double end = reference.solution.end_time();
  for (double time = 0.0; time <= end; time += step) {
    run.points.push_back({time, reference.solution.at(time)});
  }
  for (const Event& event : reference.solution.events()) {
    for (const std::size_t index : event.cables) {
      const Cable& cable = reference.the_case.cables[index];
      if (event.kind == EventKind::impact && gap_rate(cable, event.before) < -1e-3) {
        RecordedImpact impact{event.time,
                              index,
                              1.0,
                              gap_rate(cable, event.before),
                              gap_rate(cable, event.after),
                              0,
                              event.before,
                              event.after};
        impact.shared = event.cables.size() > 1;
        run.impacts.push_back(impact);
      }
    }
  }
  return run;
}

/// The judgement of the exact motion of a case at 1e-3 s, after `spoil`.
Judgement judged(
    const std::string& name, const std::function<void(Trajectory&)>& spoil = [](Trajectory&) {}) {
  const ReferenceCase reference = reference_of(name);
  const Expectation expectation(reference);
  Trajectory run = exact_run(reference, 1e-3);
  spoil(run);
  return judge(expectation, run, audited_impacts(reference, run), "float64");
}

constexpr const char* standard = "breakwater/1910121100";

TEST(Judgement, OfTheExactMotionIsWithoutAFault) {
  for (const char* name : {standard, "bouncing-ball", "elastic-box", "crane-load"}) {
    const Judgement found = judged(name);
    EXPECT_FALSE(found.rebounds.wrong()) << name;
    EXPECT_EQ(found.following.ratio.value_or(1.0), 0.0) << name;
    EXPECT_EQ(found.following.rounding.value_or(1.0), 0.0) << name;
    EXPECT_EQ(found.impacts.missed, 0U) << name;
    EXPECT_LE(found.energy, 1e-3) << name;
    EXPECT_LE(found.flight, 1e-9) << name;
  }
}

TEST(Judgement, FindsAPositionThatIsOff) {
  const Judgement found = judged(standard, [](Trajectory& run) {
    for (Point& point : run.points) {
      point.state.position.x() += 0.02 * point.time;
    }
  });
  EXPECT_GT(found.following.ratio.value_or(0.0), most_ratio);
  EXPECT_GT(found.following.error, 0.0);
}

TEST(Judgement, HoldsARunThatLocatesItsImpactsToRounding) {
  const Judgement found = judged(standard, [](Trajectory& run) {
    for (Point& point : run.points) {
      point.state.position.x() += 1e-10;
    }
  });
  EXPECT_LT(found.following.ratio.value_or(1.0), exact_ratio);
  EXPECT_GT(found.following.rounding.value_or(0.0), most_rounding);
  EXPECT_FALSE(judged(standard,
                      [](Trajectory& run) {
                        for (RecordedImpact& impact : run.impacts) {
                          impact.steps = 1;
                        }
                      })
                   .following.rounding)
      << "a run of steps is not held to rounding";
}

TEST(Judgement, FindsAnImpactThatIsMissed) {
  const Judgement found =
      judged(standard, [](Trajectory& run) { run.impacts.erase(run.impacts.begin() + 1); });
  EXPECT_EQ(found.impacts.missed, 1U);
  EXPECT_GE(found.impacts.due, 5U);
}

TEST(Judgement, FindsARiseOfEnergyOutsideContactsAlone) {
  const auto faster = [](double from, double until) {
    return [=](Trajectory& run) {
      for (Point& point : run.points) {
        if (point.time > from && point.time < until) {
          point.state.velocity *= 2.0;
        }
      }
    };
  };
  const double hit = exact_run(reference_of(standard), 1e-3).impacts.front().time;
  EXPECT_GT(judged(standard, faster(hit + 0.05, hit + 0.1)).energy, most_energy);
  EXPECT_LT(judged(standard, faster(hit - 1e-3, hit + 1.5e-3)).energy, most_energy);
}

TEST(Judgement, FindsAWrongGravityAndASpinThatFades) {
  const double weight = reference_of(standard).the_case.gravity.norm();
  const Judgement heavy = judged(standard, [weight](Trajectory& run) {
    for (Point& point : run.points) {
      point.state.velocity.y() -= 0.01 * weight * point.time;
    }
  });
  EXPECT_NEAR(heavy.flight, 0.01, 1e-6);
  const Judgement fading = judged(standard, [](Trajectory& run) {
    for (Point& point : run.points) {
      point.state.spin *= std::exp(-point.time);
    }
  });
  EXPECT_GT(fading.flight, most_flight);
}

TEST(Judgement, LeavesWhatFloatsRoundToOneSideInFlight) {
  const ReferenceCase reference = reference_of(standard);
  const Expectation expectation(reference);
  Trajectory run = exact_run(reference, 1e-3);
  const double half_ulp = 6e-8 * expectation.speed();
  for (std::size_t step = 0; step < run.points.size(); ++step) {
    run.points[step].state.velocity.y() -= half_ulp * static_cast<double>(step);
  }
  const std::vector<AuditedImpact> impacts = audited_impacts(reference, run);
  EXPECT_GT(judge(expectation, run, impacts, "float64").flight, 1e-5);
  EXPECT_EQ(judge(expectation, run, impacts, "float32").flight, 0.0);
}

TEST(Judgement, TellsNothingOfAFreeFlight) {
  ReferenceCase reference = reference_of("bouncing-ball");
  reference.the_case.duration = 0.1;
  reference = solve_cases({reference.the_case}, ImpactLaw::simultaneous).front();
  const Expectation expectation(reference);
  const Trajectory run = exact_run(reference, 1e-3);
  EXPECT_FALSE(judge(expectation, run, {}, "float64").following.ratio);
}

TEST(Judgement, FindsACableThatIsTooLong) {
  EXPECT_GT(judged(standard, [](Trajectory& run) { run.overstretch = 0.01; }).overstretch,
            most_overstretch);
}

TEST(Judgement, LeavesOutWhatIsNextToACaptureSpeed) {
  ReferenceCase reference = reference_of("bouncing-ball");
  reference.the_case.cables.front().capture_speed = 0.25;
  reference = solve_cases({reference.the_case}, ImpactLaw::simultaneous).front();
  Trajectory run = exact_run(reference, 1e-3);
  RecordedImpact impact = run.impacts.front();
  impact.rate_before = -0.2501;  // a step earlier it would have been below
  impact.rate_after = 0.0;
  run.impacts = {impact};
  EXPECT_TRUE(audited_impacts(reference, run).empty());
  run.impacts.front().rate_before = -0.3;
  EXPECT_EQ(audited_impacts(reference, run).size(), 1U);
}

TEST(Allowance, IsOfFirstOrderAndEndsWhereASchemeCanFollowNoFurther) {
  const ReferenceCase reference = reference_of(standard);
  const Expectation expectation(reference);
  const Allowance& coarse = expectation.allowance(1e-2);
  const Allowance& fine = expectation.allowance(1e-3);
  EXPECT_LT(coarse.until, fine.until);
  EXPECT_NEAR(coarse.position.at(0.3) / fine.position.at(0.3), 10.0, 4.0);
  EXPECT_EQ(expectation.allowance(1e-3).until, fine.until);
}

TEST(Allowance, OfCablesIsLargerWhereABodySpinsFast) {
  ReferenceCase reference = reference_of(standard);
  Case the_case = reference.the_case;
  the_case.cables.resize(1);
  the_case.cables.front().attachment = {0.2, 0.0};
  the_case.body.inertia = 0.002 * the_case.body.mass;
  the_case.initial.position = the_case.cables.front().anchor - Vec2(0.0, 0.5);
  the_case.initial.spin = 15.0;
  the_case.cables.front().length = 1.0;
  reference = solve_cases({the_case}, ImpactLaw::simultaneous).front();
  const Expectation expectation(reference);
  const Allowance& allowance = expectation.allowance(1e-3);
  const double until = allowance.until;
  EXPECT_GT(allowance.of_cables(until), 2.0 * allowance.at(until));
  EXPECT_GT(expectation.turning(), 15.0 * 15.0 * 0.2 - 1e-9);
  // in floats the coordinates lose a digit in every step
  EXPECT_GT(expectation.allowance(1e-3, "float32").at(until), allowance.at(until));
}

TEST(Allowance, EndsWhereImpactsMaySwap) {
  // cable 1 is hit at 2.0297 s and cable 0 at 2.0319 s: steps of 1e-3 s may take the one for the
  // other
  const ReferenceCase reference = reference_of("breakwater/1911121100");
  const Allowance& allowance = Expectation(reference).allowance(1e-3);
  EXPECT_EQ(allowance.barrier, Barrier::fork);
  EXPECT_LE(allowance.until, 2.03);
}

TEST(Allowance, OfTwoCablesStruckTogetherIsJudgedByTheLawThatStrikesThemTogether) {
  const std::string name = "level-beam";
  const std::vector<Case> cases = select_cases({&name, 1}).cases;
  const ReferenceCase together = solve_cases(cases, ImpactLaw::simultaneous).front();
  const ReferenceCase in_turn = solve_cases(cases, ImpactLaw::sequential).front();
  const double first = together.solution.events().front().time;
  EXPECT_GT(Expectation(together).allowance(1e-4).until, first - 1e-4);
  EXPECT_LT(Expectation(in_turn).allowance(1e-4).until, first - 1e-4);
}

/// A run with these impacts, each with what it asks for and what comes back.
struct RunOf {
  RunAudit audit;
  Judgement judgement;

  RunOf(const std::vector<std::pair<double, double>>& impacts, bool located) {
    for (const auto& [asked, got] : impacts) {
      AuditedImpact impact;
      impact.speed = 1.0;
      impact.requested = asked;
      impact.effective = got;
      impact.steps = 1;
      audit.impacts.push_back(impact);
    }
    judgement.rebounds = rebounds_of(audit.impacts);
    judgement.following.ratio = 0.01;
    judgement.following.located = located;
  }
  [[nodiscard]] JudgedRun in(const std::string& name) const {
    return {{name, "engine", "model", 1e-3, &audit}, &judgement};
  }
};

TEST(Course, IsExactOnlyOfRunsThatLocateTheirImpacts) {
  const RunOf blind({{0.5, 0.5}, {0.5, 0.5}, {0.5, 0.5}}, false);
  const RunOf seeing({{0.5, 0.5}, {0.5, 0.5}, {0.5, 0.5}}, true);
  EXPECT_EQ(models_of({blind.in("a")}).front().course, Course::as_good);
  EXPECT_EQ(models_of({seeing.in("a")}).front().course, Course::exact);
  EXPECT_EQ(models_of({seeing.in("a"), blind.in("b")}).front().course, Course::as_good);
}

TEST(Model, OfTwoFaultsHasOneAndNoMixture) {
  const RunOf high({{0.0, 0.16}, {0.0, 0.16}, {0.0, 0.16}}, false);
  const RunOf lost({{0.8, 0.0}, {0.8, 0.8}, {0.8, 0.8}, {0.8, 0.8}}, false);
  EXPECT_EQ(models_of({high.in("a"), lost.in("b")}).front().rebounds.word, Rebound::off);
  EXPECT_EQ(models_of({lost.in("b"), high.in("a")}).front().rebounds.word, Rebound::off);
}

TEST(Course, IsOfTheRatiosAsTheStepFalls) {
  const std::vector<double> steps = {1e-2, 1e-3, 1e-4};
  EXPECT_EQ(course_of(steps, {0.01, 0.1, 0.2}), Course::exact);
  EXPECT_EQ(course_of(steps, {0.1, 0.9, 1.4}), Course::as_good);
  EXPECT_EQ(course_of(steps, {8.4, 8.0, 8.2}), Course::converges);
  EXPECT_EQ(course_of(steps, {1.0, 9.3, 110.0}), Course::does_not_converge);
  EXPECT_EQ(course_of({1e-3}, {3.0}), Course::off);
  EXPECT_EQ(course_of({}, {}), Course::untold);
}

TEST(StepNeeded, SaysWhereAnyStepDoesAndWhereThePlainSchemeHasAnotherLaw) {
  EXPECT_FALSE(step_needed(reference_of("bouncing-ball"), usual_part).longest);
  const StepNeeded any = step_needed(reference_of("bouncing-ball"), 0.5);
  EXPECT_TRUE(any.longest);
  EXPECT_DOUBLE_EQ(any.safe, 0.02);
  const auto of_beam = [](ImpactLaw law, bool one_restitution) {
    Case beam = reference_of("level-beam").the_case;
    if (one_restitution) {
      beam.cables[1].restitution = beam.cables[0].restitution;
    }
    return step_needed(solve_cases({beam}, law).front(), usual_part);
  };
  const StepNeeded in_turn = of_beam(ImpactLaw::sequential, false);
  ASSERT_TRUE(in_turn.unlike);
  EXPECT_EQ(in_turn.safe, 0.0);
  EXPECT_TRUE(of_beam(ImpactLaw::poisson, false).unlike);
  // with one restitution for all cables the law of Poisson is the plain scheme's
  const StepNeeded poisson = of_beam(ImpactLaw::poisson, true);
  EXPECT_FALSE(poisson.unlike);
  EXPECT_GT(poisson.safe, 0.0);
}

TEST(Predictable, ImpactsNextToTheCaptureSpeedCannotBeRead) {
  ReferenceCase reference = reference_of("bouncing-ball");
  const std::vector<ExactHit> hits = exact_hits(reference, reference.solution.end_time());
  ASSERT_GT(hits.size(), 2U);
  double& capture = reference.the_case.cables.front().capture_speed;
  capture = 0.5 * (hits[1].speed + hits[2].speed);
  const std::size_t far = readable_impacts(reference, 1e-3);
  capture = 0.999 * hits[1].speed;
  EXPECT_EQ(readable_impacts(reference, 1e-3), far - 1);
}

TEST(StepNeeded, IsLargeOfAHeavyLoadAndSmallOfAFastRod) {
  const StepNeeded load = step_needed(reference_of("crane-load"), usual_part);
  EXPECT_DOUBLE_EQ(load.safe, 0.01);
  const StepNeeded rod = step_needed(reference_of("spinning-rod"), usual_part);
  EXPECT_LE(rod.safe, 5e-5);
  EXPECT_GE(rod.typical, rod.safe);
  EXPECT_DOUBLE_EQ(rounded_down(0.0099), 0.005);
  EXPECT_DOUBLE_EQ(rounded_down(0.01), 0.01);
  EXPECT_DOUBLE_EQ(next_smaller(0.01), 0.005);
  EXPECT_DOUBLE_EQ(next_smaller(0.005), 0.002);
  EXPECT_DOUBLE_EQ(next_smaller(0.002), 0.001);
}

}  // namespace
}  // namespace tautline::bench
