// Reads one run at a time, then asks each model what it does to impacts.

#include "bench/measure/audit.hpp"

#include <map>
#include <utility>

#include "bench/measure/audit_model.hpp"
#include "bench/measure/audit_parts.hpp"

namespace tautline::bench {
namespace {

/// The models with all that their runs show, in the order of their first runs.
std::vector<AuditedModel> audited_models(const std::vector<AuditedRun>& runs) {
  std::vector<AuditedModel> models;
  std::map<std::pair<std::string, std::string>, std::size_t> places;
  for (const AuditedRun& run : runs) {
    const auto [place, is_new] = places.try_emplace({run.engine, run.model}, models.size());
    if (is_new) {
      models.push_back({run.engine, run.model, 0, {}, {}, {}});
    }
    AuditedModel& model = models[place->second];
    ++model.runs;
    model.impacts.insert(model.impacts.end(), run.audit->impacts.begin(), run.audit->impacts.end());
    model.by_run.push_back({{run.the_case, run.step}, &run.audit->impacts});
    if (run.audit->freeze) {
      model.freezes.push_back({{run.the_case, run.step}, *run.audit->freeze});
    }
  }
  return models;
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
  for (const AuditedModel& model : audited_models(runs)) {
    for (const auto& look : {impulse_findings, sleep_findings}) {
      std::vector<Finding> found = look(model);
      std::move(found.begin(), found.end(), std::back_inserter(all));
    }
  }
  return all;
}

}  // namespace tautline::bench
