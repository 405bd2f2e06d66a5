#pragma once

#include <vector>

#include "bench/measure/audit/model.hpp"

namespace tautline::bench {

/// Restitution that is ignored, cut off, spread, too large or too small; impacts of several steps.
[[nodiscard]] std::vector<Finding> restitution_findings(const AuditedModel& model);

}  // namespace tautline::bench
