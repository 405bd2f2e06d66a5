#pragma once

#include "bench/cases/literals.hpp"
#include "tautline/case.hpp"
#include "tautline/multiprecision.hpp"

namespace tautline::bench {

/// `the_case` with the numbers of Table 5.1 as they are printed if it is of no file, or with the
/// decimals that its doubles are read from.
[[nodiscard]] BasicCase<Multi> in_decimals(const Case& the_case, const Literals& written);

}  // namespace tautline::bench
