#pragma once

#include <cstddef>
#include <filesystem>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "tautline/case.hpp"

namespace tautline {

/// A case, or all that is wrong with its file.
struct CaseReading {
  std::optional<Case> the_case;  // present exactly when `problems` is empty; `solve` accepts it
  std::vector<std::string>
      problems;  // sentences that name file, line, key, value and what is right
  std::vector<std::string> notes = {};  // likewise, how the start was changed to be taut
};

/// A longer file is refused before it is read [bytes].
inline constexpr std::size_t longest_case_file = std::size_t{1} << 20U;

/// Reads a case file. Never throws on bad input and never waits for it: what is not a regular file
/// is refused. Cables with `taut = true`, and those of `taut`, start taut (`taut_start`).
[[nodiscard]] CaseReading read_case(const std::filesystem::path& path, CableSet taut = {});

/// Reads the text of a case file; `source_name` names the file in the sentences.
[[nodiscard]] CaseReading read_case_text(std::string_view text, const std::string& source_name,
                                         CableSet taut = {});

/// What is wrong with a start that was to be taut, or how it has changed.
struct StartChange {
  std::vector<std::string> problems;  // sentences; the case is as it was unless this is empty
  std::vector<std::string> notes;     // sentences
};

/// Makes `taut` cables of `the_case` start taut (`taut_start`).
[[nodiscard]] StartChange start_taut(Case& the_case, CableSet taut);

/// The text of a case file that reads back as the same case, bit for bit.
/// Requires a name in UTF-8.
[[nodiscard]] std::string write_case(const Case& the_case);

/// Writes a case file whole or not at all, and makes its folder as needed. Returns what is wrong in
/// sentences, none if the file is written: a case that `read_case` would refuse is not written.
[[nodiscard]] std::vector<std::string> write_case(const Case& the_case,
                                                  const std::filesystem::path& path);

}  // namespace tautline
