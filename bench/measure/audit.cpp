// Reads one run at a time, then asks each model what it does to impacts.

#include "bench/measure/audit.hpp"

#include <iterator>

#include "bench/measure/audit_model.hpp"
#include "bench/measure/audit_parts.hpp"

namespace tautline::bench {
namespace {

/// A model with all that its runs show.
AuditedModel audited_model(const std::vector<const AuditedRun*>& runs) {
  AuditedModel model{runs.front()->engine, runs.front()->model, runs.size(), {}, {}, {}};
  for (const AuditedRun* run : runs) {
    const RunAudit& audit = *run->audit;
    model.impacts.insert(model.impacts.end(), audit.impacts.begin(), audit.impacts.end());
    model.by_run.push_back({{run->the_case, run->step}, &audit.impacts});
    if (audit.freeze) {
      model.freezes.push_back({{run->the_case, run->step}, *audit.freeze});
    }
  }
  return model;
}

}  // namespace

RunAudit audit(const ReferenceCase& reference, const Trajectory& run, double count_speed) {
  RunAudit result;
  result.impacts = audited_impacts(reference, run);
  result.ladder = ladder_of(reference, run, count_speed);
  result.freeze = freeze_of(reference, run);
  return result;
}

std::vector<Finding> findings(const std::vector<AuditedRun>& runs) {
  std::vector<Finding> all;
  for (const std::vector<const AuditedRun*>& of_model : by_model(runs)) {
    const AuditedModel model = audited_model(of_model);
    for (const auto& look : {impulse_findings, sleep_findings}) {
      std::vector<Finding> found = look(model);
      std::move(found.begin(), found.end(), std::back_inserter(all));
    }
  }
  return all;
}

}  // namespace tautline::bench
