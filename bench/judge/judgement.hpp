#pragma once

#include <algorithm>
#include <cstddef>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "bench/judge/allowance.hpp"
#include "bench/judge/rebound.hpp"
#include "bench/measure/audit.hpp"

namespace tautline::bench {

/// How far a run is from the exact motion, against what is allowed to any scheme of its step.
struct Following {
  std::optional<double>
      ratio;           // [-], of error to allowance, at worst; none where nothing is judged
  double time = 0.0;   // [s], of the worst
  double error = 0.0;  // [m], then
  double until = 0.0;  // [s], of what is judged
  /// The run names the instants of all of its impacts itself, and engines fly exactly in between.
  bool located = false;
  /// [-], of the error to what rounding explains up to the first taut cable; of a run that locates
  /// its impacts, in the numbers of its engine. None of others.
  std::optional<double> rounding;
};

/// Impacts of the exact motion that a run cannot miss.
struct Expected {
  std::size_t due = 0;
  std::size_t missed = 0;
};

/// Everything that a run is judged by.
struct Judgement {
  Rebounds rebounds;
  Following following;
  Expected impacts;
  double overstretch = 0.0;  // [-], in units of what a step explains
  /// [-], the largest rise outside contacts, in units of m a v step; none where something drives
  /// the bodies, or where a cable is elastic: a step that is stable lets the sum of kinetic and
  /// stored energy swing by its frequency times the step.
  std::optional<double> energy;
  double flight = 0.0;  // [-], of gravity: by what the acceleration in flight is off
  /// [-], by what a flight changes an angular momentum that nothing changes, at most, in units of
  /// what a scheme of first order explains; none in the plane, and where no body turns in flight.
  std::optional<double> rotation;
};

/// True if the run names the instants of all of its impacts itself.
template <class TheCase>
[[nodiscard]] bool locates(const BasicTrajectory<TheCase>& run) {
  return !run.impacts.empty() && std::all_of(run.impacts.begin(), run.impacts.end(),
                                             [](const auto& impact) { return impact.steps == 0; });
}

/// Judges `run` of a case or of a system, whose `impacts` are audited, of an engine with numbers of
/// `precision`. Elastic cables have no impacts and no restitution, and their stretch is no fault:
/// of them `following` alone tells, and `rebounds` has the word `elastic` where it does.
template <class TheReference, class TheCase>
[[nodiscard]] Judgement judge(const BasicExpectation<TheReference>& expectation,
                              const BasicTrajectory<TheCase>& run,
                              const std::vector<AuditedImpact>& impacts,
                              std::string_view precision);

// From here on it is a problem. Each number stands well above the worst of 2,496 runs of sound
// models in random cases (scripts/judgement), which is given.

inline constexpr double most_ratio = 2.0;   // of Following::ratio; 1.6
inline constexpr double exact_ratio = 0.2;  // the same, of a run that is exact to its events; 0.11
inline constexpr double most_rounding = 1000.0;  // of Following::rounding; 106
inline constexpr double most_overstretch = 2.0;  // of Judgement::overstretch; 0.93
inline constexpr double most_energy = 1.0;       // of Judgement::energy; 0.53
inline constexpr double most_flight = 2e-3;      // of Judgement::flight; 5e-16
inline constexpr double most_rotation = 2.0;     // of Judgement::rotation; 0.29

/// The impacts of an exact motion that a run of steps of `step` [s] can be read by: from this alone
/// it is known beforehand which step tells something of a case.
template <class TheReference>
[[nodiscard]] std::size_t readable_impacts(const TheReference& reference, double step);

}  // namespace tautline::bench
