#pragma once

#include <filesystem>
#include <string>
#include <vector>

#include "bench/suite/suite.hpp"
#include "bench/suite/trees.hpp"

namespace tautline::bench {

/// The runs of result trees, put together.
struct Gathering {
  SuiteResult result;                // of the whole suite
  std::vector<std::string> missing;  // sentences: shards, and runs of the shards that are here
};

/// Copies the files of all runs of `trees`, which belong together, into the result tree `out`, and
/// reads what they left. Throws FileError if a file cannot be copied.
[[nodiscard]] Gathering gather(const std::vector<ResultTree>& trees,
                               const std::filesystem::path& out);

/// The suite that `trees` are of, in one piece and written to `out`.
[[nodiscard]] SuiteOptions whole_suite(const std::vector<ResultTree>& trees,
                                       const std::filesystem::path& out);

/// How the trees were made, for the report. A machine is named once.
[[nodiscard]] Context made_by(const std::vector<ResultTree>& trees);

}  // namespace tautline::bench
