#include "shortcuts/batch/bounce_lanes.hpp"

#include "shortcuts/batch/bounce_lanes_impl.hpp"

namespace tautline {
namespace {

/// One lane after the other.
struct PackOfOne {
  using V = double;
  using Mask = bool;
  static constexpr std::size_t size = 1;

  [[nodiscard]] static double from(const LaneNumbers& numbers, std::size_t first) {
    return numbers.of[first];
  }
  static void to(double number, LaneNumbers& numbers, std::size_t first) {
    numbers.of[first] = number;
  }
};

}  // namespace

void bounce_lanes_one_by_one(const LaneQuestion& question, LaneAnswer& answer) {
  bounce_lanes<PackOfOne>(question, answer);
}

BounceLanes fastest_bounce_lanes() {
#ifdef TAUTLINE_LANES
  if (__builtin_cpu_supports("avx512f")) {
    return bounce_lanes_avx512;
  }
  if (__builtin_cpu_supports("avx2")) {
    return bounce_lanes_avx2;
  }
#endif
  return bounce_lanes_one_by_one;
}

}  // namespace tautline
