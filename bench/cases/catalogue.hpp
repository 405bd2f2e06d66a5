#pragma once

#include <filesystem>
#include <span>
#include <string>
#include <vector>

#include "tautline/case.hpp"
#include "tautline/system.hpp"

namespace tautline::bench {

/// The cases that a command line names, or all that is wrong with it.
struct CaseSelection {
  std::vector<Case> cases;                   // shipped ones in catalogue order, then files as given
  std::vector<std::string> problems;         // sentences; `cases` is empty unless this is
  std::vector<std::string> notes = {};       // sentences on starts that were changed to be taut
  std::vector<System> systems = {};          // shipped ones and files, as given
  std::vector<SpatialSystem> in_space = {};  // likewise
};

/// The kinds that a command takes.
enum class Kinds { cases_alone, cases_and_systems };

/// Resolves each argument: the name of a shipped case, the path of a case file, or a glob over the
/// shipped names (`breakwater/19*`, `*`), in which `*` matches `/` too. A file that is called like
/// a shipped case is meant by `./<name>`. A case named twice is taken once. In each of them the
/// cables of `taut` start taut, beside those of its file.
[[nodiscard]] CaseSelection select_cases(std::span<const std::string> arguments, CableSet taut = {},
                                         Kinds kinds = Kinds::cases_alone);

/// A relative path to keep a case's files under, harmless whatever the name holds: components of
/// [A-Za-z0-9._-] that start with none of "." and "-", 120 characters in all. Names that are such
/// paths are kept; a name that had to be changed ends in a hash of it, so that no two share a
/// folder.
[[nodiscard]] std::filesystem::path folder_name(const std::string& case_name);

}  // namespace tautline::bench
