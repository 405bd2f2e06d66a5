#pragma once

#include <algorithm>
#include <cmath>
#include <limits>
#include <optional>

#include "tautline/detail/scalar.hpp"

namespace tautline {

// `Real` is one number, or several side by side of as many functions (scalar.hpp).

/// A function of time at one instant, with its first three derivatives.
template <class Real>
struct BasicSample {
  Real value;
  Real rate;
  Real curvature;
  Real jerk;
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

/// As a factor, rounded up: a division takes several times as long.
inline constexpr double third = 0x1.5555555555556p-2;

/// The smallest t >= 0 with value + rate t - bend t^2 / 2 = 0, infinite if there is none.
/// Requires value >= 0. Each branch adds two numbers of one sign, so nothing cancels.
template <class Real>
[[nodiscard]] Real first_quadratic_root(const Real& value, const Real& rate, const Real& bend) {
  const Real discriminant = rate * rate + 2 * bend * value;
  const auto rising = rate >= Real(0);
  const auto none = discriminant < Real(0) || (rising && bend <= Real(0));
  const Real root = sqrt(select(none, Real(0), discriminant));
  const Real top = select(rising, Real(rate + root), Real(2 * value));
  const Real bottom = select(rising, bend, Real(root - rate));
  return select(none, infinity<Real>(), Real(top / bottom));
}

/// A step from `now` at time s, at most `window`, before whose end f has no root (Eq. 13).
///
/// Proof. On [s, s + w] let |f''''| <= Q, and c = f''(s), j = f'''(s). By Taylor f(s + t) >= f + f'
/// t
/// + c t^2 / 2 + j t^3 / 6 - Q t^4 / 24 >= f + f' t - (max(0, -j) w / 3 + Q w^2 / 12 - c) t^2 / 2
/// for t <= w, and f has no root before the smaller of w and the root of the right-hand side. Any w
/// is valid.
template <class Function, class Real>
[[nodiscard]] Real safe_step(const Function& f, const BasicSample<Real>& now, const Real& s,
                             const Real& window) {
  const Real falling = most(Real(0), Real(-now.jerk)) * third;
  const auto reach = [&](const Real& w) {
    return first_quadratic_root<Real>(
        now.value, now.rate, (falling + f.snap_bound(s, w) * w * (third / 4)) * w - now.curvature);
  };
  Real trial = least(window, first_quadratic_root<Real>(now.value, now.rate, -now.curvature));
  // at the best w both limits agree; a geometric mean closes three quarters of the log distance.
  // From a graze the right-hand side has its root at zero unless w is small: never all the way
  Real found = reach(trial);
  auto far = !(2 * found >= trial);
  for (int refinement = 1; refinement <= 3 && any(far); ++refinement) {
    const Real mean = sqrt(Real(trial * most(found, Real(epsilon<Real>() * trial))));
    trial = select(far, mean, trial);
    found = select(far, reach(trial), found);
    far = far && !(2 * found >= trial);
  }
  return least(trial, found);
}

/// True where Newton's method from `now` must converge to the first root after it. Over a time w
/// the second derivative is at most `bend(w)` in size.
///
/// Kantorovich: with |f''| <= M over 2 f/|f'| and M f <= f'^2 / 2 there is exactly one root in that
/// time, and Newton started at its begin converges to it. A quarter instead of a half saves steps.
template <class Real, class Bend>
[[nodiscard]] auto newton_is_certain(const BasicSample<Real>& now, const Bend& bend) {
  // the derivatives at s alone say no to most
  auto certain =
      now.rate < Real(0) && 4 * abs(now.curvature) * now.value <= Real(now.rate * now.rate);
  if (any(certain)) {
    const Real width = -2 * now.value / now.rate;
    certain = certain && 4 * bend(width) * now.value <= Real(now.rate * now.rate);
  }
  return certain;
}

/// Of f at time s.
template <class Function, class Real>
[[nodiscard]] auto newton_is_certain(const Function& f, const BasicSample<Real>& now,
                                     const Real& s) {
  return newton_is_certain(now, [&](const Real& w) {
    return Real(abs(now.curvature) + (abs(now.jerk) + f.snap_bound(s, w) * w / 2) * w);
  });
}

/// Where f starts at zero and rises, of what is left of it with that root divided out: g(s) =
/// f(s) / s, the integral of f'(s u) over u from 0 to 1, has f', f''/2 and f'''/3 at the start, and
/// |g'''| <= Q / 4 where |f''''| <= Q.
template <class Real>
[[nodiscard]] BasicSample<Real> without_first_root(const BasicSample<Real>& start) {
  return {start.rate, start.curvature / 2, start.jerk * third, Real(0)};
}

/// Of that, at the start.
template <class Function, class Real>
[[nodiscard]] auto newton_is_certain_of_return(const Function& f, const BasicSample<Real>& g) {
  return newton_is_certain(
      g, [&](const Real& w) { return Real(abs(g.curvature) + f.snap_bound(Real(0), w) * w / 4); });
}

/// Newton's method with the third derivative, inside its certified region, until a correction no
/// longer changes the time. Each is the first root of the Taylor parabola, at most 2 f/|f'|, and
/// from there one step of Newton's to that of the Taylor cubic. In the lanes `open`; the others
/// stay at `s`. `now` may be of f(s) / s, with the same root: it is within a twentieth then, where
/// Newton's method is certain of f, too.
template <class Function, class Real, class Mask>
[[nodiscard]] Real finish_by_newton(const Function& f, BasicSample<Real> now, Real s, Mask open,
                                    int& steps) {
  constexpr int enough = 8;  // of fourth order: three reach a double's last bit, five 100 digits
  for (int iteration = 0; iteration < enough; ++iteration) {
    const Real bend = 2 * now.curvature * now.value;
    const Real slope = sqrt(most(Real(0), Real(now.rate * now.rate - bend)));
    const Real parabolic = 2 * now.value / (slope - now.rate);
    const Real cubic = now.jerk * parabolic * parabolic;
    const Real further = cubic * parabolic / (6 * slope - 3 * cubic);
    // f there is at most what is left of the cubic, and Q t^4 / 24, and |f'| at least half its size
    // here: below rounding of the time there is nothing to gain
    const Real size = abs(parabolic) + abs(further);
    const Real square = size * size;
    const Real left = 12 * (abs(now.curvature) + abs(now.jerk) * size) * further * further +
                      f.snap_bound(s, size) * square * square;
    const Mask done = left <= Real(12 * epsilon<Real>() * s * abs(now.rate));
    s = select(open, Real(s + (parabolic + further)), s);
    open = open && !done;
    if (!any(open)) {
      break;
    }
    now = f.at(s);
    ++steps;
  }
  return s;
}

/// f at 0, by a shorter way where it offers one.
template <class Real, class Function>
[[nodiscard]] BasicSample<Real> sample_at_start(const Function& f) {
  if constexpr (requires { f.at_start(); }) {
    return f.at_start();
  } else {
    return f.at(Real(0));
  }
}

/// After so many steps f is within rounding of zero all the way: roots 1e-7 apart take under a
/// hundred [-].
inline constexpr int most_fine_steps = 1000;

/// A step may lead out of the search's horizon by a little, so that none ends on it [-].
inline constexpr double beyond = 1.0 + 1e-9;

/// What searches side by side found, each for its own first root.
template <class Real>
struct FirstRoots {
  Real root;      // infinite: none up to the horizon; NaN: unknown, numbers overflowed
  int steps = 0;  // evaluations of the functions
};

/// As `first_roots`. `may_return`: where Newton may finish from a start at zero.
template <class Function, class Real, class Mask>
[[nodiscard]] FirstRoots<Real> search_first_roots(const Function& f, const Real& horizon,
                                                  const Mask& at_zero, const Mask& may_return) {
  FirstRoots<Real> result{infinity<Real>(), 1};
  Real s(0);
  BasicSample<Real> now = sample_at_start<Real>(f);
  now.value = select(at_zero, Real(0), now.value);
  Real least_step(0);
  Mask open(true);      // still on its way
  Mask certain(false);  // at a simple root, from where Newton finishes
  BasicSample<Real> at_root = without_first_root(now);
  Real root_near(0);
  const auto end = [&](const Mask& where, const Real& root) {
    result.root = select(where, root, result.root);
    open = open && !where;
  };
  if (any(may_return)) {  // a short flight returns where its start says
    certain = may_return && at_root.value > Real(0) && newton_is_certain_of_return(f, at_root);
    open = !certain;
  }
  while (any(open)) {
    // their sum is finite only where each is
    end(open && !is_finite(Real(now.value + now.rate + now.curvature + now.jerk)),
        not_a_number<Real>());
    const Mask low = now.value <= Real(0);
    const Mask falling = now.rate < Real(0) || (now.rate == Real(0) && now.curvature < Real(0));
    end(open && low && falling, s);
    now.value = select(low, Real(0), now.value);
    const Mask newton = open && !low && newton_is_certain(f, now, s);
    if (any(newton)) {
      at_root.value = select(newton, now.value, at_root.value);
      at_root.rate = select(newton, now.rate, at_root.rate);
      at_root.curvature = select(newton, now.curvature, at_root.curvature);
      at_root.jerk = select(newton, now.jerk, at_root.jerk);
      root_near = select(newton, s, root_near);
      certain = certain || newton;
      open = open && !newton;
    }
    open = open && s < horizon;
    if (!any(open)) {
      break;
    }
    const Real rest = horizon - s;
    Real step = safe_step(f, now, s, Real(beyond * rest));
    if constexpr (requires { f.clear(s, step); }) {
      step = most(step, Real(f.clear(s, rest)));
    }
    const Mask fine = open && (s + step == s || Mask(result.steps > most_fine_steps));
    if (any(fine)) {  // not to be resolved
      end(fine && !is_finite(f.snap_bound(s, Real(0))), not_a_number<Real>());
      const Real finest = epsilon<Real>() * most(s, Real(epsilon<Real>() * horizon));
      const Real coarser = most(most(step, finest), Real(2 * least_step));
      step = select(fine, least(coarser, rest), step);
      least_step = select(fine, step, least_step);
    }
    end(open && !is_finite(step), not_a_number<Real>());
    open = open && step <= rest;
    if (!any(open)) {
      break;
    }
    s = select(open, Real(s + step), s);
    now = f.at(s);
    ++result.steps;
  }
  if (any(certain)) {
    const Real root = finish_by_newton(f, at_root, root_near, certain, result.steps);
    const Real within = select(root <= horizon, root, infinity<Real>());
    const Real found = select(is_finite(root), within, not_a_number<Real>());
    result.root = select(certain, found, result.root);
  }
  return result;
}

/// The same without a return that is certain from the start.
template <class Function, class Real, class Mask>
[[nodiscard, gnu::noinline]] FirstRoots<Real> step_to_first_roots(const Function& f,
                                                                  const Real& horizon,
                                                                  const Mask& at_zero) {
  return search_first_roots(f, horizon, at_zero, Mask(false));
}

/// The first time in [0, horizon] at which f, which starts >= 0, falls through zero.
///
/// Conservative advancement: every step is one `safe_step`, so the search never passes a root, from
/// the left and at second order or better; near a simple root Newton finishes. From a start at zero
/// only a later return counts, unless f is falling at once; Newton finishes from there where the
/// return is certain (`without_first_root`). A value <= 0 that is rising is rounding: f touches
/// zero and leaves (a graze), which is no root. Where f stays within rounding of zero, below the
/// resolution of time or for very many steps, the steps double, so the search ends there too. Where
/// a sample or a bound is too large for a double the root is NaN, never none.
///
/// `Function` offers at(s) -> Sample, and snap_bound(s, w), an upper bound of |f''''| on [s, s + w]
/// as long as f >= 0 there; it must not shrink when w grows. It may offer at_start(), the same as
/// at(0), and clear(s, w), a time up to w from s on in which it knows of no root, where it
/// oscillates many times before the first.
template <class Function, class Real, class Mask>
[[nodiscard]] FirstRoots<Real> first_roots(const Function& f, const Real& horizon,
                                           const Mask& at_zero) {
  FirstRoots<Real> result = search_first_roots(f, horizon, at_zero, at_zero);
  // Newton's method gets lost where the start rises by no more than rounding, or squares overflow
  const Mask lost = at_zero && !(result.root > Real(0));
  if (any(lost)) {
    const FirstRoots<Real> stepped = step_to_first_roots(f, horizon, at_zero);
    result.root = select(lost, stepped.root, result.root);
    result.steps += stepped.steps;
  }
  return result;
}

/// Of one function.
template <class Function, class Real>
[[nodiscard]] BasicRootSearch<Real> first_root(const Function& f, const Real& horizon,
                                               SearchStart start = {}) {
  const FirstRoots<Real> found = first_roots(f, horizon, start.at_zero);
  const bool none = found.root == infinity<Real>();
  return {none ? std::nullopt : std::optional<Real>(found.root), found.steps};
}

}  // namespace tautline
