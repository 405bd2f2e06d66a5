#include "bench/measure/audit/model.hpp"

#include <utility>

namespace tautline::bench {

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
