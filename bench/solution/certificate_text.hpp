#pragma once

#include <string>

#include "bench/base/terminal.hpp"
#include "bench/solution/certificate.hpp"
#include "tautline/case.hpp"
#include "tautline/solution.hpp"

namespace tautline::bench {

/// What `certificate` says of `solution`, in a few lines and a table.
[[nodiscard]] std::string certificate_text(const Certificate& certificate, const Case& the_case,
                                           const Solution& solution, const TerminalStyle& style);

}  // namespace tautline::bench
