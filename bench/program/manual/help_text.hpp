#pragma once

#include <cstddef>
#include <string>

#include "bench/program/manual/outline.hpp"

namespace tautline::bench {

/// What the program says without a command: what it is, its commands, and where to begin. In lines
/// of at most `width` columns.
[[nodiscard]] std::string help_text(const Outline& outline, std::size_t width);

/// The help of one command.
[[nodiscard]] std::string help_text(const Command& command, std::size_t width);

}  // namespace tautline::bench
