#pragma once

#include <optional>

#include "tautline/case.hpp"
#include "tautline/series.hpp"

namespace tautline {

// When the motion from now on, up to `horizon` [s], leaves the case's range of validity: in free
// flight from a state, or along a series. None where it does not or the case has no such limit; NaN
// where numbers overflow.

/// An attachment rises to `the_case.ceiling`.
template <class Real>
[[nodiscard]] std::optional<Real> time_to_ceiling(const BasicCase<Real>& the_case,
                                                  const BasicState<Real>& state,
                                                  const std::type_identity_t<Real>& horizon);
/// The same along a series.
template <class Real>
[[nodiscard]] std::optional<Real> time_to_ceiling(const BasicCase<Real>& the_case,
                                                  const TautSeries<Real>& motion,
                                                  const std::type_identity_t<Real>& horizon);

/// |angle| reaches `the_case.angle_limit`.
template <class Real>
[[nodiscard]] std::optional<Real> time_to_angle_limit(const BasicCase<Real>& the_case,
                                                      const BasicState<Real>& state,
                                                      const std::type_identity_t<Real>& horizon);
/// The same along a series.
template <class Real>
[[nodiscard]] std::optional<Real> time_to_angle_limit(const BasicCase<Real>& the_case,
                                                      const TautSeries<Real>& motion,
                                                      const std::type_identity_t<Real>& horizon);

}  // namespace tautline
