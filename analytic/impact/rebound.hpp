#pragma once

#include <optional>

#include "tautline/detail/rows.hpp"
#include "tautline/impact.hpp"

namespace tautline {

/// By how much the gap rates of `cables` may be off [m/s].
template <class TheCase, class Real = RealOf<TheCase>>
[[nodiscard]] BasicCableVector<Real> rate_errors(const TheCase& the_case,
                                                 const StateOf<TheCase>& state, CableSet cables) {
  BasicCableVector<Real> result(static_cast<Eigen::Index>(cables.size()));
  Eigen::Index row = 0;
  for (const std::size_t index : cables) {
    result[row++] = rounding_margin * rounding_of_rate(the_case.cables[index], state);
  }
  return result;
}

/// The rows that the cables of `part` have among those of `cables`.
[[nodiscard]] inline std::vector<Eigen::Index> rows_within(CableSet part, CableSet cables) {
  std::vector<Eigen::Index> result;
  Eigen::Index row = 0;
  for (const std::size_t index : cables) {
    if (part.contains(index)) {
      result.push_back(row);
    }
    ++row;
  }
  return result;
}

/// Newton's law (Eq. 14) for `cables` with the restitutions `e`, where their gap `rates` [m/s] may
/// be off by `rounding` [m/s]. None if there is no such rebound, or its numbers overflow.
template <class TheCase, class Real = RealOf<TheCase>>
[[nodiscard]] std::optional<BasicImpact<TheCase>> rebound(const TheCase& the_case,
                                                          const StateOf<TheCase>& before,
                                                          CableSet cables,
                                                          const BasicCableVector<Real>& rates,
                                                          const BasicCableVector<Real>& e,
                                                          const BasicCableVector<Real>& rounding);

}  // namespace tautline
