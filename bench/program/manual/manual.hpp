#pragma once

#include <cstddef>
#include <map>
#include <string>
#include <vector>

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

/// What may stand at the end of a command line, for a shell: `words` are those after `tautline`,
/// and the last of them, which may be "", is being typed. A line each: the word, a tab and its
/// meaning. A line ":files", a tab and a pattern asks the shell for its files, a line ":folders"
/// for folders.
[[nodiscard]] std::string completions(const Outline& outline,
                                      const std::vector<std::string>& words);

/// The script with which a shell asks for them, by the name of the shell.
[[nodiscard]] const std::map<std::string, std::string>& completion_scripts();

}  // namespace tautline::bench
