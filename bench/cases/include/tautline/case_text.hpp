#pragma once

#include <cstddef>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "tautline/case.hpp"
#include "tautline/system.hpp"

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

/// Reads the text of a case file; `source_name` names the file in the sentences. Text that begins
/// with { is a JSON object with the keys of a case file, any other text is TOML. JSON gets the same
/// sentences, without lines. Cables with `taut = true`, and those of `taut`, start taut
/// (`taut_start`). The file of a system is refused.
[[nodiscard]] CaseReading read_case_text(std::string_view text, const std::string& source_name,
                                         CableSet taut = {});

/// A system, in the plane or in space, or all that is wrong with its file.
struct SystemReading {
  std::optional<System> system = {};  // in the plane; one of the two if `problems` is empty
  std::optional<SpatialSystem> in_space = {};  // where gravity has three numbers
  /// It as a case, where the file has one [body], cables with anchor and attachment, and constants
  /// alone: `solve` is fastest with it, and it alone keeps `angle_limit` and `ceiling`.
  std::optional<Case> the_case = {};
  std::vector<std::string> problems = {};  // as in CaseReading
  std::vector<std::string> notes = {};     // likewise; none on a file that is no case
  /// If the file is no case, a sentence that names the first key of a system in it.
  std::string only_a_system = {};
};

/// Reads the text of a case file of either kind, as `read_case_text` does.
[[nodiscard]] SystemReading read_system_text(std::string_view text, const std::string& source_name,
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

/// The same as one JSON object.
[[nodiscard]] std::string write_case_json(const Case& the_case);

/// The text of a case file that reads back as the same system, bit for bit: what is given over time
/// as times and values where it was made of them, and as pieces otherwise. Requires that `problems`
/// finds none, and names in UTF-8.
[[nodiscard]] std::string write_system(const System& system);
/// Likewise in space.
[[nodiscard]] std::string write_system(const SpatialSystem& system);

/// A system as one JSON object.
[[nodiscard]] std::string write_system_json(const System& system);
/// Likewise in space.
[[nodiscard]] std::string write_system_json(const SpatialSystem& system);

}  // namespace tautline
