#pragma once

#include <vector>

#include "tautline/impact.hpp"

namespace tautline {

/// The impulses [N s], >= 0, after which no gap opens slower than it should, and none is larger
/// than it has to be (Eq. 14): for an engine whose own solver cannot be asked. `delassus` is the
/// engine's J M^-1 J^T, `excess` the rates of the gaps less the wanted ones [m/s]. Zero where there
/// are none, which cannot be where the wanted rates are those of bounces. `rank` is of `delassus`,
/// three of a planar body.
[[nodiscard]] inline CableVector impulses_by_hand(const CableMatrix& delassus,
                                                  const CableVector& excess, double rounding,
                                                  int rank = 3) {
  if (const auto impulses = solve_lcp(delassus, excess, rounding, rank)) {
    return *impulses;
  }
  // a rate above the wanted one by rounding left no solution: such cables take no part
  std::vector<Eigen::Index> rows;
  for (Eigen::Index row = 0; row < excess.size(); ++row) {
    if (excess[row] <= 0.0) {
      rows.push_back(row);
    }
  }
  CableVector result = CableVector::Zero(excess.size());
  if (rows.empty()) {
    return result;
  }
  const CableMatrix part = delassus(rows, rows);
  const CableVector rest = excess(rows);
  if (const auto impulses = solve_lcp(part, rest, rounding, rank)) {
    result(rows) = *impulses;
  }
  return result;
}

}  // namespace tautline
