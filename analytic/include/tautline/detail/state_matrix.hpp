#pragma once

#include <Eigen/Core>

namespace tautline {

/// Derivatives of the six numbers x, y [m], angle [rad], x velocity, y velocity [m/s] and spin
/// [rad/s], one a row, with respect to the same six of an earlier state, one a column.
template <class Real>
using BasicStateMatrix = Eigen::Matrix<Real, 6, 6>;
using StateMatrix = BasicStateMatrix<double>;

}  // namespace tautline
