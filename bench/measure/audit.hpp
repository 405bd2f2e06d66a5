#pragma once

#include <optional>
#include <string>
#include <vector>

#include "bench/measure/audit_impacts.hpp"
#include "bench/measure/finding.hpp"
#include "bench/measure/reference.hpp"
#include "bench/run/record.hpp"

namespace tautline::bench {

/// What the restitution audit reads from one run, from all its samples and impacts.
struct RunAudit {
  std::optional<Ladder> ladder;
  std::vector<AuditedImpact> impacts;
  std::optional<Freeze> freeze;
};
/// `count_speed` [m/s] is of the ladder.
[[nodiscard]] RunAudit audit(const ReferenceCase& reference, const Trajectory& run,
                             double count_speed);

/// The audit of a run, and whose run it is.
struct AuditedRun {
  std::string the_case;
  std::string engine;
  std::string model;
  const RunAudit* audit = nullptr;
  double step = 0.0;  // [s]
};

/// What the models do to impacts, apart from their rebounds, in the order of their first runs.
[[nodiscard]] std::vector<Finding> findings(const std::vector<AuditedRun>& runs);

}  // namespace tautline::bench
