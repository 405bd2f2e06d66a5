#include "bench/solution/texts.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <cstddef>

#include "bench/base/table.hpp"
#include "bench/base/text.hpp"
#include "bench/data/coordinates.hpp"
#include "bench/solution/cable_words.hpp"
#include "bench/solution/right_digits.hpp"
#include "bench/solution/samples.hpp"
#include "bench/solution/time_errors.hpp"
#include "tautline/geometry.hpp"

namespace tautline::bench {
namespace {

/// Digits after the point of a time, and of the numbers of a state.
constexpr int time_digits = 12;
constexpr int state_digits = 6;

/// The cells of the numbers of a state.
void add_state(std::vector<std::string>& cells, const State& state, const State& errors) {
  for (const Bounded& one : bounded(state, errors)) {
    cells.push_back(right_fixed(one.value, one.error, state_digits));
  }
}

/// Of an accumulation: its limit, the cables and the state there. Infinitely many impacts have no
/// rate and no impulse.
std::vector<std::string> accumulation_cells(const Solution& solution,
                                            const Uncertainty& uncertainty, const Event& event,
                                            const Accumulation& accumulation) {
  const double error = limit_error(solution, uncertainty, accumulation).value_or(-1.0);
  std::vector<std::string> cells = {right_fixed(accumulation.time, error, time_digits),
                                    std::string(to_string(event.kind)), cable_list(event.cables),
                                    dash, dash};
  const double limit = std::min(accumulation.time, solution.end_time());
  if (const auto at_limit = uncertainty.at(limit)) {
    const State state = solution.at(limit);
    State off = *at_limit;  // and what the motion goes within the error of the limit
    off.position += error * state.velocity.cwiseAbs();
    off.angle += error * std::abs(state.spin);
    const State later = solution.at(std::min(limit + error, solution.end_time()));
    off.velocity += 2.0 * (later.velocity - state.velocity).cwiseAbs();
    off.spin += 2.0 * std::abs(later.spin - state.spin);
    add_state(cells, state, off);
  } else {
    cells.insert(cells.end(), coordinates(event.after).size(), dash);
  }
  return cells;
}

/// The fastest closing rate and the sum of the impulses of one event.
std::vector<std::string> event_cells(const Case& the_case, const Solution& solution,
                                     const Uncertainty& uncertainty, const Event& event,
                                     const EventErrors& errors) {
  if (const Accumulation* const accumulation = accumulation_at(solution, event)) {
    return accumulation_cells(solution, uncertainty, event, *accumulation);
  }
  const double closing = closing_speed(the_case, event.cables, event.before);
  const bool impact = event.kind == EventKind::impact;
  std::vector<std::string> cells = {
      right_fixed(event.time, errors.time, time_digits), std::string(to_string(event.kind)),
      cable_list(event.cables), impact ? right_scientific(closing, errors.rate, 6) : dash,
      impact ? right_scientific(event.impulses.sum(), errors.impulses.sum(), 6) : dash};
  add_state(cells, event.after, errors.after);
  return cells;
}

}  // namespace

std::string events_text(const Case& the_case, const Solution& solution,
                        const Uncertainty& uncertainty, bool all, const TerminalStyle& style) {
  const std::size_t count = solution.events().size();
  const std::size_t shown = all ? count : std::min(count, most_events);
  if (shown == 0) {
    return "";
  }
  std::vector<Column> columns = {ranked("event at", 0), ranked("kind", 0), ranked("cables", 0),
                                 ranked("closing rate", 0), ranked("impulse", 0)};
  for (const auto& one : coordinates(the_case.initial)) {
    columns.push_back(ranked(one.name, one.is_rate ? 2 : 1));
  }
  Table table(std::move(columns));
  for (std::size_t index = 0; index < shown; ++index) {
    const auto& errors = uncertainty.events()[index];
    if (errors) {
      table.add(event_cells(the_case, solution, uncertainty, solution.events()[index], *errors));
    } else if (index == 0 || uncertainty.events()[index - 1]) {
      table.add(std::vector<std::string>{dash, "beyond the horizon: one of many motions"});
    }
  }
  const std::string rest = shown < count
                               ? fmt::format(
                                     "and {} more: --events prints all, --json FILE has them with "
                                     "every digit",
                                     count - shown)
                               : "";
  return "\n" + table.plain(style) + wrapped(rest, style.text);
}

}  // namespace tautline::bench
