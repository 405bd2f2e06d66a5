#pragma once

#include <string>

#include "bench/base/table.hpp"
#include "bench/report/report.hpp"

namespace tautline::bench {

/// How far the distributions of every engine, model and step are from those of the exact motion;
/// empty in a report without draws.
[[nodiscard]] Table distributions_table(const Report& report);

/// What was drawn and what the exact motions do, in sentences; "" in a report without draws.
[[nodiscard]] std::string distributions_paragraph(const Report& report);

/// How to read the table.
inline constexpr const char* how_to_read_distributions =
    "Beyond its horizon one motion says nothing about an engine, a distribution does. Each number "
    "is D, the largest distance between the distribution functions of the engine and of the "
    "exact motion (Kolmogorov and Smirnov): 0 for the same, 1 for apart; in brackets where the two "
    "cannot be told apart, by D or by the energy distance, in all tests of the table together.";

}  // namespace tautline::bench
