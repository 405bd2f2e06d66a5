#include "bench/run/registry.hpp"

#include <fmt/format.h>
#include <algorithm>
#include <atomic>
#include <cstdlib>
#include <functional>
#include <future>
#include <iterator>
#include <set>
#include <string_view>
#include <system_error>
#include <thread>

#include "bench/base/listed.hpp"
#include "bench/base/text.hpp"
#include "bench/run/protocol/engine_file.hpp"
#include "bench/run/worker.hpp"

namespace tautline::bench {
namespace {

namespace fs = std::filesystem;

/// One engine of this source tree: how it was configured when the program was built.
struct KnownEngine {
  std::string_view name;
  std::string_view package;
  std::string_view missing;  // empty if it was built
};

constexpr KnownEngine known_engines[] = {
#include "known_engines.inc"
};

constexpr std::string_view prefix = "tautline-engine-";

fs::path program_folder() {
  std::error_code error;
  return fs::read_symlink("/proc/self/exe", error).parent_path();
}

/// Asks an engine what it is, unless that is known, or that it cannot answer.
void ask(RegisteredEngine& engine) {
  if (engine.info || !engine.missing.empty() || !engine.failure.empty()) {
    return;
  }
  DescribeReply reply = describe_in_worker(engine.plugin);
  engine.info = std::move(reply.info);
  engine.failure = std::move(reply.failure);
  if (engine.info) {
    engine.name = engine.info->name;
  }
}

/// The same for all of them, on all cores: some take a second to start.
void ask_all(std::vector<RegisteredEngine>& engines) {
  std::atomic<std::size_t> next = 0;
  const auto work = [&] {
    for (std::size_t index = next++; index < engines.size(); index = next++) {
      ask(engines[index]);
    }
  };
  std::vector<std::future<void>> others;
  for (unsigned count = 1; count < std::thread::hardware_concurrency(); ++count) {
    others.push_back(std::async(std::launch::async, work));
  }
  work();
  for (std::future<void>& other : others) {
    other.get();
  }
}

RegisteredEngine from_plugin(const fs::path& plugin) {
  RegisteredEngine engine;
  engine.plugin = plugin;
  engine.name = plugin.stem().string();
  if (engine.name.starts_with(prefix)) {
    engine.name.erase(0, prefix.size());
  }
  return engine;
}

/// What an engine.toml says of its engine, which is not asked.
RegisteredEngine from_engine_file(const fs::path& path) {
  const EngineFile file = read_engine_file(path);
  RegisteredEngine engine;
  engine.plugin = file.path;
  if (!file.problems.empty()) {
    engine.name = file.path.parent_path().filename().string();
    const std::size_t more = file.problems.size() - 1;
    engine.failure = file.problems.front() + (more > 0 ? fmt::format(" (and {} more)", more) : "");
    return engine;
  }
  engine.name = file.name;
  engine.missing = missing(file);
  return engine;
}

/// True for an engine with an engine.toml.
bool is_outside(const RegisteredEngine& engine) { return is_engine_file(engine.plugin); }

/// The folder that holds the engine's: its name means all engines in it.
std::string group_of(const RegisteredEngine& engine) {
  return is_outside(engine) ? engine.plugin.parent_path().parent_path().filename().string() : "";
}

std::vector<fs::path> plugins_in(const fs::path& folder) {
  std::vector<fs::path> found;
  std::error_code error;
  for (const auto& entry : fs::directory_iterator(folder, error)) {
    const std::string name = entry.path().filename().string();
    if (name.starts_with(prefix) && name.ends_with(".so")) {
      found.push_back(entry.path());
    }
  }
  std::sort(found.begin(), found.end());
  return found;
}

bool is_path(const std::string& wanted) {
  return wanted.find('/') != std::string::npos || wanted.ends_with(".so") ||
         wanted.ends_with(".toml");
}

/// The known engines in their order, each with what was found of it; then the rest of `found`.
std::vector<RegisteredEngine> in_known_order(std::vector<RegisteredEngine> found) {
  std::vector<RegisteredEngine> result;
  for (const KnownEngine& known : known_engines) {
    const auto here = std::find_if(found.begin(), found.end(),
                                   [&](const auto& engine) { return engine.name == known.name; });
    if (here != found.end()) {
      result.push_back(std::move(*here));
      found.erase(here);
    } else {
      RegisteredEngine engine;
      engine.name = known.name;
      engine.missing =
          known.missing.empty()
              ? fmt::format("its plug-in, {}{}, is not in the engine folder", prefix, known.name)
              : std::string(known.missing);
      result.push_back(std::move(engine));
    }
    // a package helps where one was missed; a plug-in that was built and is gone it does not bring
    result.back().package = known.missing.empty() ? "" : known.package;
  }
  std::move(found.begin(), found.end(), std::back_inserter(result));
  return result;
}

std::string unknown_name(std::string_view what, const std::string& name,
                         const std::vector<std::string>& known) {
  const std::string near = suggestion(name, known);
  return fmt::format("unknown {} {}{}", what, printable(name),
                     near.empty() ? "; known: " + joined(known, "and") : near);
}

std::string missing_sentence(const RegisteredEngine& engine) {
  std::string sentence = fmt::format("engine {} is not here: {}", engine.name, engine.missing);
  return engine.package.empty() ? sentence
                                : sentence + fmt::format(" (package {} brings it)", engine.package);
}

/// Adds the engine that is called `want` among `all`, or lies there, or those of the folder `want`.
void choose(const std::string& want, const std::vector<RegisteredEngine>& all,
            EngineChoice& choice) {
  if (is_path(want)) {
    const fs::path path = fs::absolute(want);
    if (!is_engine_file(path)) {
      choice.engines.push_back(from_plugin(path));
      return;
    }
    choice.engines.push_back(from_engine_file(path));
    for (std::string& sentence : read_engine_file(path).problems) {
      choice.problems.push_back(std::move(sentence));
    }
    if (!choice.engines.back().missing.empty()) {
      choice.problems.push_back(missing_sentence(choice.engines.back()));
    }
    return;
  }
  const auto here =
      std::find_if(all.begin(), all.end(), [&](const auto& engine) { return engine.name == want; });
  if (here != all.end()) {
    if (!here->missing.empty()) {
      choice.problems.push_back(missing_sentence(*here));
    }
    choice.engines.push_back(*here);
    return;
  }
  bool any = false;
  for (const RegisteredEngine& engine : all) {
    if (group_of(engine) == want) {
      any = true;
      choice.engines.push_back(engine);
    }
  }
  if (!any) {
    choice.problems.push_back(unknown_name("engine", want, listed(all, &RegisteredEngine::name)));
  }
}

/// Without an engine that could run at all there is nothing to compare.
void refuse_if_none_is_usable(EngineChoice& choice) {
  const auto unusable = [](const RegisteredEngine& engine) {
    return !engine.missing.empty() || is_no_plugin(engine);
  };
  if (!choice.problems.empty() ||
      !std::all_of(choice.engines.begin(), choice.engines.end(), unusable)) {
    return;
  }
  for (const RegisteredEngine& engine : choice.engines) {
    choice.problems.push_back(engine.missing.empty() ? printable(engine.failure, 1000)
                                                     : missing_sentence(engine));
  }
}

}  // namespace

std::vector<fs::path> engine_folders() {
  if (const char* given = std::getenv("TAUTLINE_ENGINE_PATH"); given != nullptr) {
    return folders_of(given);
  }
  // in the build tree, and where it is installed: both relative to the program
  return {(program_folder() / "../engines/modules").lexically_normal(),
          (program_folder() / TAUTLINE_INSTALLED_ENGINES).lexically_normal()};
}

std::vector<RegisteredEngine> registered_engines(Asked asked) {
  std::vector<RegisteredEngine> found;
  for (const fs::path& folder : engine_folders()) {
    for (const fs::path& plugin : plugins_in(folder)) {
      found.push_back(from_plugin(plugin));
    }
  }
  if (asked != Asked::none) {
    ask_all(found);
  }
  std::vector<RegisteredEngine> result = in_known_order(std::move(found));
  for (const fs::path& folder : engine_folders()) {
    for (const fs::path& file : engine_files_in(folder)) {
      result.push_back(from_engine_file(file));
    }
  }
  if (asked == Asked::all) {
    ask_all(result);
  }
  return result;
}

bool is_no_plugin(const RegisteredEngine& engine) {
  return !engine.plugin.empty() && engine.failure.starts_with(engine.plugin.string());
}

EngineChoice choose_engines(const std::vector<std::string>& wanted) {
  EngineChoice choice;
  const bool named = std::any_of(wanted.begin(), wanted.end(), std::not_fn(is_path));
  std::vector<RegisteredEngine> all;
  if (wanted.empty() || named) {
    all = registered_engines(Asked::plugins);
  }
  if (wanted.empty()) {
    std::erase_if(all, is_outside);
    choice.engines = std::move(all);
    return choice;
  }
  for (const std::string& want : wanted) {
    choose(want, all, choice);
  }
  ask_all(choice.engines);
  refuse_if_none_is_usable(choice);
  std::set<std::string> seen;
  for (const RegisteredEngine& engine : choice.engines) {
    if (!seen.insert(engine.name).second) {
      choice.problems.push_back(fmt::format("engine {} is given twice", engine.name));
    }
  }
  return choice;
}

std::vector<std::string> unknown_models(const std::vector<RegisteredEngine>& engines,
                                        const std::vector<std::string>& wanted) {
  std::set<std::string> known;
  for (const RegisteredEngine& engine : engines) {
    if (engine.info) {
      for (const Model& model : engine.info->models) {
        known.insert(model.name);
      }
    }
  }
  std::vector<std::string> problems;
  for (const std::string& want : wanted) {
    if (!known.contains(want)) {
      problems.push_back(unknown_name("model", want, {known.begin(), known.end()}));
    }
  }
  return problems;
}

}  // namespace tautline::bench
