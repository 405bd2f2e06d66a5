#pragma once

#include <filesystem>
#include <string>

#include "bench/run/protocol/engine_file.hpp"

namespace tautline::bench {

/// Where versions of engines are kept: $XDG_CACHE_HOME/tautline/npm, or that below ~/.cache.
[[nodiscard]] std::filesystem::path version_cache();

/// A copy of an engine whose package is of one version.
struct PinnedEngine {
  std::filesystem::path file;  // its engine.toml
  std::string problem;         // why there is none, or ""
};

/// Copies the folder of `engine` to `cache`/<name>/<version>, as it is now, and lets npm install
/// the version of its package there, unless it has before: then nothing is fetched. What the folder
/// shares with others stays where it is, and the copy finds it in the same place, by a link. Two
/// programs may ask for the same copy at once: one waits for the other. Throws
/// std::filesystem::filesystem_error where the cache cannot be written.
[[nodiscard]] PinnedEngine pinned_engine(const EngineFile& engine, const std::string& version,
                                         const std::filesystem::path& cache);

}  // namespace tautline::bench
