#pragma once

#include <string>

#include "bench/gate/limits.hpp"
#include "bench/report/report.hpp"

namespace tautline::bench {

/// Says which entries of a limits file are about no run of the report, and which known deviations
/// no run of it shows, though that breaks nothing; "" if there are none. Subsets are run too: so
/// that is no mistake.
[[nodiscard]] std::string unused_entries(const Report& report, const Limits& limits);

}  // namespace tautline::bench
