#include "tautline/detail/sensitivity.hpp"

#include <gtest/gtest.h>

#include <Eigen/LU>
#include <cmath>
#include <limits>
#include <string>

#include "sensitivity/tangent.hpp"
#include "sensitivity/taut_slopes.hpp"
#include "support.hpp"
#include "tautline/detail/series.hpp"
#include "tautline/geometry.hpp"
#include "tautline/impact.hpp"
#include "tautline/scenarios.hpp"
#include "tautline/solve.hpp"

namespace tautline::test {
namespace {

constexpr double epsilon_of_double = std::numeric_limits<double>::epsilon();

/// The state's six numbers.
Eigen::Matrix<double, 6, 1> numbers(const State& state) {
  Eigen::Matrix<double, 6, 1> result;
  result << state.position, state.angle, state.velocity, state.spin;
  return result;
}

/// d state(time) / d initial state by central differences of whole solutions, `step` to each side.
StateMatrix difference_quotients(const Case& the_case, double time, double step) {
  StateMatrix result;
  for (int axis = 0; axis < 6; ++axis) {
    const auto run = [&](double by) {
      Case nearby = the_case;
      State& start = nearby.initial;
      double* const number[] = {&start.position.x(), &start.position.y(), &start.angle,
                                &start.velocity.x(), &start.velocity.y(), &start.spin};
      *number[axis] += by;
      return numbers(solve(nearby).at(time));
    };
    result.col(axis) = (run(step) - run(-step)) / (2 * step);
  }
  return result;
}

Case falling_symmetrically() {
  Breakwater parameters;
  parameters.initial.position = Vec2(0.0, 0.2);
  parameters.duration = 3.0;
  return breakwater(parameters, "symmetric");
}

}  // namespace

TEST(Sensitivity, OfFlightIsIdentityAndTime) {
  Case the_case = bouncing_ball();
  the_case.duration = 0.9;  // before the first impact
  const Sensitivity sensitivity(the_case, solve(the_case));
  StateMatrix expected = StateMatrix::Identity();
  expected.topRightCorner<3, 3>().diagonal().setConstant(0.5);
  EXPECT_EQ(sensitivity.at(0.5), expected);
  EXPECT_TRUE(sensitivity.saltations().empty());
  EXPECT_THROW((void)sensitivity.at(0.95), std::out_of_range);
}

TEST(Sensitivity, OfAnImpactScalesVolumeByTheSquareOfRestitution) {
  // the determinant of a matrix with a largest singular value s and determinant near one is off by
  // rounding times s squared: the smallest singular value is near 1 / s
  constexpr double rounding = 20 * epsilon_of_double;  // of some ten operations an entry
  double worst = 0.0;
  for (const TableRow& row : table_5_1()) {
    const Case the_case = breakwater(row.parameters, std::string(row.number));
    const Solution solution = solve(the_case);
    const Sensitivity sensitivity(the_case, solution);
    auto event = solution.events().begin();
    for (const Saltation& saltation : sensitivity.saltations()) {
      if (event->kind != EventKind::impact || event->cables.size() != 1 ||
          event->time != saltation.time ||
          (event + 1 != solution.events().end() && (event + 1)->time == event->time)) {
        break;  // up to the first accumulation
      }
      const double size = saltation.matrix.cwiseAbs().maxCoeff();
      const double e = row.parameters.e;
      worst = std::max(worst, std::abs(saltation.matrix.determinant() - e * e) / (size * size));
      ++event;
    }
  }
  expect_within("determinant - e^2, over the square of the largest entry", worst, rounding);
}

TEST(Sensitivity, AgreesWithDifferencesOfSolutions) {
  // a step of 1e-6: its square times third derivatives, of the size of the growth cubed, 1e5
  constexpr double curvature = 1e-6;
  for (const char* const number : {"1910121100", "1911121100", "1510121100", "1900461100"}) {
    Case the_case = table_case(number);
    the_case.duration = 1.0;
    const Sensitivity sensitivity(the_case, solve(the_case));
    const StateMatrix expected = difference_quotients(the_case, 1.0, 1e-6);
    const StateMatrix reached = sensitivity.at(1.0);
    expect_within(std::string("derivative in ") + number,
                  (reached - expected).norm() / expected.norm(), curvature);
  }
}

TEST(Sensitivity, BetweenTwoInstantsIsWhatCarriesTheOneToTheOther) {
  for (const Case& the_case : shipped_cases()) {
    if (the_case.name != "crane-load" && the_case.name != "caught-swing" &&
        the_case.name != "breakwater/1910121100") {
      continue;
    }
    const Solution solution = solve(the_case);
    const Sensitivity sensitivity(the_case, solution);
    const double end = std::min(2.0, solution.end_time());
    EXPECT_TRUE(sensitivity.between(end, end).isApprox(StateMatrix::Identity(), 1e-12));
    for (const double from : {0.0, 0.2 * end, 0.7 * end}) {
      const StateMatrix carried = sensitivity.between(from, end) * sensitivity.at(from);
      const double size = sensitivity.at(end).cwiseAbs().maxCoeff();
      EXPECT_LT((carried - sensitivity.at(end)).cwiseAbs().maxCoeff(), 1e-9 * size)
          << the_case.name << ' ' << from;
    }
    EXPECT_THROW(static_cast<void>(sensitivity.between(end, 0.0)), std::out_of_range);
  }
}

TEST(Sensitivity, OfABallAtRestIsThatOfAPendulum) {
  const Case ball = bouncing_ball(0.5);  // at rest from t = 3 on, a distance of 2 below its anchor
  const Solution solution = solve(ball);
  const Sensitivity sensitivity(ball, solution);
  const double start = solution.arcs().back().start;
  const StateMatrix before = sensitivity.at(start);
  const double rate = std::sqrt(1.0 / 2.0);  // [rad/s], of a pendulum of length 2
  double worst = 0.0;
  for (const double dt : {0.1, 1.0, 3.0, 6.9}) {
    StateMatrix swing = StateMatrix::Identity();
    swing(0, 0) = swing(3, 3) = std::cos(rate * dt);
    swing(0, 3) = std::sin(rate * dt) / rate;
    swing(3, 0) = -std::sin(rate * dt) * rate;
    swing(1, 1) = swing(4, 4) = 0.0;
    swing(2, 5) = dt;
    worst = std::max(worst, (sensitivity.at(start + dt) - swing * before).cwiseAbs().maxCoeff());
  }
  expect_within("derivative against the pendulum's", worst, 1e-13);  // of entries up to 10
  EXPECT_FALSE(sensitivity.horizon(1e-3, 1e-12));
}

TEST(Sensitivity, IsInfiniteFromAChanceMeetingOfImpactsOn) {
  // both cables close at once; every neighbour off the symmetry hits one of them first
  const Case the_case = falling_symmetrically();
  const Solution solution = solve(the_case);
  ASSERT_EQ(solution.events().front().cables.size(), 2U);
  const double meeting = solution.events().front().time;
  const Sensitivity sensitivity(the_case, solution);
  EXPECT_LT(sensitivity.growth(0.99 * meeting), 2.0);
  EXPECT_EQ(sensitivity.growth(meeting), std::numeric_limits<double>::infinity());
  EXPECT_EQ(sensitivity.horizon(1e-3, 1e-12), meeting);
}

TEST(Sensitivity, OfCablesSideBySideIsThatOfOne) {
  Case one = table_case("1910121100");
  one.duration = 2.0;
  Case two = one;
  two.cables.push_back(two.cables[0]);
  const StateMatrix expected = Sensitivity(one, solve(one)).at(2.0);
  const StateMatrix reached = Sensitivity(two, solve(two)).at(2.0);
  expect_within("difference", (reached - expected).norm() / expected.norm(), 1e-12);
}

/// The acceleration of taut motion from `start`, `by` along a change of it.
Eigen::Vector3d acceleration_near(const Case& the_case, State start, CableSet taut,
                                  const Eigen::Matrix<double, 6, 1>& by) {
  start.position += by.head<2>();
  start.angle += by[2];
  start.velocity += by.segment<2>(3);
  start.spin += by[5];
  const TautSeries<double> motion(the_case, start, taut, 3);
  Eigen::Vector3d result;
  result << 2.0 * motion.position(2), 2.0 * motion.angle()[2];
  return result;
}

TEST(Sensitivity, AccelerationsOfTautMotionChangeAsTheSeriesDo) {
  constexpr double step = 1e-5;       // [-], of a change in metres, radians and their rates
  constexpr double tolerance = 1e-7;  // [-], of differences over it: cubes of 1e-5, rounding / 1e-5
  constexpr std::size_t most_arcs = 20;
  std::size_t of_one = 0;
  std::size_t of_more = 0;
  for (const Case& the_case : shipped_cases()) {
    const Solution solution = solve(the_case);
    std::size_t arcs = 0;
    for (const Arc& arc : solution.arcs()) {
      if (arc.series.rows() < 3 || !independent(the_case, arc.initial, arc.taut) ||
          ++arcs > most_arcs) {
        continue;
      }
      const auto slopes = taut_slopes(the_case, arc.initial, arc.taut);
      const Tangent along = tangent(the_case, arc.initial, arc.taut);
      for (Eigen::Index axis = 0; axis < along.directions.cols(); ++axis) {
        const Eigen::Matrix<double, 6, 1> change = along.directions.col(axis).normalized();
        const auto near = [&](double by) {
          return acceleration_near(the_case, arc.initial, arc.taut, by * change);
        };
        const Eigen::Vector3d difference = (near(step) - near(-step)) / (2.0 * step);
        const Eigen::Vector3d expected = slopes * change;
        EXPECT_LE((difference - expected).norm(),
                  tolerance * (expected.norm() + acceleration_scale(the_case, arc.initial)))
            << the_case.name << " at " << arc.start;
      }
      ++(arc.taut.size() == 1 ? of_one : of_more);
    }
  }
  EXPECT_GT(of_one, 100U);
  EXPECT_GT(of_more, 100U);
}

TEST(Sensitivity, HorizonIsTheFirstPassage) {
  const Case the_case = table_case("1910121100");
  const Solution solution = solve(the_case);
  const Sensitivity sensitivity(the_case, solution);
  for (const double ratio : {3.0, 1e3, 1e6, 1e9}) {
    const auto horizon = sensitivity.horizon(ratio * 1e-12, 1e-12);
    ASSERT_TRUE(horizon) << ratio;
    EXPECT_GE(sensitivity.growth(*horizon) * (1 + 1e-9), ratio);
    for (int sample = 0; sample < 2000; ++sample) {
      EXPECT_LT(sensitivity.growth(*horizon * sample / 2000), ratio) << *horizon;
    }
  }
}

}  // namespace tautline::test
