#include "bench/run/protocol/engine_file.hpp"

#include <fmt/format.h>
#include <unistd.h>

#include <algorithm>
#include <cstdlib>
#include <string_view>
#include <system_error>

#include "bench/base/input_file.hpp"
#include "bench/base/problems.hpp"
#include "bench/base/strict_table.hpp"
#include "bench/base/text.hpp"
#include "bench/base/value.hpp"

namespace tautline::bench {
namespace {

namespace fs = std::filesystem;

constexpr std::size_t longest_engine_file = std::size_t{64} << 10U;  // [bytes]

/// A path in the folder, as a key gives it.
std::string path_inside(StrictTable& table, const Key& key) {
  std::string path = table.optional_text(key).value_or("");
  if (fs::path(path).is_absolute()) {
    table.refuse_value(key.name, "must be relative to the folder of this file");
  }
  return path;
}

void read_tables(StrictTable root, EngineFile& result) {
  result.name = root.text({"name", "the engine's name: small letters, digits and hyphens"});
  if (result.name.find_first_not_of("abcdefghijklmnopqrstuvwxyz0123456789-") != std::string::npos) {
    root.refuse_value("name", "must be small letters, digits and hyphens");
  }
  result.command =
      root.texts({"command", "the words of the command that starts it, run in this folder"},
                 "must be the words of a command, such as [\"node\", \"engine.mjs\"]");
  result.package =
      root.optional_text({"package", "the package that the lock file pins"}).value_or("");
  result.lock = path_inside(root, {"lock", "the lock file, in this folder"});
  result.installed =
      path_inside(root, {"installed", "a path in this folder: without it the engine is not here"});
  result.bring =
      root.optional_text({"bring", "the command that installs what is missing"}).value_or("");
  result.versions =
      root.optional_text({"versions", "of the package, those that this engine is made for: >=0.15"})
          .value_or("");
  const std::string right = "must be folders next to this one, such as [\"../common\"]";
  result.shares =
      root.optional_texts({"shares", "folders next to this one that it loads from"}, right)
          .value_or(std::vector<std::string>());
  if (!std::all_of(result.shares.begin(), result.shares.end(),
                   [](const std::string& path) { return path.starts_with("../"); })) {
    root.refuse_value("shares", right);
  }
  root.refuse_unknown_keys();
}

bool can_be_run(const fs::path& file) {
  std::error_code error;
  return fs::is_regular_file(file, error) && ::access(file.c_str(), X_OK) == 0;
}

bool is_on_path(const std::string& word) {
  const char* const list = std::getenv("PATH");
  const std::vector<fs::path> folders = folders_of(list != nullptr ? list : "/usr/bin:/bin");
  return std::any_of(folders.begin(), folders.end(),
                     [&](const fs::path& folder) { return can_be_run(folder / word); });
}

}  // namespace

Form engine_form() {
  Form form;
  EngineFile nothing;
  read_tables(StrictTable(form), nothing);
  return form;
}

std::vector<fs::path> folders_of(std::string_view list) {
  std::vector<fs::path> folders;
  while (!list.empty()) {
    const std::size_t colon = std::min(list.find(':'), list.size());
    folders.emplace_back(list.substr(0, colon));
    list.remove_prefix(std::min(colon + 1, list.size()));
  }
  return folders;
}

EngineFile read_engine_file(const fs::path& file) {
  EngineFile result;
  result.path = fs::absolute(file);
  FileProblems wrong(result.path.string());
  const InputFile input = read_input_file(file, longest_engine_file);
  if (input.problem) {
    wrong.add(0, *input.problem);
  } else if (const auto table = parse_toml(input.content, wrong)) {
    read_tables(StrictTable(&*table, "", wrong), result);
  }
  result.problems = wrong.sentences();
  return result;
}

std::string missing(const EngineFile& engine) {
  const fs::path folder = engine.path.parent_path();
  const std::string& program = engine.command.front();
  if (program.find('/') == std::string::npos && !is_on_path(program)) {
    return printable(program) + " is not on PATH";
  }
  const std::string advice =
      engine.bring.empty() ? "" : fmt::format("; run {} in {}", engine.bring, folder.string());
  if (program.find('/') != std::string::npos && !can_be_run(folder / program)) {
    return fmt::format("{} cannot be run{}", printable(program), advice);
  }
  std::error_code error;
  if (!engine.installed.empty() && !fs::exists(folder / engine.installed, error)) {
    return fmt::format("{} is not installed{}", printable(engine.installed), advice);
  }
  return "";
}

std::vector<fs::path> named_files(const fs::path& file) {
  const EngineFile engine = read_engine_file(file);
  std::vector<fs::path> found = {file};
  std::vector<std::string> words = engine.command;
  words.push_back(engine.lock);
  std::error_code error;
  for (const std::string& word : words) {
    const fs::path named = file.parent_path() / word;
    if (!word.empty() && fs::is_regular_file(named, error)) {
      found.push_back(named);
    }
  }
  for (const std::string& shared : engine.shares) {
    for (const auto& entry : fs::directory_iterator(file.parent_path() / shared, error)) {
      if (entry.is_regular_file(error)) {
        found.push_back(entry.path());
      }
    }
  }
  std::sort(found.begin(), found.end());  // a folder lists its files in any order
  return found;
}

bool is_engine_file(const fs::path& file) { return file.extension() == ".toml"; }

std::vector<fs::path> engine_files_in(const fs::path& folder) {
  constexpr const char* usual_name = "engine.toml";
  std::vector<fs::path> found;
  std::error_code error;
  for (const auto& entry : fs::directory_iterator(folder, error)) {
    if (!entry.is_directory(error)) {
      continue;
    }
    if (const fs::path file = entry.path() / usual_name; fs::exists(file, error)) {
      found.push_back(file);
      continue;
    }
    for (const auto& inner : fs::directory_iterator(entry.path(), error)) {
      if (const fs::path file = inner.path() / usual_name; fs::exists(file, error)) {
        found.push_back(file);
      }
    }
  }
  std::sort(found.begin(), found.end());
  return found;
}

}  // namespace tautline::bench
