#pragma once

#include <cstddef>
#include <optional>
#include <string>
#include <vector>

#include "bench/ensemble/solve/draw_solver.hpp"

namespace tautline::bench {

/// What became of the draws of one setup, statistic by statistic: 8 bytes each and a bit a draw,
/// all of them from the start. Millions of draws fit where a `DrawResult` of each would not.
class DrawTable {
 public:
  DrawTable(std::size_t statistics, std::size_t draws);

  /// Each draw at most once.
  void put(const DrawResult& result);

  [[nodiscard]] std::size_t size() const { return solved_.size(); }
  [[nodiscard]] std::size_t ended() const { return ended_; }        // draws that were put in
  [[nodiscard]] std::size_t problems() const { return problems_; }  // those without values
  /// That of the first draw with one, or empty.
  [[nodiscard]] const std::string& first_problem() const { return first_problem_; }

  /// Whether the draw has ended without a problem.
  [[nodiscard]] bool solved(std::size_t draw) const { return solved_[draw]; }
  /// None where the motion has none of it, or the draw is not solved.
  [[nodiscard]] std::optional<double> value(std::size_t draw, std::size_t statistic) const;

 private:
  std::vector<std::vector<double>> columns_;  // by statistic, by draw; NaN: none
  std::vector<bool> solved_;                  // by draw
  std::size_t ended_ = 0;
  std::size_t problems_ = 0;
  std::size_t first_with_problem_ = 0;
  std::string first_problem_;
};

}  // namespace tautline::bench
