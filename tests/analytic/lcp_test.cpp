#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <iostream>

#include "support.hpp"
#include "tautline/impact.hpp"

namespace tautline::test {
namespace {

constexpr std::uint64_t lcp_seed = 31;

/// A random matrix J J^T of rank <= 3 with rows of length near one.
CableMatrix random_delassus(Random& random, Eigen::Index count, double scale) {
  Eigen::Matrix<double, Eigen::Dynamic, 3> jacobian(count, 3);
  for (Eigen::Index row = 0; row < count; ++row) {
    jacobian.row(row) << random.uniform(-1.0, 1.0), random.uniform(-1.0, 1.0),
        random.uniform(-1.0, 1.0);
  }
  return scale * (jacobian * jacobian.transpose());
}

/// min(z, m z + q) and its bounds, relative to q.
double violation(const CableMatrix& m, const CableVector& q, const CableVector& z) {
  const CableVector w = m * z + q;
  double worst = std::max(0.0, -z.minCoeff());
  for (Eigen::Index row = 0; row < q.size(); ++row) {
    worst = std::max({worst, -w[row], std::min(std::abs(w[row]), m(row, row) * z[row])});
  }
  return worst / q.cwiseAbs().maxCoeff();
}

/// Solved by projected Gauss-Seidel, an unrelated method; its m z + q.
CableVector by_relaxation(const CableMatrix& m, const CableVector& q) {
  constexpr int sweeps = 20000;
  CableVector z = CableVector::Zero(q.size());
  for (int sweep = 0; sweep < sweeps; ++sweep) {
    for (Eigen::Index row = 0; row < q.size(); ++row) {
      z[row] = std::max(0.0, z[row] - (m.row(row).dot(z) + q[row]) / m(row, row));
    }
  }
  return m * z + q;
}

class Lcp : public ::testing::TestWithParam<int> {};

TEST_P(Lcp, IsSolvedWheneverAllCablesClose) {
  Random random(lcp_seed);
  const Eigen::Index count = GetParam();
  double worst = 0.0;
  for (int sample = 0; sample < 3000; ++sample) {
    const CableMatrix m = random_delassus(random, count, random.log_uniform(1e-6, 1e6));
    // q = J v for a velocity v: J^T z = 0 then gives z . q = 0, so a solution exists
    CableVector pull(count);
    for (Eigen::Index row = 0; row < count; ++row) {
      pull[row] = random.uniform(0.0, 1.0);
    }
    const CableVector q = -(m * pull);
    const auto z = solve_lcp(m, q);
    ASSERT_TRUE(z.has_value()) << "seed " << lcp_seed << " sample " << sample;
    worst = std::max(worst, violation(m, q, *z));
  }
  std::cout << "  seed " << lcp_seed << '\n';
  constexpr double rounding = 1e-10;  // 1e-16 times the condition of three random rows, up to 1e6
  expect_within("violation", worst, rounding);
}

TEST_P(Lcp, HasTheRatesOfAnUnrelatedMethod) {
  Random random(lcp_seed);
  const Eigen::Index count = GetParam();
  double worst = 0.0;
  for (int sample = 0; sample < 20; ++sample) {
    const CableMatrix m = random_delassus(random, count, 1.0);
    CableVector pull(count);
    for (Eigen::Index row = 0; row < count; ++row) {
      pull[row] = random.uniform(-0.3, 1.0);
    }
    const CableVector q = -(m * pull);
    const auto z = solve_lcp(m, q);
    ASSERT_TRUE(z.has_value());
    worst = std::max(worst, (m * *z + q - by_relaxation(m, q)).cwiseAbs().maxCoeff());
  }
  constexpr double relaxation = 1e-4;  // relaxation converges slowly where rows are almost parallel
  expect_within("difference from relaxation", worst, relaxation);
}

INSTANTIATE_TEST_SUITE_P(Rows, Lcp, ::testing::Range(1, 9));

TEST(LcpByHand, WithOneRow) {
  const CableMatrix m = CableMatrix::Constant(1, 1, 2.0);
  EXPECT_DOUBLE_EQ((*solve_lcp(m, CableVector::Constant(1, -3.0)))[0], 1.5);
  EXPECT_DOUBLE_EQ((*solve_lcp(m, CableVector::Constant(1, 3.0)))[0], 0.0);
  EXPECT_DOUBLE_EQ((*solve_lcp(m, CableVector::Constant(1, 0.0)))[0], 0.0);
}

TEST(LcpByHand, HasNoSolutionWhereTwoOppositeCablesBothPull) {
  CableMatrix m(2, 2);
  m << 1.0, -1.0, -1.0, 1.0;  // one degree of freedom, held from both sides
  CableVector q(2);
  q << -1.0, -1.0;  // both want it at once
  EXPECT_FALSE(solve_lcp(m, q).has_value());
}

TEST(LcpByHand, RedundantRowsShareWithAtMostThree) {
  const CableMatrix m = CableMatrix::Constant(8, 8, 1.0);
  const auto z = solve_lcp(m, CableVector::Constant(8, -1.0));
  ASSERT_TRUE(z.has_value());
  EXPECT_DOUBLE_EQ(z->sum(), 1.0);
  EXPECT_LE((z->array() > 0.0).count(), 3);
}

}  // namespace
}  // namespace tautline::test
