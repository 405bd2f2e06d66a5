#pragma once

#include <Eigen/Core>

#include <type_traits>
#include <vector>

#include "bench/replay/path.hpp"
#include "bench/run/trajectory.hpp"
#include "tautline/case.hpp"
#include "tautline/solution.hpp"
#include "tautline/system.hpp"

namespace tautline::bench {

/// What is known of the motion of a body at one instant. At an impact, velocity and energy jump.
/// A pose has N numbers: in the plane x, y [m] and the angle [rad], in space x, y, z [m] and the
/// quaternion w, x, y, z.
template <int N>
struct Sample {
  using Numbers = Eigen::Matrix<double, N, 1>;

  double time;           // [s]
  Numbers pose;          //
  Numbers arriving;      // rate of the pose before
  Numbers leaving;       // and after
  double energy_before;  // [J], of all bodies
  double energy_after;   // [J]
};
template <class TheCase>
using SampleOf = Sample<std::is_same_v<TheCase, Case> ? 3 : 7>;

/// All that was recorded of each body of `run`, in rising time, up to where it is not finite: its
/// points and its impacts. The velocities are the simulation's own where it located its impacts.
/// Else a step moves the body by one velocity while it stores another, and they are those of the
/// way between points.
template <class TheCase>
[[nodiscard]] std::vector<std::vector<SampleOf<TheCase>>> samples_of(
    const TheCase& the_case, const BasicTrajectory<TheCase>& run);

/// The exact motion of each body, finer than it can be drawn, with both sides of every event.
template <class TheCase>
[[nodiscard]] std::vector<std::vector<SampleOf<TheCase>>> samples_of(
    const TheCase& the_case, const BasicSolution<TheCase>& solution);

/// How near a drawing is to what was recorded.
struct Nearness {
  struct Turn {
    double reach = 0.0;  // [m], of what is drawn of the body from its centre
    double lever = 0.0;  // [m], >= reach, > 0: an angle may be off by bound / lever
  };
  double bound = 0.0;        // [m], centre and attachments may be off by it
  std::vector<Turn> bodies;  //
  double energy = 0.0;       // [J], the energy may be off by it
  double tension = 0.0;      // [N], a tension may be off by it; 0: there is none to draw
};

/// More pieces than this are not drawn: where a run shakes by more than the bound at every step,
/// the bound is doubled until they suffice. `Path::error` says what came of it.
inline constexpr std::size_t most_pieces = 3000;

/// The motion of `samples` of a body, which are not empty: few knots, and a cubic between two that
/// is as near to the samples as `bound` [m] and `turn` ask; at most `most` pieces.
template <int N>
[[nodiscard]] CurveColumns<N> drawn_motion(const std::vector<Sample<N>>& samples, double bound,
                                           const Nearness::Turn& turn, std::size_t most);

/// A number at an instant. Two of one instant are a jump.
struct Level {
  double time;   // [s]
  double value;  // in its own unit
};

/// A line through levels, and by how much it is off them, at most.
struct DrawnLine {
  Line line;
  double error;
};

/// A line through `levels`, which are not empty, that is as near as `bound` asks; or of twice that,
/// and so on, until it has no more than `most` pieces.
[[nodiscard]] DrawnLine drawn_line(const std::vector<Level>& levels, double bound,
                                   std::size_t most);

/// The energies of `samples`.
template <int N>
[[nodiscard]] std::vector<Level> energies(const std::vector<Sample<N>>& samples) {
  std::vector<Level> levels;
  for (const Sample<N>& one : samples) {
    levels.push_back({one.time, one.energy_before});
    if (one.energy_after != one.energy_before) {
      levels.push_back({one.time, one.energy_after});
    }
  }
  return levels;
}

}  // namespace tautline::bench
