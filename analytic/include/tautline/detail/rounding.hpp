#pragma once

#include "tautline/case.hpp"
#include "tautline/geometry.hpp"

namespace tautline {

// What counts as zero. Each rule measures a number against what it was computed from: the rounding
// of a difference is that of its operands. analytic/README.md, "What counts as zero", derives them.

/// A long motion leaves this many roundings in its state [-]: 1e-12 in double.
inline constexpr double rounding_margin = 4500.0;

/// A single arc or impact leaves some ten roundings of one ulp each, with a margin of four [-].
inline constexpr double few_roundings = 45.0;

/// The largest number that a gap is computed from [m].
template <class Real>
[[nodiscard]] Real gap_operand(const BasicCable<Real>& cable, const BasicState<Real>& state) {
  return max(max(cable.length, Real(cable.attachment.norm())),
             max(Real(state.position.norm()), Real(cable.anchor.norm())));
}

/// One rounding of a gap [m].
template <class Real>
[[nodiscard]] Real rounding_of_gap(const BasicCable<Real>& cable, const BasicState<Real>& state) {
  return epsilon<Real>() * gap_operand(cable, state);
}

/// One rounding of the direction of a taut cable [-].
template <class Real>
[[nodiscard]] Real rounding_of_direction(const BasicCable<Real>& cable,
                                         const BasicState<Real>& state) {
  return rounding_of_gap(cable, state) / cable.length;
}

/// One rounding of the gap rate [m/s] of a taut cable: the direction of the speed of its
/// attachment.
template <class Real>
[[nodiscard]] Real rounding_of_rate(const BasicCable<Real>& cable, const BasicState<Real>& state) {
  const Real speed = state.velocity.norm() + abs(state.spin) * cable.attachment.norm();
  return rounding_of_direction(cable, state) * speed;
}

/// One rounding of a taut cable's acceleration in free flight [m/s^2] (Eq. 5): of gravity, of the
/// arm's turn and of the attachment's own turn about the anchor.
template <class Real>
[[nodiscard]] Real rounding_of_acceleration(const BasicCase<Real>& the_case,
                                            const BasicCable<Real>& cable,
                                            const BasicState<Real>& state) {
  const Real arm = cable.attachment.norm();
  const Real speed = state.velocity.norm() + abs(state.spin) * arm;
  return rounding_of_direction(cable, state) *
         (the_case.gravity.norm() + state.spin * state.spin * arm + speed * speed / cable.length);
}

/// One rounding of the energy [J]: of the kinetic one, and of the weight's at its largest height.
template <class Real>
[[nodiscard]] Real rounding_of_energy(const BasicCase<Real>& the_case,
                                      const BasicState<Real>& state) {
  Real height(0);
  for (const BasicCable<Real>& cable : the_case.cables) {
    height = max(height, gap_operand(cable, state));
  }
  return epsilon<Real>() * (kinetic_energy(the_case.body, state) +
                            the_case.body.mass * the_case.gravity.norm() * height);
}

/// True where a gap at the start counts as zero: within `gap_rounding` of the input, or of what its
/// coordinates can tell.
template <class Real>
[[nodiscard]] bool starts_at_zero(const BasicCable<Real>& cable, const BasicState<Real>& state) {
  return gap(cable, state) <= max(Real(gap_rounding * cable.length),
                                  Real(few_roundings * rounding_of_gap(cable, state)));
}

}  // namespace tautline
