#pragma once

#include <string>
#include <vector>

#include "bench/check/settle.hpp"
#include "bench/run/registry.hpp"
#include "bench/tools/calibrate/calibrate.hpp"

namespace tautline::bench {

// What is found out about engines, as JSON, and the schema of that: indented, with a line break at
// the end. But for the first, it requires an engine that has answered what it is.

/// What `tautline engines --json` writes.
[[nodiscard]] std::string engines_json(const std::vector<RegisteredEngine>& engines);
[[nodiscard]] std::string engines_schema_json();

/// One model of an engine, and every claim about it.
struct CheckedModel {
  std::string name;
  std::vector<SettledClaim> claims;
};

/// What `tautline check --json` writes.
[[nodiscard]] std::string check_json(const RegisteredEngine& engine,
                                     const std::vector<CheckedModel>& models);
[[nodiscard]] std::string check_schema_json();

/// What `tautline calibrate --json` writes.
[[nodiscard]] std::string calibration_json(const RegisteredEngine& engine,
                                           const CalibrationRequest& request,
                                           const Calibration& found);
[[nodiscard]] std::string calibration_schema_json();

}  // namespace tautline::bench
