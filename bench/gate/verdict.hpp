#pragma once

#include <string>
#include <string_view>

#include "bench/gate/listed_problems.hpp"
#include "bench/report/report.hpp"

namespace tautline::bench {

/// The precision of the engine of `run`; "" if `report` does not know it.
[[nodiscard]] std::string precision_of(const Report& report, const RunKey& run);

/// Gives every run of `report` its verdict: the problems that its judgement and the findings of the
/// audit are, and which of them are `listed`.
void add_verdicts(Report& report, const ListedProblems& listed);

/// True if the verdict of `run` has a problem of this kind.
[[nodiscard]] bool shows(const RunRow& run, std::string_view kind);

/// True if runs of `report`, which has verdicts, could show the problem, and none does. One that
/// only some runs show is never gone.
[[nodiscard]] bool is_gone(const ListedProblem& problem, const Report& report);

}  // namespace tautline::bench
