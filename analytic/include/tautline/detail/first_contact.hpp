#pragma once

#include <optional>

#include "tautline/case.hpp"
#include "tautline/detail/rounding.hpp"

namespace tautline {

/// The first instant of a free flight at which something ends it.
template <class Real>
struct BasicFirstContact {
  Real dt;          // [s] from the start of the flight; NaN: unknown, numbers overflowed
  CableSet cables;  // that become taut at that instant
};

using FirstContact = BasicFirstContact<double>;

/// What the search for the next contact found, and what it cost.
template <class Real>
struct BasicFirstContactSearch {
  std::optional<BasicFirstContact<Real>>
      contact;    // none: every cable stays slack up to the horizon
  int steps = 0;  // evaluations of gaps, over all cables
};
using FirstContactSearch = BasicFirstContactSearch<double>;

/// Cables known to be at exactly zero gap when a flight starts, because they were just hit.
template <class Real>
struct BasicTouching {
  CableSet cables;               // that touch at this instant
  Real rate_rounding = Real(0);  // [m/s], a closing rate up to this is rounding of zero,
  Real spin_rounding = Real(0);  // [rad/s], and one up to this times the arm more
  Real time_rounding = Real(0);  // [s], what is nearer than this is now

  /// Keeps the rounding of gap rates up to date: that of the fastest speeds so far. Not of the
  /// present ones: the body may be stopped within an instant by ever smaller impacts, and what is
  /// left then is rounding of the speeds before.
  void note_speed(const BasicCase<Real>& /*the_case*/, const BasicState<Real>& state) {
    const Real rounding = few_roundings * epsilon<Real>();
    rate_rounding = max(rate_rounding, Real(rounding * state.velocity.norm()));
    spin_rounding = max(spin_rounding, Real(rounding * abs(state.spin)));
  }

  /// A rate up to this is rounding of the fastest attachment's [m/s].
  [[nodiscard]] Real rounding_of_all(const BasicCase<Real>& the_case) const {
    return rate_rounding + spin_rounding * attachment_radius(the_case);
  }

  /// A closing rate of `cable` up to this is rounding of zero [m/s].
  [[nodiscard]] Real rounding(const BasicCable<Real>& cable) const {
    return rate_rounding + spin_rounding * cable.attachment.norm();
  }
};
using Touching = BasicTouching<double>;

/// Two cables whose contact times differ by less than this fraction of the flight are hit together:
/// the difference is rounding in the root search [-].
template <class Real>
[[nodiscard]] Real simultaneous() {
  return 450 * epsilon<Real>();  // 1e-13 in double
}

/// The first contact of the free flight that starts at `state`, up to `horizon` [s].
/// Cannot pass a root (analytic/README.md section 3). The gap of a cable not in `touching` must be
/// >= 0 up to rounding; where it is <= 0 and closing, the contact is at dt = 0.
template <class Real>
[[nodiscard]] BasicFirstContactSearch<Real> first_contact(
    const BasicCase<Real>& the_case, const BasicState<Real>& state,
    const BasicTouching<Real>& touching, const std::type_identity_t<Real>& horizon);

}  // namespace tautline
