#pragma once

#include <string>
#include <string_view>

#include "tautline/case.hpp"

namespace tautline::bench {

/// What was measured for a claim.
struct Measure {
  double found;          // the smaller the better; not a number where nothing could be measured
  double limit;          // that a sound engine can meet
  std::string sentence;  // what was found; beyond the limit, what seems to be wrong
};

/// A contact that an engine spreads over time may take this many steps: as many as a spring needs
/// to be stable and to give back its restitution within a few hundredths.
inline constexpr int longest_contact = 20;

/// The larger of two measures; infinite where the second is not a number, which std::max loses.
[[nodiscard]] double worse(double a, double b);

/// The largest difference of one of the six numbers of two states, each in its own unit; infinite
/// where one is not a number.
[[nodiscard]] double largest_difference(const State& a, const State& b);

/// "NaN", "infinity" or "-infinity", for a number that is not finite.
[[nodiscard]] std::string_view not_finite(double number);

}  // namespace tautline::bench
