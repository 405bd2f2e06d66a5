#pragma once

#include <vector>

#include "tautline/cable_set.hpp"
#include "tautline/detail/scalar.hpp"

// Equations (E1), ... are in analytic/README.md, section 13.

namespace tautline {

/// How an elastic cable pulls while it is stretched by s > 0 [m], with f(s) = k1 s + k2 s^2 + ...:
///
///     T = max(0, f(s) + c s')                                                               (E1)
///
/// c is `damping`, or 2 `damping_ratio` sqrt(k1 / G) with the response G of the cable to an impulse
/// of its own (B6) when it becomes stretched. At most one of both is above 0.
template <class Real>
struct BasicElasticity {
  std::vector<Real> stiffness = {};  // [N/m, N/m^2, N/m^3, ...], k1, k2, k3, ...; k1 > 0
  Real damping = Real(0);            // [N s/m], >= 0
  Real damping_ratio = Real(0);      // [-], >= 0
};
using Elasticity = BasicElasticity<double>;

/// The zones of the elastic cables of a system at an instant (E4); those in neither set are slack.
template <class Real>
struct BasicElasticZones {
  CableSet engaged;  // stretched, and pull
  CableSet loose;    // stretched, but shrink too fast to pull
  /// c [N s/m] of each cable since it was stretched last; empty: no cable is elastic.
  std::vector<Real> damping = {};

  [[nodiscard]] CableSet stretched() const { return engaged | loose; }  // longer than they are
};
using ElasticZones = BasicElasticZones<double>;

/// Elastic cables that change their zones at an instant.
struct ElasticSwitches {
  CableSet engaging;    // from slack or loose to engaged
  CableSet letting_go;  // from engaged, or from loose to slack

  [[nodiscard]] bool empty() const { return (engaging | letting_go).empty(); }  // no cable does
};

/// The force f [N] of the spring at `stretch` [m].
template <class Real>
[[nodiscard]] Real spring_force(const BasicElasticity<Real>& law, const Real& stretch) {
  Real result(0);
  for (std::size_t i = law.stiffness.size(); i-- > 0;) {
    result = (result + law.stiffness[i]) * stretch;
  }
  return result;
}

/// df/ds [N/m] at `stretch` [m].
template <class Real>
[[nodiscard]] Real spring_stiffness(const BasicElasticity<Real>& law, const Real& stretch) {
  Real result(0);
  for (std::size_t i = law.stiffness.size(); i-- > 0;) {
    result = result * stretch + static_cast<double>(i + 1) * law.stiffness[i];
  }
  return result;
}

/// The energy [J] that the spring stores at `stretch` [m]: the integral of f, 0 where it is not
/// stretched.
template <class Real>
[[nodiscard]] Real spring_energy(const BasicElasticity<Real>& law, const Real& stretch) {
  if (!(stretch > 0)) {
    return Real(0);
  }
  Real result(0);
  for (std::size_t i = law.stiffness.size(); i-- > 0;) {
    result = result * stretch + law.stiffness[i] / static_cast<double>(i + 2);
  }
  return result * stretch * stretch;
}

/// How long one contact of a linear cable without a load lasts, times the frequency sqrt(k G)
/// [-]: with `damping_ratio` >= 0, 2 acos(ratio) / sqrt(1 - ratio^2) (E5).
template <class Real>
[[nodiscard]] Real contact_phase(const Real& damping_ratio) {
  if (damping_ratio > 2) {
    const Real root = sqrt(Real((damping_ratio - 1) * (damping_ratio + 1)));
    return 2 * log(Real(damping_ratio + root)) / root;
  }
  // with z^2 = (1 - ratio) / 2 that is 2 asin(z) / (z sqrt(1 - z^2)), whose series in z^2 has no
  // singularity at a ratio of 1, and |z^2| <= 1/2
  const Real square = (1 - damping_ratio) / 2;
  Real term(2);
  Real result(0);
  for (int n = 1; abs(term) > epsilon<Real>() / 4; ++n) {
    result += term;
    term *= square * Real(2 * n) / Real(2 * n + 1);
  }
  return result;
}

/// The restitution [-] of that contact: exit speed over entry speed (E6). It falls with
/// `damping_ratio` >= 0 from 1 to 0.
template <class Real>
[[nodiscard]] Real restitution_of(const Real& damping_ratio) {
  return exp(Real(-damping_ratio * contact_phase(damping_ratio)));
}

/// The damping ratio [-] whose contacts have this `restitution`, in [0, 1]; infinite for 0, which
/// no damping gives.
template <class Real>
[[nodiscard]] Real damping_ratio_of(const Real& restitution) {
  if (!(restitution > 0)) {
    return infinity<Real>();
  }
  if (!(restitution < 1)) {
    return Real(0);
  }
  Real low(0);
  Real high = 1 / (2 * sqrt(restitution));  // the restitution is below 1 / (4 ratio^2)
  while (true) {
    const Real middle = low + (high - low) / 2;
    if (!(low < middle && middle < high)) {
      return high;
    }
    (restitution_of(middle) > restitution ? low : high) = middle;
  }
}

}  // namespace tautline
