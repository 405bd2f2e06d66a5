#pragma once

#include <array>
#include <cstddef>
#include <string>

#include "bench/report/report.hpp"

namespace tautline::bench {

/// The words from the worst to the best: which of several represents all.
inline constexpr std::array worst_first = {Word::breaks_limit, Word::known_deviation,
                                           Word::not_judged, Word::pass};

/// How many runs came to which verdict.
class Tally {
 public:
  /// One more. A run of a report without limits is not judged, or breaks the limit that it must
  /// run.
  void add(const RunRow& run);
  void add(const Tally& other);

  [[nodiscard]] std::size_t of(Word word) const {
    return counts_.at(static_cast<std::size_t>(word));
  }
  [[nodiscard]] std::size_t runs() const;
  [[nodiscard]] Word worst() const;  // of no run: pass

  auto operator<=>(const Tally&) const = default;  // NOLINT(modernize-use-nullptr): it has none

 private:
  std::array<std::size_t, all_words.size()> counts_{};  // by Word
};

/// "pass", or "breaks a limit in 3 of 21".
[[nodiscard]] std::string tally_text(const Tally& tally);

/// "of 60 runs, 3 break a limit, 2 deviate as is known and 55 pass."
[[nodiscard]] std::string sentence_of(const Tally& tally);

}  // namespace tautline::bench
