#pragma once

#include <string>

#include "bench/program/manual/outline.hpp"

namespace tautline::bench {

/// tautline(1): the program and its commands, as roff for `man`.
[[nodiscard]] std::string man_page(const Outline& outline);

/// tautline-solve(1) and the like: one of its commands.
[[nodiscard]] std::string man_page(const Outline& outline, const Command& command);

}  // namespace tautline::bench
