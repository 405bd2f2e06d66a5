#pragma once

#include <cstddef>
#include <map>
#include <optional>

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

}  // namespace tautline::bench
