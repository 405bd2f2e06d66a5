#include "bench/run/versions/npm.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <utility>

#include "bench/base/descriptor.hpp"
#include "bench/base/process.hpp"
#include "bench/base/text.hpp"
#include "bench/run/protocol/json.hpp"
#include "bench/run/versions/version_request.hpp"

namespace tautline::bench {
namespace {

namespace fs = std::filesystem;

constexpr double question_limit = 120.0;  // [s]: a registry that does not answer
constexpr double install_limit = 600.0;   // [s]: tens of megabytes on a slow line

/// npm writes JSON to its standard output, which goes where this program reads results; the words
/// beside it are on standard error.
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

}  // namespace tautline::bench
