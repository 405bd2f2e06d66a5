#pragma once

#include <array>
#include <cstddef>
#include <optional>
#include <vector>

#include "bench/ensemble/draw_table.hpp"

namespace tautline::bench {

/// The values of one statistic over the draws of one setup.
struct EnsembleSample {
  std::vector<double> values;  // in rising order
  std::size_t without = 0;     // draws that have none of it

  [[nodiscard]] std::size_t size() const { return values.size() + without; }

  /// The values, and infinity for each draw without one: a cable that has not locked by the end of
  /// the run locks after everything else, and whoever has no number has none in both samples alike.
  [[nodiscard]] std::vector<double> with_none_last() const;
};

/// The one of `values`, which rise, that has this part of them below it: for a picture the nearest
/// is enough.
[[nodiscard]] double nearest_value(const std::vector<double>& values, double part);

/// Of the draws that are held and solved.
[[nodiscard]] EnsembleSample sample_of(const DrawTable& draws, std::size_t statistic);

/// The parts of which quantiles are given.
inline constexpr std::array quantile_parts = {0.05, 0.25, 0.5, 0.75, 0.95};
inline constexpr std::size_t median_place = 2;  // among them

/// How sure an interval is [-].
inline constexpr double confidence = 0.95;

/// A quantile and where that of the distribution is, whatever the distribution: between two values
/// of the sample, by the binomial distribution. A bound is none where the sample is too small for
/// one; all are, where the draws without a value reach.
struct Quantile {
  std::optional<double> value;
  std::optional<double> low;
  std::optional<double> high;
};

struct Summary {
  std::size_t count = 0;    // draws with a value
  std::size_t without = 0;  // draws with none
  double mean = 0.0;        // of the values
  double deviation = 0.0;   // standard, of the values; 0 for fewer than two
  std::array<Quantile, quantile_parts.size()> quantiles;
};
[[nodiscard]] Summary summary_of(const EnsembleSample& sample);
[[nodiscard]] Summary summary_of(const ValueCounts& counts);

}  // namespace tautline::bench
