// The audit finds what is planted into exact motions, and nothing in those without.

#include "bench/judge/models.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <functional>

#include "bench/measure/audit.hpp"
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
    runs.push_back(
        {references()[index].the_case.name, "planted", "model", 0.0, &result.runs[index]});
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

/// What is said of the rebounds of all cases together.
Rebounds rebounds_with(const Change& change, double at_step = run_step) {
  std::vector<AuditedImpact> impacts;
  for (const RunAudit& run :
       audits_of([&](const ReferenceCase& reference) { return exact_run(reference, change); },
                 at_step)
           .runs) {
    impacts.insert(impacts.end(), run.impacts.begin(), run.impacts.end());
  }
  return rebounds_of(impacts);
}

TEST(Audit, FindsNothingInExactMotions) {
  EXPECT_EQ(told(findings_of([](auto, const auto&, auto&) {})), "");
}

TEST(Rebounds, OfExactMotionsAreKept) {
  const Rebounds kept = rebounds_with([](auto, const auto&, auto&) {});
  EXPECT_EQ(kept.word, Rebound::kept);
  EXPECT_GE(kept.readable, 20U);
  EXPECT_EQ(words_of(kept).rfind("kept (", 0), 0U) << words_of(kept);
}

TEST(Rebounds, ThatAreLostHaveTheSpeedBelowWhichTheyAre) {
  for (const double threshold : {0.08, 0.15, 0.3}) {
    const Rebounds lost = rebounds_with([&](auto, const Case& the_case, RecordedImpact& impact) {
      if (-impact.rate_before < threshold) {
        rebound(the_case, impact, 0.0);
      }
    });
    EXPECT_EQ(lost.word, Rebound::lost_below) << threshold;
    EXPECT_LE(lost.speed.value_or(0.0), threshold);
    EXPECT_GE(lost.speed.value_or(0.0), 0.9 * threshold);
  }
}

TEST(Rebounds, AreNoneWhereNothingComesBack) {
  const Rebounds none = rebounds_with(
      [](auto, const Case& the_case, RecordedImpact& impact) { rebound(the_case, impact, 0.0); });
  EXPECT_EQ(none.word, Rebound::none);
  EXPECT_EQ(words_of(none).rfind("none: ", 0), 0U) << words_of(none);
}

TEST(Rebounds, ThatAreTooFastOrTooSlowAreOffByTheMedian) {
  for (const double off : {0.1, -0.1}) {
    const Rebounds found = rebounds_with([&](auto, const Case& the_case, RecordedImpact& impact) {
      rebound(the_case, impact, requested(the_case, impact) + off);
    });
    EXPECT_EQ(found.word, Rebound::off);
    EXPECT_NEAR(found.deviation.value_or(0.0), off, 1e-4);
    EXPECT_NE(words_of(found).find(off > 0.0 ? "0.1 too high (" : "0.1 too low ("),
              std::string::npos)
        << words_of(found);
  }
}

TEST(Rebounds, ThatAreTooFastAndLostWhereTheyAreSlowAreBoth) {
  const Rebounds both = rebounds_with([](auto, const Case& the_case, RecordedImpact& impact) {
    rebound(the_case, impact, -impact.rate_before < 0.1 ? 0.0 : requested(the_case, impact) + 0.1);
  });
  EXPECT_EQ(both.word, Rebound::off);
  EXPECT_NEAR(both.speed.value_or(0.0), 0.1, 0.01);
  EXPECT_NE(words_of(both).find("; lost below 0."), std::string::npos) << words_of(both);
}

TEST(Rebounds, ThatAreOffToBothSidesScatter) {
  const Rebounds found =
      rebounds_with([](std::size_t index, const Case& the_case, RecordedImpact& impact) {
        rebound(the_case, impact, requested(the_case, impact) + (index % 2 == 0 ? 0.06 : -0.06));
      });
  EXPECT_EQ(found.word, Rebound::scatters);
}

/// At this step an error of e is far larger than what a step does [s].
constexpr double fine_step = 1e-5;

TEST(Rebounds, InProportionToTheirSpeedAreOff) {
  for (const double factor : {1.024, 0.9}) {
    const Rebounds found = rebounds_with(
        [&](auto, const Case& the_case, RecordedImpact& impact) {
          rebound(the_case, impact, factor * requested(the_case, impact));
        },
        fine_step);
    EXPECT_EQ(found.word, Rebound::off) << factor;
  }
}

TEST(Rebounds, WithAnErrorThatIsSmallAreKept) {
  const Rebounds kept = rebounds_with(
      [](std::size_t index, const Case& the_case, RecordedImpact& impact) {
        const double off = index % 2 == 0 ? 0.0015 : -0.0015;
        rebound(the_case, impact, requested(the_case, impact) + off);
      },
      fine_step);
  EXPECT_EQ(kept.word, Rebound::kept);
}

TEST(Rebounds, OneBeyondTheBoundProvesAFault) {
  const Rebounds found =
      rebounds_with([](std::size_t index, const Case& the_case, RecordedImpact& impact) {
        if (the_case.name == "bouncing-ball" && index == 0) {
          rebound(the_case, impact, 0.0);
        }
      });
  EXPECT_EQ(found.word, Rebound::loses_some);
  EXPECT_EQ(found.off, 1U);
}

TEST(Rebounds, OfTwoImpactsAreTooFewToTell) {
  AuditedImpact impact;
  impact.speed = 1.0;
  impact.requested = impact.effective = 0.5;
  impact.rate_floor = 0.01;
  impact.steps = 1;
  EXPECT_EQ(words_of(rebounds_of({impact, impact})), "too few to tell (2 impacts)");
  EXPECT_EQ(words_of(rebounds_of({impact, impact, impact})), "kept (3 impacts, from 1 m/s on)");
  EXPECT_EQ(words_of(rebounds_of({}, StaysTaut{2.96})), "none: stays taut after 2.96 m/s");
  impact.steps = 17;
  EXPECT_EQ(words_of(rebounds_of({impact, impact, impact})),
            "kept (3 impacts, from 1 m/s on), in 17 steps");
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
