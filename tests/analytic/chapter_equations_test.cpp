// The source chapter's own equations, with the signs of its extraction corrected
// (analytic/README.md section 7), against the solver's. S = 1, so r, a, b, h and times are
// nondimensional.

#include <gtest/gtest.h>
#include <rapidcheck.h>

#include <Eigen/LU>
#include <cmath>

#include "support.hpp"
#include "tautline/geometry.hpp"
#include "tautline/impact.hpp"

namespace tautline::test {
namespace {

/// The chapter's lengths at one state: Eqs. 5.7-5.10, 5.72, 5.73, 5.100, 5.101.
struct Chapter {
  Chapter(const Breakwater& p, const State& q)
      : h(std::sqrt(p.r * p.r - (1.0 - p.a) * (1.0 - p.a))) {
    const double c = std::cos(q.angle);
    const double s = std::sin(q.angle);
    const double x = q.position.x();
    const double y = q.position.y();
    jvx = 1.0 + x - p.a * c - p.b * s;
    jvy = h + p.b - y + p.a * s - p.b * c;
    kwx = 1.0 - x - p.a * c + p.b * s;
    kwy = h + p.b - y - p.a * s - p.b * c;
    cwx = p.a * c - p.b * s;
    cwy = p.a * s + p.b * c;
    cvx = p.a * c + p.b * s;  // to the left
    cvy = -p.a * s + p.b * c;
  }
  double h, jvx, jvy, kwx, kwy, cwx, cwy, cvx, cvy;
};

/// Solves 3 equations by Cramer's rule, as the chapter does after Eq. 5.92.
Eigen::Vector3d cramer(const Eigen::Matrix3d& a, const Eigen::Vector3d& b) {
  Eigen::Vector3d result;
  for (int column = 0; column < 3; ++column) {
    Eigen::Matrix3d replaced = a;
    replaced.col(column) = b;
    result[column] = replaced.determinant() / a.determinant();
  }
  return result;
}

/// (x', y', angle') after an impact of the right cable, g1 = 0: Eqs. 5.67-5.92.
Eigen::Vector3d right_impact(const Breakwater& p, double inertia, const State& q) {
  const Chapter k(p, q);
  const double sine = k.kwx / p.r;  // of phi, the cable's angle from the vertical
  const double cosine = k.kwy / p.r;
  const Vec2 v = q.velocity;
  const double vx = v.x() - k.cwy * q.spin;
  const double vy = v.y() + k.cwx * q.spin;
  const double vn = -vx * sine - vy * cosine;
  Eigen::Matrix3d a;
  a << -sine, -cosine, k.cwy * sine - k.cwx * cosine,  //
      k.kwy, -k.kwx, 0.0,                              //
      -k.cwy, k.cwx, -inertia;
  return cramer(a, {-p.e * vn, k.kwy * v.x() - k.kwx * v.y(),
                    -k.cwy * v.x() + k.cwx * v.y() - inertia * q.spin});
}

/// The same for the left cable, g2 = 0: Eqs. 5.95-5.119.
Eigen::Vector3d left_impact(const Breakwater& p, double inertia, const State& q) {
  const Chapter k(p, q);
  const double sine = k.jvx / p.r;  // of psi
  const double cosine = k.jvy / p.r;
  const Vec2 v = q.velocity;
  const double vx = v.x() - k.cvy * q.spin;
  const double vy = v.y() - k.cvx * q.spin;
  const double vn = vx * sine - vy * cosine;
  Eigen::Matrix3d a;
  a << sine, -cosine, -k.cvy * sine + k.cvx * cosine,  //
      k.jvy, k.jvx, 0.0,                               //
      k.cvy, k.cvx, inertia;
  return cramer(a, {-p.e * vn, k.jvy * v.x() + k.jvx * v.y(),
                    k.cvy * v.x() + k.cvx * v.y() + inertia * q.spin});
}

/// A number of [low, high] in RapidCheck's hands.
double number(double low, double high) {
  constexpr int steps = 1'000'000;
  return low + (high - low) * *rc::gen::inRange(0, steps + 1) / steps;
}

Breakwater any_breakwater() {
  Breakwater p;
  p.r = number(1.2, 3.0);
  p.e = number(0.0, 1.0);
  p.a = number(0.05, 0.4);
  p.b = number(0.0, 0.4);
  p.shape = p.b == 0.0 ? Shape::ring : Shape::box;
  return p;
}

State any_motion() {
  return {Vec2{number(-0.3, 0.3), number(-0.2, 0.6)}, number(-1.5, 1.5),
          Vec2{number(-1.0, 1.0), number(-1.0, 1.0)}, number(-3.0, 3.0)};
}

/// Moves the body straight from or to one anchor until that cable is at zero gap, and makes it
/// close.
State at_impact(const Case& the_case, std::size_t index, State state) {
  const Cable& cable = the_case.cables[index];
  const Vec2 u = (attachment_point(state, cable) - cable.anchor).normalized();
  state.position += gap(cable, state) * u;
  if (gap_rate(cable, state) > 0.0) {
    state.velocity = -state.velocity;
    state.spin = -state.spin;
  }
  return state;
}

TEST(ChapterEquations, CramersRuleGivesTheRightCablesImpact) {
  expect_always("g1 = 0: Eqs. 5.71-5.92 are newton_impact", [] {
    const Breakwater p = any_breakwater();
    const Case the_case = breakwater(p, "any");
    const State before = at_impact(the_case, 1, any_motion());
    const Eigen::Vector3d expected = right_impact(p, the_case.body.inertia, before);
    const State after = newton_impact(the_case, before, CableSet::of(1)).after;
    const Eigen::Vector3d got(after.velocity.x(), after.velocity.y(), after.spin);
    constexpr double rounding = 1e-12;  // determinant r (Ic + l^2) >= 0.001, speeds up to 100
    RC_ASSERT((got - expected).cwiseAbs().maxCoeff() <= rounding);
  });
}

TEST(ChapterEquations, CramersRuleGivesTheLeftCablesImpact) {
  expect_always("g2 = 0: Eqs. 5.99-5.119 are newton_impact", [] {
    const Breakwater p = any_breakwater();
    const Case the_case = breakwater(p, "any");
    const State before = at_impact(the_case, 0, any_motion());
    const Eigen::Vector3d expected = left_impact(p, the_case.body.inertia, before);
    const State after = newton_impact(the_case, before, CableSet::of(0)).after;
    const Eigen::Vector3d got(after.velocity.x(), after.velocity.y(), after.spin);
    constexpr double rounding = 1e-12;  // determinant r (Ic + l^2) >= 0.001, speeds up to 100
    RC_ASSERT((got - expected).cwiseAbs().maxCoeff() <= rounding);
  });
}

TEST(ChapterEquations, GapsAreTheChaptersConstraintsWithTheSignTurned) {
  expect_always("g1 = dR^2 - r^2 = gap (gap - 2 r), g1 <= 0 where gap >= 0", [] {
    const Breakwater p = any_breakwater();
    const Case the_case = breakwater(p, "any");
    const State state = any_motion();
    const Chapter k(p, state);
    const double g1 = k.kwx * k.kwx + k.kwy * k.kwy - p.r * p.r;  // Eq. 5.36
    const double g2 = k.jvx * k.jvx + k.jvy * k.jvy - p.r * p.r;  // Eq. 5.37
    const double right = gap(the_case.cables[1], state);
    const double left = gap(the_case.cables[0], state);
    constexpr double rounding = 1e-14;  // of a few squares, each up to r^2 = 9
    RC_ASSERT(std::abs(g1 - right * (right - 2.0 * p.r)) <= rounding * 9.0);
    RC_ASSERT(std::abs(g2 - left * (left - 2.0 * p.r)) <= rounding * 9.0);
    RC_ASSERT((g1 <= 0.0) == (right >= 0.0));
    RC_ASSERT((g2 <= 0.0) == (left >= 0.0));
  });
}

TEST(ChapterEquations, GapRatesAreItsDerivatives) {
  expect_always("g1' = -2 distance gap', Eqs. 5.120 and 5.121", [] {
    const Breakwater p = any_breakwater();
    const Case the_case = breakwater(p, "any");
    const State q = any_motion();
    const Chapter k(p, q);
    const double vx = q.velocity.x();
    const double vy = q.velocity.y();
    const double g1_rate = 2.0 * k.kwx * (-vx + k.cwy * q.spin) +  //
                           2.0 * k.kwy * (-vy - k.cwx * q.spin);
    const double g2_rate = 2.0 * k.jvx * (vx - k.cvy * q.spin) +  //
                           2.0 * k.jvy * (-vy + k.cvx * q.spin);
    const Cable& left = the_case.cables[0];
    const Cable& right = the_case.cables[1];
    constexpr double rounding = 1e-13;  // of products up to 2 r speed = 20
    RC_ASSERT(std::abs(g1_rate + 2.0 * (right.length - gap(right, q)) * gap_rate(right, q)) <=
              rounding);
    RC_ASSERT(std::abs(g2_rate + 2.0 * (left.length - gap(left, q)) * gap_rate(left, q)) <=
              rounding);
  });
}

TEST(ChapterEquations, InertiasAreThoseOfTable52) {
  constexpr double printed = 0.5e-3;  // three decimals
  const auto inertia = [](double a, double b, Shape shape) {
    Breakwater p;
    p.a = a;
    p.b = b;
    p.shape = shape;
    return breakwater(p, "table").body.inertia;
  };
  EXPECT_NEAR(inertia(0.1, 0.0, Shape::ring), 0.010, printed);
  EXPECT_NEAR(inertia(0.2, 0.0, Shape::ring), 0.040, printed);
  EXPECT_NEAR(inertia(0.3, 0.0, Shape::ring), 0.090, printed);
  EXPECT_NEAR(inertia(0.1, 0.1, Shape::box), 0.007, printed);
  EXPECT_NEAR(inertia(0.2, 0.2, Shape::box), 0.027, printed);
  EXPECT_NEAR(inertia(0.3, 0.3, Shape::box), 0.060, printed);
  EXPECT_NEAR(inertia(0.2, 0.1, Shape::box), 0.017, printed);
  EXPECT_NEAR(inertia(0.3, 0.1, Shape::box), 0.033, printed);
}

TEST(ChapterEquations, AnchorHeightsAreColumnHOfTable51) {
  constexpr double printed = 0.5e-3;  // three decimals
  const auto height = [](const char* number) {
    return table_case(number).cables[0].anchor.y() - table_row(number).b;
  };
  EXPECT_NEAR(height("1910121100"), 1.200, printed);
  EXPECT_NEAR(height("2910121100"), 2.332, printed);
  EXPECT_NEAR(height("1921121100"), 1.269, printed);
  EXPECT_NEAR(height("2921121100"), 2.369, printed);
  EXPECT_NEAR(height("1930121100"), 1.327, printed);
  EXPECT_NEAR(height("1933121100"), 1.327, printed);
  EXPECT_NEAR(height("1900461100"), 1.118, printed);
}

TEST(ChapterEquations, TheOriginIsTheEquilibriumWithBothCablesTaut) {
  for (const TableRow& row : table_5_1()) {
    const Case the_case = breakwater(row.parameters, std::string(row.number));
    const State origin;
    for (std::size_t index = 0; index < 2; ++index) {
      EXPECT_NEAR(gap(the_case.cables[index], origin), 0.0, 1e-15 * row.parameters.r)
          << row.number << " cable " << index;
    }
    const auto held = resting_tensions(the_case, origin, CableSet::of(0) | CableSet::of(1));
    ASSERT_TRUE(held.has_value()) << row.number;
    EXPECT_LE(held->acceleration.cwiseAbs().maxCoeff(), 1e-13) << row.number;  // rounding / inertia
    EXPECT_GT(held->tension.minCoeff(), 0.0) << row.number;
  }
}

}  // namespace
}  // namespace tautline::test
