#pragma once

#include <array>
#include <optional>
#include <string>

#include "bench/report/report.hpp"

namespace tautline::bench {

// The picture at the top of the page: one impact of a real run, before, at, and after.

/// Four instants of a run around one impact, and its numbers.
struct ImpactStills {
  const CaseRow* the_case;
  const RunRow* run;
  std::size_t cable;                   // that becomes taut
  std::size_t impact;                  // its place in the run's columns
  std::array<std::size_t, 4> samples;  // places in the run's path: slack, closing, taut, rebound
};

/// The impact to show: of the exact motion if the report has it, or else of the first run that
/// fits; the first impact whose cable is seen to be slack before it and after it. None without one.
[[nodiscard]] std::optional<ImpactStills> impact_stills(const Report& report);

/// The gap of a cable at a sample of a path [m].
[[nodiscard]] double gap_at(const CableRow& cable, const Path& path, std::size_t sample);

/// The stills as a figure with their numbers; "" without any.
[[nodiscard]] std::string picture_html(const Report& report);

}  // namespace tautline::bench
