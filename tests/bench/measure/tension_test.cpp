// Tensions and the first impulse of a run beside those of the exact motion.

#include <gtest/gtest.h>

#include <cmath>

#include "bench/measure/compare.hpp"
#include "bench/measure/metric_list.hpp"
#include "bench/measure/tension_match.hpp"
#include "tautline/geometry.hpp"
#include "tautline/scenarios.hpp"
#include "tautline/settling.hpp"
#include "tautline/solve.hpp"

namespace tautline::bench {
namespace {

/// A box of 5 kg on two vertical ropes, let go 0.5 m above their end: it stops and hangs.
Case hanging_box() {
  Case the_case;
  the_case.name = "hanging-box";
  the_case.duration = 4.0;
  the_case.gravity = Vec2(0.0, -9.81);
  the_case.body = {5.0, 5.0 / 6.0};
  for (const double x : {-0.5, 0.5}) {
    the_case.cables.push_back({Vec2(x, 5.0), Vec2(x, 0.5), 3.0, 0.0});
  }
  the_case.initial.position = Vec2(0.0, 2.0);
  return the_case;
}

/// What an engine with steps of 1e-3 s would tell: the exact tensions times `factor`, and in the
/// step of the impact its impulse, too.
void add_tensions(const Solution& solution, double factor, Trajectory& run) {
  for (const Point& point : run.points) {
    CableVector tensions = factor * solution.tensions(point.time);
    for (const Event& event : solution.events()) {
      if (event.kind == EventKind::impact && std::abs(event.time - point.time) < run.step) {
        tensions.array() += event.impulses.sum() / run.step;
      }
    }
    run.tensions.insert(run.tensions.end(), tensions.begin(), tensions.end());
  }
}

/// The exact motion and its impacts as a run.
Trajectory as_run(const Case& the_case, const Solution& solution) {
  Trajectory run;
  run.step = 1e-3;
  for (double time = 0.0; time < solution.end_time(); time += run.step) {
    run.points.push_back({time, solution.at(time)});
  }
  for (const Event& event : solution.events()) {
    Eigen::Index row = 0;
    for (const std::size_t index : event.cables) {
      if (event.kind == EventKind::impact) {
        const Cable& cable = the_case.cables[index];
        run.impacts.push_back({event.time, index, event.impulses[row++],
                               gap_rate(cable, event.before), gap_rate(cable, event.after), 0,
                               event.before, event.after});
      }
    }
  }
  return run;
}

Metrics metrics_of(const Case& the_case, const Solution& solution, const Trajectory& run) {
  return compare(the_case, solution, settling(the_case, solution), solution.end_time(), run);
}

TEST(Tensions, AtRestAndTheLargestAreThoseOfStatics) {
  const Case the_case = hanging_box();
  const Solution solution = solve(the_case);
  ASSERT_EQ(solution.ending(), Ending::rest);
  Trajectory run = as_run(the_case, solution);
  add_tensions(solution, 1.01, run);
  const Metrics metrics = metrics_of(the_case, solution, run);
  ASSERT_TRUE(metrics.rest_tension && metrics.largest_tension);
  const double half_weight = 0.5 * 5.0 * 9.81;  // [N]
  for (const ExactAndFound& tension : {*metrics.rest_tension, *metrics.largest_tension}) {
    EXPECT_NEAR(tension.exact, half_weight, 1e-11);
    EXPECT_NEAR(tension.found, 1.01 * half_weight, 1e-9) << "without the impulse of the impact";
  }
  EXPECT_FALSE(metrics.first_impulse) << "two cables share it";
  const MetricValues values = values_of(metrics);
  EXPECT_NEAR(values[place_of("rest_tension_error").value()].value(), 0.01 * half_weight, 1e-9);
  EXPECT_NEAR(values[place_of("largest_tension_error").value()].value(), 0.01 * half_weight, 1e-9);
}

TEST(Tensions, AreAbsentWhereThereAreNoneToCompare) {
  const Case box = hanging_box();
  const Solution hangs = solve(box);
  const Metrics untold = metrics_of(box, hangs, as_run(box, hangs));
  EXPECT_FALSE(untold.rest_tension || untold.largest_tension) << "the engine tells none";

  Case elastic = bouncing_ball(1.0);  // never taut
  elastic.duration = 3.0;
  const Solution bounces = solve(elastic);
  Trajectory slack = as_run(elastic, bounces);
  add_tensions(bounces, 1.0, slack);
  const Metrics metrics = metrics_of(elastic, bounces, slack);
  EXPECT_FALSE(metrics.rest_tension || metrics.largest_tension);
  ASSERT_TRUE(metrics.first_impulse);
  EXPECT_EQ(metrics.first_impulse->exact, metrics.first_impulse->found);
  EXPECT_GT(metrics.first_impulse->exact, 0.0);

  Case four = box;  // statics do not say what each of four ropes takes
  for (const double x : {-0.25, 0.25}) {
    four.cables.push_back({Vec2(x, 5.0), Vec2(x, 0.5), 3.0, 0.0});
  }
  const Solution redundant = solve(four);
  Trajectory run = as_run(four, redundant);
  add_tensions(redundant, 1.0, run);
  EXPECT_FALSE(metrics_of(four, redundant, run).rest_tension);
}

TEST(Tensions, TheLargestOfARunIsThatOfTheStepsWithoutAnImpact) {
  Trajectory run;
  run.step = 0.1;
  for (int step = 0; step < 20; ++step) {
    run.points.push_back({run.step * step, {}});
  }
  EXPECT_FALSE(largest_tension(run)) << "the engine tells none";
  run.tensions.assign(2 * run.points.size(), 1.0);
  run.tensions[0] = run.tensions[1] = std::nan("");  // no step leads to the start
  run.tensions[2 * 4 + 1] = 500.0;                   // of an impact
  run.tensions[2 * 8] = 40.0;                        // of what it leaves to the steps after it
  run.tensions[2 * 19 + 1] = 7.0;
  RecordedImpact impact{0.35, 1, 50.0, -1.0, 1.0, 0, {}, {}};
  run.impacts = {impact};
  EXPECT_EQ(largest_tension(run), 500.0) << "an impact that is located is not in the tensions";
  impact.time = 0.3;  // the step that it is in, from its start
  impact.steps = 1;
  run.impacts = {impact};
  EXPECT_EQ(largest_tension(run), 7.0);
  run.tensions.assign(run.tensions.size(), 0.0);
  EXPECT_EQ(largest_tension(run), 0.0) << "no cable pulls";
}

}  // namespace
}  // namespace tautline::bench
