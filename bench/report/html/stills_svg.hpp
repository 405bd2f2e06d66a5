#pragma once

#include <array>
#include <cstddef>
#include <string>

#include "bench/report/motion/drawn_path.hpp"
#include "bench/report/report.hpp"

namespace tautline::bench {

/// Where a body is.
struct Pose {
  Vec2 centre = Vec2::Zero();  // [m]
  double angle = 0.0;          // [rad]
};

[[nodiscard]] Pose pose_at(const DrawnPath& path, double time);

/// The gap of a cable at a pose [m].
[[nodiscard]] double gap_of(const CableRow& cable, const Pose& pose);

/// One still of three: the body at its instant, the way it came from the first, and its cables, of
/// which `struck` stands out. All stills of a motion have one scale.
[[nodiscard]] std::string still_svg(const CaseRow& the_case, const DrawnPath& path,
                                    const std::array<double, 3>& times, std::size_t still,
                                    std::size_t struck);

}  // namespace tautline::bench
