#pragma once

#include <tuple>
#include <type_traits>

#include "flight/pair.hpp"

// Sines and cosines in double by arithmetic alone: lanes, which no mathematical library serves with
// the bits that it gives for one number, then have the same as one number has.

namespace tautline {

/// A turn of the body: its sine, and one less its cosine without the loss of digits that the
/// difference has near zero.
template <class V>
struct Turn {
  V sine;
  V versine;
};

/// The direction of the body's own first axis in the world.
template <class V>
struct Direction {
  V cosine;
  V sine;

  static constexpr auto members() { return std::tuple(&Direction::cosine, &Direction::sine); }
};

/// Lanes turn by no more than this [rad].
inline constexpr double farthest_turn = 1e5;

/// At an `angle` [rad] of 1 or more in size; NaN where it is not finite.
[[nodiscard]] Direction<double> far_direction(double angle);

/// By `angle` in [-1, 1] rad: Taylor's series, whose next terms are below 1e-17.
template <class V>
[[nodiscard]] Turn<V> small_turn(const V& angle) {
  const V x = angle * angle;
  const V x2 = x * x;
  const V x4 = x2 * x2;
  const V odd = (-1.0 / 6 + x * (1.0 / 120)) + x2 * (-1.0 / 5'040 + x * (1.0 / 362'880)) +
                x4 * ((-1.0 / 39'916'800 + x * (1.0 / 6'227'020'800)) +
                      x2 * (-1.0 / 1'307'674'368'000 + x * (1.0 / 355'687'428'096'000)));
  const V even = (1.0 / 24 - x * (1.0 / 720)) + x2 * (1.0 / 40'320 - x * (1.0 / 3'628'800)) +
                 x4 * ((1.0 / 479'001'600 - x * (1.0 / 87'178'291'200)) +
                       x2 * (1.0 / 20'922'789'888'000 - x * (1.0 / 6'402'373'705'728'000)));
  return {angle + angle * x * odd, 0.5 * x - x2 * even};
}

/// The integer next to `v`, which is smaller than 2^51 in size.
template <class V>
[[nodiscard]] V nearest(const V& v) {
  constexpr double shift = 0x1.8p52;  // numbers of this size have no digits after the point
  return (v + shift) - shift;
}

/// The direction `rest` [rad], at most an eighth of a turn, beyond `k` quarters, -2 to 2.
template <class V>
[[nodiscard]] Direction<V> beyond_quarters(const V& k, const V& rest) {
  const auto [sine, versine] = small_turn(rest);
  const V cosine = 1.0 - versine;
  const auto left = k == V(1);
  const auto right = k == V(-1);
  const auto odd = left || right;
  const V x = select(odd, sine, cosine);
  const V y = select(odd, cosine, sine);
  const auto back = V(abs(k)) == V(2);
  return {select(left || back, V(-x), x), select(right || back, V(-y), y)};
}

/// The direction at `angle` [rad], in lanes at most `farthest_turn` in size: within an eighth of a
/// turn by `small_turn`, the rest by quarters (W. J. Cody and W. Waite's reduction: the first two
/// parts of pi / 2 have 33 binary digits, so that their products with the number of quarters are
/// exact).
template <class V>
[[nodiscard]] Direction<V> direction(const V& angle) {
  if constexpr (std::is_same_v<V, double>) {
    if (!(abs(angle) <= farthest_turn)) {
      return far_direction(angle);
    }
  }
  constexpr double quarters = 0.63661977236758134308;  // a radian
  constexpr double part_1 = 1.57079632673412561417e+00;
  constexpr double part_2 = 6.07710050630396597660e-11;
  constexpr double part_3 = 2.02226624879595063154e-21;
  const V n = nearest(V(angle * quarters));
  const V k = n - 4.0 * nearest(V(n * 0.25));
  return beyond_quarters(k, V(((angle - n * part_1) - n * part_2) - n * part_3));
}

/// A turn by `angle` [rad], in lanes at most `farthest_turn` in size.
template <class V>
[[nodiscard]] Turn<V> turn(const V& angle) {
  if constexpr (std::is_same_v<typename NumberOf<V>::type, double>) {
    const auto near = V(abs(angle)) <= V(1);
    if (!any(!near)) {
      return small_turn(angle);
    }
    const Turn<V> small = small_turn(select(near, angle, V(0)));
    const Direction<V> far = direction(angle);
    return {select(near, small.sine, far.sine), select(near, small.versine, V(1.0 - far.cosine))};
  } else {
    const V half = sin(V(angle / 2));
    return {2 * half * cos(V(angle / 2)), 2 * half * half};
  }
}

}  // namespace tautline
