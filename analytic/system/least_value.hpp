#pragma once

#include <optional>

#include "tautline/function.hpp"

namespace tautline {

/// A number given over time, at one instant.
struct ValueAtTime {
  double time;   // [s]
  double value;  // in the function's unit
};

/// An instant from `begin` to `end` [s] at which `function` is not above zero; none where it is
/// above zero at all of them.
[[nodiscard]] std::optional<ValueAtTime> not_above_zero(const Function<1>& function, double begin,
                                                        double end);

}  // namespace tautline
