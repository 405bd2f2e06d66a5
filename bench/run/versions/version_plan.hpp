#pragma once

#include <string>
#include <vector>

#include "bench/run/protocol/engine_file.hpp"

namespace tautline::bench {

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

}  // namespace tautline::bench
