#pragma once

#include <optional>
#include <vector>

#include "bench/measure/audit/model.hpp"

namespace tautline::bench {

/// Whether and when `run` freezes.
[[nodiscard]] std::optional<Freeze> freeze_of(const ReferenceCase& reference,
                                              const Trajectory& run);

/// Bodies put to sleep.
[[nodiscard]] std::vector<Finding> sleep_findings(const AuditedModel& model);

}  // namespace tautline::bench
