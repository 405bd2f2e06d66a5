#pragma once

#include <optional>

#include "bench/measure/audit.hpp"
#include "bench/replay/replay.hpp"
#include "bench/report/report.hpp"

namespace tautline::bench {

/// All that a run left: its row, what is drawn of it, and what the report draws from all runs
/// together.
struct RunRecord {
  RunRow row;
  RunReplay replay;
  std::optional<TimingRow> timing;  // none if nothing was measured
  std::optional<RunAudit> audit;    // none without a trajectory
};

}  // namespace tautline::bench
