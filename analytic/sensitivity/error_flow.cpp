#include "error_flow.hpp"

#include <algorithm>
#include <optional>

#include "linearised.hpp"
#include "saltation.hpp"
#include "tangent.hpp"

namespace tautline {

StateVector rate_at(const Arc& arc, double dt, const State& last, const Vec2& gravity) {
  if (arc.series.rows() > 0) {
    return state_rate(arc, dt, gravity);
  }
  StateVector result;
  result << last.velocity, last.spin, gravity, 0.0;
  return result;
}

Spread along(const Spread& spread, const Case& the_case, const Sizes& sizes, const Arc& arc,
             CableSet basis, double dt, const State& last) {
  Spread result = spread;
  double arm = 0.0;              // [m]
  std::optional<double> least;   // independence of two taut cables
  if (arc.series.rows() == 0) {  // Eq. 40, from both sides
    result.topRows<3>() += dt * spread.middleRows<3>(3);
    result.leftCols<3>() += (dt * result.middleCols<3>(3)).eval();
  } else if (is_rest(arc)) {
    if (arc.initial.spin != 0.0) {  // exactly
      result.row(2) += dt * spread.row(5);
      result.col(2) += (dt * result.col(5)).eval();
    }
  } else {
    const State middle = arc.after(dt / 2.0, the_case.gravity);
    result = carried(spread, the_case, {basis, dt, arc.initial, middle, last});
    if (basis.size() > 1) {
      for (const std::size_t index : basis) {
        arm = std::max(arm, the_case.cables[index].attachment.norm());
      }
      for (const State& state : {arc.initial, middle, last}) {
        least = std::min(least.value_or(1.0), independence(the_case, state, basis));
      }
    }
  }
  settle(result);
  add_errors(result, least ? taut_rounding(sizes, arc.initial, last, dt, arm, *least)
                           : arc_rounding(sizes, arc.initial, last, dt));
  return result;
}

}  // namespace tautline
