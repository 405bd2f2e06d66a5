#include "bench/run/versions/version_plan.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <filesystem>

#include "bench/base/text.hpp"
#include "bench/run/registry.hpp"
#include "bench/run/versions/npm.hpp"
#include "bench/run/versions/version_request.hpp"

namespace tautline::bench {
namespace {

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
    return "npm does not bring its package: there is no package.json beside its engine.toml";
  }
  EngineFile before_install = engine;
  before_install.installed.clear();
  return missing(before_install);
}

}  // namespace

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
