#pragma once

#include <string>

#include "tautline/case.hpp"

namespace tautline::bench {

/// The text of a case file that reads back as the same case, bit for bit.
/// Requires a name in UTF-8.
[[nodiscard]] std::string write_case(const Case& the_case);

}  // namespace tautline::bench
