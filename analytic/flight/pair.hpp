#pragma once

#include <tuple>

#include "tautline/detail/scalar.hpp"

namespace tautline {

/// Two numbers of the plane.
template <class V>
struct Pair {
  V x, y;

  static constexpr auto members() { return std::tuple(&Pair::x, &Pair::y); }

  friend Pair operator+(const Pair& a, const Pair& b) { return {a.x + b.x, a.y + b.y}; }
  friend Pair operator-(const Pair& a, const Pair& b) { return {a.x - b.x, a.y - b.y}; }
  friend Pair operator*(const V& s, const Pair& a) { return {s * a.x, s * a.y}; }
};

template <class V>
[[nodiscard]] V dot(const Pair<V>& a, const Pair<V>& b) {
  return a.x * b.x + a.y * b.y;
}

template <class V>
[[nodiscard]] V norm(const Pair<V>& a) {
  return sqrt(V(dot(a, a)));
}

/// `a` turned by +90 degrees.
template <class V>
[[nodiscard]] Pair<V> turned_left(const Pair<V>& a) {
  return {-a.y, a.x};
}

}  // namespace tautline
