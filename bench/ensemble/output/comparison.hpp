#pragma once

#include <algorithm>
#include <cstddef>
#include <optional>
#include <string>
#include <vector>

#include "bench/ensemble/ensemble.hpp"
#include "bench/ensemble/output/summary.hpp"

namespace tautline::bench {

/// How often all tests together may find a difference where there is none [-].
inline constexpr double error_rate = 0.05;

/// Fewer values on a side tell nothing: Kolmogorov's limit is off by 0.004 there.
inline constexpr std::size_t least_sample = 10;

/// A comparison that could only see larger differences than this says nothing [-]: a normal
/// distribution shifted by 0.64 of its standard deviation has D = 0.25.
inline constexpr double coarsest_visible = 0.25;

/// A test of whether two samples are of one distribution.
struct Test {
  double effect = 0.0;       // [-], 0 to 1: how far apart they are
  double probability = 1.0;  // of being as far apart by chance
  double adjusted = 1.0;     // the same for all tests together, by Holm
};

/// A statistic of a setup compared with that of the first one, both of the draws that are held.
struct Comparison {
  std::size_t setup = 0;                // index into the setups, from 1
  std::size_t statistic = 0;            // index into statistics_of
  std::size_t draws = 0;                // of the setup
  Test kolmogorov;                      // draws without a value are larger than all that have one
  std::optional<Test> energy;           // of the draws with a value; none where they are few
  std::optional<double> median_change;  // in the statistic's unit; none without both medians
  /// The smallest Kolmogorov distance that would be called a difference [-].
  double visible = 1.0;
  std::optional<double>
      visible_shift;  // that makes it; none where more draws than that share a value

  /// The smaller of those of its tests, adjusted.
  [[nodiscard]] double probability() const {
    return energy ? std::min(kolmogorov.adjusted, energy->adjusted) : kolmogorov.adjusted;
  }
  [[nodiscard]] bool differs() const { return probability() <= error_rate; }
  /// True if no difference was found and only large ones could have been: there are too few draws.
  [[nodiscard]] bool says_nothing() const { return !differs() && visible > coarsest_visible; }
};

/// What an ensemble says: a summary of each setup and statistic, and every comparison.
struct Findings {
  std::vector<Statistic> statistics;
  std::vector<std::vector<Summary>> summaries;  // by setup, by statistic; of all draws
  std::vector<Comparison> comparisons;          // by setup, by statistic
  std::vector<std::size_t> problems;            // of each setup, its draws without values
  std::vector<std::string> first_problems;      // of each setup, a draw's, or empty

  [[nodiscard]] std::size_t tests() const;
};

/// True if `setup`, which `summary` is of, tells a statistic.
[[nodiscard]] bool tells(const EnsembleSetup& setup, const Statistic& statistic,
                         const Summary& summary);

/// `jobs` threads share the work, and have no part in what it says.
[[nodiscard]] Findings findings_of(const EnsembleRequest& request, const EnsembleResult& result,
                                   unsigned jobs);

/// Holm's (1979) correction of the probabilities of several tests: with those at most `error_rate`
/// called differences, all together err no more often than that.
[[nodiscard]] std::vector<double> holm(const std::vector<double>& probabilities);

}  // namespace tautline::bench
