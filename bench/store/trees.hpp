#pragma once

#include <cstddef>
#include <filesystem>
#include <string>
#include <vector>

#include "bench/store/manifest.hpp"
#include "bench/store/plan.hpp"

namespace tautline::bench {

/// A result tree that is to be merged with others.
struct ResultTree {
  std::filesystem::path path;
  Manifest manifest;
  SuiteOptions options;  // that `manifest` tells of
};

/// The shards of one suite, or in sentences why `trees` are none: no result tree, of another
/// program, cases, engines, models, steps, law or limits than the first, a shard twice.
struct TreeSet {
  std::vector<ResultTree> trees;  // by their shards, rising
  std::vector<std::string> problems;
};
[[nodiscard]] TreeSet read_trees(const std::vector<std::filesystem::path>& paths);

/// The numbers of the shards that `trees`, which belong together, lack.
[[nodiscard]] std::vector<std::size_t> missing_shards(const std::vector<ResultTree>& trees);

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
