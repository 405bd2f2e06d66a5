#include <gtest/gtest.h>

#include <Eigen/Geometry>
#include <algorithm>
#include <cmath>
#include <stdexcept>
#include <vector>

#include "support.hpp"
#include "tautline/geometry.hpp"
#include "tautline/solve.hpp"

// Tensions against closed forms, and against a linkage solved by other means.

namespace tautline::test {
namespace {

/// Of the largest tension of a motion [-].
constexpr double of_the_largest = 1e-11;

constexpr int tension_samples = 200;  // of a motion

Case on_one_cable(double length, double mass, const Vec2& gravity) {
  Case result;
  result.name = "one-cable";
  result.body = {mass, 0.0};
  result.cables = {{{0.0, 0.0}, {0.0, 0.0}, length, 0.0, 0.0, {}}};
  result.gravity = gravity;
  return result;
}

/// The largest relative error of the tension of cable 0 against `wanted`, of a state.
template <class Wanted>
double worst_error(const Solution& solution, const Wanted& wanted) {
  double worst = 0.0;
  double largest = 0.0;
  for (int k = 0; k <= tension_samples; ++k) {
    const double time =
        solution.end_time() * std::min(1.0, static_cast<double>(k) / tension_samples);
    const double right = wanted(time, solution.at(time));
    worst = std::max(worst, std::abs(solution.tensions(time)[0] - right));
    largest = std::max(largest, std::abs(right));
  }
  return worst / largest;
}

struct PendulumOf {
  double mass;
  double length;
  double gravity;
  double start;  // [rad] from the lowest point, at rest
};

class PendulumTension : public ::testing::TestWithParam<PendulumOf> {};

TEST_P(PendulumTension, IsThreeCosinesLessTwoOfTheStart) {
  const double mass = GetParam().mass;
  const double length = GetParam().length;
  const double gravity = GetParam().gravity;
  const double start = GetParam().start;
  Case the_case = on_one_cable(length, mass, {0.0, -gravity});
  the_case.initial.position = {length * std::sin(start), -length * std::cos(start)};
  the_case.duration = 7.0 * std::sqrt(length / gravity);
  const Solution solution = solve(the_case);
  ASSERT_EQ(solution.arcs().front().taut, CableSet::of(0));
  const double error = worst_error(solution, [&](double /*time*/, const State& state) {
    const double cosine = -state.position.y() / length;
    return mass * gravity * (3.0 * cosine - 2.0 * std::cos(start));
  });
  expect_within("tension of a pendulum", error, of_the_largest);
}

INSTANTIATE_TEST_SUITE_P(Closed, PendulumTension,
                         ::testing::Values(PendulumOf{1.0, 1.0, 9.81, 0.5},
                                           PendulumOf{2.5, 0.3, 9.81, 1.5},
                                           PendulumOf{0.01, 12.0, 1.62, 1.2},
                                           PendulumOf{4000.0, 30.0, 9.81, 0.02},
                                           PendulumOf{7.0, 1.0, 24.8, 1.0}));

struct CircleOf {
  double mass;
  double length;
  double speed;
};

class CircleTension : public ::testing::TestWithParam<CircleOf> {};

TEST_P(CircleTension, IsTheCentripetalForce) {
  const auto [mass, length, speed] = GetParam();
  Case the_case = on_one_cable(length, mass, {0.0, 0.0});
  the_case.initial.position = {length, 0.0};
  the_case.initial.velocity = {0.0, speed};
  the_case.duration = 20.0 * length / speed;
  const double right = mass * speed * speed / length;
  const double error =
      worst_error(solve(the_case), [&](double /*time*/, const State& /*state*/) { return right; });
  expect_within("tension of a circle", error, of_the_largest);
}

INSTANTIATE_TEST_SUITE_P(Closed, CircleTension,
                         ::testing::Values(CircleOf{1.0, 1.0, 2.0}, CircleOf{0.2, 5.0, 30.0},
                                           CircleOf{70.0, 0.01, 0.5}, CircleOf{3.0, 2.0, 1e-3}));

class WhirlTension : public ::testing::TestWithParam<double> {};

/// A stone that goes all the way round: m v^2 / L + m g cos(phi), v^2 from the energy.
TEST_P(WhirlTension, IsWeightAndCentripetalForceAllTheWayRound) {
  const double lowest_speed = GetParam();  // [m/s]
  constexpr double gravity = 9.81;
  constexpr double length = 0.8;
  constexpr double mass = 0.5;
  Case the_case = on_one_cable(length, mass, {0.0, -gravity});
  the_case.initial.position = {0.0, -length};
  the_case.initial.velocity = {lowest_speed, 0.0};
  the_case.duration = 5.0;
  const double error = worst_error(solve(the_case), [&](double /*time*/, const State& state) {
    const double cosine = -state.position.y() / length;
    const double square = lowest_speed * lowest_speed - 2.0 * gravity * length * (1.0 - cosine);
    return mass * (square / length + gravity * cosine);
  });
  expect_within("tension of a whirl", error, of_the_largest);
}

INSTANTIATE_TEST_SUITE_P(Closed, WhirlTension, ::testing::Values(6.5, 9.0, 40.0));

Case hanging_box(double offset) {
  Case the_case;
  the_case.name = "hanging-box";
  the_case.body = {5.0, 0.8333333333333334};
  for (const double side : {-0.5, 0.5}) {
    the_case.cables.push_back({{side + offset, 5.0}, {side + offset, 0.5}, 3.0, 0.0, 0.0, {}});
  }
  the_case.gravity = {0.0, -9.81};
  the_case.initial.position = {0.0, 2.0};
  the_case.duration = 20.0;
  return the_case;
}

TEST(Tension, OfAHangingBoxIsHalfTheWeightEach) {
  const Solution solution = solve(hanging_box(0.0));
  EXPECT_EQ(solution.ending(), Ending::rest);
  const CableVector fallen = solution.tensions(0.1);  // 0.5 m above the ropes' end
  EXPECT_EQ(fallen, CableVector::Zero(2));
  const CableVector held = solution.tensions(20.0);
  const double weight = 5.0 * 9.81;
  for (Eigen::Index cable = 0; cable < 2; ++cable) {
    expect_within("share of the weight", std::abs(held[cable] / (weight / 2.0) - 1.0),
                  of_the_largest);
  }
}

/// Ropes at -0.5 + c and 0.5 + c from the centre carry m g (1/2 + c) and m g (1/2 - c).
TEST(Tension, OfABoxHungAsideIsThatOfALever) {
  for (const double aside : {-0.4, 0.1, 0.45}) {
    Case the_case = hanging_box(aside);
    for (Cable& cable : the_case.cables) {
      cable.length = 2.5;
    }
    the_case.initial.position = {0.0, 2.0};
    const CableVector held = solve(the_case).tensions(1.0);
    const double weight = 5.0 * 9.81;
    expect_within("left", std::abs(held[0] - weight * (0.5 + aside)) / weight, of_the_largest);
    expect_within("right", std::abs(held[1] - weight * (0.5 - aside)) / weight, of_the_largest);
  }
}

/// Vertical ropes at x_k carry a + b x_k, where that pulls: the smallest sum of squares.
TEST(Tension, OfRedundantRopesIsTheSmallestThatPulls) {
  const auto hung = [](std::vector<double> places) {
    Case the_case;
    the_case.name = "ropes";
    the_case.body = {2.0, 1.0};
    for (const double x : places) {
      the_case.cables.push_back({{x, 3.0}, {x, 0.0}, 3.0, 0.0, 0.0, {}});
    }
    the_case.gravity = {0.0, -10.0};
    the_case.duration = 3.0;
    return solve(the_case).tensions(2.0);
  };
  constexpr double newtons = 1e-11 * 20.0;
  const CableVector four = hung({-2.0, -1.0, 1.0, 2.0});
  for (Eigen::Index cable = 0; cable < 4; ++cable) {
    EXPECT_NEAR(four[cable], 5.0, newtons) << cable;
  }
  const CableVector three = hung({-1.0, 0.0, 2.0});  // sum 20, moment 0: a = 50/7, b = -10/7
  EXPECT_NEAR(three[0], 60.0 / 7.0, newtons);
  EXPECT_NEAR(three[1], 50.0 / 7.0, newtons);
  EXPECT_NEAR(three[2], 30.0 / 7.0, newtons);
  // without the sign the rope at 9 would push: the other two carry all
  const CableVector one_idle = hung({-1.0, 1.0, 1.5, 9.0});
  EXPECT_GE(one_idle.minCoeff(), 0.0);
  EXPECT_EQ(one_idle[3], 0.0);
  EXPECT_NEAR(one_idle.sum(), 20.0, newtons);
  EXPECT_NEAR(-one_idle[0] + one_idle[1] + 1.5 * one_idle[2], 0.0, newtons);
}

/// The same linkage by another way: its equations of motion in descriptor form, M q" + J^T z = f
/// and J q" = -J' q', with half the squared distance as the constraint, solved as one dense system
/// and followed by the classical Runge-Kutta method.
class Descriptor {
 public:
  Descriptor(const Case& the_case, const State& state) : case_(the_case) {
    q_ << state.position, state.angle, state.velocity, state.spin;
  }

