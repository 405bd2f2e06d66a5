#pragma once

#include <limits>
#include <string>
#include <vector>

#include "bench/check/strike.hpp"

namespace tautline::bench {

/// The restitutions of one strike over all settings that were tried [-].
struct Reach {
  double lowest = std::numeric_limits<double>::infinity();
  double highest = -std::numeric_limits<double>::infinity();

  void include(double restitution);  // one that is not finite says nothing
};

/// Where `wanted` lies further than `tolerance` beyond what any setting gave, in sentences.
[[nodiscard]] std::vector<std::string> sentences_of(const std::vector<Strike>& strikes,
                                                    const std::vector<Reach>& reach, double wanted,
                                                    double tolerance);

}  // namespace tautline::bench
