#pragma once

#include <optional>
#include <string>

#include "bench/solution/certificate.hpp"
#include "tautline/solve.hpp"

namespace tautline::bench {

/// A certificate may be computed with this many digits. Fewer are hardly more than the 16 of a
/// double; more than a thousand correct ones no one has asked for, and they take minutes.
inline constexpr int least_digits = 20;
inline constexpr int most_digits = 1000;

/// Solves `the_case` once more with numbers of `digits` decimal digits, and holds `solution`, which
/// solves it with `options`, against that. The numbers of the case are the doubles they are.
/// Requires least_digits <= digits <= most_digits. Not for several threads: see `Digits`.
[[nodiscard]] Certificate certify(const Case& the_case, const SolveOptions& options,
                                  const Solution& solution, int digits);

/// The sentence that says why a certificate cannot have `digits`; none if it can.
[[nodiscard]] std::optional<std::string> digits_problem(int digits);

}  // namespace tautline::bench
