#pragma once

#include <optional>
#include <string>
#include <vector>

#include "bench/base/terminal.hpp"
#include "bench/solution/digits_ties.hpp"
#include "tautline/multiprecision.hpp"
#include "tautline/settling.hpp"
#include "tautline/solution.hpp"
#include "tautline/solve.hpp"

namespace tautline::bench {

struct ManyDigits;

/// A solution with many digits, and what it settles into.
struct DigitsRun {
  int digits;
  BasicCase<Multi> the_case;
  BasicSolution<BasicCase<Multi>> solution;
  BasicSettling<Multi> settling;
};

/// How far two numbers are apart.
[[nodiscard]] inline Multi apart(const Multi& a, const Multi& b) { return abs(Multi(a - b)); }

/// The numbers of a sample in the order of `sample_names`.
[[nodiscard]] std::vector<Multi> sample_of(const DigitsRun& run, double time);

// What two runs of one case agree on, in words and tables. `few` has fewer digits than `many`.

/// The samples with all right digits, a column each; what follows a tie is open.
[[nodiscard]] std::string samples_of(const Case& the_case, const DigitsRun& few,
                                     const DigitsRun& many, const std::optional<NumberTie>& tie,
                                     const ManyDigits& asked, const TerminalStyle& style);

/// The tensions of a body at rest, a line; "" for one that is not.
[[nodiscard]] std::string rest_tensions_of(const DigitsRun& few, const DigitsRun& many,
                                           const ManyDigits& asked);

/// That impulses are one split of several, a line; "" where they are not.
[[nodiscard]] std::string split_line(const DigitsRun& few, const DigitsRun& many,
                                     const SolveOptions& options, const ManyDigits& asked);

/// The events that both have, one row each, up to a tie.
[[nodiscard]] std::string events_of(const DigitsRun& few, const DigitsRun& many,
                                    const std::optional<NumberTie>& tie, const ManyDigits& asked,
                                    const TerminalStyle& style);

}  // namespace tautline::bench
