#pragma once

#include <xsimd/xsimd.hpp>

#include "shortcuts/batch/bounce_lanes_impl.hpp"

namespace tautline {

template <class Arch>
struct NumberOf<xsimd::batch<double, Arch>> {
  using type = double;
};

/// The numbers of as many lanes as a register of `Arch` holds.
template <class Arch>
struct PackOf {
  using V = xsimd::batch<double, Arch>;
  using Mask = typename V::batch_bool_type;
  static constexpr std::size_t size = V::size;

  [[nodiscard]] static V from(const LaneNumbers& numbers, std::size_t first) {
    return V::load_aligned(numbers.of.data() + first);
  }
  static void to(const V& v, LaneNumbers& numbers, std::size_t first) {
    v.store_aligned(numbers.of.data() + first);
  }
};

}  // namespace tautline
