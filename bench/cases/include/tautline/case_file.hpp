#pragma once

#include <filesystem>
#include <string>
#include <vector>

#include "tautline/case_text.hpp"

namespace tautline {

/// Reads a case file. Never throws on bad input and never waits for it: what is not a regular file
/// is refused. Cables with `taut = true`, and those of `taut`, start taut (`taut_start`).
[[nodiscard]] CaseReading read_case(const std::filesystem::path& path, CableSet taut = {});

/// Reads a case file of either kind, as `read_case` does.
[[nodiscard]] SystemReading read_system(const std::filesystem::path& path, CableSet taut = {});

/// Writes a case file whole or not at all, and makes its folder as needed. Returns what is wrong in
/// sentences, none if the file is written: a case that `read_case` would refuse is not written.
[[nodiscard]] std::vector<std::string> write_case(const Case& the_case,
                                                  const std::filesystem::path& path);
/// Writes the file of a system likewise.
[[nodiscard]] std::vector<std::string> write_system(const System& system,
                                                    const std::filesystem::path& path);

}  // namespace tautline
