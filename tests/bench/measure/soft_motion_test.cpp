// Cables that are springs and dampers of an engine: their motion, and the parts of a deviation.

#include "bench/measure/attribution/soft_motion.hpp"

#include <fmt/format.h>
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <vector>

#include "bench/measure/attribution/attribution.hpp"
#include "bench/measure/reference.hpp"
#include "bench/run/record.hpp"
#include "tautline/elasticity.hpp"
#include "tautline/geometry.hpp"
#include "tautline/scenarios.hpp"
#include "tautline/solve.hpp"
#include "tautline/system_geometry.hpp"
#include "tests/bench/spoilt_scheme.hpp"

namespace tautline::bench {
namespace {

constexpr double soft_frequency = 100.0;  // [1/s]
constexpr double soft_load = 9.81;        // [m/s^2]

/// Steps of a hundredth of 1/frequency, of second order.
constexpr double of_soft_steps = 2e-5;  // [-]

SoftRow soft_row(double ratio, double load = 0.0) {
  return {soft_frequency * soft_frequency, 2.0 * ratio * soft_frequency, load};
}

/// A ball that flies straight into its cable, 0.1 m away, with 1 m/s.
Case into_a_spring(double load) {
  Case the_case = bouncing_ball(0.5);
  the_case.gravity = Vec2(0.0, -load);
  the_case.initial.velocity = Vec2(0.0, -1.0);
  the_case.initial.position.y() = 0.1;
  return the_case;
}

/// The same as a system in space.
SpatialSystem into_a_spring_in_space(const Case& the_case) {
  SpatialSystem result;
  result.name = "into a spring";
  result.duration = the_case.duration;
  result.gravity = Function<3>::constant({the_case.gravity.x(), the_case.gravity.y(), 0.0});
  SpatialBody body;
  body.mass = the_case.body.mass;
  result.bodies = {body};
  SpatialState start;
  start.position << the_case.initial.position, 0.0;
  start.velocity << the_case.initial.velocity, 0.0;
  result.initial.bodies = {start};
  for (const Cable& cable : the_case.cables) {
    SpatialCable one;
    one.from = {std::nullopt, Eigen::Vector3d(cable.anchor.x(), cable.anchor.y(), 0.0), {}};
    one.to = {0, Eigen::Vector3d::Zero(), {}};
    one.length = Function<1>::constant(cable.length);
    one.restitution = cable.restitution;
    result.cables.push_back(one);
  }
  return result;
}

TEST(SoftMotion, ReboundsAsTheClosedFormsSay) {
  const Case the_case = into_a_spring(0.0);
  for (const double ratio : {0.0, 0.05, 0.3, 1.0, 1.5}) {
    const std::vector<SoftRow> rows = {soft_row(ratio)};
    const double contact = contact_phase(ratio) / soft_frequency;
    const auto after = soft_motion(the_case, rows, 0.1 + contact + 0.1);
    ASSERT_TRUE(after);
    const double e = restitution_of(ratio);
    EXPECT_NEAR(after->velocity.y() / e, 1.0, of_soft_steps) << ratio;
    // (E7): it lets go while the cable is still stretched by 2 ratio e v / w
    const double height = 0.1 * e - 2.0 * ratio * e / soft_frequency;
    EXPECT_NEAR(after->position.y(), height, of_soft_steps * 0.1) << ratio;
    const double half = 0.5 * contact;  // (E7)
    const auto deepest = soft_motion(the_case, rows, 0.1 + half);
    ASSERT_TRUE(deepest);
    EXPECT_NEAR(deepest->position.y() * soft_frequency, -std::sqrt(e), of_soft_steps) << ratio;
    EXPECT_NEAR(deepest->velocity.y(), 0.0, of_soft_steps) << ratio;
  }
}

TEST(SoftMotion, AgreesWithTheElasticCableOfAPointMass) {
  const Case the_case = into_a_spring(soft_load);
  SpatialSystem system = into_a_spring_in_space(the_case);
  constexpr double ratio = 0.1;
  const std::vector<SoftRow> rows = {soft_row(ratio)};
  const double until = 1.2;  // after several contacts, into the slow ones
  const auto in_space = soft_motion(system, rows, until);
  const auto in_the_plane = soft_motion(the_case, rows, until);
  ASSERT_TRUE(in_space && in_the_plane);
  system.cables[0].restitution = SpatialCable().restitution;
  system.cables[0].elasticity = Elasticity{{system.bodies[0].mass * rows[0].stiffness}, 0.0, ratio};
  system.duration = until;
  const double exact = solve(system).at(until).bodies[0].position.y();
  EXPECT_NEAR(in_the_plane->position.y(), exact, 1e-5);  // of contacts that are 1e-2 deep
  EXPECT_NEAR(in_space->bodies[0].position.y(), in_the_plane->position.y(), 1e-10);
}

TEST(SoftMotion, ARowThatTakesOverTheLoadDoesNotSag) {
  Case the_case = into_a_spring(soft_load);
  the_case.initial.position.y() = 0.0;
  the_case.initial.velocity.setZero();
  const double sag = soft_load / (soft_frequency * soft_frequency);
  for (const double load : {0.0, 0.9, 1.0}) {
    const std::vector<SoftRow> rows = {soft_row(0.7, load)};
    const auto after = soft_motion(the_case, rows, 1.0);
    ASSERT_TRUE(after);
    EXPECT_NEAR(-after->position.y() / sag, 1.0 - load, of_soft_steps) << load;
  }
}

TEST(SoftMotion, TwoCablesShareAndAreFoundWhereOneStartsInAContactOfTheOther) {
  // the second cable, 3 mm longer, is struck in the contact of the first: halves of the mass ...
  Case the_case = into_a_spring(0.0);
  the_case.cables.push_back(the_case.cables[0]);
  the_case.cables[1].length += 0.003;
  const std::vector<SoftRow> rows = {soft_row(0.0), soft_row(0.0)};
  const auto after = soft_motion(the_case, rows, 0.3);
  ASSERT_TRUE(after);
  EXPECT_NEAR(after->velocity.y(), 1.0, of_soft_steps);  // ... and no energy is lost
  // s = sin(w t)/w up to 3 mm, then half of an oscillation about 1.5 mm with sqrt(2) w, and back
  const double first = std::asin(0.003 * soft_frequency);
  const double speed = std::cos(first);
  const double stiff = std::sqrt(2.0) * soft_frequency;
  const double second = std::acos(-1.0) - 2.0 * std::atan2(0.0015 * stiff, speed);
  const double contact = 2.0 * first / soft_frequency + second / stiff;
  EXPECT_NEAR(after->position.y(), 0.3 - 0.1 - contact, of_soft_steps * 0.2);
}

TEST(SoftMotion, GivesUpWhereStepsAreTooMany) {
  Case the_case = into_a_spring(soft_load);
  the_case.initial.position.y() = 0.0;
  the_case.duration = 100.0;
  const std::vector<SoftRow> rows = {{1e12, 1.4e6}};
  const auto after = soft_motion(into_a_spring_in_space(the_case), rows, the_case.duration);
  EXPECT_FALSE(after);
  EXPECT_EQ(after.why, "springs and dampers need more than 20000 steps up to then");
}

/// A point mass on a spring and a damper, in steps of semi-implicit Euler.
class SpringSteps final : public Simulation, public SoftCables {
 public:
  SpringSteps(const Case& the_case, const SoftRow& row)
      : case_(the_case), rows_{row}, now_(the_case.initial) {}

