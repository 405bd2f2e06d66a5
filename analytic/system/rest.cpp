#include <Eigen/Cholesky>

#include "instantiate.hpp"
#include "system/kernel.hpp"

namespace tautline {
namespace {

/// How many freedoms cables can take: a turn across which none has an arm is no motion.
template <class Real, int D>
std::size_t freedoms_to_hold(const BasicSystem<Real, D>& system) {
  int result = 0;
  for (std::size_t i = 0; i < system.bodies.size(); ++i) {
    Eigen::Matrix<Real, Eigen::Dynamic, D> arms(0, D);
    for (const auto& cable : system.cables) {
      for (std::size_t k = 0; k <= cable.segments(); ++k) {
        if (cable.end(k).body == i) {
          arms.conservativeResize(arms.rows() + 1, D);
          arms.row(arms.rows() - 1) = cable.end(k).at.transpose();
        }
      }
    }
    result += D + (has_inertia(system.bodies[i].inertia) ? turns_held(arms) : 0);
  }
  return static_cast<std::size_t>(result);
}

/// The rates of all gradients, one a column, of motions of one freedom each.
template <class Real, int D>
Eigen::Matrix<Real, Eigen::Dynamic, Eigen::Dynamic> gap_curvature(
    const BasicCableOfSystem<Real, D>& cable, const BasicSystemState<Real, D>& state) {
  const BasicSystemState<Real, D> still = standing_still(state);
  RowOf<BasicSystem<Real, D>> unit = no_change(state);
  Eigen::Matrix<Real, Eigen::Dynamic, Eigen::Dynamic> result(unit.size(), unit.size());
  for (Eigen::Index axis = 0; axis < unit.size(); ++axis) {
    unit.setZero();
    unit[axis] = Real(1);
    result.col(axis) = gap_gradient_rate(cable, with_gain(still, unit));
  }
  return result;
}

/// True where the potential energy falls along a motion that keeps the held cables taut: where the
/// stiffness -sum of T_i d2 g_i, with f' dg dg^T of each engaged cable, has a negative eigenvalue
/// on those motions.
template <class Real, int D>
bool is_unstable(const BasicSystem<Real, D>& system, const BasicSystemState<Real, D>& state,
                 const BasicHold<BasicSystem<Real, D>>& held) {
  using TheCase = BasicSystem<Real, D>;
  using Matrix = Eigen::Matrix<Real, Eigen::Dynamic, Eigen::Dynamic>;
  const RowOf<TheCase> weight = root_of_inverse_mass(system.bodies);
  Matrix bending = Matrix::Zero(weight.size(), weight.size());
  for (const std::size_t index : held.pulling) {
    bending -= held.motion.tension(index)[0] * gap_curvature(system.cables[index], state);
  }
  for (const std::size_t index : state.elastic.engaged) {
    const auto& cable = system.cables[index];
    const RowOf<TheCase> row = gap_gradient(cable, state);
    const Real stretch = -gap(cable, state);
    bending += spring_stiffness(*cable.elasticity, stretch, length_at(cable, state)) * row *
               row.transpose();
    bending -= held.motion.tension(index)[0] * gap_curvature(cable, state);
  }
  const CableRows<TheCase> rows(system, state, held.pulling);
  const RowSpace<TheCase> space = rows.space(rows.all());
  Matrix along(weight.size(), weight.size());
  for (Eigen::Index axis = 0; axis < weight.size(); ++axis) {
    along.col(axis) = space.across(RowOf<TheCase>::Unit(weight.size(), axis));
  }
  const Matrix stiffness =
      along.transpose() * weight.asDiagonal() * bending * weight.asDiagonal() * along;
  // raised by what is rounding, it has a negative pivot where it has a negative eigenvalue
  const Real rounding = rounding_margin * epsilon<Real>() * stiffness.cwiseAbs().maxCoeff();
  const Matrix raised =
      stiffness + Matrix(rounding * Matrix::Identity(weight.size(), weight.size()));
  return Eigen::LDLT<Matrix>(raised).vectorD().minCoeff() < 0;
}

/// The size of the accelerations of `motion` at its start [m/s^2], half of it.
template <class Real, int D>
Real half_acceleration(const BasicSystem<Real, D>& system, const SystemSeries<Real, D>& motion) {
  Real result(0);
  for (std::size_t i = 0; i < system.bodies.size(); ++i) {
    result = max(result, Real(motion.position(i, 2).cwiseAbs().sum() +
                              longest_arm(system, i) * motion.turn(i, 2).cwiseAbs().sum()));
  }
  return result;
}

}  // namespace

template <class Real, int D>
std::optional<Ending> equilibrium(const BasicSystem<Real, D>& system,
                                  const BasicSystemState<Real, D>& state,
                                  const BasicHold<BasicSystem<Real, D>>& held) {
  if (!is_constant_from(system, state)) {
    return std::nullopt;
  }
  for (std::size_t i = 0; i < system.bodies.size(); ++i) {
    if (!(longest_arm(system, i) > 0) && !spins_unnoticed(system, state, i)) {
      return std::nullopt;  // it tumbles about the centre that it hangs at
    }
  }
  if (held.pulling.size() >= freedoms_to_hold(system)) {
    return Ending::rest;
  }
  Real lightness(0);  // a light body turns fast
  for (std::size_t i = 0; i < system.bodies.size(); ++i) {
    const Real arm = longest_arm(system, i);
    const auto& body = system.bodies[i];
    if (has_inertia(body.inertia)) {
      lightness = max(lightness, Real(body.mass * arm * arm / least_moment(body)));
    }
  }
  const Real acceleration = half_acceleration(system, held.motion);
  const Real rounding =
      epsilon<Real>() * acceleration_scale(system, standing_still(state)) * (1 + lightness) +
      rounding_of_pulls(system, standing_still(state));
  if (acceleration > rounding_margin * rounding) {
    return std::nullopt;
  }
  if (!is_unstable(system, state, held)) {
    return Ending::rest;
  }
  return acceleration <= few_roundings * rounding ? std::optional(Ending::unstable_rest)
                                                  : std::nullopt;
}

template std::optional<Ending> equilibrium(const InstanceCase&, const StateOf<InstanceCase>&,
                                           const BasicHold<InstanceCase>&);

}  // namespace tautline
