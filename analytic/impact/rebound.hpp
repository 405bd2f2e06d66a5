#pragma once

#include <optional>

#include "tautline/impact.hpp"
#include "tautline/rows.hpp"

namespace tautline {

/// By how much the gap rates of `cables` may be off [m/s].
template <class Real>
[[nodiscard]] BasicCableVector<Real> rate_errors(const BasicCase<Real>& the_case,
                                                 const BasicState<Real>& state, CableSet cables) {
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
template <class Real>
[[nodiscard]] std::optional<BasicImpact<Real>> rebound(const BasicCase<Real>& the_case,
                                                       const BasicState<Real>& before,
                                                       CableSet cables,
                                                       const BasicCableVector<Real>& rates,
                                                       const BasicCableVector<Real>& e,
                                                       const BasicCableVector<Real>& rounding);

}  // namespace tautline
