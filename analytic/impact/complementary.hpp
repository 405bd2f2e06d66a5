#pragma once

#include <optional>

#include "tautline/detail/rows.hpp"

namespace tautline {

/// The solution of 0 <= z, perpendicular to, w = q + A A^T z >= 0 for the rows A of cables, with
/// what rounding may have done to it.
template <class Real>
struct Complementary {
  CableSet active;                          // rows, not cables, with z > 0: independent
  BasicCableVector<Real> multipliers;       // z
  BasicCableVector<Real> left;              // w
  BasicCableVector<Real> multiplier_error;  // by which `multipliers` may be off
  BasicCableVector<Real> left_error;        // by which `left` may be off
};

/// None if there is no solution, not even for a q that differs by `rounding` in each row, which is
/// what it has from the numbers it was computed from.
template <class TheCase, class Real = RealOf<TheCase>>
[[nodiscard]] std::optional<Complementary<Real>> complementary(
    const CableRows<TheCase>& cables, const BasicCableVector<Real>& q,
    const BasicCableVector<Real>& rounding);

}  // namespace tautline