  void step(double h) {
    const Vector6 a = rate(q_);
    const Vector6 b = rate(q_ + 0.5 * h * a);
    const Vector6 c = rate(q_ + 0.5 * h * b);
    q_ += h / 6.0 * (a + 2.0 * b + 2.0 * c + rate(q_ + h * c));
  }

  /// [N]
  [[nodiscard]] double tension(std::size_t cable) const {
    return solved(q_)[3 + static_cast<Eigen::Index>(cable)] * case_.cables[cable].length;
  }

 private:
  using Vector6 = Eigen::Matrix<double, 6, 1>;
  using Vector5 = Eigen::Matrix<double, 5, 1>;

  [[nodiscard]] Vector6 rate(const Vector6& q) const {
    Vector6 result;
    result << q.tail<3>(), solved(q).head<3>();
    return result;
  }

  /// The accelerations and the multipliers.
  [[nodiscard]] Vector5 solved(const Vector6& q) const {
    Eigen::Matrix<double, 5, 5> matrix = Eigen::Matrix<double, 5, 5>::Zero();
    Vector5 right = Vector5::Zero();
    matrix.diagonal().head<3>() << case_.body.mass, case_.body.mass, case_.body.inertia;
    right.head<2>() = case_.body.mass * case_.gravity;
    for (Eigen::Index k = 0; k < 2; ++k) {
      const Cable& cable = case_.cables[static_cast<std::size_t>(k)];
      const Vec2 arm = Eigen::Rotation2Dd(q[2]) * cable.attachment;
      const Vec2 turned(-arm.y(), arm.x());
      const Vec2 from = q.head<2>() + arm - cable.anchor;
      const Vec2 velocity = q.segment<2>(3) + q[5] * turned;
      matrix.row(3 + k).head<3>() << from.x(), from.y(), from.dot(turned);
      matrix.col(3 + k).head<3>() = matrix.row(3 + k).head<3>().transpose();
      right[3 + k] = -velocity.squaredNorm() + q[5] * q[5] * from.dot(arm);
    }
    return matrix.fullPivLu().solve(right);
  }

