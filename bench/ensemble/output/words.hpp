#pragma once

#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "bench/ensemble/ensemble.hpp"
#include "bench/ensemble/output/comparison.hpp"

namespace tautline::bench {

/// An ensemble that has been solved, and what it says. All must outlive it.
struct EnsembleReport {
  const EnsembleRequest& request;
  const EnsembleResult& result;
  const Findings& findings;
};

/// "breakwater/1910121100 to 12 s, 1000 draws, seed 1".
[[nodiscard]] std::string ensemble_title(const EnsembleReport& report);

/// First whether these are all draws. Then of each setup but the first which statistics differ, or
/// that none can be told apart and how small a difference would have been seen, or that there are
/// too few draws to tell; of each setup how many draws have no values or have not locked; which
/// engines have no part; what all draws share; and of how many draws the tests and curves are.
[[nodiscard]] std::vector<std::string> ensemble_sentences(const EnsembleReport& report);

/// The value of a statistic that every draw has, of each setup that tells it; none where two differ
/// or one has none.
[[nodiscard]] std::optional<double> common_value(const EnsembleReport& report,
                                                 std::size_t statistic);

/// "n too small: differences below D = 0.63 cannot be seen".
[[nodiscard]] std::string too_small_words(const Comparison& one,
                                          std::string_view what = "n too small");

/// "last impact > 0.01 m/s [s]".
[[nodiscard]] std::string statistic_title(const Statistic& statistic);

/// How to read the tables.
inline constexpr const char* how_to_read_summaries =
    "The median lies between low and high with 95 % confidence, for any distribution. Draws "
    "without "
    "a value (none) count as the largest.";
inline constexpr const char* how_to_read_comparisons =
    "D is the largest distance between the distribution functions (Kolmogorov and Smirnov), E the "
    "energy distance as a share of the largest it could be: both 0 for the same, 1 for samples "
    "apart. p is the smaller of the two probabilities of such a distance by chance, corrected for "
    "all tests together (Holm). Visible is the smallest D that this many draws would show as a "
    "difference, and the shift of all values that would make it: a true shift of just that size "
    "is seen about half of the time. n is called too small if no difference was found and visible "
    "is above 0.25.";

}  // namespace tautline::bench
