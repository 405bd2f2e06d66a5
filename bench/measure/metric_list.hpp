#pragma once

#include <cstddef>
#include <optional>
#include <span>
#include <string_view>
#include <vector>

#include "bench/base/table.hpp"
#include "bench/measure/metrics.hpp"

namespace tautline::bench {

// The one list of what a run is measured by. Reports, their tables and schema, limits and the
// comparison of two reports follow from it: a metric is added here and nowhere else.

/// How the runs of one engine, model and step over the cases come to one number.
enum class Aggregate {
  none,     // they do not
  typical,  // median, and the worst next to it, of the runs that did their work
  extreme,  // the worst of all runs that have the metric
};

/// Which tables have a column of a metric.
enum class Shown { nowhere, by_run, by_run_and_over_cases };

/// How much of a change from one report to another is noise (see `Noise` of gate/noise.hpp).
enum class NoiseKind {
  early,    // rounding, before the motion has amplified it
  horizon,  // rounding, amplified as the horizon allows
  extreme,  // one draw of a chaotic motion where the run goes beyond the horizon
  share,    // a share of the counted impacts, of which one may change sides
  any,      // not compared: a worst of many impacts, or of what lies beyond the horizon
};

/// One number that a run is measured by; the smaller, the better.
struct Metric {
  std::string_view name;     // [a-z_]+, in files
  std::string_view heading;  // of its column; below `group` where that is not empty
  std::string_view group;    // shared with its neighbours
  std::string_view brief;    // heading where there is little room, or empty: not shown there
  std::string_view unit;     // "1" for a ratio or a count
  std::string_view meaning;  // one sentence
  std::optional<double> (*of)(const Metrics& metrics);  // none: could not be measured
  Digits digits;
  Aggregate aggregate;
  NoiseKind noise;
  Shown shown;
  int rank = 0;  // of the column over the cases: see Column::rank
};

/// Every metric, in the order of the tables.
[[nodiscard]] std::span<const Metric> metric_list();

/// What is asked of a run or of a model first, where there is little room.
[[nodiscard]] inline bool is_asked_first(const Metric& metric) {
  return metric.shown == Shown::by_run_and_over_cases && !metric.brief.empty();
}

/// The place of `name` in the list; none if there is no such metric.
[[nodiscard]] std::optional<std::size_t> place_of(std::string_view name);

/// One number, or none, for each of the list.
using MetricValues = std::vector<std::optional<double>>;

/// The values of all metrics.
[[nodiscard]] MetricValues values_of(const Metrics& metrics);

}  // namespace tautline::bench
