// A host engine's step, split at the instants at which cables go taut. Bullet's and ODE's drop-in
// cables share it; it knows neither, and needs C++11 alone.
//
// A Host flies its whole world: `host.fly(dt)`. A Cable is one of its cables:
//   bool flies()                   slack, so that its next impact is an event
//   Real gap(), rate()             now [m], [m/s]
//   Real gap_after(dt)             if nothing but the forces acts, <= one step ahead [m]
//   Real tolerance()               the gap that counts as zero [m]
//   Real inverse_mass()            J M^-1 J^T, now [1/kg]
//   void apply(impulse)            changes the velocities of its ends now, impulse [N s]
//   bool is_impact(closing), Real rebound(closing)   see CableRule; [m/s]
//   void struck(impulse), hold(), release()

#pragma once

#include <algorithm>
#include <cmath>
#include <limits>
#include <vector>

namespace tautline {

/// The first time in (0, dt] at which `cable` runs out of gap, located to rounding; `dt` if it does
/// not. A cable that runs out twice within `dt` and is slack at its end is not seen.
template <typename Real, typename Cable>
Real time_to_taut(Cable& cable, Real dt) {
  Real slack = 0;
  Real taut = dt;
  if (cable.gap_after(dt) >= 0) {
    return dt;
  }
  // halving: a cable that was just struck starts from a gap of rounding, of either sign
  const int halvings = std::numeric_limits<Real>::digits;
  for (int done = 0; done < halvings; ++done) {
    const Real middle = (slack + taut) / 2;
    (cable.gap_after(middle) < 0 ? taut : slack) = middle;
  }
  return taut;
}

/// Solves the impacts of all `cables` at this pose at once, by Gauss-Seidel over their rows:
/// 0 <= impulse, rate >= wanted, one of the two with equality.
template <typename Real, typename Cable>
void solve_impacts(std::vector<Cable>& cables) {
  struct Row {
    Cable* cable;
    Real wanted;        // [m/s]
    Real inverse_mass;  // [1/kg]
    Real impulse;       // [N s]
    bool struck;
  };
  std::vector<Row> rows;
  Real fastest = 0;  // [m/s]
  for (Cable& cable : cables) {
    if (cable.gap() > cable.tolerance()) {
      continue;
    }
    const Real rate = cable.rate();
    const bool struck = cable.is_impact(-rate);
    // one that rests, or opens, is not to close faster than it does
    const Real wanted = struck ? cable.rebound(-rate) : std::min(rate, Real(0));
    rows.push_back(Row{&cable, wanted, cable.inverse_mass(), Real(0), struck});
    fastest = std::max(fastest, struck ? -rate : Real(0));
  }
  if (!(fastest > 0)) {
    return;
  }
  const int passes = 1000;  // one row takes two; nearly dependent ones, some hundreds
  Real change = fastest;
  for (int pass = 0; pass < passes && change > std::numeric_limits<Real>::epsilon() * fastest;
       ++pass) {
    change = 0;
    for (Row& row : rows) {
      const Real missing = row.wanted - row.cable->rate();
      const Real impulse = std::max(Real(0), row.impulse + missing / row.inverse_mass);
      change = std::max(change, std::abs(impulse - row.impulse) * row.inverse_mass);
      row.cable->apply(impulse - row.impulse);
      row.impulse = impulse;
    }
  }
  for (const Row& row : rows) {
    row.cable->struck(row.impulse);
    if (row.struck) {
      row.wanted > 0 ? row.cable->release() : row.cable->hold();
    }
  }
}

/// Steps the world by `dt` [s] in at most `most` + 1 parts, each ending where a slack cable goes
/// taut; impacts are solved there, in no time. What is left after `most` parts is one part, before
/// which a cable that has no more than rounding left to rebound is held taut. Returns the number
/// of parts.
template <typename Real, typename Host, typename Cable>
int step_by_events(Host& host, std::vector<Cable>& cables, Real dt, int most) {
  // in a step of rounding, engines do nothing or worse; an instant that close to a part's end is it
  const Real shortest = dt * Real(1e-4);
  solve_impacts<Real>(cables);  // of cables that were pulled taut between two steps
  Real left = dt;
  int parts = 0;
  while (left > 0) {
    Real part = left;
    for (Cable& cable : cables) {
      if (!cable.flies()) {
        continue;
      }
      if (parts < most) {
        part = std::min(part, std::max(shortest, time_to_taut(cable, part)));
      } else if (cable.gap() <= cable.tolerance() && cable.gap_after(part) < 0) {
        cable.hold();
      }
    }
    if (left - part <= shortest) {
      part = left;
    }
    host.fly(part);
    left -= part;
    ++parts;
    solve_impacts<Real>(cables);
  }
  return parts;
}

}  // namespace tautline
