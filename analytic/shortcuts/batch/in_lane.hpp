#pragma once

#include <cstddef>
#include <type_traits>

#include "shortcuts/batch/bounce_lanes.hpp"
#include "shortcuts/members.hpp"

namespace tautline {

/// The numbers of one lane in what has those of all.
struct InLane {
  std::size_t lane;

  /// Sets them.
  template <class OfLanes, class OfOne>
  void operator()(OfLanes& into, const OfOne& one) const {
    each_number(into, one,
                [this](LaneNumbers& numbers, double number) { numbers.of[lane] = number; });
  }

  /// Reads them; of a mask what is > 0.
  template <class OfOne, class OfLanes>
  [[nodiscard]] OfOne get(const OfLanes& from) const {
    OfOne result;
    each_number(result, from, [this]<class Number>(Number& number, const LaneNumbers& numbers) {
      if constexpr (std::is_same_v<Number, bool>) {
        number = numbers.of[lane] > 0.0;
      } else {
        number = numbers.of[lane];
      }
    });
    return result;
  }
};

}  // namespace tautline
