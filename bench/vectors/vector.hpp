#pragma once

#include <array>
#include <cstddef>
#include <optional>
#include <string>
#include <vector>

#include "tautline/case.hpp"
#include "tautline/impact.hpp"
#include "tautline/solution.hpp"

namespace tautline::bench {

/// An instant of the exact motion: a sample, or an event with the state after it.
struct VectorRow {
  double time = 0.0;              // [s]
  std::optional<EventKind> kind;  // none: a sample
  std::array<double, 6> state{};  // x, y, angle, vx, vy, spin
  std::optional<double> growth;   // [-], the largest so far; none: not known from here on
  double step = 0.0;              // [s], the longest of a scheme that may be asked about this row
  std::optional<double> energy;   // [J], of a sample
  CableSet cables;                // of an event
  // of an impact
  std::optional<double> rate;                     // [m/s], > 0, of the cable that closes fastest
  std::vector<double> impulses;                   // [N s], of `cables`; empty: not determined
  std::optional<std::array<double, 3>> velocity;  // vx, vy and spin before it
};

/// An exact motion, by which an engine can check itself.
struct Vector {
  Case the_case;  // with the duration of the motion that was solved
  ImpactLaw law = ImpactLaw::simultaneous;
  double slowest = 0.0;         // [m/s]: impacts that close slower have no row
  double radius = 0.0;          // [m], of gyration: how much a turn counts
  double fastest = 0.0;         // [m/s], of all rows
  std::string ends;             // "lock", or an `Ending`
  std::vector<VectorRow> rows;  // in rising time
};

}  // namespace tautline::bench
