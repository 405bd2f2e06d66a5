#pragma once

#include <optional>
#include <vector>

#include "tautline/solution.hpp"
#include "tautline/system.hpp"

namespace tautline {

/// A contact of an elastic cable: it pulls all the time from its entry to its exit.
template <class Real>
struct BasicElasticContact {
  std::size_t cable;              // index
  Real entry = Real(0);           // [s]
  std::optional<Real> exit = {};  // [s]; none: it pulls until the end of the run
  Real entry_speed = Real(0);     // [m/s], at which it is stretched at the entry
  /// [m/s], at which it shrinks at the exit; below 0 where it is cut while it still stretches, 0 if
  /// there is no exit.
  Real exit_speed = Real(0);
  Real peak = Real(0);              // [N], the largest tension
  Real peak_time = Real(0);         // [s], of that
  Real greatest_stretch = Real(0);  // [m]
  Real impulse = Real(0);           // [N s], the integral of the tension, up to the end of the run
};
using ElasticContact = BasicElasticContact<double>;

/// All contacts of `solution`, by rising entry. Peaks are roots of the rates of tension and stretch
/// along the arcs, to rounding.
template <class Real, int D>
[[nodiscard]] std::vector<BasicElasticContact<Real>> elastic_contacts(
    const BasicSolution<BasicSystem<Real, D>>& solution);

}  // namespace tautline
