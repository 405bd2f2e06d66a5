#pragma once

#include <string>
#include <string_view>
#include <vector>

#include "tautline/case.hpp"

namespace tautline::bench {

/// The names of the numbers of `the_case` that an ensemble may vary: those of its start and its
/// body, "restitution", "length" and "capture_speed" of all cables, and of one: "length_0".
[[nodiscard]] std::vector<std::string> quantities_of(const Case& the_case);

/// The unit of a quantity: "m", or "" for a number without one.
[[nodiscard]] std::string_view unit_of_quantity(std::string_view name);

/// The number of that name, one of `quantities_of`; of all cables that of the first.
[[nodiscard]] double quantity(const Case& the_case, std::string_view name);
void set_quantity(Case& the_case, std::string_view name, double value);
void scale_quantity(Case& the_case, std::string_view name, double factor);  // each of its numbers

}  // namespace tautline::bench
