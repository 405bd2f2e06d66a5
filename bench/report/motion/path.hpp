#pragma once

#include <vector>

#include "bench/report/motion/column.hpp"

namespace tautline::bench {

/// When a cable is taut, and its gap as it was recorded then.
struct TautColumns {
  GridColumn times;         // [s], from, until, from, until, ...: taut in between, else slack
  GridColumn gap_times;     // [s], inside the long ones of these stretches
  std::vector<double> gap;  // [m], recorded then: the least and the largest of a part of a stretch
};

/// A motion as it is drawn: pieces between knots, each of which is a cubic. At the part s of its
/// way from a knot a to the next b it is at
///   a + s (b - a) + 3 s (1 - s) ((1 - s) p + s q),
/// where p and q are its two bends: its velocity is (b - a + 3 p) / T at its start and
/// (b - a - 3 q) / T at its end, T [s] being its length. Where velocities jump, the piece before a
/// knot ends with another one than the piece after it starts with.
struct Path {
  double error = 0.0;      // [m], off what was recorded by at most: the centre and every attachment
  double spacing = 0.0;    // [s], between two recorded samples; 0: known at every instant
  GridColumn time;         // [s], of the knots
  GridColumn x;            // [m], of the centre of mass
  GridColumn y;            // [m]
  GridColumn angle;        // [rad]
  GridColumn x_bends;      // [m], two for each piece
  GridColumn y_bends;      // [m]
  GridColumn angle_bends;  // [rad]
  double energy_error = 0.0;  // [J], off what was recorded by at most
  GridColumn energy_time;     // [s]; a jump is two knots at one time
  GridColumn energy;          // [J], kinetic and potential; straight between two knots
  std::vector<TautColumns> cables;
};

}  // namespace tautline::bench
