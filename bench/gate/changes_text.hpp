#pragma once

#include <string>

#include "bench/base/terminal.hpp"
#include "bench/gate/changes.hpp"

namespace tautline::bench {

/// What changed, for a terminal: what is broken first. Runs that are in one report alone are
/// counted.
[[nodiscard]] std::string changes_text(const Changes& changes,
                                       const TerminalStyle& style = unlimited);

/// Of these what fails anew, and the runs that are gone; "" without any.
[[nodiscard]] std::string missing_text(const Changes& changes, const TerminalStyle& style);

/// Its last line: how many changes.
[[nodiscard]] std::string changes_sentence(const Changes& changes);

}  // namespace tautline::bench
