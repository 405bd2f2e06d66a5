#pragma once

#include <filesystem>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "bench/ensemble/spec.hpp"

namespace tautline::bench {

struct Form;

/// What an ensemble is asked, or all that is wrong with its file.
struct SpecReading {
  std::optional<EnsembleSpec> spec;  // present exactly when `problems` is empty
  std::vector<std::string>
      problems;  // sentences that name file, line, key, value and what is right
  std::vector<std::string> notes = {};  // on the case's start, if it was changed to be taut
};

/// Reads the file of `tautline ensemble` (docs/guides/ensembles.md), as strictly as a case file. A
/// path in it counts from the folder that it is in. `other_case` replaces the case that it names.
[[nodiscard]] SpecReading read_spec_file(const std::filesystem::path& path,
                                         const std::optional<std::string>& other_case = {});

/// Reads its text; `source` names the file in the sentences, and its folder.
[[nodiscard]] SpecReading read_spec_text(std::string_view text, const std::filesystem::path& source,
                                         const std::optional<std::string>& other_case = {});

/// The keys of such a file.
[[nodiscard]] Form spec_form();

}  // namespace tautline::bench
