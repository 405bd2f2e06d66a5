#pragma once

#include "tautline/geometry.hpp"

namespace tautline {

/// What an impact on one cable does.
template <class Real>
struct SingleImpact {
  Real rate;     // [m/s], of the gap, before
  Real kept;     // [-], the restitution at that rate
  Real impulse;  // [N s], 0 where the cable opens
  BasicState<Real> after;
};

/// One cable closes: Newton's law in closed form (Eq. 14).
template <class Real>
[[nodiscard]] SingleImpact<Real> single_impact(const BasicBody<Real>& body,
                                               const BasicCable<Real>& cable,
                                               const BasicState<Real>& before) {
  const Eigen::Matrix<Real, 3, 1> row = gap_gradient(cable, before);
  const Eigen::Matrix<Real, 3, 1> response = row.cwiseProduct(inverse_mass(body));
  const Real rate =
      row[0] * before.velocity.x() + row[1] * before.velocity.y() + row[2] * before.spin;
  const Real kept = restitution(cable, rate);
  const Real impulse = -(1 + kept) * rate / row.dot(response);
  SingleImpact<Real> impact{rate, kept, impulse, before};
  if (!(impulse > 0)) {  // it opens
    impact.impulse = isfinite(impulse) ? Real(0) : impulse;
  }
  const Eigen::Matrix<Real, 3, 1> gain = impact.impulse * response;
  impact.after = with_gain(before, gain);
  return impact;
}

}  // namespace tautline
