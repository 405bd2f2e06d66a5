#pragma once

#include <cstddef>
#include <functional>
#include <string>
#include <vector>

#include "bench/measure/audit_impacts.hpp"
#include "bench/measure/finding.hpp"

namespace tautline::bench {

/// A freeze and the run it happened in.
struct RunFreeze {
  RunOfModel run;
  Freeze freeze;
};

/// The audited impacts of a run.
struct RunImpacts {
  RunOfModel run;
  const std::vector<AuditedImpact>* impacts = nullptr;
};

/// All runs of one model.
struct AuditedModel {
  std::string engine;
  std::string model;
  std::size_t runs = 0;
  std::vector<AuditedImpact> impacts;  // of all
  std::vector<RunImpacts> by_run;      // the same
  std::vector<RunFreeze> freezes;
};

/// The runs of `model` with an impact for which `shows` is true.
[[nodiscard]] std::vector<RunOfModel> runs_with(
    const AuditedModel& model, const std::function<bool(const AuditedImpact&)>& shows);

/// A finding of `model`, without its sentence and value.
[[nodiscard]] Finding finding_of(const AuditedModel& model, std::string kind);

}  // namespace tautline::bench
