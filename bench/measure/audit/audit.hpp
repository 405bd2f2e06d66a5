#pragma once

#include <nlohmann/json.hpp>

namespace tautline::bench {

/// Adds the restitution audit to `report`, an object of bench/report/report.schema.json with its
/// cases and runs: "audit" of every run, and "findings", what the models do to impacts. Drawn from
/// `report` alone: from the impacts and paths of its runs.
void add_audit(nlohmann::ordered_json& report);

}  // namespace tautline::bench
