#pragma once

#include <optional>
#include <vector>

#include "bench/measure/audit_model.hpp"

namespace tautline::bench {

// What the audit of a model is made of.

/// Restitution that is ignored, cut off, spread, too large or too small; impacts of several steps.
[[nodiscard]] std::vector<Finding> restitution_findings(const AuditedModel& model);

/// Impulses that do not point along the cable, or turn the body by other than their arm.
[[nodiscard]] std::vector<Finding> impulse_findings(const AuditedModel& model);

/// Bodies put to sleep.
[[nodiscard]] std::vector<Finding> sleep_findings(const AuditedModel& model);

/// Whether and when `run` freezes.
[[nodiscard]] std::optional<Freeze> freeze_of(const ReferenceCase& reference,
                                              const Trajectory& run);

}  // namespace tautline::bench
