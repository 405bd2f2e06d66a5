#pragma once

#include <cstddef>
#include <string>
#include <vector>

#include "bench/measure/audit/finding.hpp"
#include "bench/measure/audit/freeze.hpp"
#include "bench/measure/audit/impacts.hpp"

namespace tautline::bench {

/// A freeze and the case it happened in.
struct CaseFreeze {
  std::string the_case;
  Freeze freeze;
};

/// All runs of one model.
struct AuditedModel {
  std::string engine;
  std::string model;
  std::size_t runs = 0;
  std::vector<AuditedImpact> impacts;
  std::vector<CaseFreeze> freezes;
};

/// A finding of `model`, without its sentence and value.
[[nodiscard]] Finding finding_of(const AuditedModel& model, std::string kind);

}  // namespace tautline::bench
