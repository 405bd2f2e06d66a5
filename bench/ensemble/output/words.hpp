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

}  // namespace tautline::bench
