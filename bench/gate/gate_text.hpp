#pragma once

#include <string>
#include <vector>

#include "bench/gate/broken.hpp"
#include "bench/gate/listed_problems.hpp"
#include "bench/report/report.hpp"

namespace tautline::bench {

/// The rows that break the gate as a table for a terminal, and a last line that says whether it
/// holds.
[[nodiscard]] std::string gate_text(const Report& report, const ListedProblems& listed,
                                    const std::vector<BrokenRow>& rows);

}  // namespace tautline::bench
