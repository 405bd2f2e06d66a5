#pragma once

#include <filesystem>
#include <optional>
#include <string>
#include <vector>

#include "tautline/engine.hpp"

namespace tautline::bench {

/// An engine this program knows of or was given.
struct RegisteredEngine {
  std::string name;                // its own word for itself; the file's name if it cannot be asked
  std::filesystem::path plugin;    // its .so or its engine.toml; empty if there is none
  std::optional<EngineInfo> info;  // set if it answered
  std::string failure;             // set if a plug-in is there but did not answer
  std::string missing;             // set if there is no plug-in, or nothing that it needs: why
  std::string package;             // what brings it, if known
};

/// The folders in which plug-ins are looked for: those of the environment variable
/// TAUTLINE_ENGINE_PATH, or else the program's own.
[[nodiscard]] std::vector<std::filesystem::path> engine_folders();

/// Which engines are asked what they are. A plug-in takes up to 0.1 s to load, an engine in a
/// process of its own a second to start; one that is not asked is called as its file is.
enum class Asked { none, plugins, all };

/// Every engine there is or could be: the exact control first, then the known ones in their order,
/// then others found, those with an engine.toml last. They are asked in worker processes.
[[nodiscard]] std::vector<RegisteredEngine> registered_engines(Asked asked);

/// True if its file is nothing that can be used here, and `failure` says why; false too for a
/// plug-in that is one and went wrong when it was asked.
[[nodiscard]] bool is_no_plugin(const RegisteredEngine& engine);

/// A choice among them, or every sentence of what is wrong with it.
struct EngineChoice {
  std::vector<RegisteredEngine> engines;
  std::vector<std::string> problems;
};

/// `wanted` are names, or paths of plug-ins (with a '/', or ending in .so or .toml); empty means
/// all that run in the program's own workers. The name of a folder means all engines with an
/// engine.toml in it. Names of which none can run are a problem.
[[nodiscard]] EngineChoice choose_engines(const std::vector<std::string>& wanted);

/// The models of `engines` among `wanted` (all if empty), as sentences where one is unknown to all.
[[nodiscard]] std::vector<std::string> unknown_models(const std::vector<RegisteredEngine>& engines,
                                                      const std::vector<std::string>& wanted);

}  // namespace tautline::bench
