#pragma once

#include <filesystem>
#include <string>
#include <vector>

#include "bench/run/protocol/engine_file.hpp"

namespace tautline::bench {

/// Versions of an engine, as a command line asks for them: `planck@1.0..1.4.2`.
struct VersionRequest {
  std::string engine;   // its name, or the path of its engine.toml
  std::string range;    // as npm reads it: ">=1.0 <=1.4.2"; empty: what the engine.toml says
  std::string problem;  // a sentence where `text` is no request
};

/// Reads ENGINE, ENGINE@FROM..TO, ENGINE@FROM.., ENGINE@..TO or ENGINE@RANGE, where RANGE is npm's
/// own.
[[nodiscard]] VersionRequest version_request(const std::string& text);

/// Of `versions`, which rise, the newest of each minor version: 1.4.2 of 1.4.0 and 1.4.2.
[[nodiscard]] std::vector<std::string> newest_of_each_minor(
    const std::vector<std::string>& versions);

/// True where `one` is older. Which versions a range has is npm's to say; it lists them in any
/// order.
[[nodiscard]] bool is_older(const std::string& one, const std::string& other);

/// A version that is to be run.
struct PlannedVersion {
  std::string version;
  bool untried = false;  // the engine.toml says which versions it is made for, and not this one
};

/// An engine and the versions of its package that are to be run.
struct VersionPlan {
  EngineFile engine;
  std::string range;                     // as npm reads it
  std::vector<PlannedVersion> versions;  // from the oldest to the newest
  std::vector<std::string> problems;     // sentences; the rest is void if there are any
};

/// What `text`, such as "planck@1.0..1.4" or "./mine/engine.toml@^2", asks for: the newest of each
/// minor version, or `every` one. Without versions, those that the engine.toml names. Asks npm.
[[nodiscard]] VersionPlan version_plan(const std::string& text, bool every);

/// Versions that npm knows, from the oldest to the newest, or why it names none.
struct NpmVersions {
  std::vector<std::string> versions;
  std::string problem;
};

/// The versions of `package` in `range`, which npm reads. Without a network npm answers from what
/// it has kept.
[[nodiscard]] NpmVersions versions_in(const std::string& package, const std::string& range);

/// Installs exactly this version of `package` into `folder`, whose package.json then says so, and
/// what else that asks for. Runs no script of a package. Why it could not, or "".
[[nodiscard]] std::string install_version(const std::filesystem::path& folder,
                                          const std::string& package, const std::string& version);

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
