#include <fmt/format.h>

#include <algorithm>

#include "bench/base/text.hpp"
#include "bench/solution/cable_words.hpp"
#include "bench/solution/right_digits.hpp"
#include "bench/solution/samples.hpp"
#include "bench/solution/taut_phases.hpp"
#include "bench/solution/texts.hpp"
#include "tautline/impact.hpp"

namespace tautline::bench {
namespace {

/// Digits that a double has at most where it is printed whole.
constexpr int most_digits_of_sample = 17;

/// The numbers of a sample in the order of `sample_names`.
std::vector<Bounded> numbers_of(const MotionSample& sample) {
  std::vector<Bounded> result = bounded(sample.state, sample.errors);
  for (const CableSample& cable : sample.cables) {
    result.insert(result.end(), {cable.gap, cable.gap_rate, cable.tension});
  }
  result.push_back(sample.energy);
  return result;
}

/// A number, or a dash for a cell.
std::string cell(const Bounded& one, int digits) {
  return right_fixed(one.value, one.error, digits);
}

}  // namespace

std::string samples_table(const std::vector<std::string>& names, std::span<const double> times,
                          std::size_t longest_number, const TerminalStyle& style,
                          const std::function<std::vector<std::string>(double)>& numbers_at) {
  std::size_t longest_name = 0;  // [columns]
  for (const std::string& name : names) {
    longest_name = std::max(longest_name, name.size());
  }
  const std::size_t room = std::max(style.width, longest_name) - longest_name;
  const std::size_t fit = std::max<std::size_t>(1, room / (longest_number + 2));
  std::string result;
  for (std::size_t first = 0; first < times.size(); first += fit) {
    std::vector<std::string> headings = {"sample at"};
    std::vector<std::vector<std::string>> rows;
    for (const std::string& name : names) {
      rows.push_back({name});
    }
    for (std::size_t index = first; index < std::min(times.size(), first + fit); ++index) {
      headings.push_back(shortest(times[index]));
      const std::vector<std::string> numbers = numbers_at(times[index]);
      for (std::size_t row = 0; row < rows.size(); ++row) {
        rows[row].push_back(numbers.empty() ? "beyond the horizon" : numbers[row]);
      }
    }
    Table samples(headings, 1);
    for (const std::vector<std::string>& row : rows) {
      samples.add(row);
    }
    result += "\n" + samples.plain(style);
  }
  return result;
}

std::string samples_text(const Case& the_case, const Solution& solution,
                         const Uncertainty& uncertainty, const std::vector<double>& times,
                         const TerminalStyle& style) {
  constexpr std::size_t longest_number = 24;  // [columns], -1.7976931348623157e+308
  return samples_table(sample_names(the_case), times, longest_number, style, [&](double time) {
    const MotionSample sample = sample_at(the_case, solution, uncertainty, time);
    std::vector<std::string> result;
    if (sample.errors) {
      for (const Bounded& one : numbers_of(sample)) {
        result.push_back(right_general(one.value, one.error, most_digits_of_sample));
      }
    }
    return result;
  });
}

std::string tensions_text(const Case& the_case, const Solution& solution,
                          const Uncertainty& uncertainty, const TerminalStyle& style) {
  const std::vector<TautPhase> phases = taut_phases(the_case, solution, uncertainty);
  if (phases.empty()) {
    return "";
  }
  constexpr int time_digits = 6;
  Table table({ranked("taut from", 0), ranked("until", 0), ranked("cable", 0),
               ranked("least tension", 0), ranked("first at", 0), ranked("largest tension", 0),
               ranked("first at", 0)});
  bool indeterminate = false;
  for (const TautPhase& phase : phases) {
    const auto number = [](const Bounded& one) { return right_general(one.value, one.error, 10); };
    table.add(std::vector<std::string>{
        cell(phase.from, time_digits), cell(phase.until, time_digits),
        std::to_string(phase.cable) + (phase.indeterminate ? "*" : ""), number(phase.least.tension),
        cell(phase.least.time, time_digits), number(phase.largest.tension),
        cell(phase.largest.time, time_digits)});
    indeterminate = indeterminate || phase.indeterminate;
  }
  const std::string note =
      indeterminate ? "* indeterminate: more cables are taut than statics can tell apart; these "
                      "are the smallest tensions that give the motion"
                    : "";
  return "\n" + table.plain(style) + wrapped(note, style.text);
}

std::string rest_tensions_text(const Case& the_case, const Solution& solution,
                               const Uncertainty& uncertainty) {
  const double end = solution.end_time();
  const CableSet taut = taut_at(solution, end);
  const bool rests =
      solution.ending() == Ending::rest || solution.ending() == Ending::unstable_rest;
  if (!rests || taut.empty()) {
    return "";
  }
  const MotionSample sample = sample_at(the_case, solution, uncertainty, end);
  std::string list;
  for (const std::size_t index : taut) {
    const Bounded& tension = sample.cables[index].tension;
    const std::string text = right_general(tension.value, tension.error, 6);
    if (text == dash) {
      return "";
    }
    list += fmt::format("{}{} on cable {}", list.empty() ? "" : ", ", text, index);
  }
  const bool determinate = independent(the_case, sample.state, taut);
  return rest_tension_sentence(list, determinate);
}

std::string period_tensions_text(const Case& the_case, const Solution& solution,
                                 const Settling& settling, const Uncertainty& uncertainty) {
  const auto error = uncertainty.energy(solution.end_time());
  if (!error || !settling.lock || !settling.lock->swing) {
    return "";
  }
  const Lock& lock = *settling.lock;
  std::string result;
  for (const PeriodTension& one : period_tensions(the_case, solution.events().back().after,
                                                  lock.cables, *lock.swing, *error)) {
    const std::string least = number_in_words(one.least.value, one.least.error, 6);
    const std::string largest = number_in_words(one.largest.value, one.largest.error, 6);
    result += fmt::format("Tension of cable {} over a period: {}.\n", one.cable,
                          least == largest ? least : fmt::format("{} to {}", least, largest));
  }
  return result;
}

}  // namespace tautline::bench
