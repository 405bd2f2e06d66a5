#pragma once

#include <filesystem>
#include <nlohmann/json.hpp>
#include <optional>
#include <string>

#include "bench/base/descriptor.hpp"
#include "bench/run/record.hpp"
#include "bench/suite/suite.hpp"

namespace tautline::bench {

/// The folder of one run inside a result tree: runs/<case>/<engine>/<model>/<step>.
[[nodiscard]] std::filesystem::path run_folder(const std::filesystem::path& out,
                                               const std::string& case_name,
                                               const std::string& engine, const std::string& model,
                                               double step);

/// Time, state and event of a run as CSV; an impact is two rows at one time, before and after.
[[nodiscard]] std::string trajectory_csv(const Trajectory& run, std::size_t samples);

/// The impacts of a run as CSV.
[[nodiscard]] std::string events_csv(const Trajectory& run);

/// The same text for the same run, another for any other: case, engine, version, plug-in file,
/// model, settings, step and how it is compared.
[[nodiscard]] std::string fingerprint(const SuiteOptions& options, const PlannedRun& run);

/// Writes a run's files; result.json last, so that a folder with one is whole.
void write_run(const std::filesystem::path& folder, const SuiteOptions& options,
               const PlannedRun& run, const RunReply& reply, const RunResult& result);

/// The result of an earlier invocation, if `folder` holds one with this fingerprint.
[[nodiscard]] std::optional<RunResult> read_run(const std::filesystem::path& folder,
                                                const std::string& fingerprint);

/// Makes `out` a result tree, or opens it if it is one; with `clear` an earlier tree's runs and
/// report are removed. The tree is this program's alone until the descriptor is gone. Throws
/// FileError if it cannot be made, or if another program is writing to it.
[[nodiscard]] Descriptor open_tree(const std::filesystem::path& out, bool clear);

/// Why `out` cannot be made a result tree, or none: it holds files that are not one.
[[nodiscard]] std::optional<std::string> tree_problem(const std::filesystem::path& out);

}  // namespace tautline::bench
