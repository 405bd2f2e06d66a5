#pragma once

#include <optional>
#include <vector>

#include "bench/measure/audit_model.hpp"

namespace tautline::bench {

// What the audit of a model is made of.

/// Impulses that do not point along the cable, or turn the body by other than their arm; impacts of
/// several steps.
[[nodiscard]] std::vector<Finding> impulse_findings(const AuditedModel& model);

/// Bodies put to sleep.
[[nodiscard]] std::vector<Finding> sleep_findings(const AuditedModel& model);

/// Whether and when `run` freezes.
[[nodiscard]] std::optional<Freeze> freeze_of(const ReferenceCase& reference,
                                              const Trajectory& run);

}  // namespace tautline::bench
