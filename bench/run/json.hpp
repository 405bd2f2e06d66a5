#pragma once

#include <string>
#include <vector>

#include "bench/check/settle.hpp"
#include "bench/run/calibration/calibrate.hpp"
#include "bench/run/registry.hpp"
#include "tautline/engine.hpp"

namespace tautline::bench {

// JSON of engines, as text.

/// What `tautline engines --json` writes.
[[nodiscard]] std::string engines_json(const std::vector<RegisteredEngine>& engines);

/// One model of an engine, and every claim about it.
struct CheckedModel {
  std::string name;
  std::vector<SettledClaim> claims;
};

/// What `tautline check --json` writes, as bench/check/check.schema.json describes it. Requires an
/// engine that has answered what it is.
[[nodiscard]] std::string check_json(const RegisteredEngine& engine,
                                     const std::vector<CheckedModel>& models);

/// What `tautline calibrate --json` writes, as bench/run/calibration/calibration.schema.json
/// describes it. Requires an engine that has answered what it is.
[[nodiscard]] std::string calibration_json(const RegisteredEngine& engine,
                                           const CalibrationRequest& request,
                                           const Calibration& found);

}  // namespace tautline::bench
