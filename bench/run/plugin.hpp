#pragma once

#include <cstddef>
#include <filesystem>
#include <memory>
#include <stdexcept>
#include <string>
#include <string_view>

#include "bench/run/cost.hpp"
#include "tautline/engine.hpp"

namespace tautline::bench {

class ChildEngine;

/// Why a file is not a plug-in that can be used here, in one sentence that names the file.
class PluginError : public std::runtime_error {
 public:
  using std::runtime_error::runtime_error;
};

/// What a process may hold in memory unless told otherwise [bytes].
inline constexpr std::size_t usual_memory = std::size_t{2} << 30U;

/// A loaded plug-in and its engine. Everything made by the engine must be gone before it.
class Plugin {
 public:
  /// Loads `file` with its symbols kept to itself; an engine.toml starts the engine's own process,
  /// which may hold `memory` [bytes]. Throws PluginError if there is no such file, if it is not a
  /// shared library or not a plug-in, or if it was built against another interface; and
  /// std::runtime_error for an engine in another process that does not say who it is.
  [[nodiscard]] static Plugin open(const std::filesystem::path& file,
                                   std::size_t memory = usual_memory);

  [[nodiscard]] const Engine& engine() const { return *engine_; }

  /// True if the engine computes in a process of its own.
  [[nodiscard]] bool has_a_process() const { return child_ != nullptr; }

  /// Measures what the engine uses, in the process where it computes.
  [[nodiscard]] Meter meter() const;

  /// From here on the meter's memory is the most that is held from here on, where an earlier run
  /// may have held more: in an engine's own process.
  void forget_peak_memory() const;

 private:
  struct CloseLibrary {
    void operator()(void* handle) const;
  };
  struct DestroyEngine {
    void (*destroy)(Engine*);
    void operator()(Engine* engine) const { destroy(engine); }
  };

  using Library = std::unique_ptr<void, CloseLibrary>;
  using OwnedEngine = std::unique_ptr<Engine, DestroyEngine>;

  Plugin(Library library, OwnedEngine engine);
  explicit Plugin(std::unique_ptr<ChildEngine> engine);

  Library library_;  // before engine_, whose code it holds
  OwnedEngine engine_;
  const ChildEngine* child_ = nullptr;  // the engine, where it has a process of its own
};

/// Why a plug-in whose interface text is `theirs` cannot be loaded by a program whose text is
/// `ours` (TAUTLINE_INTERFACE of plugin.hpp), and how to build one that can; empty if it can be.
[[nodiscard]] std::string misfit(std::string_view theirs, std::string_view ours);

}  // namespace tautline::bench
