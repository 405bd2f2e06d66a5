#pragma once

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
  double arm = 0.0;        // [m]
  double across = 0.0;     // [-], unexplained momentum across the cable, as part of the impulse
  double turning = 0.0;  // [-], unexplained spin, as part of the impulse at the radius of gyration
  double rate_floor = 0.0;  // [m/s], what a step does to rates: less says nothing
  std::size_t steps = 0;    // with an impulse; 0 if located

  /// Effective less requested restitution.
  [[nodiscard]] double deviation() const { return effective - requested; }
  /// The same as a rate, in units of what a step does.
  [[nodiscard]] double floors() const { return deviation() * speed / rate_floor; }
};

/// The impacts of `run` that say something of restitution: those of one cable alone, counted, up to
/// the lock of the exact motion, and fast enough for the run's step.
[[nodiscard]] std::vector<AuditedImpact> audited_impacts(const ReferenceCase& reference,
                                                         const Trajectory& run, double count_speed);

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

/// Effective less requested restitution over impacts.
struct Scatter {
  std::size_t count = 0;
  double mean = 0.0;
  double standard_deviation = 0.0;
  double smallest = 0.0;
  double largest = 0.0;
};
[[nodiscard]] std::optional<Scatter> scatter_of(const std::vector<AuditedImpact>& impacts);

/// The scatter of both together.
[[nodiscard]] Scatter pooled(const Scatter& one, const Scatter& other);

/// A run that freezes: the body stops in one go where the exact motion swings on.
struct Freeze {
  double moving = 0.0;  // [s], of the last sample before
  double time = 0.0;    // [s], of the first sample from which on nothing moves
  double lost = 0.0;    // [J], of energy between the two
};

}  // namespace tautline::bench
