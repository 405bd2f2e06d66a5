#pragma once

#include <algorithm>
#include <cstddef>

namespace tautline::bench {

/// The last index of `first` .. `last` for which `fits(index)` holds, if those that fit are the
/// first ones; `first` is taken without asking. Asks where doubled strides lead, then halves the
/// stride that was too long: a long stretch costs few answers.
template <class Fits>
std::size_t farthest(std::size_t first, std::size_t last, const Fits& fits) {
  std::size_t good = first;
  std::size_t bad = last + 1;
  for (std::size_t stride = 1; good < last; stride *= 2) {
    const std::size_t next = std::min(last, good + stride);
    if (!fits(next)) {
      bad = next;
      break;
    }
    good = next;
  }
  while (bad - good > 1) {
    const std::size_t middle = good + (bad - good) / 2;
    (fits(middle) ? good : bad) = middle;
  }
  return good;
}

}  // namespace tautline::bench
