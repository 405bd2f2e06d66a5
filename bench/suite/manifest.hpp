#pragma once

#include <filesystem>
#include <string>
#include <vector>

#include "bench/report/manifest.hpp"
#include "bench/suite/plan.hpp"

namespace tautline::bench {

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
