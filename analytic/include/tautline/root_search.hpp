#pragma once

#include <algorithm>
#include <cmath>
#include <limits>
#include <optional>

#include "tautline/scalar.hpp"

namespace tautline {

/// A function of time at one instant, with its first two derivatives.
template <class Real>
struct BasicSample {
  Real value;
  Real rate;
  Real curvature;
};
using Sample = BasicSample<double>;

/// What is known about a function where a search starts, better than its rounded sample says.
struct SearchStart {
  bool at_zero = false;  // the value is exactly zero
};

/// What a search for the first root found.
template <class Real>
struct BasicRootSearch {
  std::optional<Real> root;  // none: no root in [0, horizon]; NaN: unknown, numbers overflowed
  int steps = 0;             // evaluations of the function, the measure of work
};
using RootSearch = BasicRootSearch<double>;

/// The smallest t >= 0 with value + rate t - bend t^2 / 2 = 0, infinite if there is none.
/// Requires value >= 0. Each branch adds two numbers of one sign, so nothing cancels.
template <class Real>
[[nodiscard]] Real first_quadratic_root(const Real& value, const Real& rate, const Real& bend) {
  const Real discriminant = rate * rate + 2 * bend * value;
  if (discriminant < 0 || (bend <= 0 && rate >= 0)) {
    return infinity<Real>();
  }
  const Real root = sqrt(discriminant);
  return rate >= 0 ? Real((rate + root) / bend) : Real(2 * value / (root - rate));
}

/// A step from `now` at time s, at most `window`, before whose end f has no root (Eq. 13).
///
/// Proof. On [s, s + w] let |f'''| <= J and c = f''(s). Then f'' >= c - J t there, so by Taylor
/// f(s + t) >= f + f' t + c t^2 / 2 - J t^3 / 6 >= f + f' t - (J w / 3 - c) t^2 / 2 for t <= w, and
/// f has no root before the smaller of w and the root of the right-hand side. Any w is valid.
template <class Function, class Real>
[[nodiscard]] Real safe_step(const Function& f, const BasicSample<Real>& now, const Real& s,
                             const Real& window) {
  const auto reach = [&](const Real& w) {
    return first_quadratic_root<Real>(now.value, now.rate,
                                      f.jerk_bound(s, w) * w / 3 - now.curvature);
  };
  Real trial = min(window, first_quadratic_root<Real>(now.value, now.rate, -now.curvature));
  // at the best w both limits agree; a geometric mean closes three quarters of the log distance.
  // From a graze the right-hand side has its root at zero unless w is small: never all the way
  const Real least = epsilon<Real>();
  for (int refinement = 0; refinement < 3; ++refinement) {
    const Real found = reach(trial);
    if (2 * found >= trial) {  // near enough
      return min(trial, found);
    }
    trial = sqrt(Real(trial * max(found, Real(least * trial))));
  }
  return min(trial, reach(trial));
}

/// True where Newton's method from `now` must converge to the first root after s.
///
/// Kantorovich: with |f''| <= M on [s, s + 2 f/|f'|] and M f <= f'^2 / 2 there is exactly one root
/// in that interval, and Newton started at s converges to it. A quarter instead of a half saves
/// steps.
template <class Function, class Real>
[[nodiscard]] bool newton_is_certain(const Function& f, const BasicSample<Real>& now,
                                     const Real& s) {
  if (now.rate >= 0) {
    return false;
  }
  const Real width = -2 * now.value / now.rate;
  const Real bound = abs(now.curvature) + f.jerk_bound(s, width) * width;
  return 4 * bound * now.value <= now.rate * now.rate;
}

/// Newton's method with the second derivative, inside its certified region: each correction is the
/// first root of the Taylor parabola, at most 2 f/|f'|, until one no longer changes the time.
template <class Function, class Real>
[[nodiscard]] Real finish_by_newton(const Function& f, BasicSample<Real> now, Real s, int& steps) {
  constexpr int enough = 8;  // cubic from 1/4: four reach a double's last bit, six 100 digits
  for (int iteration = 0; iteration < enough; ++iteration) {
    const Real bend = 2 * now.curvature * now.value;
    const Real slope = sqrt(max(Real(0), Real(now.rate * now.rate - bend)));
    const Real correction = 2 * now.value / (slope - now.rate);
    const Real size = abs(correction);
    // f there is at most J size^3 / 6 and |f'| at least half its size here: below rounding of the
    // time there is nothing to gain
    const bool done =
        f.jerk_bound(s, size) * size * size * size <= 3 * epsilon<Real>() * s * abs(now.rate);
    s += correction;
    if (done) {
      break;
    }
    now = f.at(s);
    ++steps;
  }
  return s;
}

/// After so many steps f is within rounding of zero all the way: roots 1e-7 apart take under a
/// hundred [-].
inline constexpr int most_fine_steps = 1000;

/// The first time in [0, horizon] at which f, which starts >= 0, falls through zero.
///
/// Conservative advancement: every step is one `safe_step`, so the search never passes a root, from
/// the left and at second order or better; within rounding of a simple root Newton finishes.
/// From a start at zero only a later return counts, unless f is falling at once. A value <= 0 that
/// is rising is rounding: f touches zero and leaves (a graze), which is no root. Where f stays
/// within rounding of zero, below the resolution of time or for very many steps, the steps double,
/// so the search ends there too. Where a sample or a
/// bound is too large for a double the root is NaN, never none.
///
/// `Function` offers at(s) -> Sample, and jerk_bound(s, w), an upper bound of |f'''| on [s, s + w]
/// as long as f >= 0 there; it must not shrink when w grows. It may offer clear(s, w), a time up to
/// w from s on in which it knows of no root, where it oscillates many times before the first.
template <class Function, class Real>
[[nodiscard]] BasicRootSearch<Real> first_root(const Function& f, const Real& horizon,
                                               SearchStart start = {}) {
  BasicRootSearch<Real> search;
  Real s(0);
  BasicSample<Real> now = f.at(s);
  search.steps = 1;
  if (start.at_zero) {
    now.value = Real(0);
  }
  Real least_step(0);
  const auto unknown = [&search] {
    search.root = not_a_number<Real>();
    return search;
  };
  while (true) {
    // their sum is finite only where each is
    if (!isfinite(Real(now.value + now.rate + now.curvature))) {
      return unknown();
    }
    if (now.value <= 0) {
      if (now.rate < 0 || (now.rate == 0 && now.curvature < 0)) {
        search.root = s;
        return search;
      }
      now.value = Real(0);
    } else if (newton_is_certain(f, now, s)) {
      const Real root = finish_by_newton(f, now, s, search.steps);
      if (!isfinite(root)) {
        return unknown();
      }
      if (root <= horizon) {
        search.root = root;
      }
      return search;
    }
    if (s >= horizon) {
      return search;
    }
    Real step = safe_step(f, now, s, Real(horizon - s));
    if (!isfinite(step)) {
      return unknown();
    }
    if constexpr (requires { f.clear(s, step); }) {
      step = max(step, Real(f.clear(s, Real(horizon - s))));
    }
    if (s + step == s || search.steps > most_fine_steps) {  // not to be resolved
      if (!isfinite(f.jerk_bound(s, Real(0)))) {
        return unknown();
      }
      const Real finest = epsilon<Real>() * max(s, Real(epsilon<Real>() * horizon));
      step = max({step, finest, Real(2 * least_step)});
      least_step = step;
    }
    s = min(horizon, Real(s + step));
    now = f.at(s);
    ++search.steps;
  }
}

}  // namespace tautline
