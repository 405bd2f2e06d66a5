#include "equilibrium.hpp"

#include <utility>

#include "instantiate.hpp"
#include "tautline/detail/rounding.hpp"
#include "tautline/detail/rows.hpp"
#include "tautline/geometry.hpp"

namespace tautline {
namespace {

/// The second derivatives of the gap of `cable`, by the pose.
template <class Real>
Eigen::Matrix<Real, 3, 3> gap_curvature(const BasicCable<Real>& cable,
                                        const BasicState<Real>& state) {
  Eigen::Matrix<Real, 3, 3> result;
  for (Eigen::Index axis = 0; axis < 3; ++axis) {
    BasicState<Real> moving = state;
    moving.velocity = axis < 2 ? BasicVec2<Real>(BasicVec2<Real>::Unit(axis))
                               : BasicVec2<Real>(BasicVec2<Real>::Zero());
    moving.spin = Real(axis == 2 ? 1 : 0);
    result.col(axis) = gap_gradient_rate(cable, moving);
  }
  return result;
}

/// True where the potential energy falls along a motion that keeps the held cables taut: where
/// P M^-1/2 (-sum of T_i d2 g_i) M^-1/2 P has a negative eigenvalue, with P the projection onto
/// those motions. At an equilibrium the gradient of the energy is J^T T, and gravity's is constant.
template <class Real>
bool is_unstable(const BasicCase<Real>& the_case, const BasicState<Real>& state,
                 const BasicHold<BasicCase<Real>>& held) {
  using Matrix3 = Eigen::Matrix<Real, 3, 3>;
  Matrix3 bending = Matrix3::Zero();
  for (const std::size_t index : held.pulling) {
    bending -= held.motion.tension(index)[0] * gap_curvature(the_case.cables[index], state);
  }
  const Vector3<Real> weight = root_of_inverse_mass(the_case.body);
  const CableRows<BasicCase<Real>> rows(the_case, state, held.pulling);
  const RowSpace<BasicCase<Real>> space = rows.space(rows.all());
  Matrix3 along;
  for (Eigen::Index axis = 0; axis < 3; ++axis) {
    const Vector3<Real> unit = Vector3<Real>::Unit(axis);
    along.col(axis) = unit - space.part(unit);
  }
  const Matrix3 stiffness =
      along.transpose() * weight.asDiagonal() * bending * weight.asDiagonal() * along;
  // along a row there is no motion, so that one eigenvalue is zero: the others solve a quadratic
  const Real half = stiffness.trace() / 2;
  Real minors(0);
  for (const auto& [i, j] : {std::pair(0, 1), std::pair(1, 2), std::pair(2, 0)}) {
    minors += stiffness(i, i) * stiffness(j, j) - stiffness(i, j) * stiffness(j, i);
  }
  const Real least = half - sqrt(max(Real(0), Real(half * half - minors)));
  return least < -rounding_margin * epsilon<Real>() * stiffness.cwiseAbs().maxCoeff();
}

}  // namespace

template <class Real>
bool turns_freely(const BasicCase<Real>& the_case, const BasicState<Real>& state, CableSet taut) {
  for (std::size_t index = 0; index < the_case.cables.size(); ++index) {
    const BasicCable<Real>& cable = the_case.cables[index];
    const Real arm = cable.attachment.norm();
    const bool slack_for_good =
        !taut.contains(index) && (state.position - cable.anchor).norm() + arm < cable.length;
    if (arm > 0 && !slack_for_good) {
      return false;
    }
  }
  return true;
}

template <class Real>
std::optional<Ending> equilibrium(const BasicCase<Real>& the_case, const BasicState<Real>& state,
                                  const BasicHold<BasicCase<Real>>& held) {
  const Real radius = attachment_radius(the_case);
  // pulling cables are independent: as many as there are ways to move leave none
  const bool turns = radius > 0 && inverse_mass(the_case.body)[2] > 0;
  if (held.pulling.size() >= (turns ? 3U : 2U)) {
    return Ending::rest;
  }
  const auto& motion = held.motion;
  const Real acceleration =  // [m/s^2], half of it
      motion.position(2).cwiseAbs().sum() + radius * abs(motion.angle()[2]);
  // of gravity, and of its moment, which turns a light body fast
  const Real lightness =
      turns ? Real(the_case.body.mass * radius * radius / the_case.body.inertia) : Real(0);
  const Real rounding = epsilon<Real>() * the_case.gravity.norm() * (1 + lightness);
  if (acceleration > rounding_margin * rounding) {
    return std::nullopt;
  }
  if (!is_unstable(the_case, state, held)) {
    return Ending::rest;
  }
  // what is left grows, so that only rounding itself is none
  return acceleration <= few_roundings * rounding ? std::optional(Ending::unstable_rest)
                                                  : std::nullopt;
}

template bool turns_freely(const InstanceCase&, const BasicState<Instance>&, CableSet);
template std::optional<Ending> equilibrium(const InstanceCase&, const BasicState<Instance>&,
                                           const BasicHold<InstanceCase>&);

}  // namespace tautline
