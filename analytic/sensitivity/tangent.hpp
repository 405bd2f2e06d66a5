#pragma once

#include <Eigen/Core>
#include <array>

#include "spread.hpp"
#include "tautline/case.hpp"

namespace tautline {

/// The small changes of a state that keep cables taut, in coordinates of their own: two for each
/// freedom that the cables leave, along axes that are orthonormal in the metric of M. Two cables
/// leave two coordinates of six.
struct Tangent {
  static constexpr int most = 4;  // of one cable

  /// What a unit of each coordinate changes, one a column.
  Eigen::Matrix<double, 6, Eigen::Dynamic, 0, 6, most> directions;
  /// Of the nearest such change to any one: the derivative of the projection (18), without its
  /// momentum, is `directions * coordinates`.
  Eigen::Matrix<double, Eigen::Dynamic, 6, 0, most, 6> coordinates;
};

/// With the independent cables `taut`, at least one, at zero gap and rate.
[[nodiscard]] Tangent tangent(const Case& the_case, const State& state, CableSet taut);

/// The errors of the pose [m, m, rad] where the gaps of the independent cables `taut`, up to three,
/// are closed and each may be off by that of `gaps` [m], in rising order. Nearly dependent cables
/// multiply them.
[[nodiscard]] Eigen::Vector3d closing_errors(const Case& the_case, const State& state,
                                             CableSet taut, const std::array<double, 3>& gaps);

/// `spread` after the state is projected onto the cables.
[[nodiscard]] Spread projected(const Spread& spread, const Tangent& onto);

/// Motion on the independent cables `taut` for `dt` [s].
struct TautArc {
  CableSet taut;
  double dt;
  State start, middle, end;
};

/// `spread` after that.
[[nodiscard]] Spread carried(const Spread& spread, const Case& the_case, const TautArc& arc);

}  // namespace tautline
