#pragma once

#include <algorithm>
#include <cmath>
#include <limits>
#include <optional>

namespace tautline {

/// A function of time at one instant, with its first two derivatives.
struct Sample {
  double value;
  double rate;
  double curvature;
};

/// What is known about a function where a search starts, better than its rounded sample says.
struct SearchStart {
  bool at_zero = false;  // the value is exactly zero
};

/// What a search for the first root found.
struct RootSearch {
  std::optional<double> root;  // none: no root in [0, horizon]; NaN: unknown, numbers overflowed
  int steps = 0;               // evaluations of the function, the measure of work
};

/// The smallest t >= 0 with value + rate t - bend t^2 / 2 = 0, infinite if there is none.
/// Requires value >= 0. Each branch adds two numbers of one sign, so nothing cancels.
[[nodiscard]] inline double first_quadratic_root(double value, double rate, double bend) {
  const double discriminant = rate * rate + 2.0 * bend * value;
  if (discriminant < 0.0 || (bend <= 0.0 && rate >= 0.0)) {
    return std::numeric_limits<double>::infinity();
  }
  const double root = std::sqrt(discriminant);
  return rate >= 0.0 ? (rate + root) / bend : 2.0 * value / (root - rate);
}

/// A step from `now` at time s, at most `window`, before whose end f has no root.
///
/// Proof. On [s, s + w] let |f'''| <= J and c = f''(s). Then f'' >= c - J w there, so by Taylor
/// f(s + t) >= f + f' t - (J w - c) t^2 / 2 for t <= w, and f has no root before the smaller of w
/// and the root of the right-hand side. Any w gives a valid step; the loop looks for a long one.
template <class Function>
[[nodiscard]] double safe_step(const Function& f, const Sample& now, double s, double window) {
  const auto reach = [&](double w) {
    return first_quadratic_root(now.value, now.rate, f.jerk_bound(s, w) * w - now.curvature);
  };
  double trial = std::min(window, first_quadratic_root(now.value, now.rate, -now.curvature));
  // at the best w both limits agree; the geometric mean closes three quarters of the log distance.
  // From a graze the right-hand side has its root at zero unless w is small: never all the way
  constexpr double least = std::numeric_limits<double>::epsilon();
  for (int refinement = 0; refinement < 3; ++refinement) {
    const double found = reach(trial);
    if (found >= trial) {
      return trial;
    }
    trial = std::sqrt(trial * std::max(found, least * trial));
  }
  return std::min(trial, reach(trial));
}

/// True where Newton's method from `now` must converge to the first root after s.
///
/// Kantorovich: with |f''| <= M on [s, s + 2 f/|f'|] and M f <= f'^2 / 2 there is exactly one root
/// in that interval, and Newton started at s converges to it. A quarter instead of a half saves
/// steps.
template <class Function>
[[nodiscard]] bool newton_is_certain(const Function& f, const Sample& now, double s) {
  if (now.rate >= 0.0) {
    return false;
  }
  const double width = -2.0 * now.value / now.rate;
  const double bound = std::abs(now.curvature) + f.jerk_bound(s, width) * width;
  return bound * now.value <= 0.25 * now.rate * now.rate;
}

/// Newton's method with the second derivative, inside its certified region: each correction is the
/// first root of the Taylor parabola, at most 2 f/|f'|, until one no longer changes the time.
template <class Function>
[[nodiscard]] double finish_by_newton(const Function& f, Sample now, double s, int& steps) {
  constexpr int enough = 8;  // cubic from 1/4: four reach the last bit, the rest is rounding
  for (int iteration = 0; iteration < enough; ++iteration) {
    const double bend = 2.0 * now.curvature * now.value;
    const double slope = std::sqrt(std::max(0.0, now.rate * now.rate - bend));
    const double correction = 2.0 * now.value / (slope - now.rate);
    const double size = std::abs(correction);
    // f there is at most J size^3 / 6 and |f'| at least half its size here: below rounding of the
    // time there is nothing to gain
    const bool done = f.jerk_bound(s, size) * size * size * size <=
                      3.0 * std::numeric_limits<double>::epsilon() * s * std::abs(now.rate);
    s += correction;
    if (done) {
      break;
    }
    now = f.at(s);
    ++steps;
  }
  return s;
}

/// The first time in [0, horizon] at which f, which starts >= 0, falls through zero.
///
/// Conservative advancement: every step is one `safe_step`, so the search never passes a root, from
/// the left and at second order or better; within rounding of a simple root Newton finishes.
/// From a start at zero only a later return counts, unless f is falling at once. A value <= 0 that
/// is rising is rounding: f touches zero and leaves (a graze), which is no root. Where f stays
/// within rounding of zero the steps double, so the search ends there too. Where a sample or a
/// bound is too large for a double the root is NaN, never none.
///
/// `Function` offers at(s) -> Sample, and jerk_bound(s, w), an upper bound of |f'''| on [s, s + w]
/// as long as f >= 0 there; it must not shrink when w grows.
template <class Function>
[[nodiscard]] RootSearch first_root(const Function& f, double horizon, SearchStart start = {}) {
  RootSearch search;
  double s = 0.0;
  Sample now = f.at(s);
  search.steps = 1;
  if (start.at_zero) {
    now.value = 0.0;
  }
  double least_step = 0.0;
  const auto unknown = [&search] {
    search.root = std::numeric_limits<double>::quiet_NaN();
    return search;
  };
  while (true) {
    // their sum is finite only where each is
    if (!std::isfinite(now.value + now.rate + now.curvature)) {
      return unknown();
    }
    if (now.value <= 0.0) {
      if (now.rate < 0.0 || (now.rate == 0.0 && now.curvature < 0.0)) {
        search.root = s;
        return search;
      }
      now.value = 0.0;
    } else if (newton_is_certain(f, now, s)) {
      const double root = finish_by_newton(f, now, s, search.steps);
      if (!std::isfinite(root)) {
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
    double step = safe_step(f, now, s, horizon - s);
    if (!std::isfinite(step)) {
      return unknown();
    }
    if (s + step == s) {  // below the resolution of time
      if (!std::isfinite(f.jerk_bound(s, 0.0))) {
        return unknown();
      }
      step = std::max(std::nextafter(s, horizon) - s, 2.0 * least_step);
      least_step = step;
    }
    s = std::min(horizon, s + step);
    now = f.at(s);
    ++search.steps;
  }
}

}  // namespace tautline
