#include "bench/chapter/tables/tables.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <iterator>
#include <string>

#include "bench/chapter/tables/print.hpp"
#include "tautline/geometry.hpp"

namespace tautline::bench {
namespace {

/// The columns of Table 5.3.
constexpr const char* quantities[] = {"t", "x", "vx", "y", "vy", "g1", "g2"};

/// The row whose instant is an event of the exact motion too, before and after it.
constexpr std::string_view first_impact = "1st impact";

/// t, x, vx, y, vy, g1 and g2 of the exact point mass at an instant of Table 5.3; `printed_time`
/// where the instant is no event of the exact motion.
std::vector<double> exact_numbers(const ChapterStudy& study, std::string_view instant,
                                  double printed_time) {
  const ChapterCase& point = study.point_mass();
  const Event& first = point.solution.events().front();
  const bool at_first = instant.starts_with(first_impact);
  const double time = at_first ? first.time : printed_time;
  const State state =
      at_first ? (instant.back() == '-' ? first.before : first.after) : point.solution.at(time);
  // the chapter's g is squared distance less squared length; cable 1 is the right one, g1
  const auto squared = [&](std::size_t index) {
    const Cable& cable = point.the_case.cables[index];
    const double open = gap(cable, state);
    return open * (open - 2.0 * cable.length) + 0.0;  // not -0
  };
  return {
      time,       state.position.x(), state.velocity.x(), state.position.y(), state.velocity.y(),
      squared(1), squared(0)};
}

std::vector<double> differences(const std::vector<std::string_view>& printed,
                                const std::vector<double>& exact) {
  std::vector<double> result;
  std::transform(printed.begin(), printed.end(), exact.begin(), std::back_inserter(result),
                 [](std::string_view cell, double value) { return printed_value(cell) - value; });
  return result;
}

/// Why the chapter's last impact is not the end.
std::string last_impact_note(const ChapterStudy& study) {
  const std::vector<std::string_view> printed = split(printed_table_5_3().back().cells);
  const auto value = [&](std::size_t index) { return printed_value(printed[index]); };
  const double time = value(0);
  const double speed = std::hypot(value(2), value(4));
  const ChapterCase& point = study.point_mass();
  const auto& events = point.solution.events();
  const auto next = std::find_if(events.begin(), events.end(),
                                 [&](const Event& event) { return event.time > time; });
  return fmt::format(
      "The printed *last impact* ends nothing: by its own digits the body still slides along the "
      "right boundary at speed {:.3f}, with energy {:.4f}. The exact motion has no event at that "
      "instant, but one at t = {:.6f} and the next at t = {:.6f}; it comes to rest at t = {:.4f}.",
      speed, speed * speed / 2 + value(3), std::prev(next)->time, next->time,
      point.settling.lock->time);
}

}  // namespace

ChapterTable chapter_table_5_3(const ChapterStudy& study) {
  ChapterTable table{"Table 5.3",
                     "The point mass, case 1900461100: printed and exact.",
                     "table_5_3.csv",
                     2,
                     {{"instant", "", ""},
                      {"quantity", "", ""},
                      {"printed", "", ""},
                      {"exact", "", "{:.10f}"},
                      {"error", "", "{:+.1e}"},
                      {"half a unit", "", "{:.0e}"},
                      {"digits", "", ""}},
                     {},
                     {}};
  std::size_t right = 0;
  std::size_t compared = 0;
  for (const auto& [instant, cells] : printed_table_5_3()) {
    const std::vector<std::string_view> printed = split(cells);
    const std::vector<double> exact = exact_numbers(study, instant, printed_value(printed[0]));
    const std::vector<double> errors = differences(printed, exact);
    for (std::size_t index = 0; index < printed.size(); ++index) {
      if (index == 0 && !instant.starts_with(first_impact)) {
        continue;  // the time at which the others are compared
      }
      const bool good = std::abs(errors[index]) <= half_unit(printed[index]) + printed_rounding;
      right += good ? 1U : 0U;
      ++compared;
      table.rows.push_back({std::string(instant), quantities[index], std::string(printed[index]),
                            exact[index], errors[index], half_unit(printed[index]),
                            good ? "right" : "wrong"});
    }
  }
  const ChapterCase& point = study.point_mass();
  table.notes = {
      fmt::format("*Error* is printed less exact; {} of {} numbers are right to the last digit.",
                  right, compared),
      "The chapter prints each row twice, for its point mass and for its rigid body without "
      "dimensions, with the same digits; the angle and spin of the second are 0, as in truth.",
      fmt::format("Up to t = 15 there are {} impacts, which the chapter locates to 1e-6 in g.",
                  std::count_if(point.solution.events().begin(), point.solution.events().end(),
                                [](const Event& event) { return event.time < 15.0; })),
      last_impact_note(study)};
  return table;
}

std::vector<double> table_5_3_errors(const ChapterStudy& study, std::string_view instant) {
  const std::vector<std::string_view> printed = split(find_printed_state(instant).cells);
  return differences(printed, exact_numbers(study, instant, printed_value(printed.front())));
}

}  // namespace tautline::bench
