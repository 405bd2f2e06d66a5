#pragma once

#include <cstdint>
#include <filesystem>
#include <optional>
#include <string>

#include "bench/report/record.hpp"
#include "bench/run/record.hpp"
#include "bench/run/worker.hpp"
#include "bench/store/plan.hpp"

namespace tautline::bench {

/// The folder of one run inside a result tree: runs/<case>/<engine>/<model>/<step>.
[[nodiscard]] std::filesystem::path run_folder(const std::filesystem::path& out, const RunKey& run);

/// Time, state and event of a run as CSV; an impact is two rows, before and after: at one time, but
/// where a push lasts several steps. Where the engine tells of them, the mean tension [N] of each
/// cable since the point before: a row of an impact has none.
/// A system's columns begin with the names of its bodies, unless it has one without a name.
template <class TheCase>
[[nodiscard]] std::string trajectory_csv(const TheCase& the_case,
                                         const BasicTrajectory<TheCase>& run, std::size_t samples);

/// The impacts of a run as CSV.
template <class TheCase>
[[nodiscard]] std::string events_csv(const BasicTrajectory<TheCase>& run);

/// Of the program itself: what it compares, and how, may change without its version.
[[nodiscard]] std::uint64_t program_hash();

/// Of the plug-in of one of the engines of `options`.
[[nodiscard]] std::uint64_t plugin_hash(const SuiteOptions& options, std::size_t engine);

/// The same text for the same run, another for any other: case, engine, version, plug-in file,
/// model, settings, step and how it is compared.
[[nodiscard]] std::string fingerprint(const SuiteOptions& options, const PlannedRun& run);

/// Writes a run's files; result.json last, so that a folder with one is whole.
void write_run(const std::filesystem::path& folder, const SuiteOptions& options,
               const PlannedRun& run, const RunReply& reply, const RunRecord& record);

/// The result of an earlier invocation, if `folder` holds one with this fingerprint.
[[nodiscard]] std::optional<RunRecord> read_run(const std::filesystem::path& folder,
                                                const std::string& fingerprint);

}  // namespace tautline::bench
