#pragma once

#include <cstddef>
#include <span>
#include <string>
#include <vector>

namespace tautline::bench {

/// Samples of one motion: a file of about a hundred megabytes.
inline constexpr std::size_t most_samples = 1'000'000;

/// Times to sample a motion at [s], or all that is wrong with what asks for them.
struct SampleTimes {
  std::vector<double> times;          // as asked; empty unless `problems` is
  std::vector<std::string> problems;  // sentences
};

/// The times that `--at` names: numbers, and ranges "FROM:STEP:TO" with both ends.
[[nodiscard]] SampleTimes times_at(std::span<const std::string> words);

/// The times of `--every`: from 0 to `until` [s], `step` [s] apart.
[[nodiscard]] SampleTimes times_every(double step, double until);

}  // namespace tautline::bench
