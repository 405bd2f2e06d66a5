#pragma once

#include <cstddef>
#include <map>
#include <optional>
#include <string>
#include <utility>
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
  double step = 0.0;  // [s]
  const RunAudit* audit = nullptr;
};

/// The runs of each model, in the order of their first. `Run` is an AuditedRun; `runs` must outlive
/// the result.
template <class Run>
[[nodiscard]] std::vector<std::vector<const Run*>> by_model(const std::vector<Run>& runs) {
  std::vector<std::vector<const Run*>> models;
  std::map<std::pair<std::string, std::string>, std::size_t> places;
  for (const Run& run : runs) {
    const auto [place, is_new] = places.try_emplace({run.engine, run.model}, models.size());
    if (is_new) {
      models.emplace_back();
    }
    models[place->second].push_back(&run);
  }
  return models;
}

/// What the models do to impacts, apart from their rebounds, in the order of their first runs.
[[nodiscard]] std::vector<Finding> findings(const std::vector<AuditedRun>& runs);

}  // namespace tautline::bench
