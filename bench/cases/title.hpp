#pragma once

#include <string>

#include "tautline/scenarios.hpp"

namespace tautline::bench {

/// What tells a case from others, in words and few digits: "e = 0.9, box 0.2 x 0.2, two cables of
/// 1.5", in the case's own units. A start at an angle or with a spin is named, and gravity that
/// does not point down.
[[nodiscard]] std::string title_of(const Case& the_case);

/// The first of the sentences on a system.
template <int D>
[[nodiscard]] std::string title_of(const BasicShippedSystem<D>& one) {
  return std::string(one.shows.substr(0, one.shows.find(". ") + 1));
}

/// All systems that ship, in the plane and then in space, for `use`.
template <class Use>
void each_shipped_system(const Use& use) {
  for (const ShippedSystem& one : shipped_systems()) {
    use(one);
  }
  for (const ShippedSpatialSystem& one : shipped_spatial_systems()) {
    use(one);
  }
}

}  // namespace tautline::bench
