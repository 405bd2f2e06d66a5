#pragma once

#include <nlohmann/json.hpp>
#include <string>

#include "bench/base/terminal.hpp"

namespace tautline::bench {

/// The answers over all cases, by engine, model and step, with a word from the verdicts, in aligned
/// columns. What does not fit the width is left out, the least important column first, and named
/// below. Drawn from `report` alone.
[[nodiscard]] std::string terminal_answers(const nlohmann::ordered_json& report,
                                           const TerminalStyle& style);

}  // namespace tautline::bench
