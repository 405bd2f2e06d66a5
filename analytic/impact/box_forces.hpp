#pragma once

#include <Eigen/Cholesky>
#include <array>
#include <bit>

#include "tautline/detail/rows.hpp"

namespace tautline {

/// Forces of rows that stand still, and which of them are strictly between their bounds.
template <class Real>
struct BoxForces {
  BasicCableVector<Real> force;
  CableSet between;
};

/// The forces from 0 to `largest` under which each row either stands still, or opens without force,
/// or closes against its largest; `others` is the pull of everything else. At most three of them
/// are between their bounds, and those rows are independent. The motion is unique. Where rounding
/// leaves a choice, a row is at a bound, and one of `pulling` not at 0.
///
/// With rows of rank 3 such a solution always exists (the forces minimise a convex quadratic on a
/// box), so the at most 4864 choices for 8 rows are all there is to try; a few rows are usual. In
/// exact arithmetic one of them violates nothing; rounding decides, the smallest violation wins.
template <class TheCase, class Real = RealOf<TheCase>>
[[nodiscard]] BoxForces<Real> box_forces(const RowsOf<TheCase>& rows, const RowOf<TheCase>& others,
                                         const BasicCableVector<Real>& largest, CableSet pulling) {
  constexpr double dependent_rows = 1e-12;  // [-], of a pivot against the largest entry
  const BasicCableMatrix<Real> g = rows * rows.transpose();
  const BasicCableVector<Real> free = rows * others;  // the gaps' accelerations without them
  const Real rounding = 64 * epsilon<Real>() * (others.norm() + largest.sum());
  const auto all = (1U << static_cast<unsigned>(rows.rows())) - 1U;
  BoxForces<Real> best{BasicCableVector<Real>::Zero(rows.rows()), {}};
  Real smallest = infinity<Real>();

  unsigned pulled = 0;
  for (const std::size_t row : pulling) {
    pulled |= 1U << row;
  }

  const auto consider = [&](unsigned between, unsigned upper) {
    BasicCableVector<Real> force = BasicCableVector<Real>::Zero(rows.rows());
    std::vector<Eigen::Index> inside;
    CableSet set;
    for (Eigen::Index row = 0; row < rows.rows(); ++row) {
      if (((between >> static_cast<unsigned>(row)) & 1U) != 0) {
        inside.push_back(row);
        set.insert(static_cast<std::size_t>(row));
      } else if (((upper >> static_cast<unsigned>(row)) & 1U) != 0) {
        force[row] = largest[row];
      }
    }
    if (!inside.empty()) {
      const BasicCableMatrix<Real> block = g(inside, inside);
      const Eigen::LDLT<BasicCableMatrix<Real>> factors(block);
      if (factors.vectorD().minCoeff() <= dependent_rows * block.diagonal().maxCoeff()) {
        return;
      }
      const BasicCableVector<Real> right = BasicCableVector<Real>(-(g * force + free))(inside);
      force(inside) = BasicCableVector<Real>(factors.solve(right));
    }
    const BasicCableVector<Real> acceleration = g * force + free;
    Real violation(0);
    for (Eigen::Index row = 0; row < rows.rows(); ++row) {
      const bool held = set.contains(static_cast<std::size_t>(row));
      const Real below = held ? Real(-force[row] * g(row, row)) : Real(-acceleration[row]);
      const Real above = held ? Real((force[row] - largest[row]) * g(row, row)) : acceleration[row];
      const bool at_upper = ((upper >> static_cast<unsigned>(row)) & 1U) != 0;
      violation = max(violation, held ? max(below, above) : at_upper ? above : below);
    }
    violation = violation <= rounding ? Real(0) : violation;
    if (violation < smallest) {
      smallest = violation;
      best = {force, set};
    }
  };

  for (unsigned between = 0; between <= all; ++between) {
    if (std::popcount(between) > 3) {
      continue;
    }
    const unsigned rest = all & ~between;
    for (unsigned upper = rest;; upper = (upper - 1U) & rest) {  // every subset of `rest`
      if ((pulled & ~(between | upper)) == 0) {
        consider(between, upper);
      }
      if (upper == 0) {
        break;
      }
    }
  }
  return best;
}

}  // namespace tautline
