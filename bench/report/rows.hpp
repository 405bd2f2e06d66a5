#pragma once

#include <nlohmann/json.hpp>

#include "bench/suite/suite.hpp"

namespace tautline::bench {

/// A run's row of the report: what ran, how it ended, and the metrics if there is something to
/// compare.
[[nodiscard]] nlohmann::ordered_json run_row(const ReferenceCase& reference,
                                             const EngineInfo& engine, const PlannedRun& run,
                                             const RunReply& reply, const CompareOptions& options);

/// What the run cost, or null: it differs from machine to machine and from day to day.
[[nodiscard]] nlohmann::ordered_json timing_row(const ReferenceCase& reference,
                                                const EngineInfo& engine, const PlannedRun& run,
                                                const RunReply& reply);

/// What the exact solution says of a case.
[[nodiscard]] nlohmann::ordered_json case_row(const ReferenceCase& reference,
                                              const CompareOptions& options);

}  // namespace tautline::bench
