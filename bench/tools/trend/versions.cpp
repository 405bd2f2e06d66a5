#include "bench/tools/trend/versions.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <charconv>
#include <filesystem>
#include <string_view>
#include <tuple>

#include "bench/base/text.hpp"
#include "bench/run/registry.hpp"

namespace tautline::bench {

namespace {

/// Major, minor and patch, and what is after a hyphen: without it a version is the newer one.
struct VersionParts {
  std::array<unsigned long, 3> numbers{};
  std::string_view pre;
};

VersionParts parts_of(std::string_view version) {
  VersionParts parts;
  const char* at = version.data();
  const char* const end = at + version.size();
  for (unsigned long& number : parts.numbers) {
    at = std::from_chars(at, end, number).ptr;
    if (at == end || *at != '.') {
      break;
    }
    ++at;
  }
  const std::string_view rest(at, static_cast<std::size_t>(end - at));
  parts.pre = rest.starts_with('-') ? rest.substr(1) : std::string_view();
  return parts;
}

/// What npm reads for `FROM..TO`; either may be missing.
std::string npm_range(const std::string& range) {
  const std::size_t dots = range.find("..");
  if (dots == std::string::npos) {
    return range;
  }
  const std::string from = range.substr(0, dots);
  const std::string to = range.substr(dots + 2);
  return (from.empty() ? "" : ">=" + from) + (from.empty() || to.empty() ? "" : " ") +
         (to.empty() ? "" : "<=" + to);
}

namespace fs = std::filesystem;

/// The engine that is called so, or whose engine.toml it is; with a sentence where there is none.
EngineFile find_engine(const std::string& name) {
  if (is_engine_file(name)) {
    return read_engine_file(name);
  }
  std::vector<std::string> names;
  for (const fs::path& folder : engine_folders()) {
    for (const fs::path& file : engine_files_in(folder)) {
      EngineFile engine = read_engine_file(file);
      if (engine.problems.empty() && engine.name == name) {
        return engine;
      }
      names.push_back(engine.name);
    }
  }
  EngineFile none;
  const std::string near = suggestion(name, names);
  none.problems.push_back(
      fmt::format("{}: no engine with an engine.toml has this name{}", printable(name),
                  !near.empty() || names.empty() ? near : "; known: " + joined(names, "and")));
  return none;
}

/// Why npm cannot bring versions of it, or "".
std::string unfit(const EngineFile& engine) {
  std::error_code error;
  if (engine.package.empty()) {
    return "its engine.toml names no package";
  }
  if (!fs::exists(engine.path.parent_path() / "package.json", error)) {
    return "npm does not install it: there is no package.json next to its engine.toml";
  }
  EngineFile before_install = engine;
  before_install.installed.clear();
  return missing(before_install);
}

}  // namespace

VersionRequest version_request(const std::string& text) {
  const std::size_t at = text.rfind('@');
  VersionRequest request;
  request.engine = text.substr(0, at);
  if (at != std::string::npos) {
    request.range = npm_range(text.substr(at + 1));
  }
  if (request.engine.empty() || (at != std::string::npos && request.range.empty())) {
    request.problem = fmt::format("{}: must be an engine and its versions, such as planck@1.0..1.4",
                                  printable(text));
  }
  return request;
}

bool is_older(const std::string& one, const std::string& other) {
  const VersionParts left = parts_of(one);
  const VersionParts right = parts_of(other);
  return std::tuple(left.numbers, left.pre.empty(), left.pre) <
         std::tuple(right.numbers, right.pre.empty(), right.pre);
}

std::vector<std::string> newest_of_each_minor(const std::vector<std::string>& versions) {
  std::vector<std::string> newest;  // in rising order, as `versions`
  for (const std::string& version : versions) {
    const auto same_minor = [&](const std::string& other) {
      const auto one = parts_of(version).numbers;
      const auto two = parts_of(other).numbers;
      return one[0] == two[0] && one[1] == two[1];
    };
    if (!newest.empty() && same_minor(newest.back())) {
      newest.back() = version;
    } else {
      newest.push_back(version);
    }
  }
  return newest;
}

VersionPlan version_plan(const std::string& text, bool every) {
  VersionPlan plan;
  const auto refuse = [&](const std::string& why) {
    plan.problems.push_back(fmt::format("{}: {}", printable(text), why));
    return plan;
  };
  const VersionRequest request = version_request(text);
  if (!request.problem.empty()) {
    plan.problems.push_back(request.problem);
    return plan;
  }
  plan.engine = find_engine(request.engine);
  if (!plan.engine.problems.empty()) {
    plan.problems = plan.engine.problems;
    return plan;
  }
  if (const std::string why = unfit(plan.engine); !why.empty()) {
    return refuse(why);
  }
  plan.range = request.range.empty() ? plan.engine.versions : request.range;
  if (plan.range.empty()) {
    return refuse("which versions? Its engine.toml does not say; give them, such as " +
                  printable(request.engine) + "@1.0..1.4");
  }
  const NpmVersions found = versions_in(plan.engine.package, plan.range);
  if (!found.problem.empty()) {
    return refuse(found.problem);
  }
  const std::vector<std::string> tried =
      plan.engine.versions.empty()
          ? found.versions
          : versions_in(plan.engine.package, plan.engine.versions).versions;
  for (const std::string& version : every ? found.versions : newest_of_each_minor(found.versions)) {
    const bool untried = std::find(tried.begin(), tried.end(), version) == tried.end();
    plan.versions.push_back({version, untried});
  }
  return plan;
}

}  // namespace tautline::bench
