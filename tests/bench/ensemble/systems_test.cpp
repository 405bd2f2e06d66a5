// Ensembles of systems: what may vary, and what a draw is reduced to.

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <filesystem>
#include <numbers>
#include <set>
#include <string>

#include "bench/ensemble/draw.hpp"
#include "bench/ensemble/output/comparison.hpp"
#include "bench/ensemble/output/output.hpp"
#include "bench/ensemble/spec_file.hpp"
#include "bench/ensemble/statistic.hpp"
#include "tautline/scenarios.hpp"
#include "tautline/solve.hpp"
#include "tautline/system_geometry.hpp"
#include "tautline/system_settling.hpp"
#include "tests/bench/ensemble/solved.hpp"
#include "tests/bench/program.hpp"
#include "tests/bench/support.hpp"

namespace tautline::bench {
namespace {

System shipped(const std::string& name) { return test::named(shipped_systems(), name); }
SpatialSystem in_space(const std::string& name) {
  return test::named(shipped_spatial_systems(), name);
}

template <class TheSystem>
bool has(const TheSystem& system, const std::string& name) {
  const auto names = quantities_of(system);
  return std::find(names.begin(), names.end(), name) != names.end();
}

// every number that may vary takes what it is given, for every shipped system
TEST(SystemQuantities, TakeEveryValue) {
  const auto expect_taken = [](const auto& shipped) {
    for (const auto& one : shipped) {
      for (const std::string& name : quantities_of(one.system)) {
        auto changed = one.system;
        set_quantity(changed, name, 0.75);
        EXPECT_NEAR(quantity(changed, name), 0.75, 1e-15) << one.system.name << ' ' << name;
        scale_quantity(changed, name, 2.0);
        EXPECT_NEAR(quantity(changed, name), 1.5, 1e-15) << one.system.name << ' ' << name;
      }
    }
  };
  expect_taken(shipped_systems());
  expect_taken(shipped_spatial_systems());
}

TEST(SystemQuantities, HaveNamesThatMeanOneThing) {
  System system = shipped("two-bodies");
  system.bodies[0].name = "drag";
  system.bodies[1].name = "spin_drag";
  const auto names = quantities_of(system);
  const std::set<std::string> different(names.begin(), names.end());
  EXPECT_EQ(different.size(), names.size());
  EXPECT_EQ(unit_of_quantity(shipped("bouncer-stable"), "amplitude"), "m");
  EXPECT_EQ(unit_of_quantity(shipped("breakwater-in-waves"), "amplitude_0"), "N");
  EXPECT_EQ(unit_of_quantity(shipped("breakwater-in-waves"), "amplitude_2"), "N m");
}

TEST(SystemQuantities, AreOfAllBodiesOrOfOne) {
  System tow = shipped("tow");
  set_quantity(tow, "drag", 100.0);
  set_quantity(tow, "barge.drag", 200.0);
  EXPECT_EQ(tow.bodies[0].drag, 100.0);
  EXPECT_EQ(tow.bodies[1].drag, 200.0);
  set_quantity(tow, "tug.velocity_x", 2.0);
  EXPECT_EQ(tow.initial.bodies[0].velocity.x(), 2.0);
  EXPECT_EQ(tow.initial.bodies[1].velocity.x(), 0.0);
  set_quantity(tow, "cut_at_0", 12.0);
  EXPECT_EQ(tow.cables[0].cut_at, 12.0);
  EXPECT_FALSE(has(tow, "from_time")) << "its line is there from the start";
  EXPECT_FALSE(has(tow, "phase")) << "without a wave";
  EXPECT_TRUE(has(shipped("breakwater-in-waves"), "phase"));
}

// the same winch with its rate halved takes in half as much, from and to the same instants
TEST(SystemQuantities, ChangeTheRateOfAWinch) {
  System winch = shipped("winch");
  const auto before = winch.cables[0].length;
  const double rate = quantity(winch, "length_rate_0");
  EXPECT_LT(rate, 0.0) << "it takes in";
  set_quantity(winch, "length_rate", rate / 2.0);
  const auto& after = winch.cables[0].length;
  for (double time = 0.0; time < winch.duration; time += 0.1) {
    EXPECT_NEAR(after.at(time)[0], 0.5 * (before.at(0.0)[0] + before.at(time)[0]), 1e-15) << time;
  }
  EXPECT_TRUE(problems(winch).empty()) << "it is continuous";
  set_quantity(winch, "length", before.at(0.0)[0] + 1.0);
  EXPECT_NEAR(winch.cables[0].length.at(winch.duration)[0],
              0.5 * (before.at(0.0)[0] + before.at(winch.duration)[0]) + 1.0, 1e-15);
}

// a phase turns the whole sea: what pushes and what turns the body keep their places in it
TEST(SystemQuantities, ShiftAllWavesInTime) {
  System waves = shipped("breakwater-in-waves");
  const auto before = waves.bodies[0];
  const double first = quantity(waves, "phase");
  const double frequency = 2.0 * std::numbers::pi / quantity(waves, "period");
  set_quantity(waves, "phase", first + 0.3);
  for (const double time : {0.0, 0.7, 3.1}) {
    const double then = time + 0.3 / frequency;
    EXPECT_NEAR(waves.bodies[0].force.at(time)[0], before.force.at(then)[0], 1e-14);
    EXPECT_NEAR(waves.bodies[0].moment.at(time)[0], before.moment.at(then)[0], 1e-14);
  }
  set_quantity(waves, "amplitude", 2.0 * quantity(waves, "amplitude"));
  EXPECT_NEAR(waves.bodies[0].moment.at(1.0)[0], 2.0 * before.moment.at(1.0 + 0.3 / frequency)[0],
              1e-14)
      << "all grow together";
  set_quantity(waves, "amplitude_0", 5.0);
  EXPECT_NEAR(quantity(waves, "amplitude_0"), 5.0, 1e-14);
  EXPECT_NE(quantity(waves, "amplitude_1"), 5.0);
}

TEST(SystemQuantities, OfAnElasticCableAreItsOwn) {
  System winch = shipped("winch");
  EXPECT_FALSE(has(winch, "stiffness"));
  winch.cables[0].restitution = 1.0;
  winch.cables[0].elasticity = Elasticity{.stiffness = {100.0, 8.0}, .damping_ratio = 0.25};
  EXPECT_FALSE(has(winch, "restitution_0"));
  EXPECT_FALSE(has(winch, "capture_speed_0"));
  EXPECT_FALSE(has(winch, "damping")) << "its file has damping_ratio";
  EXPECT_EQ(quantity(winch, "damping_ratio_0"), 0.25);
  EXPECT_EQ(unit_of_quantity(winch, "stiffness"), "N/m");
  set_quantity(winch, "stiffness", 50.0);
  EXPECT_EQ(winch.cables[0].elasticity->stiffness, (std::vector<double>{50.0, 4.0}));
  winch.cables[0].elasticity->damping_ratio = 0.0;
  set_quantity(winch, "damping_0", 3.0);
  EXPECT_EQ(winch.cables[0].elasticity->damping, 3.0);
  EXPECT_EQ(unit_of_quantity(winch, "damping"), "N s/m");
  EXPECT_FALSE(has(winch, "damping_ratio"));
  EXPECT_FALSE(has(winch, "EA"));
  winch.cables[0].elasticity->of_strain = true;
  winch.cables[0].elasticity->stiffness = {100.0};
  winch.cables[0].elasticity->corners = {{0.01, 400.0}};
  EXPECT_FALSE(has(winch, "stiffness"));
  EXPECT_EQ(unit_of_quantity(winch, "EA"), "N");
  set_quantity(winch, "EA_0", 50.0);
  EXPECT_EQ(winch.cables[0].elasticity->stiffness, std::vector<double>{50.0});
  EXPECT_EQ(winch.cables[0].elasticity->corners[0].stiffness, 200.0);
  EXPECT_EQ(winch.cables[0].elasticity->corners[0].stretch, 0.01);
}

TEST(SystemQuantities, InSpaceHaveTheNamesOfTheFile) {
  const SpatialSystem load = in_space("hoisted-load");
  for (const char* name : {"x", "y", "z", "load.rotation_x", "velocity_z", "spin_y", "load.spin_z",
                           "inertia_x", "hook.mass", "drag", "spin_drag", "gravity_z", "length_4",
                           "length_rate", "restitution", "amplitude", "period", "phase_1"}) {
    EXPECT_TRUE(has(load, name)) << name;
  }
  for (const char* name : {"angle", "spin", "inertia", "rotation", "hook.rotation_x",
                           "hook.inertia_x", "hook.spin_drag"}) {
    EXPECT_FALSE(has(load, name)) << name;
  }
  EXPECT_EQ(unit_of_quantity(load, "rotation_y"), "rad");
  EXPECT_EQ(unit_of_quantity(load, "inertia_z"), "kg m^2");
  EXPECT_EQ(unit_of_quantity(load, "amplitude"), "m");
  EXPECT_EQ(unit_of_quantity(in_space("moored-buoy"), "amplitude"), "N");
  SpatialSystem changed = load;
  set_quantity(changed, "load.spin_z", 2.0);
  EXPECT_EQ(changed.initial.bodies[0].spin, (BasicVector<double, 3>(0.4, -0.3, 2.0)));
  set_quantity(changed, "gravity_x", 0.5);
  EXPECT_EQ(changed.gravity.at(0.0), (BasicVector<double, 3>(0.5, 0.0, -1.0)));
  set_quantity(changed, "inertia_y", 0.09);
  EXPECT_EQ(changed.bodies[0].inertia, (BasicVector<double, 3>(0.08, 0.09, 0.12)));
  EXPECT_TRUE(changed.bodies[1].inertia.isZero(0)) << "the hook stays a point mass";
}

// the three numbers of a rotation are those of the file, set in any order, up to a whole turn
TEST(SystemQuantities, TurnABodyInSpaceAsItsFileDoes) {
  using Rotation = BasicVector<double, 3>;
  SpatialSystem brick = in_space("tumbling-brick");
  Quaternion& orientation = brick.initial.bodies[0].orientation;
  for (const Rotation& rotation :
       {Rotation(0.2, -0.3, 0.1), Rotation(0.0, 0.0, 1e-12), Rotation(0.0, 3.1, 0.5),
        Rotation(-4.0, 1.0, 3.0), Rotation(0.0, 0.0, -6.2)}) {
    orientation = Quaternion::Unit(0);
    for (const int axis : {2, 0, 1}) {
      set_quantity(brick, std::string("rotation_") + "xyz"[axis], rotation[axis]);
    }
    EXPECT_LT((orientation - quaternion_of<double>(rotation)).norm(), 1e-15)
        << rotation.transpose();
    for (const int axis : {0, 1, 2}) {
      EXPECT_NEAR(quantity(brick, std::string("rotation_") + "xyz"[axis]), rotation[axis], 1e-14)
          << rotation.transpose();
    }
  }
}

// no pull moves an attachment more than that says
TEST(SystemEnsemble, BoundsTheResponseOfEachCable) {
  const auto expect_bound = [](const auto& all) {
    for (const auto& one : all) {
      SolveOptions options;
      options.max_events = 50;
      const auto solution = solve(one.system, options);
      for (std::size_t index = 0; index < one.system.cables.size(); ++index) {
        const double most = most_response(one.system, one.system.cables[index]);
        for (const auto& event : solution.events()) {
          EXPECT_LE(delassus(one.system, event.before, index), most * (1.0 + 1e-12))
              << one.system.name << " cable " << index;
        }
      }
    }
  };
  expect_bound(shipped_systems());
  expect_bound(shipped_spatial_systems());
}

double value_of(const EnsembleRequest& request, const EnsembleResult& result, std::size_t draw,
                const std::string& name) {
  const std::size_t place = place_of_statistic(statistics_of(request.spec), name);
  const auto value = result.draws.front().value(draw, place);
  EXPECT_TRUE(value) << name << " of draw " << draw;
  return value.value_or(NAN);
}

// two point masses: a snap of 6 N s in closed form, in proportion to the speed that varies
TEST(SystemEnsemble, HasTheSnapOfTwoBodies) {
  const EnsembleRequest request = request_of(
      "case = \"two-bodies\"\ncount = 1\n[[vary]]\nquantities = [\"thrown.velocity_x\"]\n"
      "grid = [3.5, 14]\npoints = 4\n");
  const EnsembleResult result = solved(request);
  ASSERT_EQ(result.draws.front().problems(), 0U) << result.draws.front().first_problem();
  for (std::size_t draw = 0; draw < 4; ++draw) {
    const double speed = 3.5 + 3.5 * static_cast<double>(draw);
    const System system = std::get<System>(case_of(request.spec, request.setups.front(), draw));
    const auto& cable = system.cables.front();
    const double mass = 2.0 * 1.5 / (2.0 + 1.5);
    const double snap = mass * (1.0 + cable.restitution) * speed;
    EXPECT_NEAR(value_of(request, result, draw, "largest_impulse"), snap, 1e-12);
    EXPECT_EQ(value_of(request, result, draw, "impacts"), 1.0);
    EXPECT_EQ(value_of(request, result, draw, "first_cable"), 0.0);
    EXPECT_NEAR(value_of(request, result, draw, "loss_0"), 1.0, 1e-12);
  }
}

// what `settling` says of a draw is what stands in the table
TEST(SystemEnsemble, SaysWhatTheSettlingOfEachDrawSays) {
  const EnsembleRequest request = request_of(
      "case = \"bouncer-stable\"\nuntil = 40\ncount = 6\n[[vary]]\nquantities = [\"amplitude\"]\n"
      "uniform = [0.12, 0.14]\n");
  const EnsembleResult result = solved(request);
  for (std::size_t draw = 0; draw < 6; ++draw) {
    const System system = std::get<System>(case_of(request.spec, request.setups.front(), draw));
    EXPECT_EQ(system.duration, 40.0);
    const SystemSettling settled = settling(system, solve(system));
    ASSERT_TRUE(settled.forced);
    EXPECT_EQ(value_of(request, result, draw, "impacts_a_period"), settled.forced->impacts);
    EXPECT_EQ(value_of(request, result, draw, "taut_share_0"), settled.cables[0].taut_share);
    ASSERT_TRUE(settled.cables[0].impulse);
    EXPECT_EQ(value_of(request, result, draw, "largest_impulse"), settled.cables[0].impulse->value);
  }
}

// likewise in space, where a body is drawn in each of its numbers
TEST(SystemEnsemble, InSpaceSaysWhatTheSettlingOfEachDrawSays) {
  const EnsembleRequest request = request_of(
      "case = \"tethered-ball\"\ncount = 12\n[[vary]]\nquantities = [\"x\", \"rotation_y\", "
      "\"velocity_z\", \"spin_z\", \"mass\", \"inertia_x\", \"length\", \"gravity_z\"]\n"
      "normal = 1e-4\n");
  const EnsembleResult result = solved(request);
  ASSERT_EQ(result.draws.front().problems(), 0U) << result.draws.front().first_problem();
  std::set<double> masses;
  for (std::size_t draw = 0; draw < 12; ++draw) {
    const auto system =
        std::get<SpatialSystem>(case_of(request.spec, request.setups.front(), draw));
    masses.insert(system.bodies[0].mass);
    EXPECT_NEAR(system.initial.bodies[0].orientation.norm(), 1.0, 1e-15);
    const auto solution = solve(system);
    const SystemSettling settled = settling(system, solution);
    EXPECT_EQ(value_of(request, result, draw, "taut_share_0"), settled.cables[0].taut_share);
    ASSERT_TRUE(settled.cables[0].impulse);
    ASSERT_TRUE(settled.cables[0].tension);
    EXPECT_EQ(value_of(request, result, draw, "largest_impulse"), settled.cables[0].impulse->value);
    EXPECT_EQ(value_of(request, result, draw, "largest_tension"), settled.cables[0].tension->value);
    EXPECT_EQ(value_of(request, result, draw, "settled_fast"), settled.last_impacts[0].time);
  }
  EXPECT_EQ(masses.size(), 12U) << "no two draws are alike";
}

// two of four slings carry a box, with what each of two has at rest: m g / 2 over the cosine of its
// angle, 1.5 to 3.5^(1/2)
TEST(SystemEnsemble, HasTheTwoSlingsThatCarryABox) {
  const SpecReading reading = read_spec_file(TAUTLINE_SPECS "/slings.toml");
  ASSERT_TRUE(reading.spec) << reading.problems.front();
  EnsembleRequest request{*reading.spec, {}, {}, {}};
  request.spec.count = 12;
  request.setups = setups_of(request.spec, {});
  const EnsembleResult result = solved(request);
  ASSERT_EQ(result.draws.front().problems(), 0U) << result.draws.front().first_problem();
  for (std::size_t draw = 0; draw < 12; ++draw) {
    double taut = 0.0;
    for (const char* name : {"taut_share_0", "taut_share_1", "taut_share_2", "taut_share_3"}) {
      taut += value_of(request, result, draw, name);
    }
    EXPECT_GT(taut, 1.9) << "draw " << draw;
    EXPECT_LT(taut, 3.0) << "draw " << draw;
    const double of_two = 1000.0 * 9.81 / 2.0 * std::sqrt(3.5) / 1.5;
    EXPECT_GT(value_of(request, result, draw, "largest_tension"), 0.99 * of_two);
  }
}

TEST(SystemEnsemble, InSpaceHasAPictureOfEachCell) {
  const EnsembleRequest request = request_of(
      "case = \"spherical-slack\"\nuntil = 4\ncount = 1\n[[vary]]\nquantities = [\"velocity_y\"]\n"
      "grid = [0.2, 0.4]\npoints = 2\n[[vary]]\nquantities = [\"restitution\"]\n"
      "grid = [0.0, 0.5]\npoints = 2\n");
  const EnsembleResult result = solved(request);
  const test::TemporaryFolder folder;
  write_ensemble(folder.path(), {request, result, findings_of(request, result, 1)});
  std::size_t pictures = 0;
  for (const auto& entry : std::filesystem::directory_iterator(folder.path() / "cells")) {
    EXPECT_NE(test::content_of(entry.path()).find(">front</text>"), std::string::npos)
        << entry.path();
    ++pictures;
  }
  EXPECT_EQ(pictures, 4U);
}

TEST(SystemEnsemble, InSpaceHasNoQuantityOfThePlane) {
  for (const auto& [name, right] : {std::pair("angle", "angle is none of this case; it has"),
                                    {"spin", "spin is none of this case; did you mean"},
                                    {"rotation_w",
                                     "rotation_w is none of this case; did you mean "
                                     "rotation_x, rotation_y or rotation_z?"}}) {
    const SpecReading reading = read_spec_text(
        "case = \"bifilar\"\n[[vary]]\nquantities = [\"" + std::string(name) + "\"]\nnormal = 1\n",
        "test.toml");
    ASSERT_EQ(reading.problems.size(), 1U) << name;
    EXPECT_NE(reading.problems.front().find(right), std::string::npos) << reading.problems.front();
  }
}

// threads have no say, nor has the page a gap
TEST(SystemEnsemble, IsTheSameInAnyNumberOfThreads) {
  const EnsembleRequest request = request_of(
      "case = \"breakwater-and-ball\"\nuntil = 2\ncount = 8\n[[vary]]\n"
      "quantities = [\"ball.x\", \"ball.y\", \"ball.mass\"]\nnormal = 1e-3\n");
  const EnsembleResult one = solved(request, 1);
  const EnsembleResult two = solved(request, 2);
  const std::vector<Statistic> statistics = statistics_of(request.spec);
  for (std::size_t draw = 0; draw < 8; ++draw) {
    for (std::size_t place = 0; place < statistics.size(); ++place) {
      EXPECT_EQ(one.draws.front().value(draw, place), two.draws.front().value(draw, place))
          << statistics[place].name;
    }
  }
  const Findings findings = findings_of(request, one, 1);
  const std::string text = ensemble_markdown({request, one, findings});
  for (const char* part : {"breakwater-and-ball to 2 s", "cable 2 taut", "residual energy"}) {
    EXPECT_NE(text.find(part), std::string::npos) << part << " in\n" << text;
  }
}

// a number that becomes 0 is no longer there to grow; a draw that is no system says so
TEST(SystemEnsemble, SurvivesNumbersThatVanish) {
  const EnsembleRequest flat = request_of(
      "case = \"bouncer-unstable\"\nuntil = 4\ncount = 1\n[[vary]]\n"
      "quantities = [\"amplitude\"]\ngrid = [0, 0.2]\npoints = 3\n[[exact]]\nname = \"twice\"\n"
      "quantity = \"amplitude\"\nfactor = 0.5\n");
  EXPECT_EQ(solved(flat).draws.front().problems(), 0U);
  const EnsembleRequest period = request_of(
      "case = \"bouncer-unstable\"\nuntil = 4\ncount = 40\n[[vary]]\n"
      "quantities = [\"period\"]\nnormal = 3\n[[vary]]\nquantities = [\"phase\"]\n"
      "uniform = [0, 6]\n");
  const EnsembleResult result = solved(period);
  EXPECT_GT(result.draws.front().problems(), 0U);
  EXPECT_EQ(result.draws.front().first_problem().rfind("no such case: ", 0), 0U)
      << result.draws.front().first_problem();
  const EnsembleRequest winch = request_of(
      "case = \"winch\"\ncount = 1\n[[vary]]\nquantities = [\"length_rate\"]\n"
      "grid = [-0.5, 0.0]\npoints = 2\n[[vary]]\nquantities = [\"length_rate_0\"]\n"
      "list = [-0.25]\n");
  EXPECT_EQ(solved(winch).draws.front().problems(), 0U);
}

// what a winch does while bounces are completed is no speed of theirs
TEST(SystemEnsemble, LosesNoDrawOfTheCrane) {
  const EnsembleRequest request =
      request_of("case = \"" TAUTLINE_SPECS
                 "/../crane/crane.toml\"\ncount = 1\n[[vary]]\n"
                 "quantities = [\"length_rate_0\"]\ngrid = [-1.0, -0.1]\npoints = 5\n[[vary]]\n"
                 "quantities = [\"restitution\"]\ngrid = [0.0, 0.9]\npoints = 4\n");
  const EnsembleResult result = solved(request);
  EXPECT_EQ(result.draws.front().problems(), 0U) << result.draws.front().first_problem();
  for (std::size_t draw = 0; draw < 20; ++draw) {
    const double rate = 1.0 - 0.225 * static_cast<double>(draw % 5);
    const double restitution = 0.3 * static_cast<double>(draw / 5);
    EXPECT_NEAR(value_of(request, result, draw, "largest_impulse"),
                440.0 * (1.0 + restitution) * rate, 1e-6)
        << "draw " << draw;
  }
}

TEST(SystemEnsemble, HasNoEngines) {
  const SpecReading reading = read_spec_text(
      "case = \"tow\"\n[[vary]]\nquantities = [\"tugg.drag\"]\nnormal = 1\n[engines]\n"
      "names = [\"ode\"]\n",
      "test.toml");
  std::string all;
  for (const std::string& sentence : reading.problems) {
    all += sentence + "\n";
  }
  for (const char* part : {"test.toml:6: engines.names", "tow is a system",
                           "tugg.drag is none of this case; did you mean tug.drag?"}) {
    EXPECT_NE(all.find(part), std::string::npos) << part << " in\n" << all;
  }
}

}  // namespace
}  // namespace tautline::bench
