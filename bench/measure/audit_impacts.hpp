#pragma once

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <optional>
#include <vector>

#include "bench/measure/reference.hpp"
#include "bench/run/record.hpp"

namespace tautline::bench {

/// An impact of a run as the audit sees it.
struct AuditedImpact {
  double speed = 0.0;      // [m/s], > 0, at which the cable closed
  double requested = 0.0;  // [-], the cable's restitution at that speed
  double effective = 0.0;  // [-], what came back
  double arm = 0.0;        // [m]; 0 of a system
  double across = 0.0;     // [-], unexplained momentum across the cable, as part of the impulse
  double turning = 0.0;  // [-], unexplained spin, as part of the impulse at the radius of gyration
  double rate_floor = 0.0;  // [m/s], what its steps do to its rates at most
  std::size_t steps = 0;    // with an impulse; 0 if located

  /// Effective less requested restitution.
  [[nodiscard]] double deviation() const { return effective - requested; }
};

/// An impact can be read where what its steps do to its rates is at most this part of them [-].
inline constexpr double readable_part = 0.1;

/// By how much a step may change what is read of an impact of cable `index`, per second of it
/// [m/s^2]: the rate before is one of a flight that goes on for up to a step, the rate after one of
/// a flight that has gone on and of the pose before. `before` and `after` are at one pose.
template <class TheCase>
[[nodiscard]] double change_of_rates(const TheCase& the_case, std::size_t index,
                                     const StateOf<TheCase>& before, const StateOf<TheCase>& after);

/// By how much rates that change by `change` [m/s] put in doubt what is read of an impact at
/// `speed` [m/s], in [m/s]: by more if the restitution depends on the speed, and next to a capture
/// speed by all of it.
template <class TheCable>
[[nodiscard]] double doubt_of_rates(const TheCable& cable, double speed, double change) {
  if (!depends_on_speed(cable)) {
    return change;
  }
  const double here = restitution(cable, speed);
  return change +
         speed * std::max(std::abs(restitution(cable, std::max(0.0, speed - change)) - here),
                          std::abs(restitution(cable, speed + change) - here));
}

/// The impacts of `run` that say something of restitution: those of one cable alone that can be
/// read, up to the end of the exact motion.
template <class TheReference, class TheCase>
[[nodiscard]] std::vector<AuditedImpact> audited_impacts(const TheReference& reference,
                                                         const BasicTrajectory<TheCase>& run);

/// Heights of consecutive bounces on one cable through the centre of mass, as parts of the first
/// fall.
struct Ladder {
  std::size_t cable = 0;
  double exact_ratio = 0.0;     // [-], of one height to the next: e^2
  std::vector<double> heights;  // [-], h_n / h_0, n = 1, 2, ...
  std::vector<double> exact;    // [-], e^(2n)
};

/// The ladder of `run`; none where its bounces do not stay on one line.
[[nodiscard]] std::optional<Ladder> ladder_of(const ReferenceCase& reference, const Trajectory& run,
                                              double count_speed);

/// A run that freezes: the body stops in one go where the exact motion swings on.
struct Freeze {
  double moving = 0.0;  // [s], of the last sample before
  double time = 0.0;    // [s], of the first sample from which on nothing moves
  double lost = 0.0;    // [J], of energy between the two
};

}  // namespace tautline::bench
