#pragma once

#include <optional>

#include "tautline/case.hpp"
#include "tautline/detail/series.hpp"
#include "tautline/solution.hpp"

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

/// A limit that a motion reaches.
template <class Real>
struct ReachedLimit {
  Real dt;        // [s] from now; NaN: numbers overflowed
  Ending ending;  // that it is
};

/// The first of these, `along` a flight from a state or a series; none: neither.
template <class Real, class Along>
[[nodiscard]] std::optional<ReachedLimit<Real>> reached_limit(const BasicCase<Real>& the_case,
                                                              const Along& along, Real horizon) {
  std::optional<ReachedLimit<Real>> result;
  if (const auto dt = time_to_angle_limit(the_case, along, horizon)) {
    result = {*dt, Ending::angle_limit};
    horizon = *dt;
  }
  if (const auto dt = time_to_ceiling(the_case, along, horizon)) {
    result = {*dt, Ending::ceiling};
  }
  return result;
}

}  // namespace tautline
