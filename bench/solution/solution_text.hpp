#pragma once

#include <string>

#include "bench/solution/certify.hpp"
#include "tautline/case.hpp"
#include "tautline/settling.hpp"
#include "tautline/solution.hpp"

namespace tautline::bench {

/// "0+1"
[[nodiscard]] std::string cable_list(CableSet cables);

/// How the motion ends, when it settled and what is left of it, in a few lines of plain words.
[[nodiscard]] std::string summary_text(const Case& the_case, const Solution& solution,
                                       const Settling& settling);

/// What `certificate` says of `solution`, in a few lines and a table.
[[nodiscard]] std::string certificate_text(const Certificate& certificate, const Case& the_case,
                                           const Solution& solution);

}  // namespace tautline::bench
