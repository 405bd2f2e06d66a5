// A start that is typed with a few digits, made taut.

#include <gtest/gtest.h>

#include <Eigen/QR>
#include <cmath>

#include "support.hpp"
#include "tautline/detail/projection.hpp"
#include "tautline/geometry.hpp"
#include "tautline/settling.hpp"
#include "tautline/solve.hpp"

namespace tautline {
namespace {

/// `value` as it is typed with so many digits after the point.
double typed(double value, int digits) {
  const double unit = std::pow(10.0, -digits);
  return std::round(value / unit) * unit;
}

/// A pendulum of length 1 at this angle from the plumb line, in mid-swing, all typed.
Case typed_pendulum(double angle, double speed, int digits) {
  Case result;
  result.name = "pendulum";
  result.duration = 10.0;
  result.gravity = {0.0, -9.81};
  result.cables = {{{0.0, 0.0}, {0.0, 0.0}, 1.0, 1.0}};
  result.body = {1.0, 0.0};
  result.initial.position = {typed(std::sin(angle), digits), typed(-std::cos(angle), digits)};
  result.initial.velocity = {typed(speed * std::cos(angle), digits),
                             typed(speed * std::sin(angle), digits)};
  return result;
}

TEST(TautStart, APendulumTypedWithAFewDigitsSwings) {
  for (const double angle : {0.349, -0.7, 1.2}) {
    for (const double speed : {0.0, 0.9, -0.5}) {
      for (const int digits : {4, 7, 10}) {
        Case the_case = typed_pendulum(angle, speed, digits);
        const TautStart found = taut_start(the_case, CableSet::of(0));
        ASSERT_TRUE(found.start) << found.problems.front();
        EXPECT_LE(found.moved, std::pow(10.0, -digits)) << "no further than it was rounded";
        EXPECT_LE(found.slowed, 4.0 * std::pow(10.0, -digits));
        the_case.initial = *found.start;
        const Solution solution = solve(the_case);
        ASSERT_EQ(solution.events().size(), 1U) << angle << ", " << speed << ", " << digits;
        EXPECT_EQ(solution.events().front().kind, EventKind::taut);
        const TautStart again = taut_start(the_case, CableSet::of(0));
        EXPECT_EQ(again.start->position, found.start->position) << "to the last bit";
        EXPECT_EQ(again.start->velocity, found.start->velocity);
      }
    }
  }
}

// the least move has no part along what keeps the gaps: M (change) is along the cables' gradients
TEST(TautStart, MovesTheBodyByTheLeastInItsMass) {
  test::Random random(7);
  int tried = 0;
  for (int system = 0; system < 200; ++system) {
    test::Draw draw;
    draw.cables = 1 + static_cast<std::size_t>(system % 2);
    draw.taut_chance = 1.0;
    Case the_case = test::random_case(random, draw);
    const State taut = the_case.initial;
    the_case.initial.position += 1e-6 * random.in_square(1.0);
    the_case.initial.angle += is_point_mass(the_case) ? 0.0 : 1e-6 * random.uniform(-1.0, 1.0);
    CableSet cables;
    for (const std::size_t index : test::all_cables(the_case)) {
      if (std::abs(gap(the_case.cables[index], taut)) < 1e-12) {
        cables.insert(index);
      }
    }
    const TautStart found = cables.empty() ? TautStart{} : taut_start(the_case, cables);
    if (!found.start) {
      continue;  // none is taut, or they are nearly in line
    }
    ++tried;
    Eigen::MatrixXd rows(3, static_cast<Eigen::Index>(cables.size()));
    Eigen::Index column = 0;
    for (const std::size_t index : cables) {
      EXPECT_LE(std::abs(gap(the_case.cables[index], *found.start)), 1e-14);
      rows.col(column++) = gap_gradient(the_case.cables[index], *found.start);
    }
    Eigen::Vector3d push(found.start->position.x() - the_case.initial.position.x(),
                         found.start->position.y() - the_case.initial.position.y(),
                         found.start->angle - the_case.initial.angle);
    push = push.cwiseProduct(
        Eigen::Vector3d(the_case.body.mass, the_case.body.mass, the_case.body.inertia));
    const Eigen::VectorXd along = rows.colPivHouseholderQr().solve(push);
    EXPECT_LE((push - rows * along).norm(), 1e-3 * push.norm() + 1e-15) << "system " << system;
    EXPECT_EQ(found.turned, std::abs(found.start->angle - the_case.initial.angle));
  }
  EXPECT_GE(tried, 100);
}

TEST(TautStart, ARateThatIsMeantStays) {
  Case falling = typed_pendulum(0.349, 0.0, 7);
  falling.initial.velocity = {0.0, -2.0};
  const TautStart found = taut_start(falling, CableSet::of(0));
  ASSERT_TRUE(found.start);
  EXPECT_EQ(found.start->velocity, falling.initial.velocity);
  falling.initial = *found.start;
  const Solution solution = solve(falling);
  ASSERT_FALSE(solution.events().empty());
  EXPECT_EQ(solution.events().front().kind, EventKind::impact);
  EXPECT_EQ(solution.events().front().time, 0.0);
}

TEST(TautStart, CablesThatNoPoseNearbyClosesAreRefused) {
  Case the_case;  // a point on the line of two anchors, 1e-4 short of both
  the_case.cables = {{{0.0, 1.0}, {0.0, 0.0}, 1.0001, 0.5}, {{0.0, -1.0}, {0.0, 0.0}, 1.0001, 0.5}};
  const TautStart found = taut_start(the_case, CableSet::first(2));
  EXPECT_FALSE(found.start);
  ASSERT_EQ(found.problems.size(), 1U);
  EXPECT_TRUE(found.problems.front().starts_with("cables 0+1 cannot start taut together"))
      << found.problems.front();
}

}  // namespace
}  // namespace tautline
