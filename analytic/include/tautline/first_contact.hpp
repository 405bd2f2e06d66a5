#pragma once

#include <optional>

#include "tautline/case.hpp"

namespace tautline {

/// The first instant of a free flight at which something ends it.
struct FirstContact {
  double dt;        // [s] from the start of the flight; NaN: unknown, numbers overflowed
  CableSet cables;  // that become taut at that instant
};

struct FirstContactSearch {
  std::optional<FirstContact> contact;  // none: every cable stays slack up to the horizon
  int steps = 0;                        // evaluations of gaps, over all cables
};

/// Cables known to be at exactly zero gap when a flight starts, because they were just hit.
struct Touching {
  CableSet cables;
  double rate_rounding = 0.0;  // [m/s], a closing rate up to this is rounding of zero
};

/// Two cables whose contact times differ by less than this fraction of the flight are hit together:
/// the difference is rounding in the root search [-].
inline constexpr double simultaneous = 1e-13;

/// The first contact of the free flight that starts at `state`, up to `horizon` [s].
/// Cannot pass a root (analytic/README.md section 3). The gap of a cable not in `touching` must be
/// >= 0 up to rounding; where it is <= 0 and closing, the contact is at dt = 0.
[[nodiscard]] FirstContactSearch first_contact(const Case& the_case, const State& state,
                                               const Touching& touching, double horizon);

/// The same search for an attachment that rises to `the_case.ceiling`; none without a ceiling, NaN
/// where numbers overflow.
[[nodiscard]] std::optional<double> time_to_ceiling(const Case& the_case, const State& state,
                                                    double horizon);

/// When |angle| reaches `the_case.angle_limit`, in closed form; none without a limit.
[[nodiscard]] std::optional<double> time_to_angle_limit(const Case& the_case, const State& state,
                                                        double horizon);

}  // namespace tautline
