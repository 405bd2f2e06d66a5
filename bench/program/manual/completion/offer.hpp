#pragma once

#include <string>
#include <vector>

#include "bench/program/manual/outline.hpp"

namespace tautline::bench {

// What the completions of all shells have in common.

/// What a shell offers for a value.
enum class Offer { nothing, file, folder, one_case, engine, model, command, choices };
[[nodiscard]] Offer offer_of(const Argument& argument);

// Words with blanks between them.
[[nodiscard]] std::string spaced(const std::vector<std::string>& words);
[[nodiscard]] std::string case_names();  // of the shipped cases
[[nodiscard]] std::string command_names(const Outline& outline);

/// Text in single quotes, in which no shell reads anything; a quote becomes a typographic one.
[[nodiscard]] std::string in_quotes(std::string text);

/// What only the installed program knows, the script asks of it when it needs it. `tautline
/// engines` prints a line for each engine, and below it, indented, one for each model; what is
/// missing has no "version".
inline constexpr const char* shell_functions = R"(
_tautline_engines() {
  tautline engines 2>/dev/null | sed -n 's/^\([^ ][^ ]*\)  version.*/\1/p'
}
_tautline_models() {
  tautline engines 2>/dev/null | sed -n 's/^  \([^ ][^ ]*\)  .*/\1/p' | sort -u
}
)";

}  // namespace tautline::bench
