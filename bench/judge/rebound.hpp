#pragma once

#include <cstddef>
#include <optional>
#include <vector>

#include "bench/measure/audit_impacts.hpp"

namespace tautline::bench {

// The word on the restitution of a run or of a model, from the impacts that can be read. What
// a step does to the reading of an impact is a bound (AuditedImpact::rate_floor), no guess: one
// impact beyond it proves a fault, and three within it are wanted before a word of praise.

/// The word on rebounds.
enum class Rebound {
  kept,        // every impact that can be read has the restitution that is asked for
  off,         // half of them or more are off, to one side
  lost_below,  // those up to a speed come back with less than half of it
  loses_some,  // some come back with less than half of it, at any speed
  scatters,    // some are off, to both sides
  none,        // nothing comes back
  too_few,     // too few impacts can be read to tell
  elastic,     // every cable is elastic and has no impacts; judged by position
};

/// The rebounds of a run or of a model.
struct Rebounds {
  Rebound word = Rebound::too_few;
  std::size_t readable = 0;         // impacts
  std::size_t off = 0;              // of them
  std::optional<double> asked;      // [-], the restitution, where it is the same for all
  std::optional<double> slowest;    // [m/s], of the readable ones
  std::optional<double> deviation;  // [-], median of e got less e asked
  std::optional<double> speed;  // [m/s]: up to it they are lost; with `stays_taut` of that impact
  bool stays_taut = false;      // after an impact that ought to have thrown the body back
  double steps = 0.0;           // that an impact takes, median

  /// Enough was seen, and nothing is wrong with it.
  [[nodiscard]] bool well() const { return word == Rebound::kept || word == Rebound::elastic; }

  /// Something is wrong with them.
  [[nodiscard]] bool wrong() const { return !well() && word != Rebound::too_few; }
};

/// An impact after which a cable ought to be slack for a while, and stays taut in the run.
struct StaysTaut {
  double speed = 0.0;  // [m/s], of the exact impact
};

/// The word on `impacts`; `stuck` if the run has such an impact.
[[nodiscard]] Rebounds rebounds_of(const std::vector<AuditedImpact>& impacts,
                                   const std::optional<StaysTaut>& stuck = std::nullopt);

}  // namespace tautline::bench
