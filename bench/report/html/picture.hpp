#pragma once

#include <array>
#include <cstddef>
#include <optional>
#include <string>

#include "bench/report/motion/drawn_path.hpp"
#include "bench/report/replay.hpp"
#include "bench/report/report.hpp"

namespace tautline::bench {

// The picture at the top of the page: one impact of a real run, before, at, and after.

/// Three instants of a run around one impact, and its numbers.
struct ImpactStills {
  const CaseRow* the_case;
  const RunRow* run;
  const ImpactColumns* impacts;  // of the run
  DrawnPath path;                // of the run
  std::size_t cable;             // that becomes taut
  std::size_t impact;            // its place in the run's columns
  std::array<double, 3> times;   // [s]: slack, taut, rebound
};

/// The impact to show: of the exact motion if the report has it, or else of the first run that
/// fits; of its impacts the one around which all cables are slackest. None where that is not seen.
[[nodiscard]] std::optional<ImpactStills> impact_stills(const Report& report, const Replay& replay);

/// The stills as a figure with their numbers; "" without any.
[[nodiscard]] std::string picture_html(const Report& report, const Replay& replay);

}  // namespace tautline::bench
