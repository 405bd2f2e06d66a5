#pragma once

#include <vector>

#include "tautline/cable_set.hpp"
#include "tautline/detail/scalar.hpp"

// Equations (E1), ... are in analytic/README.md, section 13.

namespace tautline {

/// A change of the slope of a force.
template <class Real>
struct BasicCorner {
  Real stretch;    // [m], > 0, where it is; of a law of strain the strain [-]
  Real stiffness;  // [N/m], > 0, the slope from there on; of a law of strain [N]
};
using Corner = BasicCorner<double>;

/// How long an elastic cable pulls.
enum class ElasticCut {
  force,    // until its tension falls to zero: it never pushes
  stretch,  // until it is no longer stretched: its damper pushes before
  never,    // always: its damper acts while it is slack, too
};

/// How an elastic cable pulls while it is stretched by s > 0 [m]:
///
///     T = max(0, f(s) + c s'),  f(s) = k1 s + k2 s^2 + ...                                  (E1)
///
/// c is `damping`, or 2 `damping_ratio` sqrt(f'(0) / G) with the response G of the cable to an
/// impulse of its own (B6) when it becomes stretched. At most one of both is above 0.
///
/// With `corners` f has one coefficient, k1 is its slope up to the first of them, and f goes on
/// in straight lines. A law of strain is one of s / L in the place of s, with the length L of the
/// cable at the time: {EA} is f = EA s / L, also while L changes.
///
/// With another `cut` than `force` T = f(s) + c s', which may be below 0, and c s' where the cable
/// is slack and the cut is `never`: then c is found when it begins to act.
template <class Real>
struct BasicElasticity {
  std::vector<Real> stiffness = {};             // [N/m, N/m^2, N/m^3, ...], k1, k2, k3, ...; k1 > 0
  Real damping = Real(0);                       // [N s/m], >= 0
  Real damping_ratio = Real(0);                 // [-], >= 0
  std::vector<BasicCorner<Real>> corners = {};  // by rising stretch
  bool of_strain = false;                       // its coefficients are [N]
  ElasticCut cut = ElasticCut::force;           // of (E1)
};
using Elasticity = BasicElasticity<double>;

/// The zones of the elastic cables of a system at an instant (E4); those in no set are slack.
template <class Real>
struct BasicElasticZones {
  CableSet engaged;    // stretched, and pull
  CableSet loose;      // stretched, but shrink too fast to pull
  CableSet resisting;  // slack, with a damper that acts
  /// c [N s/m] of each cable since it was stretched last; empty: no cable is elastic.
  std::vector<Real> damping = {};
  /// How many corners of its force each stretched cable is past; empty: 0 of each.
  std::vector<std::size_t> past = {};

  /// How many cable `index` is past.
  [[nodiscard]] std::size_t corners_past(std::size_t index) const {
    return index < past.size() ? past[index] : 0;
  }

  [[nodiscard]] CableSet stretched() const { return engaged | loose; }    // longer than they are
  [[nodiscard]] CableSet pulling() const { return engaged | resisting; }  // have a tension
};
using ElasticZones = BasicElasticZones<double>;

/// Elastic cables that change their zones or pass a corner at an instant.
struct ElasticSwitches {
  CableSet engaging;    // from slack or loose to engaged
  CableSet letting_go;  // from engaged, or from loose to slack
  CableSet passing;     // past their next corner
  CableSet returning;   // back to before their last one

  /// Those that do any of it.
  [[nodiscard]] CableSet all() const { return engaging | letting_go | passing | returning; }
  [[nodiscard]] bool empty() const { return all().empty(); }  // no cable does
};

/// The length [m] over which `law` takes a stretch: that of the cable, `length`, or 1.
template <class Real>
[[nodiscard]] Real base_of(const BasicElasticity<Real>& law, const Real& length) {
  return law.of_strain ? length : Real(1);
}

/// By how much the slope of the force rises at a corner.
template <class Real>
[[nodiscard]] Real rise_at(const BasicElasticity<Real>& law, std::size_t corner) {
  return law.corners[corner].stiffness -
         (corner == 0 ? law.stiffness[0] : law.corners[corner - 1].stiffness);
}

/// The force f [N] of the spring at `stretch` [m] of a cable of this `length` [m].
template <class Real>
[[nodiscard]] Real spring_force(const BasicElasticity<Real>& law, const Real& stretch,
                                const Real& length) {
  const Real x = stretch / base_of(law, length);
  Real result(0);
  for (std::size_t i = law.stiffness.size(); i-- > 0;) {
    result = (result + law.stiffness[i]) * x;
  }
  for (std::size_t i = 0; i < law.corners.size() && x > law.corners[i].stretch; ++i) {
    result += rise_at(law, i) * (x - law.corners[i].stretch);
  }
  return result;
}

/// df/ds [N/m] at `stretch` [m]; at a corner, of the piece before it.
template <class Real>
[[nodiscard]] Real spring_stiffness(const BasicElasticity<Real>& law, const Real& stretch,
                                    const Real& length) {
  const Real base = base_of(law, length);
  const Real x = stretch / base;
  Real result(0);
  for (std::size_t i = law.stiffness.size(); i-- > 0;) {
    result = result * x + static_cast<double>(i + 1) * law.stiffness[i];
  }
  for (std::size_t i = 0; i < law.corners.size() && x > law.corners[i].stretch; ++i) {
    result += rise_at(law, i);
  }
  return result / base;
}

/// The energy [J] that the spring stores at `stretch` [m]: the integral of f, 0 where it is not
/// stretched.
template <class Real>
[[nodiscard]] Real spring_energy(const BasicElasticity<Real>& law, const Real& stretch,
                                 const Real& length) {
  if (!(stretch > 0)) {
    return Real(0);
  }
  const Real base = base_of(law, length);
  const Real x = stretch / base;
  Real result(0);
  for (std::size_t i = law.stiffness.size(); i-- > 0;) {
    result = result * x + law.stiffness[i] / static_cast<double>(i + 2);
  }
  result = result * x * x;
  for (std::size_t i = 0; i < law.corners.size() && x > law.corners[i].stretch; ++i) {
    const Real over = x - law.corners[i].stretch;
    result += rise_at(law, i) * over * over / 2;
  }
  return result * base;
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
