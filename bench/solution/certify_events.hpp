#pragma once

#include <algorithm>
#include <utility>
#include <vector>

#include "bench/solution/certificate.hpp"
#include "tautline/multiprecision.hpp"
#include "tautline/solution.hpp"

namespace tautline::bench {

/// The accumulation that `event` completes, or null.
template <class TheCase>
[[nodiscard]] const Accumulation* completed_by(const BasicSolution<TheCase>& solution,
                                               const BasicEvent<TheCase>& event) {
  const auto& all = solution.accumulations();
  const auto found = std::find_if(all.begin(), all.end(), [&](const Accumulation& accumulation) {
    return accumulation.start == event.time && accumulation.cables == event.cables;
  });
  return event.kind == EventKind::taut && found != all.end() ? &*found : nullptr;
}

/// The events of a solution in double next to those of one with more digits.
template <class TheCase, class InDigits>
class Alignment {
 public:
  Alignment(const BasicSolution<TheCase>& one, const BasicSolution<InDigits>& other);

  [[nodiscard]] const EventMatch& match() const { return match_; }

  /// How many events of either lie behind, after each event that is the same; rising.
  [[nodiscard]] const std::vector<std::pair<std::size_t, std::size_t>>& places() const {
    return places_;
  }

  /// True where the last event up to `time`, and all before it, are the same in both.
  [[nodiscard]] bool between_same_events(double time) const;

 private:
  const BasicSolution<TheCase>& one_;
  const BasicSolution<InDigits>& other_;
  EventMatch match_;
  std::vector<std::pair<std::size_t, std::size_t>> places_;
};

}  // namespace tautline::bench
