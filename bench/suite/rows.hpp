#pragma once

#include "bench/judge/allowance.hpp"
#include "bench/measure/compare.hpp"
#include "bench/measure/reference.hpp"
#include "bench/replay/curve.hpp"
#include "bench/report/record.hpp"
#include "bench/run/worker.hpp"
#include "tautline/engine.hpp"

namespace tautline::bench {

/// How near the runs of a case are drawn.
[[nodiscard]] Nearness nearness_of(const AnyExpectation& expected);

/// What a run left: how it ended, and what is measured and drawn of it, as near as `nearness`, if
/// there is a trajectory.
[[nodiscard]] RunRecord run_record(const AnyExpectation& expected, const Nearness& nearness,
                                   const EngineInfo& engine, const RunKey& key,
                                   const RunReply& reply, const CompareOptions& options);

/// What the exact solution says of a case, and of runs of `steps` [s] of it.
[[nodiscard]] CaseRow case_row(const AnyExpectation& expected, const CompareOptions& options,
                               const std::vector<double>& steps);

}  // namespace tautline::bench
