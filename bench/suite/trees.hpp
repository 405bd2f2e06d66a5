#pragma once

#include <cstddef>
#include <filesystem>
#include <string>
#include <vector>

#include "bench/report/manifest.hpp"
#include "bench/suite/plan.hpp"

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

}  // namespace tautline::bench
