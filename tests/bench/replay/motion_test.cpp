// The motions in a report: drawn from few numbers, yet within a pixel of what was recorded, and
// within a size that a page can load.

#include "bench/replay/motion.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <nlohmann/json.hpp>
#include <random>

#include "bench/replay/path.hpp"
#include "bench/report/json/json.hpp"
#include "tautline/geometry.hpp"
#include "tautline/scenarios.hpp"
#include "tautline/system_geometry.hpp"
#include "tests/bench/support.hpp"

namespace tautline::bench {
namespace {

using nlohmann::json;

ReferenceCase reference_of(const Case& the_case) {
  return solve_cases({the_case}, ImpactLaw::simultaneous).front();
}

/// A pixel of a picture that is a thousand wide [m].
double pixel(const ReferenceCase& reference) { return 1e-3 * drawn_extent(reference); }

/// `path` as a page has it: written as JSON and read back.
Path as_read(const Path& path) {
  RunRecord record;
  record.replay.path = path;
  return *record_from(record_json(record, "it"), "it").value().replay.path;
}

/// How far centre and attachments are from `state` [m], at most.
double distance(const Case& the_case, const Eigen::Vector3d& pose, const State& state) {
  return (Vec2(pose.head<2>()) - state.position).norm() +
         attachment_radius(the_case) * std::abs(pose[2] - state.angle);
}

/// The exact motion as an engine would record it that locates its impacts.
template <class TheCase, class TheSettling>
BasicTrajectory<TheCase> located_run(const BasicReference<TheCase, TheSettling>& reference,
                                     double step) {
  BasicTrajectory<TheCase> run;
  run.step = step;
  const double end = reference.solution.end_time();
  for (std::size_t i = 0; static_cast<double>(i) * step < end; ++i) {
    const double time = static_cast<double>(i) * step;
    run.points.push_back({time, reference.solution.at(time)});
  }
  run.points.push_back({end, reference.solution.at(end)});
  for (const auto& event : reference.solution.events()) {
    if (event.kind == EventKind::impact) {
      const std::size_t cable = event.cables.indices().front();
      const auto& its = reference.the_case.cables[cable];
      run.impacts.push_back({event.time, cable, 1.0, gap_rate(its, event.before),
                             gap_rate(its, event.after), 0, event.before, event.after});
    }
  }
  return run;
}

/// What an engine does with fixed steps: it moves by the velocity that it has just changed, pushes
/// within a step, and pulls back what is too far.
Trajectory stepped_run(const Case& the_case, double step) {
  Trajectory run;
  run.step = step;
  State now = the_case.initial;
  run.points.push_back({0.0, now});
  const auto steps = static_cast<std::size_t>(the_case.duration / step);
  for (std::size_t i = 1; i <= steps; ++i) {
    const State before = now;
    now.velocity += step * the_case.gravity;
    for (std::size_t index = 0; index < the_case.cables.size(); ++index) {
      const Cable& cable = the_case.cables[index];
      const double rate = gap_rate(cable, now);
      if (gap(cable, now) > 0.0 || rate >= 0.0) {
        continue;
      }
      const CableSet one = CableSet::of(index);
      CableVector impulse(1);
      impulse << -(rate < -0.05 ? 1.0 + cable.restitution : 1.0) * rate /
                     delassus(the_case, now, one)(0, 0);
      now = with_impulses(the_case, now, one, impulse);
      if (rate < -0.05) {
        run.impacts.push_back({static_cast<double>(i - 1) * step, index, impulse[0],
                               gap_rate(cable, before), gap_rate(cable, now), 1, before, now});
      }
    }
    now.position += step * now.velocity;
    now.angle += step * now.spin;
    run.points.push_back({static_cast<double>(i) * step, now});
  }
  return run;
}

/// Expects `path` to be as near to every recorded sample as it says, and that to be near enough.
void expect_near(const ReferenceCase& reference, const Trajectory& run, double enough) {
  const Path path = as_read(run_path(reference.the_case, nearness_of(reference), run));
  const DrawnPath drawn(path);
  double worst = 0.0;
  double worst_energy = 0.0;
  for (const Point& point : run.points) {
    worst = std::max(worst, distance(reference.the_case, drawn.pose(point.time), point.state));
    const double recorded = energy(reference.the_case, point.state);
    worst_energy = std::max(worst_energy, std::abs(drawn.energy(point.time) - recorded));
  }
  EXPECT_LE(worst, path.error * (1.0 + 1e-9) + 1e-12) << "said: " << path.error;
  EXPECT_LE(path.error, enough) << reference.the_case.name << ", step " << run.step;
  EXPECT_LE(worst_energy, path.energy_error * (1.0 + 1e-9) + 1e-12)
      << "said: " << path.energy_error;
  EXPECT_LE(path.time.steps.size(), run.points.size() + run.impacts.size());
}

TEST(Motion, TheExactMotionIsDrawnWithinAPixelAtEveryInstant) {
  for (const std::size_t which : {0U, 2U, 6U, 8U}) {
    const ReferenceCase reference = reference_of(shipped_cases().at(which));
    const Path path = as_read(exact_replay(reference).path);
    const DrawnPath drawn(path);
    const double end = reference.solution.end_time();
    double worst = 0.0;
    double worst_energy = 0.0;
    constexpr int instants = 20'011;  // a prime: they fall on no sample
    for (int i = 0; i <= instants; ++i) {
      const double time = end * i / instants;
      const State state = reference.solution.at(time);
      worst = std::max(worst, distance(reference.the_case, drawn.pose(time), state));
      worst_energy =
          std::max(worst_energy, std::abs(drawn.energy(time) - energy(reference.the_case, state)));
    }
    // between two samples of the drawing it may be off by a little more than at them
    EXPECT_LE(worst, 1.2 * path.error) << reference.the_case.name;
    EXPECT_LE(worst, 0.5 * pixel(reference)) << reference.the_case.name;
    EXPECT_LE(worst_energy, 1.2 * path.energy_error) << reference.the_case.name;
    RecordProperty("pixels" + std::to_string(which), std::to_string(worst / pixel(reference)));
  }
}

TEST(Motion, ARunThatIsExactLiesOverTheExactMotionAtEveryInstant) {
  const ReferenceCase reference = reference_of(shipped_cases().front());
  const DrawnPath exact(as_read(exact_replay(reference).path));
  for (const double step : {1e-2, 1e-3}) {
    const Trajectory run = located_run(reference, step);
    const DrawnPath drawn(as_read(run_path(reference.the_case, nearness_of(reference), run)));
    double worst = 0.0;
    for (double time = 0.0; time < reference.solution.end_time(); time += 7.3e-4) {
      State there;
      there.position = exact.pose(time).head<2>();
      there.angle = exact.pose(time)[2];
      worst = std::max(worst, distance(reference.the_case, drawn.pose(time), there));
    }
    EXPECT_LE(worst, pixel(reference)) << "step " << step;
  }
}

TEST(Motion, RunsAreDrawnAsNearToTheirRecordAsTheySay) {
  for (const std::size_t which : {0U, 8U}) {
    const ReferenceCase reference = reference_of(shipped_cases().at(which));
    for (const double step : {1e-1, 1e-2, 1e-3}) {
      expect_near(reference, stepped_run(reference.the_case, step), 0.3 * pixel(reference));
      expect_near(reference, located_run(reference, step), 0.3 * pixel(reference));
    }
  }
}

TEST(Motion, ARunThatShakesIsDrawnWorseAndSaysSo) {
  const ReferenceCase reference = reference_of(shipped_cases().front());
  Trajectory run = stepped_run(reference.the_case, 2e-3);
  run.impacts.clear();
  std::mt19937 random(7);
  std::uniform_real_distribution<double> shake(-5.0, 5.0);  // [pixels]
  for (Point& point : run.points) {
    point.state.position.x() += shake(random) * pixel(reference);
  }
  const Path path = run_path(reference.the_case, nearness_of(reference), run);
  EXPECT_LE(path.time.steps.size(), most_pieces + 1);
  EXPECT_GT(path.error, pixel(reference));
  expect_near(reference, run, 10.0 * pixel(reference));
}

TEST(Motion, ARunThatFliesAwayIsDrawnToo) {
  const ReferenceCase reference = reference_of(shipped_cases().front());
  Trajectory run = stepped_run(reference.the_case, 1e-2);
  run.impacts.clear();
  for (std::size_t i = 500; i < run.points.size(); ++i) {
    State& state = run.points[i].state;
    state.position *= std::pow(10.0, static_cast<double>(i - 500) / 400.0);
    state.velocity *= 1e3;
  }
  run.points.back().state.velocity.x() = std::numeric_limits<double>::quiet_NaN();
  const Path path = run_path(reference.the_case, nearness_of(reference), run);
  EXPECT_EQ(numbers(path.time).size(), path.time.steps.size());
  EXPECT_NEAR(numbers(path.time).back(), run.points.rbegin()[1].time, 1e-4);
  run.points.pop_back();
  expect_near(reference, run, pixel(reference));
}

TEST(Motion, ARunOfOneSampleIsAPoint) {
  const ReferenceCase reference = reference_of(shipped_cases().front());
  Trajectory run;
  run.points = {{0.0, reference.the_case.initial}};
  const DrawnPath drawn(as_read(run_path(reference.the_case, nearness_of(reference), run)));
  EXPECT_EQ(distance(reference.the_case, drawn.pose(1.0), reference.the_case.initial), 0.0);
}

TEST(Motion, TautIsWhatTheExactMotionHoldsAndNothingElse) {
  for (const std::size_t which : {0U, 8U}) {
    const ReferenceCase reference = reference_of(shipped_cases().at(which));
    const DrawnPath drawn(as_read(exact_replay(reference).path));
    std::size_t told = 0;
    for (const Arc& arc : reference.solution.arcs()) {
      const double middle = 0.5 * (arc.start + arc.end);
      if (arc.end - arc.start < 1e-6) {
        continue;  // shorter than two instants of a page
      }
      for (std::size_t cable = 0; cable < reference.the_case.cables.size(); ++cable) {
        EXPECT_EQ(drawn.is_taut(cable, middle), arc.taut.contains(cable))
            << reference.the_case.name << ", cable " << cable << ", t = " << middle;
        told += drawn.is_taut(cable, middle) ? 1U : 0U;
      }
    }
    EXPECT_GT(told, 0U) << reference.the_case.name;
  }
}

TEST(Motion, TautIsWhereTheRecordHoldsACableAtItsLength) {
  const ReferenceCase reference = reference_of(shipped_cases().at(8));
  const Case& the_case = reference.the_case;
  const Trajectory run = stepped_run(the_case, 1e-3);
  const Path path = as_read(run_path(the_case, nearness_of(reference), run));
  const DrawnPath drawn(path);
  std::size_t told = 0;
  for (std::size_t cable = 0; cable < the_case.cables.size(); ++cable) {
    const double near = taut_part * the_case.cables[cable].length;
    const auto within = [&](const Point& point) {
      return gap(the_case.cables[cable], point.state) <= near;
    };
    for (auto from = run.points.begin(); from != run.points.end();) {
      // the points up to the next that is on the other side
      const bool side = within(*from);
      const auto to = std::find_if(from, run.points.end(),
                                   [&](const Point& point) { return within(point) != side; });
      const bool held = side && std::prev(to)->time - from->time >= shortest_hold;
      for (; from != to; ++from) {
        ASSERT_EQ(drawn.is_taut(cable, from->time), held)
            << "cable " << cable << ", t = " << from->time;
        told += held ? 1U : 0U;
      }
    }
    for (const double shown : path.cables[cable].gap) {
      EXPECT_LE(shown, near);
    }
  }
  EXPECT_GT(told, 100U);
}

TEST(Motion, TheGapOfATautCableIsTheRecordedOne) {
  const ReferenceCase reference = reference_of(shipped_cases().at(8));
  const Path path = exact_replay(reference).path;
  std::size_t shown = 0;
  for (std::size_t cable = 0; cable < path.cables.size(); ++cable) {
    const std::vector<double> times = numbers(path.cables[cable].gap_times);
    ASSERT_EQ(times.size(), path.cables[cable].gap.size());
    for (const double value : path.cables[cable].gap) {
      EXPECT_LT(std::abs(value), 1e-10);  // as the solution holds it; a drawn path is 1e-4 off
      ++shown;
    }
  }
  EXPECT_GT(shown, 10U);
}

TEST(Motion, IsReadAsThePageReadsIt) {
  const json shared = json::parse(test::content_of(TAUTLINE_TEST_DATA "/replay/path.json"));
  RunRecord empty;
  json record = json::parse(record_json(empty, "it"));
  record["record"]["row"]["path"] = shared.at("path");
  const DrawnPath drawn(*record_from(record.dump(), "it").value().replay.path);
  for (const json& row : shared.at("at")) {
    const double time = row.at("time");
    const Eigen::Vector3d pose = drawn.pose(time);
    EXPECT_NEAR(pose[0], row.at("x"), 1e-14) << time;
    EXPECT_NEAR(pose[1], row.at("y"), 1e-14) << time;
    EXPECT_NEAR(pose[2], row.at("angle"), 1e-14) << time;
    EXPECT_NEAR(drawn.energy(time), row.at("energy"), 1e-14) << time;
    EXPECT_EQ(drawn.is_taut(0, time), row.at("taut").get<bool>()) << time;
    EXPECT_FALSE(drawn.is_taut(1, time));
  }
}

TEST(Motion, TheEventsOfTheExactMotionAreCounted) {
  const ReferenceCase reference = reference_of(shipped_cases().front());
  const EventColumns events = exact_replay(reference).events;
  EXPECT_EQ(events.time.size(), std::min(reference.solution.events().size(), most_drawn));
  EXPECT_EQ(events.time.size() + events.left_out, reference.solution.events().size());
}

// ---- systems in space

ReferenceSystem spatial(const std::string& name) {
  return solve_case(test::named(shipped_spatial_systems(), name), ImpactLaw::simultaneous);
}

struct Off {
  double position = 0.0;  // [m]
  double turn = 0.0;      // [rad], 2 atan2(|vector part|, |w|)
  double reach = 0.0;     // [m], of both at the end of what is drawn of the body
};

/// How far `drawn` is from `state`, the most of all bodies.
Off off(const SpatialSystem& system, const Nearness& nearness, const DrawnPath& drawn, double time,
        const SpatialSystemState& state) {
  Off worst;
  for (std::size_t body = 0; body < system.bodies.size(); ++body) {
    const SpatialState there = drawn.pose(body, time);
    const SpatialState& here = state.bodies[body];
    Quaternion back = here.orientation;
    back.tail<3>() *= -1.0;
    const Quaternion between = product<double>(back, there.orientation);
    const double turn = 2.0 * std::atan2(between.tail<3>().norm(), std::abs(between[0]));
    const double position = (there.position - here.position).norm();
    worst.position = std::max(worst.position, position);
    worst.turn = std::max(worst.turn, turn);
    worst.reach = std::max(worst.reach, position + nearness.bodies[body].reach * turn);
  }
  return worst;
}

TEST(MotionInSpace, TheExactMotionIsDrawnWithinAPixelAtRandomInstants) {
  std::mt19937 random(11);
  for (const char* name : {"conical", "dzhanibekov", "tethered-ball", "spherical-slack"}) {
    const ReferenceSystem reference = spatial(name);
    const Nearness nearness = nearness_of(reference);
    const Path path = as_read(exact_replay(reference).path);
    const DrawnPath drawn(path);
    const double pixel = 1e-3 * drawn_extent(reference);
    std::uniform_real_distribution<double> instant(0.0, reference.solution.end_time());
    Off worst;
    double worst_energy = 0.0;
    for (int i = 0; i < 2000; ++i) {
      const double time = instant(random);
      const SpatialSystemState state = reference.solution.at(time);
      const Off here = off(reference.the_case, nearness, drawn, time, state);
      worst.position = std::max(worst.position, here.position);
      worst.turn = std::max(worst.turn, here.turn);
      worst.reach = std::max(worst.reach, here.reach);
      worst_energy =
          std::max(worst_energy, std::abs(drawn.energy(time) - energy(reference.the_case, state)));
    }
    // between two samples of the drawing it may be off by a little more than at them
    EXPECT_LE(worst.reach, 1.2 * path.error) << name;
    EXPECT_LE(worst.reach, 0.5 * pixel) << name;
    EXPECT_LE(worst.position, 0.5 * pixel) << name;
    EXPECT_LE(worst.turn, 2e-2) << name;
    EXPECT_LE(worst_energy, 1.2 * path.energy_error) << name;
    RecordProperty(std::string(name), std::to_string(worst.reach / pixel) + " pixels, " +
                                          std::to_string(worst.turn) + " rad");
  }
}

TEST(MotionInSpace, RunsAreDrawnAsNearToTheirRecordAsTheySay) {
  for (const char* name : {"dzhanibekov", "tethered-ball", "spherical-slack"}) {
    const ReferenceSystem reference = spatial(name);
    const Nearness nearness = nearness_of(reference);
    for (const double step : {1e-2, 1e-3}) {
      SystemTrajectory run = located_run(reference, step);
      // a quaternion and its negative are one orientation
      for (std::size_t i = 0; i < run.points.size(); i += 3) {
        run.points[i].state.bodies[0].orientation *= -1.0;
      }
      const Path path = as_read(run_path(reference.the_case, nearness, run));
      const DrawnPath drawn(path);
      double worst = 0.0;
      for (const auto& point : run.points) {
        worst = std::max(worst,
                         off(reference.the_case, nearness, drawn, point.time, point.state).reach);
      }
      EXPECT_LE(worst, path.error * (1.0 + 1e-6) + 1e-12) << name << ", said: " << path.error;
      EXPECT_LE(path.error, 3e-4 * drawn_extent(reference)) << name << ", step " << step;
      EXPECT_LE(path.bodies.value()[0].time.steps.size(), most_pieces + 1);
    }
  }
}

TEST(MotionInSpace, TensionsAreThoseOfTheExactMotion) {
  const ReferenceSystem reference = spatial("conical");
  const Path path = as_read(exact_replay(reference).path);
  ASSERT_TRUE(path.cables.at(0).tension.has_value());
  const std::vector<double> times = numbers(path.cables[0].tension->time);
  const std::vector<double> values = numbers(path.cables[0].tension->value);
  const double bound = 1.1 * nearness_of(reference).tension;
  EXPECT_GT(bound, 0.0);
  for (std::size_t i = 0; i < times.size(); ++i) {
    const double time = std::min(times[i], reference.solution.end_time());
    EXPECT_NEAR(values[i], reference.solution.tensions(time)[0], bound) << time;
  }
  EXPECT_FALSE(exact_replay(spatial("dzhanibekov")).path.cables.at(0).tension.has_value())
      << "a cable that is never taut pulls in impacts alone";
}

TEST(MotionInSpace, TautIsWhatTheExactMotionHolds) {
  const ReferenceSystem reference = spatial("spherical-slack");
  const DrawnPath drawn(as_read(exact_replay(reference).path));
  std::size_t told = 0;
  for (const auto& arc : reference.solution.arcs()) {
    if (arc.end - arc.start > 1e-6) {
      EXPECT_EQ(drawn.is_taut(0, 0.5 * (arc.start + arc.end)), arc.taut.contains(0)) << arc.start;
      told += arc.taut.contains(0) ? 1U : 0U;
    }
  }
  EXPECT_GT(told, 0U);
}

TEST(MotionInSpace, ARunThatFliesAwayIsDrawnUpToThere) {
  const ReferenceSystem reference = spatial("dzhanibekov");
  SystemTrajectory run = located_run(reference, 1e-2);
  run.impacts.clear();
  run.points.back().state.bodies[0].position.x() = std::numeric_limits<double>::quiet_NaN();
  const Path path = run_path(reference.the_case, nearness_of(reference), run);
  EXPECT_NEAR(numbers(path.bodies.value()[0].time).back(), run.points.rbegin()[1].time, 1e-4);
}

}  // namespace
}  // namespace tautline::bench
