#include "bench/solution/solution_tables.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cstddef>

#include "bench/base/table.hpp"
#include "bench/base/text.hpp"
#include "bench/solution/solution_text.hpp"
#include "tautline/geometry.hpp"

namespace tautline::bench {
namespace {

/// Events that anyone reads below the summary.
constexpr std::size_t most_events = 20;

/// The fastest closing rate and the sum of the impulses of one event.
std::vector<std::string> event_cells(const Case& the_case, const Event& event) {
  double closing = 0.0;
  for (const std::size_t index : event.cables) {
    closing = std::max(closing, -gap_rate(the_case.cables[index], event.before));
  }
  const State& after = event.after;
  return {fmt::format("{:.12f}", event.time),
          std::string(to_string(event.kind)),
          cable_list(event.cables),
          fmt::format("{:.6e}", closing),
          fmt::format("{:.6e}", event.impulses.sum()),
          fixed_text(after.position.x(), 6),
          fixed_text(after.position.y(), 6),
          fixed_text(after.angle, 6),
          fixed_text(after.velocity.x(), 6),
          fixed_text(after.velocity.y(), 6),
          fixed_text(after.spin, 6)};
}

}  // namespace

std::string events_text(const Case& the_case, const Solution& solution, bool all,
                        const TerminalStyle& style) {
  const std::size_t count = solution.events().size();
  const std::size_t shown = all ? count : std::min(count, most_events);
  if (shown == 0) {
    return "";
  }
  const auto column = [](const char* heading, int rank) {
    Column result;
    result.heading = heading;
    result.rank = rank;
    return result;
  };
  constexpr int velocity = 2;
  constexpr int pose = 1;
  Table table({column("event at", 0), column("kind", 0), column("cables", 0),
               column("closing rate", 0), column("impulse", 0), column("x", pose),
               column("y", pose), column("angle", pose), column("vx", velocity),
               column("vy", velocity), column("spin", velocity)});
  for (std::size_t index = 0; index < shown; ++index) {
    table.add(event_cells(the_case, solution.events()[index]));
  }
  const std::string rest = shown < count
                               ? fmt::format(
                                     "and {} more: --events prints all, --json FILE has them with "
                                     "every digit",
                                     count - shown)
                               : "";
  return "\n" + table.plain(style) + wrapped(rest, style.text);
}

std::string samples_text(const Solution& solution, const std::vector<double>& times,
                         const TerminalStyle& style) {
  constexpr std::size_t longest_number = 24;  // [columns], -1.7976931348623157e+308
  constexpr std::size_t longest_name = 9;     // [columns], "sample at"
  const std::size_t fit =
      std::max<std::size_t>(1, (style.width - longest_name) / (longest_number + 2));
  std::string result;
  for (std::size_t first = 0; first < times.size(); first += fit) {
    std::vector<std::string> headings = {"sample at"};
    std::vector<std::vector<std::string>> rows = {{"x"},  {"y"},  {"angle"},
                                                  {"vx"}, {"vy"}, {"spin"}};
    for (std::size_t index = first; index < std::min(times.size(), first + fit); ++index) {
      const State state = solution.at(times[index]);
      headings.push_back(shortest(times[index]));
      const std::array numbers = {state.position.x(), state.position.y(), state.angle,
                                  state.velocity.x(), state.velocity.y(), state.spin};
      for (std::size_t row = 0; row < rows.size(); ++row) {
        rows[row].push_back(shortest(numbers.at(row)));
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

}  // namespace tautline::bench
