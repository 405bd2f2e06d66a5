#pragma once

#include <filesystem>
#include <string>
#include <string_view>
#include <vector>

namespace tautline::bench {

struct Form;

/// What an engine.toml says: how to start an engine in a process of its own.
struct EngineFile {
  std::filesystem::path path;        // the file itself, absolute
  std::string name;                  // [a-z0-9-]+
  std::vector<std::string> command;  // run in the file's folder; the first word is looked up
  std::string package;               // what the lock file pins; may be empty, as all below
  std::string lock;                  // in the folder
  std::string installed;             // in the folder: without it the engine is not here
  std::string bring;                 // the command that brings it
  std::string versions;              // of `package`, those that the engine is made for: ">=0.15"
  std::vector<std::string> shares;   // folders next to it that it loads from: "../common"
  std::vector<std::string>
      problems;  // of the file, in sentences; the rest is void if there are any
};

/// The folders of a list like PATH, with colons between them.
[[nodiscard]] std::vector<std::filesystem::path> folders_of(std::string_view list);

/// Reads it; what is wrong with it becomes `problems`.
[[nodiscard]] EngineFile read_engine_file(const std::filesystem::path& file);

/// The keys of such a file.
[[nodiscard]] Form engine_form();

/// Why the engine cannot be started here, and what would bring it: a command that is not on PATH,
/// or what is not installed. Empty if it can. Requires a file without problems; starts nothing.
[[nodiscard]] std::string missing(const EngineFile& engine);

/// The files that decide what the engine does, as far as its file names them: the file itself, what
/// it is locked to, the words of its command that are files, and the files in the folders that it
/// shares. What these load from elsewhere is not known.
[[nodiscard]] std::vector<std::filesystem::path> named_files(const std::filesystem::path& file);

/// True for the name that such a file has.
[[nodiscard]] bool is_engine_file(const std::filesystem::path& file);

/// The engine files one or two folders below `folder`, in their order.
[[nodiscard]] std::vector<std::filesystem::path> engine_files_in(
    const std::filesystem::path& folder);

}  // namespace tautline::bench
