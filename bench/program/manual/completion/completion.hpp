#pragma once

#include <string>

#include "bench/program/manual/outline.hpp"

namespace tautline::bench {

// Scripts with which a shell completes the command line: commands, options, the shipped cases, the
// engines that are here and their models, files and folders.

[[nodiscard]] std::string bash_completion(const Outline& outline);
[[nodiscard]] std::string zsh_completion(const Outline& outline);
[[nodiscard]] std::string fish_completion(const Outline& outline);

}  // namespace tautline::bench
