#include "bench/run/plugin.hpp"

#include <dlfcn.h>
#include <fmt/format.h>

#include <array>
#include <cstddef>
#include <optional>
#include <string>
#include <utility>

#include "bench/base/text.hpp"
#include "bench/run/protocol/child_engine.hpp"
#include "tautline/plugin.hpp"

namespace tautline::bench {
namespace {

/// The parts of an interface text: each is a name and what stands behind it.
constexpr std::array part_names = {"tautline-engine ", "C++ ABI ", "std::string ABI ", "Eigen ",
                                   "alignment "};
enum TextPart : std::size_t { version, compiler, strings, eigen, alignment };
using TextParts = std::array<std::string, part_names.size()>;

/// None where `text` is not made of them.
std::optional<TextParts> text_parts_of(std::string_view text) {
  TextParts parts;
  for (std::size_t k = 0; k < parts.size(); ++k) {
    if (!text.starts_with(part_names[k])) {
      return std::nullopt;
    }
    text.remove_prefix(std::string_view(part_names[k]).size());
    const std::size_t end = k + 1 < parts.size() ? text.find(", ") : text.size();
    if (end == std::string_view::npos) {
      return std::nullopt;
    }
    parts[k] = text.substr(0, end);
    text.remove_prefix(end == text.size() ? end : end + 2);
  }
  return parts;
}

/// Clang says so whatever its version. It lays out what the interface holds as GCC does.
constexpr std::string_view abi_of_clang = "1002";

/// GCC's number is 1000 more than that of its option.
std::string abi_option(const std::string& abi) {
  return abi.size() == 4 && abi.front() == '1'
             ? fmt::format("-fabi-version={}", std::stoi(abi.substr(1)))
             : "the same -fabi-version";
}

std::string build_advice(const TextParts& theirs, const TextParts& ours) {
  if (theirs[version] != ours[version]) {
    return "rebuild it against this version's headers";
  }
  const bool by_clang = theirs[compiler] == abi_of_clang || ours[compiler] == abi_of_clang;
  if (theirs[compiler] != ours[compiler] && !by_clang) {
    return fmt::format("another version of GCC lays out classes otherwise; build it with {}",
                       abi_option(ours[compiler]));
  }
  if (theirs[strings] != ours[strings]) {
    return theirs[strings] == "0" || theirs[strings] == "1"
               ? fmt::format(
                     "its std::string is another; build it with -D_GLIBCXX_USE_CXX11_ABI={}",
                     ours[strings])
               : "its standard library is another; build it with -stdlib=libstdc++";
  }
  if (theirs[eigen] != ours[eigen]) {
    return fmt::format("build it against Eigen {}", ours[eigen]);
  }
  if (theirs[alignment] != ours[alignment]) {
    return fmt::format(
        "vector flags such as -mavx or -march=native change how Eigen aligns; keep them, and add "
        "-DEIGEN_MAX_STATIC_ALIGN_BYTES={}",
        ours[alignment]);
  }
  return "";
}

}  // namespace

std::string misfit(std::string_view theirs, std::string_view ours) {
  if (theirs == ours) {
    return "";
  }
  const auto of_theirs = text_parts_of(theirs);
  const auto of_ours = text_parts_of(ours);
  const std::string way = of_theirs && of_ours ? build_advice(*of_theirs, *of_ours)
                                               : "rebuild it against this version's headers";
  if (way.empty()) {
    return "";
  }
  return fmt::format(
      "built against another interface (\"{}\", here it is \"{}\"): {}. An engine in a process of "
      "its own needs none of this: see engines/protocol",
      theirs, ours, way);
}

namespace {

using InterfaceText = const char*();
using CreateEngine = Engine*();
using DestroyFunction = void(Engine*);

/// What the dynamic loader has to say about its latest failure.
std::string loader_message() {
  const char* message = ::dlerror();
  return message != nullptr ? message : "the dynamic loader gives no reason";
}

/// Why `file` cannot be a library, as far as the file system tells; empty if it can.
std::string problem_of(const std::filesystem::path& file) {
  std::error_code error;
  const std::filesystem::file_status status = std::filesystem::status(file, error);
  if (status.type() == std::filesystem::file_type::regular) {
    return "";
  }
  if (status.type() == std::filesystem::file_type::directory) {
    return "is a directory";
  }
  if (status.type() == std::filesystem::file_type::not_found) {
    return "no such file";
  }
  return error ? "cannot be looked at: " + error.message() : "is no regular file";
}

/// The function `name` of the plug-in `file`.
template <class Function>
Function* function(void* library, const char* name, const std::string& file) {
  void* const symbol = ::dlsym(library, name);
  if (symbol == nullptr) {
    throw PluginError(file + ": not a tautline plug-in: it does not export " + name +
                      "; put TAUTLINE_PLUGIN(YourEngine) in one of its sources");
  }
  return reinterpret_cast<Function*>(symbol);
}

/// Refuses a plug-in whose types may be laid out otherwise than ours. Nothing else of the plug-in
/// may be called before this.
void check_interface(const std::string& theirs, const std::string& file) {
  if (const std::string problem = misfit(theirs, TAUTLINE_INTERFACE); !problem.empty()) {
    throw PluginError(file + ": " + problem);
  }
}

/// The engine of an engine.toml.
std::unique_ptr<ChildEngine> open_in_process(const std::filesystem::path& file,
                                             std::size_t memory) {
  const EngineFile engine = read_engine_file(file);
  if (!engine.problems.empty()) {
    throw PluginError(joined(engine.problems, "and"));
  }
  if (const std::string reason = missing(engine); !reason.empty()) {
    throw PluginError(file.string() + ": engine " + engine.name + " is not here: " + reason);
  }
  return ChildEngine::open(engine, memory);
}

}  // namespace

void Plugin::CloseLibrary::operator()(void* handle) const { ::dlclose(handle); }

Plugin::Plugin(Library library, OwnedEngine engine)
    : library_(std::move(library)), engine_(std::move(engine)) {}

Plugin::Plugin(std::unique_ptr<ChildEngine> engine)
    : engine_(engine.get(), DestroyEngine{[](Engine* made) { delete made; }}),
      child_(engine.release()) {}

Meter Plugin::meter() const {
  if (child_ == nullptr) {
    return own_meter();
  }
  // the event driver, which is part of such a model, computes here
  return {[child = child_, own = own_meter()] {
            return own.processor_time() + child->processor_time();
          },
          [child = child_] { return child->peak_memory(); }};
}

void Plugin::forget_peak_memory() const {
  if (child_ != nullptr) {
    child_->forget_peak_memory();
  }
}

Plugin Plugin::open(const std::filesystem::path& file, std::size_t memory) {
  if (is_engine_file(file)) {
    return Plugin(open_in_process(file, memory));
  }
  const std::string name = file.string();
  if (const std::string problem = problem_of(file); !problem.empty()) {
    throw PluginError(name + ": " + problem +
                      "; give the path of a plug-in (.so) or of an engine.toml");
  }
  // a path without a slash would be looked up in the system's library folders
  const std::string path = std::filesystem::absolute(file).string();
  // never unloaded: an exception of the plug-in's own types may still be in flight when its Plugin
  // goes, and an engine's static destructors must not run before the reply is written
  Library library(::dlopen(path.c_str(), RTLD_NOW | RTLD_LOCAL | RTLD_NODELETE));
  if (!library) {
    throw PluginError(name + ": not a shared library that can be loaded: " + loader_message());
  }
  auto* const interface_text =
      function<InterfaceText>(library.get(), "tautline_plugin_interface", name);
  check_interface(interface_text(), name);
  auto* const create = function<CreateEngine>(library.get(), "tautline_plugin_create", name);
  auto* const destroy = function<DestroyFunction>(library.get(), "tautline_plugin_destroy", name);
  OwnedEngine engine(create(), DestroyEngine{destroy});
  return {std::move(library), std::move(engine)};
}

}  // namespace tautline::bench
