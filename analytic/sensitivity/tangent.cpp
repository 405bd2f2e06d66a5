#include "tangent.hpp"

#include <Eigen/Geometry>
#include <array>

#include "cable_view.hpp"
#include "taut_slopes.hpp"
#include "tautline/detail/rows.hpp"

namespace tautline {
namespace {

/// M^1/2 as a diagonal. A point mass has no inertia and does not turn: any number does.
Eigen::Vector3d root_of_metric(const Body& body) {
  const double turn = body.inertia > 0.0 ? body.inertia : body.mass;
  return Eigen::Vector3d(body.mass, body.mass, turn).cwiseSqrt();
}

/// d state(dt) / d coordinates from `start`, by a step of the method of Runge and Kutta: over the
/// reach of a series, a quarter of where its terms still converge, its error is 1e-3 and less.
template <int Count>
Eigen::Matrix<double, 6, Count> flow(const Case& the_case, const TautArc& arc,
                                     const Eigen::Matrix<double, 6, Count>& start) {
  using Columns = Eigen::Matrix<double, 6, Count>;
  using Slopes = Eigen::Matrix<double, 3, 6>;
  const auto rate = [](const Slopes& slopes, const Columns& at) {
    Columns result;
    result << at.template bottomRows<3>(), slopes * at;
    return result;
  };
  const Slopes middle = taut_slopes(the_case, arc.middle, arc.taut);
  const double half = arc.dt / 2.0;
  const Columns k1 = rate(taut_slopes(the_case, arc.start, arc.taut), start);
  const Columns k2 = rate(middle, start + half * k1);
  const Columns k3 = rate(middle, start + half * k2);
  const Columns k4 = rate(taut_slopes(the_case, arc.end, arc.taut), start + arc.dt * k3);
  return start + arc.dt / 6.0 * (k1 + 2.0 * (k2 + k3) + k4);
}

/// `spread` of the state's coordinates, mapped to the state by `map`.
template <class Map>
Spread mapped_from(const Spread& spread, const Tangent& from, const Map& map) {
  const Eigen::Matrix<double, Map::ColsAtCompileTime, 6, 0, Map::MaxColsAtCompileTime, 6>
      coordinates = from.coordinates;
  Spread result = spread;
  const auto inner = (coordinates * spread.topLeftCorner<6, 6>() * coordinates.transpose()).eval();
  result.topLeftCorner<6, 6>() = (map * inner).eval() * map.transpose();
  result.topRightCorner<6, 1>() = map * (coordinates * spread.topRightCorner<6, 1>());
  result.bottomLeftCorner<1, 6>() = result.topRightCorner<6, 1>().transpose();
  settle(result);
  return result;
}

}  // namespace

Tangent tangent(const Case& the_case, const State& state, CableSet taut) {
  const Eigen::Vector3d root = root_of_metric(the_case.body);
  const CableViews views = cable_views(the_case, state);
  std::array<Vector3<double>, 3> rows{Vector3<double>::Zero(), Vector3<double>::Zero(),
                                      Vector3<double>::Zero()};
  std::array<Eigen::Vector3d, 3> gradient_rates;
  std::size_t count = 0;
  for (const std::size_t index : taut) {
    rows[count] = views[index].gradient().cwiseQuotient(root);
    gradient_rates[count++] = views[index].rate_row(state).head<3>().transpose();
  }
  const RowSpace<Case> space(rows, count);
  std::array<Eigen::Vector3d, 2> free;  // axes across the rows
  const Eigen::Index freedoms = 3 - static_cast<Eigen::Index>(count);
  if (freedoms == 1) {
    free[0] = rows[0].cross(rows[1]).normalized();
  } else if (freedoms == 2) {
    free[0] = rows[0].unitOrthogonal();
    free[1] = rows[0].cross(free[0]).normalized();
  }
  Tangent result;
  result.directions.setZero(6, 2 * freedoms);
  result.coordinates.setZero(2 * freedoms, 6);
  for (Eigen::Index axis = 0; axis < freedoms; ++axis) {
    const Eigen::Vector3d& across = free[static_cast<std::size_t>(axis)];
    const Eigen::Vector3d along = across.cwiseQuotient(root);
    Eigen::Vector3d kept = Eigen::Vector3d::Zero();  // what keeps the rates zero at the other pose
    for (std::size_t row = 0; row < count; ++row) {
      kept -= space.dual(row) * gradient_rates[row].dot(along);
    }
    result.directions.col(axis) << along, kept.cwiseQuotient(root);
    result.directions.col(freedoms + axis).tail<3>() = along;
    result.coordinates.row(axis).head<3>() = across.cwiseProduct(root).transpose();
    result.coordinates.row(freedoms + axis).tail<3>() = across.cwiseProduct(root).transpose();
  }
  return result;
}

Eigen::Vector3d closing_errors(const Case& the_case, const State& state, CableSet taut,
                               const std::array<double, 3>& gaps) {
  const Eigen::Vector3d root = root_of_metric(the_case.body);
  const CableViews views = cable_views(the_case, state);
  std::array<Vector3<double>, 3> rows{Vector3<double>::Zero(), Vector3<double>::Zero(),
                                      Vector3<double>::Zero()};
  std::size_t count = 0;
  for (const std::size_t index : taut) {
    rows[count++] = views[index].gradient().cwiseQuotient(root);
  }
  const RowSpace<Case> space(rows, count);
  Eigen::Vector3d result = Eigen::Vector3d::Zero();
  for (std::size_t row = 0; row < count; ++row) {
    result += gaps[row] * space.dual(row).cwiseQuotient(root).cwiseAbs();
  }
  return result;
}

Spread projected(const Spread& spread, const Tangent& onto) {
  return mapped_from(spread, onto, onto.directions);
}

Spread carried(const Spread& spread, const Case& the_case, const TautArc& arc) {
  const Tangent from = tangent(the_case, arc.start, arc.taut);
  switch (from.directions.cols()) {
    case 2:
      return mapped_from(spread, from, flow<2>(the_case, arc, from.directions));
    case 4:
      return mapped_from(spread, from, flow<4>(the_case, arc, from.directions));
    default:
      return projected(spread, from);
  }
}

}  // namespace tautline
