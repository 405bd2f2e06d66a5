#pragma once

#include <algorithm>

#include "tautline/solution.hpp"

namespace tautline {

/// A tension that differs less than this from another is the same one [-]: the first of equal
/// extremes counts.
inline constexpr double same_tension = 1e-12;

/// Looks for the extremes of the tension of one cable over arcs on which it is taut.
template <class TheCase>
class TensionExtremes {
 public:
  using Real = RealOf<TheCase>;
  using Arc = BasicArc<TheCase>;  // on which to look

  /// For this cable; `solution` must outlive it.
  TensionExtremes(const BasicSolution<TheCase>& solution, std::size_t cable)
      : solution_(solution), cable_(cable) {}

  /// Takes the extremes of an arc on which the cable is taut.
  void look_at(const Arc& arc) {
    // an arc is a quarter of the radius of convergence long: its tension turns once or twice
    constexpr int parts = 8;
    const Real step = (arc.end - arc.start) / parts;
    Real before = tension(arc, Real(0));
    take(arc, Real(0), before);
    Real here = before;
    for (int k = 1; k <= parts && step > 0; ++k) {
      const Real dt = k * step;
      const Real next = tension(arc, dt);
      take(arc, dt, next);
      if (k > 1 && (here - before) * (next - here) < 0) {
        refine(arc, dt - 2 * step, dt, here < before);
      }
      before = here;
      here = next;
    }
    // a turn within the first or the last part shows at its end alone
    if (step > 0) {
      for (const bool least : {true, false}) {
        refine(arc, Real(0), step, least);
        refine(arc, (parts - 1) * step, parts * step, least);
      }
    }
  }

  /// An extreme; `arc` is null as long as it has looked at none.
  struct Found {
    const Arc* arc = nullptr;  // null: none yet
    Real dt = Real(0);         // [s], since the start of the arc
    Real tension = Real(0);    // [N]
  };
  [[nodiscard]] const Found& least() const { return least_; }      // so far
  [[nodiscard]] const Found& largest() const { return largest_; }  // so far

 private:
  [[nodiscard]] Real tension(const Arc& arc, const Real& dt) const {
    return solution_.tensions(arc, dt)[static_cast<Eigen::Index>(cable_)];
  }

  void take(const Arc& arc, const Real& dt, const Real& value) {
    const Real same = same_tension * max(largest_.tension, value);
    if (least_.arc == nullptr || value < least_.tension - same) {
      least_ = {&arc, dt, value};
    }
    if (largest_.arc == nullptr || value > largest_.tension + same) {
      largest_ = {&arc, dt, value};
    }
  }

  /// By golden sections; without an extreme inside, they end at an end.
  void refine(const Arc& arc, Real low, Real high, bool least) {
    constexpr double golden = 0.6180339887498949;
    const double sign = least ? 1.0 : -1.0;
    Real a = high - golden * (high - low);
    Real b = low + golden * (high - low);
    Real at_a = sign * tension(arc, a);
    Real at_b = sign * tension(arc, b);
    const Real known = least ? least_.tension : Real(-largest_.tension);
    const Real promise = 2 * abs(at_a - at_b) + same_tension * abs(known);
    if (min(at_a, at_b) > known + promise) {
      return;  // not near the best so far
    }
    constexpr int enough = 40;  // to the root of rounding
    for (int k = 0; k < enough; ++k) {
      if (at_a < at_b) {
        high = b;
        b = a;
        at_b = at_a;
        a = high - golden * (high - low);
        at_a = sign * tension(arc, a);
      } else {
        low = a;
        a = b;
        at_a = at_b;
        b = low + golden * (high - low);
        at_b = sign * tension(arc, b);
      }
    }
    take(arc, a, Real(sign * at_a));
  }

  const BasicSolution<TheCase>& solution_;
  std::size_t cable_;
  Found least_;
  Found largest_;
};

}  // namespace tautline
