// The restitution audit finds what is planted into exact motions, and nothing in those without.

#include "bench/measure/audit.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <functional>

#include "bench/measure/compare.hpp"
#include "tautline/geometry.hpp"
#include "tautline/scenarios.hpp"

namespace tautline::bench {
namespace {

constexpr double run_step = 1e-3;  // [s]

/// Changes an impact of an exact motion; the first argument counts them from 0.
using Change = std::function<void(std::size_t index, const Case& the_case, RecordedImpact& impact)>;

/// The impact comes back with restitution `e`.
void rebound(const Case& the_case, RecordedImpact& impact, double e) {
  impact.rate_after = -e * impact.rate_before;
  const Eigen::Vector3d pull = gap_gradient(the_case.cables[impact.cable], impact.before);
  impact.after.velocity = impact.before.velocity + (1.0 + e) * -impact.rate_before * pull.head<2>();
}

double requested(const Case& the_case, const RecordedImpact& impact) {
  return restitution(the_case.cables[impact.cable], impact.rate_before);
}

/// The exact motion as an engine's run, with changed impacts.
Trajectory exact_run(const ReferenceCase& reference, const Change& change) {
  Trajectory run;
  run.step = run_step;
  const Case& the_case = reference.the_case;
  const Solution& solution = reference.solution;
  for (std::size_t i = 0; static_cast<double>(i) * 0.01 < solution.end_time(); ++i) {
    const double time = static_cast<double>(i) * 0.01;
    run.points.push_back({time, solution.at(time)});
  }
  for (const Event& event : solution.events()) {
    for (const std::size_t index : event.cables) {
      const Cable& cable = the_case.cables[index];
      RecordedImpact impact{event.time,
                            index,
                            1.0,
                            gap_rate(cable, event.before),
                            gap_rate(cable, event.after),
                            0,
                            event.before,
                            event.after};
      if (event.kind == EventKind::impact && -impact.rate_before > 1e-3) {
        change(run.impacts.size(), the_case, impact);
        run.impacts.push_back(impact);
      }
    }
  }
  return run;
}

/// The exact sides of some cases with e = 0.5 to 0.9, solved once.
const std::vector<ReferenceCase>& references() {
  static const std::vector<ReferenceCase> solved = [] {
    std::vector<Case> cases;
    for (const Case& the_case : shipped_cases()) {
      for (const char* name : {"breakwater/1910121100", "breakwater/1710121100",
                               "breakwater/1510121100", "breakwater/1930121100", "bouncing-ball"}) {
        if (the_case.name == name) {
          cases.push_back(the_case);
        }
      }
    }
    return solve_cases(cases, ImpactLaw::simultaneous);
  }();
  return solved;
}

/// One model that ran every case, as `run_of` made it.
struct Audits {
  std::vector<RunAudit> runs;  // by reference
  std::vector<Finding> findings;
};

Audits audits_of(const std::function<Trajectory(const ReferenceCase&)>& run_of,
                 double at_step = run_step) {
  Audits result;
  for (const ReferenceCase& reference : references()) {
    Trajectory run = run_of(reference);
    run.step = at_step;
    result.runs.push_back(audit(reference, run, CompareOptions().count_speed));
  }
  std::vector<AuditedRun> runs;
  for (std::size_t index = 0; index < references().size(); ++index) {
    runs.push_back({references()[index].the_case.name, "planted", "model", &result.runs[index]});
  }
  result.findings = findings(runs);
  return result;
}

std::vector<Finding> findings_of(const Change& change, double at_step = run_step) {
  return audits_of([&](const ReferenceCase& reference) { return exact_run(reference, change); },
                   at_step)
      .findings;
}

std::string told(const std::vector<Finding>& findings) {
  std::string text;
  for (const Finding& finding : findings) {
    text += finding.kind + ": " + finding.sentence + "\n";
  }
  return text;
}

/// The only finding, or an empty one where there is none or another; what there is is told.
Finding only(const std::vector<Finding>& findings, const std::string& kind) {
  if (findings.size() != 1 || findings.front().kind != kind) {
    ADD_FAILURE() << "no " << kind << " alone: " << told(findings);
    return {};
  }
  return findings.front();
}

double value_of(const Finding& finding) { return finding.value.value_or(NAN); }

TEST(Audit, FindsNothingInExactMotions) {
  EXPECT_EQ(told(findings_of([](auto, const auto&, auto&) {})), "");
}

TEST(Audit, FindsTheSpeedBelowWhichBouncesAreLost) {
  for (const double threshold : {0.08, 0.15, 0.3}) {
    const auto finding = only(findings_of([&](auto, const Case& the_case, RecordedImpact& impact) {
                                if (-impact.rate_before < threshold) {
                                  rebound(the_case, impact, 0.0);
                                }
                              }),
                              "threshold");
    EXPECT_NEAR(value_of(finding), threshold, 0.1 * threshold);
    EXPECT_TRUE(finding.sentence.starts_with("bounces slower than"));
  }
}

TEST(Audit, FindsRestitutionThatIsIgnored) {
  for (const double e : {0.0, 0.3}) {
    const auto finding = only(findings_of([&](auto, const Case& the_case, RecordedImpact& impact) {
                                rebound(the_case, impact, e);
                              }),
                              "restitution-ignored");
    EXPECT_NEAR(value_of(finding), e, 1e-5);
  }
}

TEST(Audit, FindsReboundsThatAreTooFastOrTooSlow) {
  for (const auto& [by, kind] : {std::pair(0.1, "gain"), std::pair(-0.1, "offset")}) {
    const double off = by;
    const auto finding = only(findings_of([&](auto, const Case& the_case, RecordedImpact& impact) {
                                rebound(the_case, impact, requested(the_case, impact) + off);
                              }),
                              kind);
    EXPECT_NEAR(value_of(finding), off, 1e-4);
  }
}

TEST(Audit, FindsScatterAndItsSize) {
  const auto finding =
      only(findings_of([&](std::size_t index, const Case& the_case, RecordedImpact& impact) {
             const double off = index % 2 == 0 ? 0.06 : -0.06;
             rebound(the_case, impact, requested(the_case, impact) + off);
           }),
           "scatter");
  EXPECT_NEAR(value_of(finding), 0.06, 1e-3);
}

/// At this step an error of e is far larger than what a step does [s].
constexpr double fine_step = 1e-5;

TEST(Audit, AnErrorInProportionIsNoScatter) {
  for (const double factor : {1.024, 0.9}) {
    const double by = factor;
    const auto finding = only(findings_of(
                                  [&](auto, const Case& the_case, RecordedImpact& impact) {
                                    rebound(the_case, impact, by * requested(the_case, impact));
                                  },
                                  fine_step),
                              factor > 1.0 ? "gain" : "offset");
    EXPECT_NEAR(value_of(finding), (factor - 1.0) * 0.9, 0.5 * std::abs(factor - 1.0));
  }
}

TEST(Audit, SaysNothingOfAnErrorThatIsSmall) {
  EXPECT_EQ(told(findings_of(
                [](std::size_t index, const Case& the_case, RecordedImpact& impact) {
                  const double off = index % 2 == 0 ? 0.01 : -0.005;
                  rebound(the_case, impact, requested(the_case, impact) + off);
                },
                fine_step)),
            "");
}

TEST(Audit, FindsImpactsOfSeveralSteps) {
  const auto finding =
      only(findings_of([](auto, const auto&, RecordedImpact& impact) { impact.steps = 4; }),
           "several-steps");
  EXPECT_EQ(value_of(finding), 4.0);
}

TEST(Audit, FindsMomentumThatNoCableGives) {
  const auto across = only(
      findings_of([](auto, const Case& the_case, RecordedImpact& impact) {
        const Vec2 along = gap_gradient(the_case.cables[impact.cable], impact.before).head<2>();
        impact.stray.head<2>() = -0.3 * impact.rate_before * perpendicular(along);
      }),
      "tangential-impulse");
  EXPECT_GT(value_of(across), 0.1);
  const auto turning = only(findings_of([](auto, const Case& the_case, RecordedImpact& impact) {
                              impact.stray[2] =
                                  -0.3 * impact.rate_before * std::sqrt(the_case.body.inertia);
                            }),
                            "angular-impulse");
  EXPECT_GT(value_of(turning), 0.1);
}

TEST(Audit, SaysNothingOfTwoImpacts) {
  EXPECT_EQ(told(findings_of([](std::size_t index, const Case& the_case, RecordedImpact& impact) {
              if (the_case.name == "bouncing-ball" && index < 2) {
                rebound(the_case, impact, 0.0);
              }
            })),
            "");
}

/// The exact run, standing still from `time` [s] on where it is then.
Trajectory frozen_run(const ReferenceCase& reference, double time) {
  Trajectory run = exact_run(reference, [](auto, const auto&, auto&) {});
  std::erase_if(run.impacts, [=](const RecordedImpact& impact) { return impact.time > time; });
  for (Point& point : run.points) {
    if (point.time > time) {
      point.state = reference.solution.at(time);
      point.state.velocity = Vec2::Zero();
      point.state.spin = 0.0;
    }
  }
  return run;
}

TEST(Audit, FindsABodyThatIsPutToSleep) {
  const auto finding = only(
      audits_of([](const ReferenceCase& reference) { return frozen_run(reference, 4.3); }).findings,
      "sleeping");
  EXPECT_NEAR(value_of(finding), 4.3, 0.011);  // the next sample
  // the ball has come to rest by then, in the exact motion too
  EXPECT_EQ(finding.runs, references().size() - 1);
}

TEST(Audit, ABodyThatComesToRestIsNotAsleep) {
  const auto slowing = [](const ReferenceCase& reference) {
    Trajectory run = exact_run(reference, [](auto, const auto&, auto&) {});
    const State end = run.points.back().state;
    for (Point& point : run.points) {
      const double left = std::exp(-2.0 * point.time);
      point.state.position = end.position + left * (point.state.position - end.position);
      point.state.angle = end.angle + left * (point.state.angle - end.angle);
    }
    return run;
  };
  for (const Finding& finding : audits_of(slowing).findings) {
    EXPECT_NE(finding.kind, "sleeping") << finding.sentence;
  }
}

TEST(Audit, TheLadderOfTheBallIsThatOfItsRestitution) {
  const Audits audits = audits_of([](const ReferenceCase& reference) {
    return exact_run(reference, [](auto, const auto&, auto&) {});
  });
  std::size_t ladders = 0;
  for (std::size_t index = 0; index < references().size(); ++index) {
    const std::optional<Ladder>& ladder = audits.runs[index].ladder;
    if (references()[index].the_case.name != "bouncing-ball") {
      EXPECT_FALSE(ladder);
      continue;
    }
    ++ladders;
    ASSERT_TRUE(ladder);
    EXPECT_EQ(ladder->exact_ratio, 0.25);
    ASSERT_GE(ladder->heights.size(), 5U);
    for (std::size_t n = 0; n < ladder->heights.size(); ++n) {
      const double exact = std::pow(0.25, static_cast<double>(n + 1));
      EXPECT_NEAR(ladder->exact.at(n), exact, 1e-12 * exact);
      EXPECT_NEAR(ladder->heights[n], exact, 1e-9 * exact);
    }
  }
  EXPECT_EQ(ladders, 1U);
}

}  // namespace
}  // namespace tautline::bench
