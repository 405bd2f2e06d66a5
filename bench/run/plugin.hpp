#pragma once

#include <filesystem>
#include <memory>
#include <stdexcept>

#include "tautline/engine.hpp"

namespace tautline::bench {

/// Why a file is not a plug-in that can be used here, in one sentence that names the file.
class PluginError : public std::runtime_error {
 public:
  using std::runtime_error::runtime_error;
};

/// A loaded plug-in and its engine. Everything made by the engine must be gone before it.
class Plugin {
 public:
  /// Loads `file` with its symbols kept to itself. Throws PluginError if there is no such file, if
  /// it is not a shared library or not a plug-in, or if it was built against another interface.
  [[nodiscard]] static Plugin open(const std::filesystem::path& file);

  [[nodiscard]] const Engine& engine() const { return *engine_; }

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

  Library library_;  // before engine_, whose code it holds
  OwnedEngine engine_;
};

}  // namespace tautline::bench
