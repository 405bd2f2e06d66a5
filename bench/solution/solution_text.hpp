#pragma once

#include <string>

#include "bench/solution/cable_words.hpp"
#include "tautline/case.hpp"
#include "tautline/settling.hpp"
#include "tautline/solution.hpp"
#include "tautline/uncertainty.hpp"

namespace tautline::bench {

/// How the motion ends, when it settled and what is left of it, in a few lines of plain words. Each
/// number has right digits alone, as `uncertainty` says, and what is beyond the horizon is named.
[[nodiscard]] std::string solution_text(const Case& the_case, const Solution& solution,
                                        const Settling& settling, const Uncertainty& uncertainty);

}  // namespace tautline::bench
