#include "tangent.hpp"

#include <Eigen/Geometry>
#include <array>

#include "cable_view.hpp"
#include "dual.hpp"
#include "tautline/rows.hpp"
#include "tautline/series_impl.hpp"

namespace tautline {
namespace {

/// Terms of the derivative's series. Those of the motion fall to rounding in 28, by about 1/4 each,
/// so these to some 1e-3 of the error, whose first digit is all that is said.
constexpr std::size_t flow_order = 5;

/// M^1/2 as a diagonal. A point mass has no inertia and does not turn: any number does.
Eigen::Vector3d root_of_metric(const Body& body) {
  const double turn = body.inertia > 0.0 ? body.inertia : body.mass;
  return Eigen::Vector3d(body.mass, body.mass, turn).cwiseSqrt();
}

/// The three numbers' derivatives in the order of a pose.
template <int Count>
Eigen::Matrix<double, 3, Count> slopes_of(const TautSeries<Dual<double, Count>>& motion,
                                          std::size_t k) {
  Eigen::Matrix<double, 3, Count> result;
  result << motion.x()[k].slopes.transpose(), motion.y()[k].slopes.transpose(),
      motion.angle()[k].slopes.transpose();
  return result;
}

/// d state(dt) / d coordinates at the start.
template <int Count>
Eigen::Matrix<double, 6, Count> flow(const Case& the_case, const State& start, CableSet taut,
                                     const Tangent& from, double dt) {
  using Number = Dual<double, Count>;
  const auto variable = [&](double value, Eigen::Index axis) {
    return Number(value, from.directions.row(axis).transpose());
  };
  const BasicState<Number> variables{
      {variable(start.position.x(), 0), variable(start.position.y(), 1)},
      variable(start.angle, 2),
      {variable(start.velocity.x(), 3), variable(start.velocity.y(), 4)},
      variable(start.spin, 5)};
  const BasicCase<Number> lifted_case = lifted<Number>(the_case, taut);
  CableSet all;
  for (std::size_t index = 0; index < taut.size(); ++index) {
    all.insert(index);
  }
  const TautSeries<Number> motion(lifted_case, variables, all, flow_order);
  Eigen::Matrix<double, 3, Count> pose = Eigen::Matrix<double, 3, Count>::Zero();
  Eigen::Matrix<double, 3, Count> rate = pose;
  for (std::size_t k = flow_order + 1; k-- > 0;) {
    rate = rate * dt + pose;
    pose = pose * dt + slopes_of<Count>(motion, k);
  }
  Eigen::Matrix<double, 6, Count> result;
  result << pose, rate;
  return result;
}

/// `spread` of the state's coordinates, mapped to the state by `map`.
template <class Map>
Spread mapped_from(const Spread& spread, const Tangent& from, const Map& map) {
  Spread result = spread;
  const auto inner =
      (from.coordinates * spread.topLeftCorner<6, 6>() * from.coordinates.transpose()).eval();
  result.topLeftCorner<6, 6>() = map * inner * map.transpose();
  result.topRightCorner<6, 1>() = map * (from.coordinates * spread.topRightCorner<6, 1>());
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
  const RowSpace<double> space(rows, count);
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
  const RowSpace<double> space(rows, count);
  Eigen::Vector3d result = Eigen::Vector3d::Zero();
  for (std::size_t row = 0; row < count; ++row) {
    result += gaps[row] * space.dual(row).cwiseQuotient(root).cwiseAbs();
  }
  return result;
}

Spread projected(const Spread& spread, const Tangent& onto) {
  return mapped_from(spread, onto, onto.directions);
}

Spread carried(const Spread& spread, const Case& the_case, const State& start, CableSet taut,
               double dt) {
  const Tangent from = tangent(the_case, start, taut);
  switch (from.directions.cols()) {
    case 2:
      return mapped_from(spread, from, flow<2>(the_case, start, taut, from, dt));
    case 4:
      return mapped_from(spread, from, flow<4>(the_case, start, taut, from, dt));
    default:
      return projected(spread, from);
  }
}

}  // namespace tautline
