#include <fmt/format.h>

#include <algorithm>

#include "bench/base/table.hpp"
#include "bench/base/text.hpp"
#include "bench/data/coordinates.hpp"
#include "bench/solution/cable_words.hpp"
#include "bench/solution/digits_runs.hpp"
#include "bench/solution/in_digits.hpp"
#include "bench/solution/many_digits.hpp"
#include "bench/solution/right_digits.hpp"
#include "bench/solution/samples.hpp"
#include "bench/solution/texts.hpp"
#include "tautline/geometry.hpp"
#include "tautline/impact.hpp"
#include "tautline/uncertainty.hpp"

namespace tautline::bench {

std::vector<Multi> sample_of(const DigitsRun& run, double time) {
  const Multi at(time);
  const BasicState<Multi> state = run.solution.at(at);
  const BasicCableVector<Multi> tensions = run.solution.tensions(at);
  const CableSet taut = taut_at(run.solution, at);
  std::vector<Multi> result;
  for (const auto& one : coordinates(state)) {
    result.push_back(one.value);
  }
  for (std::size_t index = 0; index < run.the_case.cables.size(); ++index) {
    const BasicCable<Multi>& cable = run.the_case.cables[index];
    const bool slack = !taut.contains(index);
    result.insert(result.end(),
                  {slack ? gap(cable, state) : Multi(0), slack ? gap_rate(cable, state) : Multi(0),
                   tensions[static_cast<Eigen::Index>(index)]});
  }
  result.push_back(energy(run.the_case, state));
  return result;
}

std::string samples_of(const Case& the_case, const DigitsRun& few, const DigitsRun& many,
                       const std::optional<NumberTie>& tie, const ManyDigits& asked,
                       const TerminalStyle& style) {
  const std::size_t longest_number = static_cast<std::size_t>(asked.digits) + 8;  // [columns]
  return samples_table(sample_names(the_case), asked.at, longest_number, style, [&](double time) {
    std::vector<std::string> result;
    if ((tie && time >= tie->time) || time > few.solution.end_time() ||
        time > many.solution.end_time()) {
      return result;
    }
    const std::vector<Multi> a = sample_of(few, time);
    const std::vector<Multi> b = sample_of(many, time);
    for (std::size_t row = 0; row < b.size(); ++row) {
      result.push_back(right_general(b[row], apart(a[row], b[row]), asked.digits));
    }
    return result;
  });
}

std::string rest_tensions_of(const DigitsRun& few, const DigitsRun& many, const ManyDigits& asked) {
  const CableSet taut = many.solution.arcs().back().taut;
  const bool rests =
      many.solution.ending() == Ending::rest || many.solution.ending() == Ending::unstable_rest;
  const BasicState<Multi> state = many.solution.at(many.solution.end_time());
  if (!rests || taut.empty() || few.solution.arcs().back().taut != taut) {
    return "";
  }
  const BasicCableVector<Multi> a = few.solution.tensions(few.solution.end_time());
  const BasicCableVector<Multi> b = many.solution.tensions(many.solution.end_time());
  std::string list;
  for (const std::size_t index : taut) {
    const auto row = static_cast<Eigen::Index>(index);
    list += fmt::format("{}{} on cable {}", list.empty() ? "" : ", ",
                        number_in_words(b[row], apart(a[row], b[row]), asked.digits), index);
  }
  return rest_tension_sentence(list, independent(many.the_case, state, taut));
}

std::string split_line(const DigitsRun& few, const DigitsRun& many, const SolveOptions& options,
                       const ManyDigits& asked) {
  std::string first;
  std::size_t more = 0;
  const auto& events = many.solution.events();
  const std::size_t common = std::min(events.size(), few.solution.events().size());
  CableSet cables;
  std::string time;
  for (std::size_t index = 0; index < common; ++index) {
    const BasicEvent<BasicCase<Multi>>& event = events[index];
    const BasicEvent<BasicCase<Multi>>& other = few.solution.events()[index];
    const CableSet open = indeterminate(options.law, many.the_case, event);
    if (open.empty() || other.cables != event.cables) {
      continue;
    }
    if (!cables.empty()) {
      ++more;
      continue;
    }
    cables = open;
    time = right_general(event.time, apart(other.time, event.time), asked.digits);
    Eigen::Index row = 0;
    for (const std::size_t cable : event.cables) {
      if (open.contains(cable)) {
        first += (first.empty() ? "" : ", ") +
                 number_in_words(event.impulses[row],
                                 apart(other.impulses[row], event.impulses[row]), asked.digits);
      }
      ++row;
    }
  }
  return cables.empty() ? "" : split_sentence(cables, time, first, more) + "\n";
}

std::string events_of(const DigitsRun& few, const DigitsRun& many,
                      const std::optional<NumberTie>& tie, const ManyDigits& asked,
                      const TerminalStyle& style) {
  const auto& events = many.solution.events();
  if (events.empty() && !tie) {
    return "";
  }
  std::vector<Column> columns = {ranked("event at", 0), ranked("kind", 0), ranked("cables", 0),
                                 ranked("impulse", 1)};
  for (const auto& one : coordinates(many.the_case.initial)) {
    columns.push_back(ranked(one.name, one.is_rate ? 3 : 2));
  }
  Table table(std::move(columns));
  const std::size_t most = asked.all_events ? events.size() : std::min(events.size(), most_events);
  std::size_t shown = 0;
  for (; shown < std::min(most, few.solution.events().size()); ++shown) {
    const BasicEvent<BasicCase<Multi>>& a = few.solution.events()[shown];
    const BasicEvent<BasicCase<Multi>>& b = events[shown];
    if ((tie && b.time >= tie->time) || a.kind != b.kind || a.cables != b.cables) {
      break;  // followed further with more digits
    }
    const bool impact = b.kind == EventKind::impact;
    std::vector<std::string> cells = {
        right_general(b.time, apart(a.time, b.time), asked.digits), std::string(to_string(b.kind)),
        cable_list(b.cables),
        impact ? right_scientific(Multi(b.impulses.sum()),
                                  apart(a.impulses.sum(), b.impulses.sum()), asked.digits - 1)
               : dash};
    const auto few_digits = coordinates(a.after);
    for (const auto& one : coordinates(b.after)) {
      const Multi& other = few_digits[cells.size() - 4].value;
      cells.push_back(right_fixed(one.value, apart(other, one.value), asked.digits));
    }
    table.add(cells);
  }
  if (tie && (shown < most || shown == events.size())) {
    table.add(std::vector<std::string>{dash, "beyond the horizon: one of many motions"});
    return "\n" + table.plain(style);
  }
  const std::string rest = shown < events.size()
                               ? fmt::format("and {} more{}", events.size() - shown,
                                             asked.all_events ? ", bounces too low to be told apart"
                                                              : ": --events prints more")
                               : "";
  return "\n" + table.plain(style) + wrapped(rest, style.text);
}

}  // namespace tautline::bench
