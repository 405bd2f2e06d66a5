#include "bench/solution/sample_times.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <charconv>
#include <cmath>
#include <optional>
#include <string_view>

#include "bench/base/text.hpp"

namespace tautline::bench {
namespace {

std::optional<double> number(std::string_view text) {
  double value = 0.0;
  const auto [end, error] = std::from_chars(text.data(), text.data() + text.size(), value);
  const bool whole = error == std::errc() && end == text.data() + text.size();
  return whole && std::isfinite(value) ? std::optional(value) : std::nullopt;
}

/// The decimal that was meant: k steps of 0.1 are 0.3, not 0.30000000000000004.
double without_rounding(double time) {
  constexpr int sure_digits = 15;      // of a double
  constexpr double roundings = 4e-16;  // [-], of a product and a sum
  const std::string text = fmt::format("{:.{}g}", time, sure_digits);
  const double decimal = number(text).value_or(time);
  return std::abs(decimal - time) <= roundings * std::abs(time) ? decimal : time;
}

/// From `from` to `to`, both with rounding; `asked` names them in a sentence.
void add_range(SampleTimes& result, const std::string& asked, double from, double step, double to) {
  constexpr double rounding = 1e-9;  // [-], of a step: the last sample is not lost to it
  const double steps = std::floor((to - from) / step + rounding);
  if (!(steps < static_cast<double>(most_samples))) {
    result.problems.push_back(fmt::format(
        "{}: {:.3g} samples are too many; at most {} fit, with a step of at least {:.3g}", asked,
        steps + 1.0, most_samples, (to - from) / static_cast<double>(most_samples - 1)));
    return;
  }
  for (std::size_t k = 0; k <= static_cast<std::size_t>(steps); ++k) {
    result.times.push_back(std::min(to, without_rounding(from + static_cast<double>(k) * step)));
  }
}

void add_word(SampleTimes& result, const std::string& word) {
  const std::string asked = "--at " + printable(word);
  const std::size_t first = word.find(':');
  if (first == std::string::npos) {
    if (const auto time = number(word)) {
      result.times.push_back(*time);
    } else {
      result.problems.push_back(asked + ": must be a time [s] or a range FROM:STEP:TO, as 0:0.1:5");
    }
    return;
  }
  const std::size_t second = word.find(':', first + 1);
  const std::string_view text = word;
  const auto from = number(text.substr(0, first));
  const auto step = second == std::string::npos
                        ? std::nullopt
                        : number(text.substr(first + 1, second - first - 1));
  const auto to = second == std::string::npos ? std::nullopt : number(text.substr(second + 1));
  if (!from || !step || !to) {
    result.problems.push_back(asked + ": a range is FROM:STEP:TO with three numbers, as 0:0.1:5");
  } else if (!(*step > 0.0)) {
    result.problems.push_back(asked + ": the step must be > 0");
  } else if (*from > *to) {
    result.problems.push_back(asked + ": the range must end at or after its start");
  } else {
    add_range(result, asked, *from, *step, *to);
  }
}

}  // namespace

SampleTimes times_at(std::span<const std::string> words) {
  SampleTimes result;
  for (const std::string& word : words) {
    add_word(result, word);
  }
  if (result.problems.empty() && result.times.size() > most_samples) {
    result.problems.push_back(fmt::format("--at: {} samples are too many; at most {} fit",
                                          result.times.size(), most_samples));
  }
  if (!result.problems.empty()) {
    result.times.clear();
  }
  return result;
}

SampleTimes times_every(double step, double until) {
  SampleTimes result;
  const std::string asked = "--every " + shortest(step);
  if (!(step > 0.0) || !std::isfinite(step)) {
    result.problems.push_back(asked + ": must be a time between samples [s], > 0 and finite");
  } else {
    add_range(result, asked, 0.0, step, until);
  }
  return result;
}

}  // namespace tautline::bench
