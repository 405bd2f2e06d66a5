#pragma once

#include <array>
#include <cstddef>
#include <string>

#include "bench/report/report.hpp"

namespace tautline::bench {

/// The words from the worst to the best: which of several represents all.
inline constexpr std::array worst_first = {Word::problem, Word::listed_problem, Word::too_few,
                                           Word::sound};

/// How many runs came to which verdict.
class Tally {
 public:
  /// One more. A run of a report without verdicts tells too little, or has the problem that it
  /// failed.
  void add(const RunRow& run);
  void add(const Tally& other);

  [[nodiscard]] std::size_t of(Word word) const {
    return counts_.at(static_cast<std::size_t>(word));
  }
  [[nodiscard]] std::size_t runs() const;
  [[nodiscard]] Word worst() const;  // of no run: too few

  auto operator<=>(const Tally&) const = default;  // NOLINT(modernize-use-nullptr): it has none

 private:
  std::array<std::size_t, all_words.size()> counts_{};  // by Word
};

/// "sound", or "problem in 3 of 21".
[[nodiscard]] std::string tally_text(const Tally& tally);

}  // namespace tautline::bench
