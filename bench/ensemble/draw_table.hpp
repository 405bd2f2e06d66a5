#pragma once

#include <cstddef>
#include <map>
#include <optional>
#include <string>
#include <vector>

#include "bench/ensemble/draw_solver.hpp"

namespace tautline::bench {

/// Binary digits that a counted value keeps: it is off by 3e-5 of itself at most, and whole numbers
/// up to 32,768 are not. Each power of two between the least and the largest value takes 16,384
/// counters at most, 64 bytes each.
inline constexpr int counted_digits = 15;

/// Exact counters of rounded values: their room depends on where the values lie and not on how many
/// there are. They say the same in whatever order the values came.
class ValueCounts {
 public:
  /// None: a draw without a value.
  void add(std::optional<double> value);

  [[nodiscard]] std::size_t count() const { return count_; }      // of the values
  [[nodiscard]] std::size_t without() const { return without_; }  // draws without one
  /// How often each value came, in rising order.
  [[nodiscard]] const std::map<double, std::size_t>& values() const { return values_; }

 private:
  std::map<double, std::size_t> values_;
  std::size_t count_ = 0;
  std::size_t without_ = 0;
};

/// Every value of this many draws, the first ones, is held: tests on them see a D of 0.004.
inline constexpr std::size_t most_held = std::size_t{1} << 19U;

/// What became of the draws of one setup, statistic by statistic. The first ones are held as they
/// are, 8 bytes each and a bit a draw, all of them from the start; where there are more than are
/// held, the values of all are counted.
class DrawTable {
 public:
  DrawTable(std::size_t statistics, std::size_t draws, std::size_t held);

  /// Each draw at most once.
  void put(const DrawResult& result);

  [[nodiscard]] std::size_t size() const { return solved_.size(); }  // draws that are held
  [[nodiscard]] bool holds_all() const { return counts_.empty(); }
  [[nodiscard]] std::size_t ended() const { return ended_; }        // draws that were put in
  [[nodiscard]] std::size_t problems() const { return problems_; }  // those without values
  /// That of the first draw with one, or empty.
  [[nodiscard]] const std::string& first_problem() const { return first_problem_; }

  /// True if the draw, one that is held, has ended without a problem.
  [[nodiscard]] bool solved(std::size_t draw) const { return solved_[draw]; }
  /// None where the motion has none of it, or the draw is not solved.
  [[nodiscard]] std::optional<double> value(std::size_t draw, std::size_t statistic) const;
  /// Of all draws that are solved, where not all are held.
  [[nodiscard]] const ValueCounts& counts(std::size_t statistic) const {
    return counts_[statistic];
  }

 private:
  std::vector<std::vector<double>> columns_;  // by statistic, by draw; NaN: none
  std::vector<bool> solved_;                  // by draw
  std::vector<ValueCounts> counts_;           // by statistic; empty where all are held
  std::size_t ended_ = 0;
  std::size_t problems_ = 0;
  std::size_t first_with_problem_ = 0;
  std::string first_problem_;
};

}  // namespace tautline::bench
