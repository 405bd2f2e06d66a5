#pragma once

#include <utility>
#include <vector>

#include "bench/solution/certificate.hpp"
#include "tautline/multiprecision.hpp"
#include "tautline/solution.hpp"

namespace tautline::bench {

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
