#pragma once

#include <cstdint>
#include <filesystem>
#include <nlohmann/json_fwd.hpp>
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

/// Every number of a case, bit for bit: -0 differs from 0, and nan equals itself.
[[nodiscard]] std::vector<std::uint64_t> bits(const Case& the_case);

/// The names of what a folder holds, sorted.
[[nodiscard]] std::vector<std::string> names_in(const std::filesystem::path& folder);

/// The content of a file.
[[nodiscard]] std::string content_of(const std::filesystem::path& path);

/// A TOML file as the JSON that a schema is about. Null for text that is not TOML.
[[nodiscard]] nlohmann::json file_as_json(std::string_view text);

}  // namespace tautline::bench::test
