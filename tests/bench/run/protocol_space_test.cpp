// Systems in space by a child: right where the child is, one clear sentence where it goes wrong.
#include <gtest/gtest.h>

#include <nlohmann/json.hpp>

#include "bench/run/plugin.hpp"
#include "bench/run/protocol/messages.hpp"
#include "tautline/solve.hpp"
#include "tautline/system_geometry.hpp"
#include "tests/bench/run/protocol_support.hpp"
#include "tests/bench/schema.hpp"

namespace tautline::test {
namespace {

using nlohmann::json;
using Point = Eigen::Vector3d;

std::string ball(const TemporaryFolder& folder, const std::string& way = "ball") {
  return space_child(folder, way);
}

/// A ball on a tether, and another one on a cable to the first.
SpatialSystem two_balls() {
  SpatialSystem result;
  result.name = "two balls";
  result.duration = 3.0;
  for (const double side : {0.0, 1.0}) {
    SpatialBody body;
    body.mass = 1.0 + side;
    body.inertia = Point::Constant(0.004 + 0.01 * side);
    result.bodies.push_back(body);
    SpatialState start;
    start.position = Point(0.2, 0.1 * side, -0.3 - 0.5 * side);
    start.velocity = Point(0.5, 0.4, 0.6 - side);
    start.spin = Point(3.0, -4.0 + side, 2.0);
    result.initial.bodies.push_back(start);
  }
  result.cables.resize(2);
  result.cables[0].from = {0, Point(0.1, 0.0, 0.0), {}};
  result.cables[1].from = {0, Point(0.0, 0.0, -0.1), {}};
  result.cables[1].to = {1, Point(0.0, 0.05, 0.1), {}};
  for (SpatialCable& cable : result.cables) {
    cable.restitution = 0.7;
  }
  return result;
}

TEST(ChildInSpace, IsExactByEventsAndOfFirstOrderInSteps) {
  if (!has_python()) {
    GTEST_SKIP() << no_python;
  }
  const TemporaryFolder folder;
  const bench::Plugin plugin = bench::Plugin::open(ball(folder));
  EXPECT_EQ(plugin.engine().info().dimensions, 3);
  const SpatialSystem system = two_balls();
  const auto exact = solve(system);
  double end = 0.0;
  std::size_t impacts = 0;
  for (const auto& event : exact.events()) {
    if (event.kind == EventKind::impact && impacts < 3) {
      ++impacts;
      end = event.time;
    }
  }
  ASSERT_EQ(impacts, 3U);
  const auto off = [&](const std::string& model, double step) {
    const auto run = plugin.engine().start_system(system, model, step);
    double worst = 0.0;
    for (int k = 1; k * step <= end; ++k) {
      run->step(step);
      const auto found = run->state();
      const auto right = exact.at(k * step);
      for (std::size_t body = 0; body < system.bodies.size(); ++body) {
        worst = std::max(worst, (found.bodies[body].position - right.bodies[body].position).norm());
        worst = std::max(worst, angle_between<double>(found.bodies[body].orientation,
                                                      right.bodies[body].orientation));
      }
    }
    return worst;
  };
  EXPECT_LT(off("event", 1e-2), 1e-11);
  const double coarse = off("row", 1e-2);
  const double fine = off("row", 1e-3);
  EXPECT_LT(fine, 0.05);
  EXPECT_LT(fine, coarse / 3.0) << coarse;
}

/// What a run of `system` says; "" if nothing.
std::string said(const std::string& file, const SpatialSystem& system, const std::string& model) {
  try {
    const bench::Plugin plugin = bench::Plugin::open(file);
    const auto run = plugin.engine().start_system(system, model, 1e-2);
    for (int k = 0; k < 100; ++k) {
      run->step(1e-2);
    }
  } catch (const std::exception& error) {
    return error.what();
  }
  return "";
}

TEST(ChildInSpace, SaysInOneSentenceWhatIsWrong) {
  if (!has_python()) {
    GTEST_SKIP() << no_python;
  }
  const TemporaryFolder folder;
  const std::string numbers =
      "26 numbers: x, y, z, qw, qx, qy, qz, vx, vy, vz, wx, wy, wz of each body";
  SpatialSystem ring = two_balls();
  ring.cables[1].through = {{std::nullopt, Point(0.0, 0.0, 1.0), {}}};
  const SpatialSystem balls = two_balls();
  EXPECT_EQ(said(ball(folder), ring, "event"), "unsupported: a ball has no ring");
  EXPECT_EQ(said(ball(folder, "too-few-bodies"), balls, "event"),
            "the engine's answer to fly: state is [0.21500000000000002,0.012,-0.28245,0.99..., "
            "must be " +
                numbers);
  EXPECT_EQ(said(ball(folder, "starts-short"), balls, "row").find("the engine's answer to start"),
            0U);
  EXPECT_EQ(said(ball(folder, "not-turned"), balls, "event"),
            "the engine's answer to fly: state[3] is 2.0, must be the first of four numbers whose "
            "squares add up to 1");
  EXPECT_EQ(said(ball(folder, "not-turned"), balls, "row"),
            "the engine's answer to step: steps[1][3] is 2.0, must be the first of four numbers "
            "whose squares add up to 1");
  EXPECT_EQ(said(ball(folder, "pushes-in-space"), balls, "event"),
            "the engine's answer to solve: impulses[0] is -1.0, must be an impulse of at least 0");
  EXPECT_EQ(said(ball(folder, "in-a-plane"), balls, "event"),
            "the engine's answer to info: models[0].in_space is [], must be left out, or the "
            "engine's protocol 2 and its dimensions [2, 3]");
  EXPECT_EQ(said(sound_child(folder), balls, "event"),
            "unsupported: twin is an engine of the plane");
  EXPECT_EQ(said(ball(folder, "lost"), balls, "event"), "");  // it stops, as in the plane
}

TEST(ChildInSpace, IsToldASystemAsTheSchemaSays) {
  const auto is_message = [](const std::string& text) {
    return broken_rules(json::parse(text), json::parse(content_of(TAUTLINE_PROTOCOL_SCHEMA)));
  };
  SpatialSystem system = two_balls();
  system.gravity = Function<3>::spline({0.0, 1.0}, {Point::Zero(), Point(0.0, 0.0, -1.0)});
  system.cables[0].to.motion.waves = {{Point(0.1, 0.0, 0.0), 1.5, -0.5}};
  system.cables[0].from_time = 0.5;
  system.cables[1].cut_at = 2.0;
  system.cables[1].through = {{0, Point::Zero(), {}}};
  system.cables[1].capture_speed = 0.1;
  const bench::ChildModel follows{{"row", "", {}}, false, true};
  const std::string start = bench::start_request(1, system, follows, 1e-3);
  EXPECT_EQ(is_message(start), "");
  const json told = json::parse(start).at("params").at("case");
  EXPECT_EQ(told.at("gravity").at("pieces")[0].at("polynomial")[2].dump(), "[0.0,0.0,-3.0]");
  EXPECT_EQ(told.at("cables")[1].at("ends").size(), 3U);
  EXPECT_EQ(told.at("cables")[1].at("restitution").dump(), "[[0.0,0.0],[0.1,0.0],[0.1,0.7]]");
  SpatialSystemState state = system.initial;
  state.time = 0.3;
  const std::string place = bench::place_request(2, state);
  EXPECT_EQ(is_message(place), "");
  EXPECT_EQ(json::parse(place).at("params").at("time"), 0.3);
}

}  // namespace
}  // namespace tautline::test