  [[nodiscard]] State state() const override { return now_; }
  [[nodiscard]] std::span<const double> impulses() const override { return impulses_; }
  [[nodiscard]] std::span<const SoftRow> soft_rows() const override { return rows_; }

  void step(double dt) override {
    const Cable& cable = case_.cables[0];
    const double stretch = -gap(cable, now_);
    const double pull =
        rows_[0].stiffness * stretch - rows_[0].damping * gap_rate(cable, now_);  // over the mass
    impulses_[0] = stretch > 0.0 ? case_.body.mass * dt * std::max(0.0, pull) : 0.0;
    now_.velocity +=
        dt * case_.gravity + impulses_[0] / case_.body.mass * gap_gradient(cable, now_).head<2>();
    now_.position += dt * now_.velocity;
  }

 private:
  Case case_;
  std::vector<SoftRow> rows_;
  State now_;
  std::vector<double> impulses_ = {0.0};
};

/// The parts of such a run of a ball that falls on its cable, at a fixed instant.
SoftParts parts_at(double step, double& deviation) {
  Case the_case = bouncing_ball(0.7);
  the_case.duration = 2.0;  // between the first impact and the second
  const ReferenceCase reference = solve_case(the_case, ImpactLaw::simultaneous);
  SpringSteps simulation(the_case, soft_row(damping_ratio_of(0.7)));
  const Trajectory run = record(the_case, simulation, step);
  const Attribution found = attribute(the_case, reference.solution, reference.horizon, run);
  EXPECT_TRUE(found.parts) << found.reason;
  EXPECT_TRUE(found.soft);
  deviation = found.deviation;
  return found.soft.value_or(SoftParts{});
}

TEST(AttributionOfSoftCables, ShorterStepsTakeAwayTheirPartAndLeaveTheModels) {
  double coarse_deviation = 0.0;
  double fine_deviation = 0.0;
  const SoftParts coarse = parts_at(1e-3, coarse_deviation);
  const SoftParts fine = parts_at(1e-4, fine_deviation);
  EXPECT_NEAR(coarse.model + coarse.step, coarse_deviation, 1e-12);
  EXPECT_NEAR(fine.model + fine.step, fine_deviation, 1e-12);
  EXPECT_GT(std::abs(coarse.step), 0.0);
  EXPECT_LT(std::abs(fine.step), 0.2 * std::abs(coarse.step));
  // the instants are a step of 1 ms apart at most, and the direction of the deviation is the same
  EXPECT_NEAR(fine.model, coarse.model, 0.02 * std::abs(coarse.model));
  EXPECT_GT(std::abs(fine.model), 10.0 * std::abs(fine.step));
}

TEST(AttributionOfSoftCables, SaysWhyItLeavesThemOut) {
  Case the_case = bouncing_ball(0.7);
  the_case.duration = 2.0;
  const SpatialSystem system = into_a_spring_in_space(the_case);
  const auto solution = solve(system);
  tautline::test::Spoiled simulation(system, {}, {});  // by nothing
  SystemTrajectory run = record(system, simulation, 1e-3);
  const Attribution without = attribute(system, solution, solution.end_time(), run);
  ASSERT_TRUE(without.parts) << without.reason;
  EXPECT_EQ(without.reason, "");
  run.soft_rows = {{1.0, 1e10}};  // it creeps
  const Attribution found = attribute(system, solution, solution.end_time(), run);
  EXPECT_FALSE(found.soft);
  EXPECT_EQ(found.reason,
            "no model and step: springs and dampers need more than 20000 steps up to then");
}

TEST(AttributionOfSoftCables, HasNoSuchPartsWhereCablesAreNotSoft) {
  Case the_case = bouncing_ball(0.7);
  the_case.duration = 2.0;
  const ReferenceCase reference = solve_case(the_case, ImpactLaw::simultaneous);
  SpringSteps simulation(the_case, soft_row(0.1));
  Trajectory run = record(the_case, simulation, 1e-3);
  ASSERT_EQ(run.soft_rows.size(), 1U);
  run.soft_rows.clear();
  const Attribution found = attribute(the_case, reference.solution, reference.horizon, run);
  EXPECT_FALSE(found.soft);
  EXPECT_EQ(found.reason.find("model"), std::string::npos) << found.reason;
}

}  // namespace
}  // namespace tautline::bench
