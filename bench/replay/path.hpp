#pragma once

#include <Eigen/Core>

#include <array>
#include <cstddef>
#include <cstdint>
#include <optional>
#include <vector>

#include "tautline/system.hpp"

namespace tautline::bench {

/// Numbers on a grid, each a whole number of grid widths from the one before: a few bytes each in
/// JSON, and the same to the last bit wherever they are read.
struct GridColumn {
  double start = 0.0;               // the first number
  double scale = 1.0;               // width of the grid, > 0
  std::vector<std::int32_t> steps;  // one for each number; the first is 0
};

/// `numbers`, each moved by at most half a `grid`; none may be further from the one before than
/// 2^31 grid widths.
[[nodiscard]] GridColumn on_grid(const std::vector<double>& numbers, double grid);

/// The numbers of `column`.
[[nodiscard]] std::vector<double> numbers(const GridColumn& column);

/// A number over time: straight lines between knots. A jump is two knots at one time.
struct Line {
  GridColumn time;   // [s]
  GridColumn value;  // in its own unit
};

/// When a cable is taut, and its gap as it was recorded then.
struct TautColumns {
  GridColumn times;         // [s], from, until, from, until, ...: taut in between, else slack
  GridColumn gap_times;     // [s], inside the long ones of these stretches
  std::vector<double> gap;  // [m], recorded then: the least and the largest of a part of a stretch
  std::optional<Line> tension = {};  // [N], in space where the exact motion has any
};

/// Something for each of the N numbers of a pose.
template <class Value, int N>
using ForEach = std::array<Value, static_cast<std::size_t>(N)>;

/// The curves of the numbers of a pose: N columns over the same knots.
template <int N>
struct CurveColumns {
  double error = 0.0;             // [m], off what was recorded by at most
  GridColumn time;                // [s], of the knots
  ForEach<GridColumn, N> places;  //
  ForEach<GridColumn, N> bends;   // two for each piece
};

/// How a body in space moves: x, y, z of its centre of mass [m], and w, x, y, z of its quaternion,
/// which a reader normalises.
using BodyPath = CurveColumns<7>;

/// A motion as it is drawn: pieces between knots, each of which is a cubic. At the part s of its
/// way from a knot a to the next b it is at
///   a + s (b - a) + 3 s (1 - s) ((1 - s) p + s q),
/// where p and q are its two bends: its velocity is (b - a + 3 p) / T at its start and
/// (b - a - 3 q) / T at its end, T [s] being its length. Where velocities jump, the piece before a
/// knot ends with another one than the piece after it starts with.
/// Of a system in space, `bodies` has a path for each body, and the columns of the plane are empty.
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
  std::optional<std::vector<BodyPath>> bodies = {};  // of a system in space
};

/// The curve of N numbers, at any instant.
template <int N>
class DrawnCurve {
 public:
  using Numbers = Eigen::Matrix<double, N, 1>;

  explicit DrawnCurve(const GridColumn& time, const ForEach<const GridColumn*, N>& places,
                      const ForEach<const GridColumn*, N>& bends);

  [[nodiscard]] double end_time() const { return time_.empty() ? 0.0 : time_.back(); }

  /// Before the first knot and after the last one, theirs.
  [[nodiscard]] Numbers at(double time) const;

 private:
  std::vector<double> time_;
  std::vector<Numbers> knots_;
  std::vector<Numbers> bends_;  // two for each piece
};

/// A path as a page draws it, at any instant: what bench/page/replay_motion.js does in the page.
class DrawnPath {
 public:
  explicit DrawnPath(const Path& path);

  [[nodiscard]] double end_time() const { return plane_.end_time(); }

  /// x, y [m] and angle [rad] at `time`; before the first knot and after the last one, theirs.
  [[nodiscard]] Eigen::Vector3d pose(double time) const { return plane_.at(time); }

  /// The place of a body in space, without its velocity.
  [[nodiscard]] SpatialState pose(std::size_t body, double time) const;

  /// Kinetic and potential energy [J]; at a jump the one after it.
  [[nodiscard]] double energy(double time) const;

  [[nodiscard]] bool is_taut(std::size_t cable, double time) const;

 private:
  DrawnCurve<3> plane_;
  std::vector<DrawnCurve<7>> bodies_;  // in space
  std::vector<double> energy_time_;
  std::vector<double> energy_;
  std::vector<std::vector<double>> taut_;  // by cable: from, until, from, until, ...
  std::vector<double> taut_grid_;          // [s], by cable
};

}  // namespace tautline::bench
