#pragma once

#include <string>

#include "bench/ensemble/output/words.hpp"

namespace tautline::bench {

/// The distribution functions of one statistic, those of all setups over each other, and beside
/// them their quantiles over those of the first setup: where both are alike, on the diagonal.
[[nodiscard]] std::string distribution_svg(const EnsembleReport& report, std::size_t statistic);

}  // namespace tautline::bench