  const Case& case_;
  Vector6 q_;
};

TEST(Tension, OfATwoCableLinkageIsThatOfItsDescriptorForm) {
  for (const double angle : {0.05, 0.2, 0.5}) {
    Case the_case = table_case("1510121100");
    the_case.initial = on_linkage(the_case, angle);
    the_case.duration = 3.0;
    const Solution solution = solve(the_case);
    ASSERT_EQ(solution.arcs().front().taut, CableSet::first(2)) << angle;
    Descriptor other(the_case, the_case.initial);
    constexpr int steps = 6000;  // whose error is near 1e-13
    double worst = 0.0;
    double largest = 0.0;
    for (int k = 0; k < steps && solution.events().size() < 2; ++k) {
      const CableVector found = solution.tensions(the_case.duration * k / steps);
      for (std::size_t cable = 0; cable < 2; ++cable) {
        const double right = other.tension(cable);
        worst = std::max(worst, std::abs(found[static_cast<Eigen::Index>(cable)] - right));
        largest = std::max(largest, right);
      }
      other.step(the_case.duration / steps);
    }
    ASSERT_GT(largest, 0.0) << angle;
    expect_within("tension of a linkage", worst / largest, of_the_largest);
  }
}

TEST(Tension, BeforeAnEventIsThatOfTheArcWhichEndsThere) {
  Case the_case = hanging_box(0.0);
  the_case.cables[1].length = 3.2;
  const Solution solution = solve(the_case);
  const auto& arcs = solution.arcs();
  for (std::size_t k = 1; k < arcs.size(); ++k) {
    const CableVector before = solution.tensions(arcs[k - 1], arcs[k - 1].end - arcs[k - 1].start);
    for (std::size_t cable = 0; cable < 2; ++cable) {
      if (!arcs[k - 1].taut.contains(cable)) {
        EXPECT_EQ(before[static_cast<Eigen::Index>(cable)], 0.0);
      }
    }
  }
  EXPECT_THROW((void)solution.tensions(-1.0), std::out_of_range);
}

}  // namespace
}  // namespace tautline::test
