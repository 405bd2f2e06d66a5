#pragma once

#include "bench/measure/compare.hpp"
#include "bench/measure/reference.hpp"
#include "bench/report/record.hpp"
#include "bench/run/worker.hpp"
#include "tautline/engine.hpp"

namespace tautline::bench {

/// What a run left: how it ended, and measures, audit and attribution if there is a trajectory.
[[nodiscard]] RunRecord run_record(const ReferenceCase& reference, const EngineInfo& engine,
                                   const RunKey& key, const RunReply& reply,
                                   const CompareOptions& options);

/// What the exact solution says of a case.
[[nodiscard]] CaseRow case_row(const ReferenceCase& reference, const CompareOptions& options);

}  // namespace tautline::bench
