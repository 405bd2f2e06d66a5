#pragma once

#include <string>

#include "tautline/scenarios.hpp"

namespace tautline::bench {

/// What tells a case from others, in words and few digits: "e = 0.9, box 0.2 x 0.2, two cables of
/// 1.5", in the case's own units. A start at an angle or with a spin is named, and gravity that
/// does not point down.
[[nodiscard]] std::string title_of(const Case& the_case);

/// The first of the sentences on a system.
[[nodiscard]] std::string title_of(const ShippedSystem& one);

}  // namespace tautline::bench
