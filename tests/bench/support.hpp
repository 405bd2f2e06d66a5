#pragma once

#include <algorithm>
#include <cstdint>
#include <filesystem>
#include <nlohmann/json_fwd.hpp>
#include <stdexcept>
#include <string>
#include <string_view>
#include <vector>

#include "tautline/case.hpp"

namespace tautline::bench::test {

/// A new empty folder, removed with all it holds when left.
class TemporaryFolder {
 public:
  TemporaryFolder();
  ~TemporaryFolder();
  TemporaryFolder(const TemporaryFolder&) = delete;
  TemporaryFolder& operator=(const TemporaryFolder&) = delete;

  [[nodiscard]] const std::filesystem::path& path() const { return path_; }

  /// Writes a file into the folder and returns its path.
  [[nodiscard]] std::filesystem::path file(const std::string& name, std::string_view content) const;

 private:
  std::filesystem::path path_;
};

/// The system of this name in `all`, of those that are shipped; it must be there.
template <class Shipped>
[[nodiscard]] auto named(const std::vector<Shipped>& all, const std::string& name) {
  const auto found = std::find_if(all.begin(), all.end(),
                                  [&](const Shipped& one) { return one.system.name == name; });
  if (found == all.end()) {
    throw std::logic_error("no shipped system is called " + name);
  }
  return found->system;
}

/// Every number of a case, bit for bit: -0 differs from 0, and nan equals itself.
[[nodiscard]] std::vector<std::uint64_t> bits(const Case& the_case);

/// The names of what a folder holds, sorted.
[[nodiscard]] std::vector<std::string> names_in(const std::filesystem::path& folder);

/// The content of a file.
[[nodiscard]] std::string content_of(const std::filesystem::path& path);

/// A TOML file as the JSON that a schema is about. Null for text that is not TOML.
[[nodiscard]] nlohmann::json file_as_json(std::string_view text);

}  // namespace tautline::bench::test
