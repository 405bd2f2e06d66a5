#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <stdexcept>
#include <string>
#include <tuple>
#include <utility>
#include <vector>

#include "support.hpp"
#include "system/spatial_systems.hpp"
#include "tautline/islands.hpp"
#include "tautline/scenarios.hpp"
#include "tautline/system_ledger.hpp"
#include "tautline/system_settling.hpp"

// Several bodies in space, what is conserved, rest, settling, laws, and what is refused.

namespace tautline::test {
namespace {

using Point = BasicVector<double, 3>;

/// Three bodies that spin about no axis of theirs, on two cables, without gravity.
SpatialSystem chain_in_space(double restitution) {
  SpatialSystem system;
  system.gravity = {};
  system.bodies.resize(3);
  system.bodies[0].inertia = {0.02, 0.03, 0.04};
  system.bodies[1].mass = 2.0;
  system.bodies[1].inertia = {0.05, 0.03, 0.04};
  system.bodies[2].mass = 1.5;
  system.bodies[2].inertia = {0.01, 0.03, 0.03};
  system.initial.bodies.resize(3);
  SpatialState& left = system.initial.bodies[0];
  SpatialState& middle = system.initial.bodies[1];
  SpatialState& right = system.initial.bodies[2];
  left.velocity = {-1.0, 0.2, 0.1};
  left.spin = {1.0, -2.0, 3.0};
  middle.position = {0.5, 0.1, 0.0};
  middle.velocity = {0.1, 0.0, -0.3};
  middle.spin = {0.5, 1.0, -2.0};
  right.position = {1.0, -0.1, 0.2};
  right.velocity = {0.8, -0.3, 0.0};
  right.spin = {1.0, 0.0, -1.0};
  const auto join = [&](std::size_t a, const Point& at, std::size_t b, const Point& to,
                        double length) {
    SpatialCable cable = cable_in_space<double>(at, to, length, restitution, a);
    cable.to.body = b;
    system.cables.push_back(cable);
  };
  join(0, {0.05, 0.02, 0.03}, 1, {-0.1, 0.0, 0.02}, 0.7);
  join(1, {0.1, 0.0, -0.05}, 2, {-0.05, 0.03, 0.0}, 0.8);
  system.duration = 6.0;
  return system;
}

TEST(ChainInSpace, KeepsItsMomentaAndItsEnergyWhereItIsElastic) {
  for (const double e : {0.9, 1.0}) {
    const SpatialSystem system = chain_in_space(e);
    const auto solution = solve(system);
    ASSERT_GE(solution.events().size(), 10U);
    const auto& start = system.initial;
    double moved = 0.0;
    double turned = 0.0;
    double energy = 0.0;
    for (int k = 0; k <= 60; ++k) {
      const auto state = solution.at(std::min(0.1 * k, solution.end_time()));
      moved = std::max(moved, (momentum(system, state) - momentum(system, start)).norm());
      turned = std::max(turned, (angular_momentum<double>(system, state, Point(0.0, 0.0, 0.0)) -
                                 angular_momentum<double>(system, start, Point(0.0, 0.0, 0.0)))
                                    .norm());
      energy = std::max(energy, std::abs(kinetic_energy(system.bodies, state) /
                                             kinetic_energy(system.bodies, start) -
                                         1.0));
    }
    expect_within("momentum [N s]", moved, 1e-14);
    expect_within("angular momentum [N m s]", turned, 1e-14);
    if (e == 1.0) {
      expect_within("energy [-]", energy, 1e-14);
    }
  }
}

TEST(IslandsInSpace, MoveTogetherAsAlone) {
  const SpatialSystem one = chain_in_space(0.9);
  SpatialSystem both = one;
  SpatialSystem two = tethered_ball<double>();
  two.gravity = {};
  both.bodies.push_back(two.bodies[0]);
  both.initial.bodies.push_back(two.initial.bodies[0]);
  both.cables.push_back(two.cables[0]);
  both.cables.back().from.body = 3;
  const auto motion = solve_islands(both);
  ASSERT_EQ(motion.parts().size(), 2U);
  const auto alone_one = solve(one);
  const auto alone_two = solve(two);
  EXPECT_EQ(motion.events().size(), alone_one.events().size() + alone_two.events().size());
  for (int k = 0; k <= 60; ++k) {
    const double time = 0.1 * k;
    const auto all = motion.at(time);
    EXPECT_EQ(all.bodies[2].orientation, alone_one.at(time).bodies[2].orientation);
    EXPECT_EQ(all.bodies[3].position, alone_two.at(time).bodies[0].position);
  }
}

/// A ball at 0.5 below its anchor, on a cable of 1 at its surface, that spins about `axis`.
SpatialSystem dropped_ball(const Point& inertia, const Point& spin) {
  SpatialState start;
  start.position.z() = -0.6;
  start.spin = spin;
  auto system = one_body<double>(inertia, start);
  system.cables = {cable_in_space<double>({0.0, 0.0, 0.1}, {0.0, 0.0, 0.0}, 1.0, 0.5)};
  system.duration = 20.0;
  return system;
}

TEST(RestInSpace, LeavesASpinThatNoCableNotices) {
  const SpatialSystem system = dropped_ball({0.004, 0.005, 0.006}, {0.0, 0.0, 2.0});
  const auto solution = solve(system);
  EXPECT_EQ(solution.ending(), Ending::rest);
  EXPECT_EQ(solution.end_time(), 20.0);
  const auto end = solution.at(20.0).bodies[0];
  EXPECT_EQ(end.velocity.norm(), 0.0);
  EXPECT_NEAR((end.spin - Point(0.0, 0.0, 2.0)).norm(), 0.0, 1e-14);
  expect_within("turned [rad]",
                angle_between<double>(end.orientation, quaternion_of<double>({0.0, 0.0, 40.0})),
                1e-13);
}

TEST(RestInSpace, IsNoneOfABodyThatTumblesAboutTheCentreItHangsAt) {
  SpatialSystem system = dropped_ball({0.004, 0.005, 0.006}, {1.0, 0.5, 2.0});
  system.cables[0].from.at.setZero();
  const auto solution = solve(system);
  EXPECT_EQ(solution.ending(), Ending::reached_duration);
  // its spin goes round: energy and the size of the angular momentum stay
  const Point inertia = system.bodies[0].inertia;
  const Point start = system.initial.bodies[0].spin;
  const Point end = solution.at(20.0).bodies[0].spin;
  EXPECT_GT((end - start).norm(), 0.1);
  expect_within("angular momentum [-]",
                std::abs(inertia.cwiseProduct(end).norm() / inertia.cwiseProduct(start).norm() - 1),
                1e-13);
}

TEST(RestInSpace, IsThatOfAPlateOnThreeCables) {
  // five freedoms may be held by lines through two points, not by those of one
  SpatialState start;
  start.position.z() = -1.0 + 0.05;
  auto system = one_body<double>({0.01, 0.01, 0.02}, start);
  for (const auto& [x, y] : {std::pair{0.2, 0.0}, {-0.1, 0.17}, {-0.1, -0.17}}) {
    system.cables.push_back(cable_in_space<double>({x, y, 0.0}, {x, y, 0.0}, 1.0, 0.0));
  }
  const auto solution = solve(system);
  EXPECT_EQ(solution.ending(), Ending::rest);
  const auto end = solution.at(solution.end_time());
  EXPECT_NEAR(end.bodies[0].position.z(), -1.0, 1e-15);
  const auto tensions = solution.tensions(solution.end_time());
  EXPECT_NEAR(tensions.sum(), 1.0, 1e-14);
  EXPECT_NEAR(tensions[0], 1.0 / 3.0, 1e-14);  // where the plate balances
}

TEST(SettlingInSpace, KeepsTheEnergyAboveTheLowestPlace) {
  const Filar<double> one = trifilar<double>();
  SpatialSystem system = one.system();
  const auto result = settling(system, solve(system));
  ASSERT_TRUE(result.lock);
  EXPECT_FALSE(result.lock->certain);
  ASSERT_TRUE(result.lock->residual_energy);
  EXPECT_NEAR(*result.lock->residual_energy, one.height(one.yaw) - one.height(0.0), 1e-12);
  system.bodies[0].spin_drag = 0.05;
  system.duration = 60.0;
  const auto damped = settling(system, solve(system));
  ASSERT_TRUE(damped.lock);
  ASSERT_TRUE(damped.lock->one_percent);
  const auto later = solve(system).at(*damped.lock->one_percent);
  const double left = energy(system, later) - one.height(0.0);
  EXPECT_NEAR(left / (one.height(one.yaw) - one.height(0.0)), 0.01, 1e-9);
}

TEST(LawsInSpace, NeverGainEnergyAndRefuseWhatTheyDoNotTake) {
  SpatialSystem system = crane_slings<double>();
  system.duration = 2.0;
  for (const ImpactLaw law : {ImpactLaw::simultaneous, ImpactLaw::poisson, ImpactLaw::sequential}) {
    SolveOptions options;
    options.law = law;
    const auto ledger = energy_ledger(system, solve(system, options));
    EXPECT_GT(ledger.impacts, 0.0);
    expect_within("residual [-]", std::abs(ledger.residual) / ledger.range, 1e-13);
  }
  SolveOptions energetic;
  energetic.law = ImpactLaw::energetic;
  EXPECT_THROW(static_cast<void>(solve(system, energetic)), std::invalid_argument);
  system.cables.pop_back();
  const auto ledger = energy_ledger(system, solve(system, energetic));
  EXPECT_GT(ledger.impacts, 0.0);
  expect_within("residual, energetic [-]", std::abs(ledger.residual) / ledger.range, 1e-13);
}

TEST(ProblemsInSpace, NameMomentsAndOrientationsThatNoBodyHas) {
  const auto first = [](const SpatialSystem& system) {
    const auto found = problems(system);
    return found.empty() ? std::string() : found.front();
  };
  SpatialSystem system = tethered_ball<double>();
  system.bodies[0].inertia = {0.1, 0.2, 0.3};  // a plate
  EXPECT_EQ(first(system), "");
  system.bodies[0].inertia = {0.1, 0.2, 0.31};
  EXPECT_EQ(first(system),
            "body 0: inertia: the largest principal moment, 0.31, must not be above the sum of the "
            "other two, 0.30000000000000004 [kg m^2]");
  system.bodies[0].inertia = {0.1, 0.0, 0.1};
  EXPECT_EQ(first(system), "body 0: inertia[1] 0 must be a finite number above 0 [kg m^2]");
  system.bodies[0].inertia = {0.0, 0.0, 0.0};
  EXPECT_EQ(first(system),
            "body 0: inertia [0, 0, 0] is for a point mass, whose attachments are all [0, 0, 0]; "
            "give three moments above 0 [kg m^2]");
  system = tethered_ball<double>();
  system.initial.bodies[0].orientation = {1.0, 0.1, 0.0, 0.0};
  EXPECT_EQ(first(system),
            "body 0: orientation: w x y z has the length 1.004987562112089; must be 1");
  system = tethered_ball<double>();
  system.initial.bodies[0].spin.y() = NAN;
  EXPECT_EQ(first(system), "body 0: spin nan is not a finite number");
  EXPECT_THROW(static_cast<void>(solve(system)), std::invalid_argument);
}

TEST(ShippedSpatialSystems, AreAcceptedAndTheirLedgersClose) {
  for (const auto& [system, shows] : shipped_spatial_systems()) {
    SCOPED_TRACE(system.name);
    ASSERT_TRUE(problems(system).empty()) << problems(system).front();
    const auto solution = solve(system);
    EXPECT_EQ(solution.ending(),
              system.name == "parallel-robot" ? Ending::rest : Ending::reached_duration);
    const auto ledger = energy_ledger(system, solution);
    expect_within(system.name + ": residual [-]", std::abs(ledger.residual) / ledger.range, 1e-13);
  }
}

/// The shipped system of this name, and the sentences on it.
ShippedSpatialSystem shipped(const std::string& name) {
  for (const ShippedSpatialSystem& one : shipped_spatial_systems()) {
    if (one.system.name == name) {
      return one;
    }
  }
  throw std::invalid_argument(name);
}

/// True if the sentences on `one` have this `number`.
bool says(const ShippedSpatialSystem& one, const std::string& number) {
  return one.shows.find(number) != std::string_view::npos;
}

TEST(ShippedSpatialSystems, ShowWhatTheySay) {
  for (const auto& [name, number, filar] :
       {std::tuple{"bifilar", "3.67951", bifilar<double>()},
        std::tuple{"trifilar", "3.83636", trifilar<double>()}}) {
    const auto one = shipped(name);
    EXPECT_TRUE(says(one, number));
    EXPECT_NEAR(filar.period(), std::stod(number), 1e-5);
    const auto solution = solve(one.system);
    EXPECT_EQ(solution.arcs().back().taut.size(), one.system.cables.size());
    const auto back = solution.at(filar.period()).bodies[0];
    EXPECT_LT(angle_between<double>(back.orientation, one.system.initial.bodies[0].orientation),
              1e-13);
  }
  const Filar<double> three = trifilar<double>();
  const double small =
      2.0 * pi<double>() * std::sqrt(three.inertia * std::sqrt(1.0 - 0.01) / (0.3 * 0.2));
  EXPECT_NEAR(three.period() / small, 1.06, 0.005);

  const auto slack = solve(shipped("spherical-slack").system);
  EXPECT_NEAR(slack.events()[1].time, 1.01699, 1e-5);
  EXPECT_NEAR(slack.events()[2].time, 3.25421, 1e-5);
  const auto ball = solve(shipped("tethered-ball").system);
  EXPECT_NEAR(ball.accumulations().front().time, 3.34612, 1e-5);
  const bool lets_go = std::any_of(ball.events().begin(), ball.events().end(), [](const auto& one) {
    return one.kind == EventKind::slack && one.time < 3.6;
  });
  EXPECT_TRUE(lets_go);
  const auto box = solve(shipped("dzhanibekov").system);
  EXPECT_NEAR(box.events().front().time, 10.9315, 1e-4);
  // the spin about the middle axis turns its sign after a quarter and each half of a round
  EXPECT_LT(box.at(4.62217).bodies[0].spin.y(), -5.99);
  EXPECT_GT(box.at(2.0 * 4.62217).bodies[0].spin.y(), 5.99);
  const auto crane = shipped("crane-slings");
  const auto crane_lock = settling(crane.system, solve(crane.system)).lock;
  ASSERT_TRUE(crane_lock);
  EXPECT_NEAR(crane_lock->time, 7.363, 1e-3);
  EXPECT_EQ(crane_lock->cables.indices(), (std::vector<std::size_t>{0, 2}));
  const auto robot = solve(shipped("parallel-robot").system);
  EXPECT_NEAR(robot.accumulations().back().time, 2.16, 0.01);
  EXPECT_EQ(robot.arcs().back().taut.size(), 6U);
  EXPECT_GT(robot.events().size(), 2000U);
  const auto tilted = shipped("breakwater-in-a-tilted-plane");
  const Point normal(-0.48, -0.64, 0.6);
  const auto in_plane = solve(tilted.system);
  for (const auto& event : in_plane.events()) {
    EXPECT_NEAR(normal.dot(event.after.bodies[0].position), 0.0, 1e-11);
  }
  const auto spindle = solve(shipped("conical").system);
  for (int k = 0; k <= 20; ++k) {
    const auto state = spindle.at(k).bodies[0];
    const Point axis = rotated<double>(state.orientation, Point(0.0, 0.0, 1.0));
    EXPECT_NEAR(std::acos(axis.z()), 0.5, 1e-12);
  }
  // a line of the buoy is slack for more than half of the time
  const auto buoy = shipped("moored-buoy");
  const auto lines = settling(buoy.system, solve(buoy.system)).cables;
  for (const CableUse& use : lines) {
    EXPECT_GT(use.taut_share, 0.2);
    EXPECT_LT(use.taut_share, 0.5);
  }
}

}  // namespace
}  // namespace tautline::test
