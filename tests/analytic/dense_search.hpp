#pragma once

#include <optional>

#include "tautline/case.hpp"

namespace tautline::test {

// A second route to the first contact of one cable: sample densely, minimise between samples, then
// bisect. Slow, and nothing like the search it checks. Works on the squared distance in long
// double; shares no code with the library.

/// What the dense method sees of the gap of cable 0 along a free flight.
struct DenseContact {
  double time;     // [s]
  double closing;  // [m/s], the rate at which the cable closes there, > 0
};

/// The first time in (0, horizon] at which cable 0 becomes taut; `intervals` samples.
[[nodiscard]] std::optional<DenseContact> dense_first_contact(const Case& the_case, double horizon,
                                                              int intervals);

/// The first local maximum of the distance that is above all distances before it.
struct Farthest {
  double time;
  double distance;   // [m]
  double curvature;  // [m/s^2], minus the distance's second derivative there, > 0
};
[[nodiscard]] std::optional<Farthest> first_farthest(const Case& the_case, double horizon,
                                                     int intervals);

/// The gap of cable 0 at one time of the flight, to 1e-18 [m].
[[nodiscard]] long double precise_gap(const Case& the_case, double time);

}  // namespace tautline::test
