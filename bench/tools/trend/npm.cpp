#include "bench/tools/trend/versions.hpp"

#include <fcntl.h>
#include <sys/file.h>

#include <fmt/format.h>

#include <algorithm>
#include <cerrno>
#include <chrono>
#include <cstdlib>
#include <system_error>
#include <thread>
#include <utility>
#include <vector>

#include "bench/base/atomic_file.hpp"
#include "bench/base/descriptor.hpp"
#include "bench/base/input_file.hpp"
#include "bench/base/process.hpp"
#include "bench/base/text.hpp"
#include "bench/data/writer.hpp"

namespace tautline::bench {

namespace {

namespace fs = std::filesystem;

constexpr double question_limit = 120.0;  // [s]: a registry that does not answer
constexpr double install_limit = 600.0;   // [s]: tens of megabytes on a slow line

/// npm writes JSON to its standard output, which goes where this program reads results; the words
/// next to it are on standard error.
constexpr const char* in_folder = "cd \"$1\" && shift && exec \"$@\" >&3";

/// A shell's exit code for a command that is not there.
constexpr int not_found = 127;

/// What npm answered, or why it did not.
struct NpmAnswer {
  Json json;
  std::string problem;
};

/// The last line of what npm said that is not empty.
std::string last_line(const std::string& text) {
  const std::size_t end = text.find_last_not_of("\n ");
  if (end == std::string::npos) {
    return "it says nothing";
  }
  const std::size_t start = text.find_last_of('\n', end);
  return text.substr(start == std::string::npos ? 0 : start + 1,
                     end - (start == std::string::npos ? 0 : start + 1) + 1);
}

/// Why npm failed, in its own words: its JSON has them, or else its output.
std::string failure_of(const ProcessEnd& end, const Json& json, double limit) {
  if (end.kind == ProcessEnd::Kind::interrupted) {
    return "interrupted";
  }
  if (end.kind == ProcessEnd::Kind::timed_out) {
    return fmt::format("npm took longer than {:g} s", limit);
  }
  if (end.kind == ProcessEnd::Kind::exited && end.code == not_found) {
    return "npm is not on PATH; it comes with node";
  }
  if (json.is_object() && json.contains("error") && json["error"].is_object()) {
    if (const std::string words = json["error"].value("summary", ""); !words.empty()) {
      return "npm: " + printable(words);
    }
  }
  return "npm: " + printable(last_line(end.output_tail));
}

NpmAnswer ask_npm(const fs::path& folder, const std::vector<std::string>& words, double limit) {
  std::vector<std::string> arguments = {"/bin/sh", "-c", in_folder, "sh", folder.string(), "npm"};
  arguments.insert(arguments.end(), words.begin(), words.end());
  const Descriptor output = memory_file();
  const Descriptor nothing = memory_file();
  const Descriptor no_turn;  // it serves one question and ends
  const ProcessEnd end = Process(arguments, nothing, output, nothing).wait(no_turn, limit);
  NpmAnswer answer{Json::parse(content_of(output), nullptr, false), ""};
  if (end.kind != ProcessEnd::Kind::exited || end.code != 0) {
    answer.problem = failure_of(end, answer.json, limit);
  }
  return answer;
}

/// One that npm has may be named without a list.
std::vector<std::string> texts_of(const Json& json) {
  std::vector<std::string> texts;
  for (const Json& one : json.is_array() ? json : Json::array({json})) {
    if (one.is_string()) {
      texts.push_back(one.get<std::string>());
    }
  }
  return texts;
}

constexpr const char* packages = "node_modules";
constexpr std::size_t longest_text = std::size_t{16} << 20U;  // [bytes], of a lock file
constexpr std::size_t longest_file = std::size_t{1} << 30U;   // [bytes], of an engine's folder

/// The lowest folder that holds `folder` and all that it shares.
fs::path common_folder(const fs::path& folder, const std::vector<std::string>& shares) {
  fs::path common = folder;
  for (const std::string& shared : shares) {
    const fs::path other = (folder / shared).lexically_normal().parent_path();
    const auto [end, unused] =
        std::mismatch(common.begin(), common.end(), other.begin(), other.end());
    fs::path both;
    std::for_each(common.begin(), end, [&](const fs::path& part) { both /= part; });
    common = both;
  }
  return common;
}

/// True for what npm writes into a folder that it installs to.
bool is_npms(const fs::path& name) {
  return name == packages || name == "package.json" || name == "package-lock.json";
}

/// Copies a file, or a folder with all that is in it. Another program may be running the copy that
/// is there: it reads the old file or the new, never a part of it.
void copy_whole(const fs::path& from, const fs::path& to) {
  if (fs::is_directory(from)) {
    fs::create_directories(to);
    for (const fs::directory_entry& entry : fs::directory_iterator(from)) {
      copy_whole(entry.path(), to / entry.path().filename());
    }
    return;
  }
  write_file(to, read_input_file(from, longest_file).content);
  fs::permissions(to, fs::status(from).permissions());
}

/// Copies what the engine's folder has; what npm makes of its own only into a `bare` copy.
void copy_files(const fs::path& from, const fs::path& to, bool bare) {
  for (const fs::directory_entry& entry : fs::directory_iterator(from)) {
    const fs::path name = entry.path().filename();
    if (name == packages || (is_npms(name) && !bare)) {
      continue;
    }
    copy_whole(entry.path(), to / name);
  }
}

/// Waits until no other program makes this copy, and keeps others from it until it is closed. Has
/// no number if this program was told to stop.
Descriptor lock(const fs::path& root) {
  using namespace std::chrono_literals;
  fs::create_directories(root.parent_path());
  const std::string name = root.string() + ".lock";
  Descriptor file(::open(name.c_str(), O_RDWR | O_CREAT | O_CLOEXEC, 0666));
  while (file.get() < 0 || ::flock(file.get(), LOCK_EX | LOCK_NB) != 0) {
    if (file.get() < 0 || errno != EWOULDBLOCK) {
      throw fs::filesystem_error("cannot lock", name,
                                 std::error_code(errno, std::generic_category()));
    }
    if (interruption()) {
      return Descriptor();
    }
    std::this_thread::sleep_for(50ms);  // npm takes seconds
  }
  return file;
}

void link(const fs::path& target, const fs::path& name) {
  fs::create_directories(name.parent_path());
  fs::remove(name);
  fs::create_directory_symlink(target, name);
}

/// What the copy was installed from: another package.json or lock file is another installation.
std::string origin(const EngineFile& engine, const fs::path& folder, const std::string& version) {
  return engine.package + "@" + version + "\n" +
         read_input_file(folder / "package.json", longest_text).content +
         read_input_file(folder / "package-lock.json", longest_text).content;
}

}  // namespace

NpmVersions versions_in(const std::string& package, const std::string& range) {
  std::vector<std::string> words = {"view", package + "@" + range, "version", "--json",
                                    "--fetch-retries=0"};
  const fs::path anywhere = "/";
  NpmAnswer answer = ask_npm(anywhere, words, question_limit);
  if (!answer.problem.empty() && !interruption()) {
    words.emplace_back("--offline");
    if (NpmAnswer kept = ask_npm(anywhere, words, question_limit); kept.problem.empty()) {
      answer = std::move(kept);
    }
  }
  NpmVersions result{{}, answer.problem};
  if (result.problem.empty()) {
    result.versions = texts_of(answer.json);
    std::sort(result.versions.begin(), result.versions.end(), is_older);
  }
  if (result.problem.empty() && result.versions.empty()) {
    result.problem = "npm names no version";
  }
  return result;
}

std::string install_version(const fs::path& folder, const std::string& package,
                            const std::string& version) {
  return ask_npm(folder,
                 {"install", "--save-exact", "--ignore-scripts", "--no-audit", "--no-fund",
                  "--prefer-offline", "--json", package + "@" + version},
                 install_limit)
      .problem;
}

fs::path version_cache() {
  const auto variable = [](const char* name) {
    const char* const value = std::getenv(name);
    return fs::path(value != nullptr ? value : "");
  };
  const fs::path given = variable("XDG_CACHE_HOME");
  // the specification ignores one that is not absolute
  const fs::path base = given.is_absolute() ? given : variable("HOME") / ".cache";
  return fs::absolute(base) / "tautline" / "npm";
}

PinnedEngine pinned_engine(const EngineFile& engine, const std::string& version,
                           const fs::path& cache) {
  const fs::path source = fs::canonical(engine.path.parent_path());
  const fs::path common = common_folder(source, engine.shares);
  const fs::path root = cache / engine.name / version;
  const fs::path folder = (root / source.lexically_relative(common)).lexically_normal();
  const Descriptor locked = lock(root);
  if (locked.get() < 0) {
    return {folder / engine.path.filename(), "interrupted"};
  }
  const fs::path mark = root / "installed.txt";
  const std::string wanted = origin(engine, source, version);
  const bool kept = read_input_file(mark, longest_text).content == wanted &&
                    fs::exists(folder / engine.installed);
  if (!kept) {
    fs::remove_all(root);
  }
  copy_files(source, folder, !kept);
  for (const std::string& shared : engine.shares) {
    const fs::path target = (source / shared).lexically_normal();
    link(target, root / target.lexically_relative(common));
  }
  PinnedEngine result{folder / engine.path.filename(), ""};
  if (!kept) {
    result.problem = install_version(folder, engine.package, version);
    if (result.problem.empty()) {
      write_file(mark, wanted);
    }
  }
  return result;
}

}  // namespace tautline::bench
