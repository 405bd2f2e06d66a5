#pragma once

#include <string>
#include <vector>

#include "bench/base/table.hpp"
#include "bench/report/report.hpp"

namespace tautline::bench {

/// Every run: its metrics, impacts, settling, restitution, cost, verdict and how it ended.
[[nodiscard]] Table runs_table(const Report& report);

/// The same of one case.
[[nodiscard]] Table runs_table(const Report& report, const std::string& the_case);

/// The checks of a verdict that matter: those that do not hold, or else the one that is nearest to
/// not holding. They are `verdict`'s own.
[[nodiscard]] std::vector<const Check*> telling_checks(const Verdict& verdict);

}  // namespace tautline::bench
