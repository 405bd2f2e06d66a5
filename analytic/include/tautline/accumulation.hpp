#pragma once

#include <optional>

#include "tautline/case.hpp"
#include "tautline/first_contact.hpp"

namespace tautline {

/// Cables that stay taut from now on: they rest, or their remaining bounces accumulate at once.
struct Capture {
  CableSet cables;
  double remaining;    // [s] to the limit of the impact times; 0 if the cables simply rest
  double uncertainty;  // [s] of `remaining`
  State after;         // velocity projected onto the taut cables, M-orthogonally
};

/// Whether the cables in `touching` are captured at `state`. None if they will leave, still bounce
/// faster than `capture_speed` [m/s], or if the certificate of analytic/README.md section 5 fails.
[[nodiscard]] std::optional<Capture> capture(const Case& the_case, const State& state,
                                             const Touching& touching, double capture_speed);

}  // namespace tautline
