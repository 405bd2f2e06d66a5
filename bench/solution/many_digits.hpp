#pragma once

#include <functional>
#include <string>
#include <vector>

#include "bench/base/terminal.hpp"
#include "bench/cases/literals.hpp"
#include "tautline/case.hpp"
#include "tautline/solution.hpp"
#include "tautline/solve.hpp"

namespace tautline::bench {

/// Right digits that may be asked for: more than this many take minutes.
inline constexpr int most_right_digits = 100;

/// What `tautline solve --digits N` was asked.
struct ManyDigits {
  int digits = 0;               // significant, that are right
  bool decimal = false;         // of the decimals that the case is written in, not of their doubles
  bool all_events = false;      // not the first 20
  Literals written = {};        // the numbers of the case's file, if it has one
  std::vector<double> at = {};  // [s], times of samples, within the solution in doubles
  std::function<void(int)> on_attempt = {};  // told the digits of each solution before it
};

/// What `tautline solve` prints of `the_case`, with `asked.digits` right digits of each number:
/// computed with as many as the doubles tell it takes, then with an eighth more, and with half as
/// many again until two solutions agree. `solution`
/// solves it in doubles with `options`. Numbers that do not come to agree keep those digits that
/// do. A tie that the digits do not decide ends what is said, in the words of `tie_sentence`. Not
/// for several threads: see `Digits`.
[[nodiscard]] std::string many_digits_text(const Case& the_case, const SolveOptions& options,
                                           const Solution& solution, const ManyDigits& asked,
                                           const TerminalStyle& style);

}  // namespace tautline::bench
