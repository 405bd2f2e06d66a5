#pragma once

#include <array>
#include <cstddef>
#include <optional>
#include <string>

#include "bench/replay/path.hpp"
#include "bench/replay/replay.hpp"
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

// The picture at the top of the page: one impact, before, at, and after. Of an engine whose rebound
// is off, the exact motion from the same start is drawn with it.

/// Three instants around one impact, and its numbers.
struct ImpactStills {
  const CaseRow* the_case;
  const RunRow* run;
  const ImpactColumns* impacts;    // of the run
  DrawnPath path;                  // of the run
  std::optional<DrawnPath> exact;  // the exact motion, where the run is not it
  std::size_t cable;               // that becomes taut
  std::size_t impact;              // its place in the run's columns
  std::array<double, 3> times;     // [s]: slack, taut, rebound
};

/// The impact to show: the one of an engine whose restitution is off the most, among those up to
/// which it is where the exact motion is; without one, of the exact motion if the report has it, or
/// else of the first run that fits, the one around which all cables are slackest. None where that
/// is not seen.
[[nodiscard]] std::optional<ImpactStills> impact_stills(const Report& report, const Replay& replay);

/// One still of three: the body at its instant, the way it came from the first, and its cables, of
/// which the struck one stands out. All stills of a motion have one scale.
[[nodiscard]] std::string still_svg(const ImpactStills& stills, std::size_t still);

/// The stills as a figure with their numbers; "" without any.
[[nodiscard]] std::string picture_html(const ImpactStills* stills);

}  // namespace tautline::bench
