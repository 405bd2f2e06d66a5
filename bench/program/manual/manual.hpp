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

/// tautline(1): the program and its commands, as roff for `man`.
[[nodiscard]] std::string man_page(const Outline& outline);

/// tautline-solve(1) and the like: one of its commands.
[[nodiscard]] std::string man_page(const Outline& outline, const Command& command);

// Scripts with which a shell completes the command line: commands, options, the shipped cases, the
// engines that are here and their models, files and folders.

[[nodiscard]] std::string bash_completion(const Outline& outline);
[[nodiscard]] std::string zsh_completion(const Outline& outline);
[[nodiscard]] std::string fish_completion(const Outline& outline);

}  // namespace tautline::bench
