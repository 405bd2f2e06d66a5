#include "bench/measure/audit_model.hpp"

#include <algorithm>
#include <utility>

namespace tautline::bench {

std::vector<RunOfModel> runs_with(const AuditedModel& model,
                                  const std::function<bool(const AuditedImpact&)>& shows) {
  std::vector<RunOfModel> result;
  for (const RunImpacts& run : model.by_run) {
    if (std::any_of(run.impacts->begin(), run.impacts->end(), shows)) {
      result.push_back(run.run);
    }
  }
  return result;
}

Finding finding_of(const AuditedModel& model, std::string kind) {
  Finding finding;
  finding.engine = model.engine;
  finding.model = model.model;
  finding.kind = std::move(kind);
  finding.runs = model.runs;
  finding.impacts = model.impacts.size();
  return finding;
}

}  // namespace tautline::bench
