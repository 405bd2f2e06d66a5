#pragma once

#include <vector>

#include "bench/measure/audit/model.hpp"

namespace tautline::bench {

/// Impulses that do not point along the cable, or turn the body by other than their arm.
[[nodiscard]] std::vector<Finding> impulse_findings(const AuditedModel& model);

}  // namespace tautline::bench
