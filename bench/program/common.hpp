#pragma once

#include <filesystem>
#include <optional>
#include <string>
#include <vector>

#include "tautline/case.hpp"

namespace tautline::bench {

/// Exit codes of the program.
inline constexpr int exit_done = 0;
inline constexpr int exit_failed = 1;  // a run failed or diverged, or a result could not be written
inline constexpr int exit_usage = 2;   // wrong usage or input

/// The one case that `argument` means; none, after complaining, if that is not one.
[[nodiscard]] std::optional<Case> one_case(const std::string& argument);

/// Prints each sentence to standard error as "tautline: ...". True if there is one.
bool complain(const std::vector<std::string>& sentences);

/// Adds `more` to `sentences`.
void append(std::vector<std::string>& sentences, const std::vector<std::string>& more);

/// What is wrong with a file that `option` names, before anything is done for it: its folder is not
/// there. Nothing is wrong with "-", with none (""), or where the folder is `made`, which the
/// command makes.
[[nodiscard]] std::vector<std::string> missing_folder(const std::string& option,
                                                      const std::string& file,
                                                      const std::filesystem::path& made = {});

/// Writes `text` to the file `target`, or to standard output for "-". Makes no folder.
void write_output(const std::string& target, const std::string& text);

}  // namespace tautline::bench
