#pragma once

#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "bench/report/report.hpp"

namespace tautline::bench {

/// The number of the form of suite.json: its key `schema`.
inline constexpr int manifest_schema = 1;

/// What a result tree is of: suite.json in it. With the results of its runs it holds all that a
/// report is made from, wherever that is done.
struct Manifest {
  struct Engine {
    EngineRow row;
    std::string plugin;  // a hash of its file
  };
  /// The program that wrote it. Only equal programs are sure to make equal reports.
  struct Program {
    std::string version;
    std::string commit;
    std::string hash;  // of its file

    auto operator<=>(const Program&) const = default;  // NOLINT(modernize-use-nullptr): it has none
  };

  Program program;
  std::vector<std::string> cases;  // as case files
  std::vector<Engine> engines;
  std::vector<std::string> models;  // of those; empty means all
  ReportOptions options;
  ShardRow shard;  // which part, and how it was made
};

/// A line for every row.
[[nodiscard]] std::string manifest_json(const Manifest& manifest);

/// None if `text` is no manifest of this form.
[[nodiscard]] std::optional<Manifest> manifest_from(std::string_view text);

}  // namespace tautline::bench
