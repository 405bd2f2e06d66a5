#pragma once

#include <array>
#include <cstddef>
#include <optional>
#include <vector>

#include "bench/data/says.hpp"
#include "tautline/case.hpp"
#include "tautline/detail/ledger.hpp"
#include "tautline/settling.hpp"
#include "tautline/solution.hpp"

namespace tautline::bench {

/// Decimal digits of a certificate where none are asked for.
inline constexpr int default_digits = 50;

/// Until when a solution in double is within 10^-digits of the one with more digits: in position
/// against the shortest cable, in angle against a radian, and in velocity against the fastest
/// speed of the motion, the latter while both are between the same two events.
struct CorrectDigits {
  int digits;
  std::optional<double> until;  // [s]; none: to the end
};

/// Its members by their names in JSON.
template <class Visitor>
void fields(Visitor& visit, CorrectDigits& correct) {
  visit("digits", correct.digits, at_least(1));
  visit("until", correct.until, "[s]; null: to the end");
}

/// Until when the solution of a case is right.
struct CertifiedDigits {
  int digits = 0;                      // decimal, of the other solution's numbers
  std::vector<CorrectDigits> correct;  // falling in digits
};

/// What tells one event from another.
struct EventMark {
  double time;  // [s]
  EventKind kind;
  CableSet cables;
};

/// Whether two solutions took the same events. An accumulation counts as one event: the solution
/// with more digits follows its impacts further before it completes them.
struct EventMatch {
  std::size_t count = 0;  // of events of the solution in double, from the first on, that are same
  double until = 0.0;     // [s], of the last of them
  bool all = false;       // neither solution has another event
  std::optional<EventMark> in_double;  // unless `all`: its next event, if there is one
  std::optional<EventMark> in_digits;  // the same of the solution with more digits
};

/// A solution in double compared with the same motion with more digits.
struct Certificate {
  int digits = default_digits;    // decimal, of the other solution's numbers
  double completion_error = 0.0;  // [-], CompletionLimits::error of that solution
  std::array<CorrectDigits, 3> correct = {{{9, {}}, {6, {}}, {3, {}}}};
  EventMatch events;
  std::size_t event_count = 0;  // of the other solution
  Ending ending = Ending::reached_duration;
  double end_time = 0.0;  // [s]
  EnergyLedger energy{};  // rounded, the residual too
  Settling settling;      // the same
};

}  // namespace tautline::bench
