#pragma once

#include <cstddef>
#include <nlohmann/json.hpp>
#include <vector>

#include "bench/run/record.hpp"
#include "tautline/case.hpp"
#include "tautline/solution.hpp"

namespace tautline::bench {

// What a page needs to draw a motion again: few samples, and all that happens between them.

/// Of one run's impacts, or of one case's events, the report has at most so many, the fastest.
inline constexpr std::size_t most_impacts = 300;

/// Samples of an exact path.
inline constexpr std::size_t most_path_samples = 400;

/// Samples of one path of a report of `runs` runs, so that all of them have about 4 MB.
[[nodiscard]] std::size_t path_samples(std::size_t runs);

/// Leaves in every run of `report` its fastest impacts, so many that all runs have about 4 MB of
/// them, and takes the others out of its path. What is drawn from all impacts comes before.
void thin_impacts(nlohmann::ordered_json& report);

/// `value` with `digits` significant digits, or null where it is not finite.
[[nodiscard]] nlohmann::ordered_json rounded(double value, int digits = 6);

/// The impacts of `run` that the report has, in rising time: those that close faster than
/// `count_speed` [m/s], the fastest `most_impacts` of them. Pointers into `run`.
[[nodiscard]] std::vector<const RecordedImpact*> kept_impacts(const Trajectory& run,
                                                              double count_speed);

/// "path" of a run: `samples` samples and one at every kept impact. There the energy is the one
/// after the impact; the place is the same on both sides.
[[nodiscard]] nlohmann::ordered_json run_path_json(const Case& the_case, const Trajectory& run,
                                                   std::size_t samples, double count_speed);

/// "impacts" of a run, one column a quantity: bench/report/report.schema.json says which.
[[nodiscard]] nlohmann::ordered_json run_impacts_json(const Case& the_case, const Trajectory& run,
                                                      double count_speed);

/// What a page needs to draw a case and its exact motion: "body", "gravity", "geometry", "path",
/// "events". Added to `row`.
void add_exact_motion(const Case& the_case, const Solution& solution, nlohmann::ordered_json& row);

}  // namespace tautline::bench
