#pragma once

#include <vector>

#include "bench/gate/limits.hpp"
#include "bench/run/registry.hpp"
#include "tautline/case.hpp"

namespace tautline::bench {

/// The names that a limits file may have: of all engines that the program knows or was given, their
/// models, the shipped cases and `cases`.
[[nodiscard]] LimitNames limit_names(const std::vector<RegisteredEngine>& given,
                                     const std::vector<Case>& cases);

}  // namespace tautline::bench
