#pragma once

#include <Eigen/Core>
#include <cstddef>
#include <vector>

#include "bench/report/motion/path.hpp"

namespace tautline::bench {

/// A path as a page draws it, at any instant: what bench/page/replay_motion.js does in the page.
class DrawnPath {
 public:
  explicit DrawnPath(const Path& path);

  [[nodiscard]] double end_time() const { return time_.empty() ? 0.0 : time_.back(); }

  /// x, y [m] and angle [rad] at `time`; before the first knot and after the last one, theirs.
  [[nodiscard]] Eigen::Vector3d pose(double time) const;

  /// Kinetic and potential energy [J]; at a jump the one after it.
  [[nodiscard]] double energy(double time) const;

  [[nodiscard]] bool is_taut(std::size_t cable, double time) const;

 private:
  std::vector<double> time_;
  std::vector<Eigen::Vector3d> knots_;
  std::vector<Eigen::Vector3d> bends_;  // two for each piece
  std::vector<double> energy_time_;
  std::vector<double> energy_;
  std::vector<std::vector<double>> taut_;  // by cable: from, until, from, until, ...
  std::vector<double> taut_grid_;          // [s], by cable
};

}  // namespace tautline::bench
