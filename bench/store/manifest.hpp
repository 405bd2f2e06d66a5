#pragma once

#include <filesystem>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "bench/report/report.hpp"
#include "bench/store/plan.hpp"

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

/// The engines of a suite as a report lists them, one that cannot be used with its reason.
[[nodiscard]] std::vector<EngineRow> engine_rows(const std::vector<RegisteredEngine>& engines);

/// What a report says was asked.
[[nodiscard]] ReportOptions report_options(const SuiteOptions& options);

/// The name of this machine's processor.
[[nodiscard]] std::string processor_name();

/// What `options.out` is of, when `command`, as it was typed, begins at `started`.
[[nodiscard]] Manifest manifest_of(const SuiteOptions& options, const std::string& command,
                                   const std::string& started);

/// A suite again from its manifest; its plug-ins need not be here. Throws std::runtime_error where
/// the manifest is of no suite that this program wrote.
[[nodiscard]] SuiteOptions options_of(const Manifest& manifest);

/// Writes the manifest of the result tree `out`. Throws FileError if it cannot.
void write_manifest(const std::filesystem::path& out, const Manifest& manifest);

/// The manifest of a result tree; none if `tree` is none.
[[nodiscard]] std::optional<Manifest> read_manifest(const std::filesystem::path& tree);

}  // namespace tautline::bench
