#pragma once

#include <cstddef>
#include <vector>

#include "box_forces.hpp"
#include "tautline/case.hpp"

// What a cable is during an impact under Stronge's law (energetic_impact.hpp).
namespace tautline::energetic {

/// Of velocities, and of times, against those of the whole impact [-]: some ten steps of a few ulp.
template <class Real>
[[nodiscard]] Real rounding() {
  return 32 * epsilon<Real>();
}

enum class Mode {
  slack,      // no force
  loading,    // force = compression, the largest so far
  returning,  // below the largest compression, along the steep line
  held,       // e = 0 only: at rest at the largest compression, force from 0 to the largest
};

/// One cable during the impact, in units in which velocities and rows are near one.
template <class TheCase>
struct Spring {
  using Real = RealOf<TheCase>;

  RowOf<TheCase> row;  // its gap's gradient over the root of the mass
  Real returned;       // [-], restitution squared
  Mode mode = Mode::slack;
  Real largest = Real(0);  // force so far
  Real value = Real(0);    // its force; while slack the way left until it pulls
  Real rate = Real(0);     // of its gap; exactly zero within rounding
  Real impulse = Real(0);
  bool fixed = false;   // by the held ones, on whose rows its own depends
  bool caught = false;  // it would close from rest at its edge: it pulls
  int stalls = 0;
  std::vector<Real> series = {};  // of `value`

  [[nodiscard]] bool acts() const { return mode == Mode::loading || mode == Mode::returning; }
  /// d value / d compression.
  [[nodiscard]] Real slope() const {
    return mode == Mode::slack ? Real(-1) : mode == Mode::loading ? Real(1) : Real(1 / returned);
  }
  /// At rest at the largest compression, with a force that may be anything up to the largest.
  [[nodiscard]] bool at_edge() const {
    return returned == 0 && largest > 0 &&
           (mode == Mode::held ||
            (rate == 0 && (mode == Mode::loading || (mode == Mode::slack && value == 0))));
  }
};

/// The value of a series at `t`.
template <class Real>
[[nodiscard]] Real value_of(const std::vector<Real>& series, const Real& t) {
  Real value(0);
  for (std::size_t k = series.size(); k-- > 0;) {
    value = value * t + series[k];
  }
  return value;
}

/// Its integral from 0 to `t`.
template <class Real>
[[nodiscard]] Real integral_of(const std::vector<Real>& series, const Real& t) {
  Real value(0);
  for (std::size_t k = series.size(); k-- > 0;) {
    value = value * t + series[k] / static_cast<double>(k + 1);
  }
  return value * t;
}

/// As many terms as a series needs whose k-th is below 1 / k!.
template <class Real>
[[nodiscard]] std::size_t enough_terms() {
  std::size_t terms = 4;
  for (Real last = Real(1) / 6; last > epsilon<Real>() / 8; ++terms) {
    last /= static_cast<double>(terms);
  }
  return terms;
}

}  // namespace tautline::energetic
