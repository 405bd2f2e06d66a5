#pragma once

#include <Eigen/Core>
#include <algorithm>
#include <cmath>

#include "tautline/case.hpp"
#include "tautline/detail/state_matrix.hpp"
#include "tautline/uncertainty.hpp"

namespace tautline {

// Errors as squares that add, carried along by derivatives. Equation numbers are those of
// analytic/README.md.

using Spread = Uncertainty::Spread;
using StateVector = Eigen::Matrix<double, 6, 1>;
using StateRow = Eigen::Matrix<double, 1, 6>;

/// The root of the mean square of one rounding to the nearest double near 1 [-].
inline constexpr double one_rounding = 0.289 * 2.220446049250313e-16;  // an ulp / sqrt(12)

/// A bound is this many times the root of the summed squares [-]. The roundings of one motion are
/// partly alike; over random systems no error comes to more than a third of the bound, over hard
/// ones to nine tenths.
inline constexpr double bound_margin = 4.0;

/// Squares are right to rounding of the largest that they are made of: what cancels is not [-].
inline constexpr double square_rounding = 1e-14;

/// Makes `spread` symmetric again: the sums of (u, v) and of (v, u) are rounded in another order,
/// and what the maps of many events make of the difference is no spread of any errors.
inline void settle(Spread& spread) {
  spread.triangularView<Eigen::StrictlyUpper>() = spread.transpose();
}

/// The spread after the velocities have changed by `kick` times the error of the state.
inline Spread kicked(const Spread& spread, const Eigen::Matrix<double, 3, 6>& kick) {
  Spread result = spread;
  const Eigen::Matrix<double, 3, 7> change = kick * spread.topRows<6>();
  const Eigen::Matrix3d square = change.leftCols<6>() * kick.transpose();
  result.middleRows<3>(3) += change;
  result.middleCols<3>(3) += change.transpose();
  result.block<3, 3>(3, 3) += square;
  settle(result);
  return result;
}

/// The spread where an event comes later by `delay` times the error of the state, which changes at
/// `rate` meanwhile.
inline Spread delayed(const Spread& spread, const StateRow& delay, const StateVector& rate) {
  Eigen::Matrix<double, 7, 1> change;
  change << rate, 1.0;
  const Eigen::Matrix<double, 1, 7> cross = delay * spread.topRows<6>();
  const double square = cross.head<6>().dot(delay);
  Spread result = spread + change * cross + cross.transpose() * change.transpose() +
                  square * change * change.transpose();
  settle(result);
  return result;
}

/// The spread at a given instant instead of one that moves with the event before: of the state
/// alone.
inline StateMatrix at_instant(const Spread& spread, const StateVector& rate) {
  const Eigen::Matrix<double, 6, 1> cross = spread.topRightCorner<6, 1>();
  StateMatrix result = spread.topLeftCorner<6, 6>() - cross * rate.transpose() -
                       rate * cross.transpose() + spread(6, 6) * rate * rate.transpose();
  result.diagonal() += square_rounding * (spread.diagonal().head<6>().cwiseMax(0.0) +
                                          spread(6, 6) * rate.cwiseAbs2());
  return result;
}

/// The bound that belongs to the square of an error.
inline double bound(double square) { return bound_margin * std::sqrt(std::max(square, 0.0)); }

/// The bound of a linear function of the state, whose derivative is `row`. What cancels in it does
/// so up to the part `cancels` of the squares.
inline double bound(const StateRow& row, const StateMatrix& squares,
                    double cancels = square_rounding) {
  const double square = (row * squares * row.transpose()).value();
  const double largest = row.cwiseAbs2().dot(squares.diagonal().cwiseMax(0.0));
  return bound(std::max(square, 0.0) + cancels * largest);
}

/// The square of the rounding of an instant [s^2].
inline double tick_square(double time) {
  const double tick = one_rounding * time;
  return tick * tick;
}

/// Adds that of a state which comes late, where the `square` of that [s^2] is independent.
inline void add_late(Spread& spread, double square, const StateVector& rate) {
  spread.topLeftCorner<6, 6>() += square * rate * rate.transpose();
}

/// Adds the squares of independent errors of the six numbers.
inline void add_errors(Spread& spread, const StateVector& errors) {
  spread.diagonal().head<6>() += errors.cwiseAbs2();
}

}  // namespace tautline
