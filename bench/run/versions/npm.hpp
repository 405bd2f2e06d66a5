#pragma once

#include <filesystem>
#include <string>
#include <vector>

namespace tautline::bench {

/// Versions that npm knows, from the oldest to the newest, or why it names none.
struct NpmVersions {
  std::vector<std::string> versions;
  std::string problem;
};

/// The versions of `package` in `range`, which npm reads. Without a network npm answers from what
/// it has kept.
[[nodiscard]] NpmVersions versions_in(const std::string& package, const std::string& range);

/// Installs exactly this version of `package` into `folder`, whose package.json then says so, and
/// what else that asks for. Runs no script of a package. Why it could not, or "".
[[nodiscard]] std::string install_version(const std::filesystem::path& folder,
                                          const std::string& package, const std::string& version);

}  // namespace tautline::bench
