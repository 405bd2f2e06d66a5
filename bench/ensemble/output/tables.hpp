#pragma once

#include "bench/base/table.hpp"
#include "bench/ensemble/output/words.hpp"

namespace tautline::bench {

/// Each statistic of each setup: its median and spread.
[[nodiscard]] Table summary_table(const EnsembleReport& report);

/// Each statistic of each setup but the first, held against it; empty without another.
[[nodiscard]] Table comparison_table(const EnsembleReport& report);

}  // namespace tautline::bench
