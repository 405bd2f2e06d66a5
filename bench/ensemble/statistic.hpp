#pragma once

#include <cstddef>
#include <optional>
#include <string>
#include <vector>

#include "bench/base/table.hpp"
#include "bench/ensemble/spec.hpp"
#include "bench/measure/reference.hpp"
#include "bench/run/trajectory.hpp"
#include "tautline/case.hpp"

namespace tautline::bench {

/// Which engines' runs tell a statistic. Those of some: as far as they know it, by their steps, so
/// that it is shown beside the exact one, and not tested against it.
enum class OfEngines { none, some, all };

/// One number that every motion of an ensemble is reduced to.
struct Statistic {
  std::string name;     // in files
  std::string heading;  // in tables
  std::string unit;     // or empty
  Digits digits;        // of a value
  bool compared;        // with the exact motion
  bool of_exact;        // the exact motion tells it; no cable of it is ever overstretched
  OfEngines of_engines;
  std::string meaning;  // a sentence
};

/// The statistics of an ensemble, in the order in which results have them.
[[nodiscard]] std::vector<Statistic> statistics_of(const EnsembleSpec& spec);

/// The place of a statistic by its name, one of `statistics_of`.
[[nodiscard]] std::size_t place_of_statistic(const std::vector<Statistic>& all,
                                             const std::string& name);

/// The response of the attachment of `cable` to a pull is at most this, as across its arm [1/kg].
[[nodiscard]] double most_response(const Case& the_case, const Cable& cable);
template <int D>
[[nodiscard]] double most_response(const BasicSystem<double, D>& system,
                                   const BasicCableOfSystem<double, D>& cable);

/// A value for each statistic; none where the motion has none of it.
using StatisticValues = std::vector<std::optional<double>>;

/// Of the exact motion of one draw, which solves `the_case`, and of its `lock`.
[[nodiscard]] StatisticValues exact_statistics(const EnsembleSpec& spec, const Case& the_case,
                                               const Solution& solution,
                                               const std::optional<Lock>& lock);

/// Likewise for a system, which has other statistics.
template <int D>
[[nodiscard]] StatisticValues system_statistics(
    const EnsembleSpec& spec, const BasicSystem<double, D>& system,
    const BasicSolution<BasicSystem<double, D>>& solution);

/// Of an engine's run of it.
[[nodiscard]] StatisticValues run_statistics(const EnsembleSpec& spec,
                                             const ReferenceCase& reference, const Trajectory& run);

}  // namespace tautline::bench
