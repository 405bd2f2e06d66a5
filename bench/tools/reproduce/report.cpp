#include "bench/tools/reproduce/report.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <iterator>
#include <string>

#include "bench/tools/reproduce/source.hpp"
#include "tautline/geometry.hpp"
#include "tautline/scenarios.hpp"
#include "tautline_bench_reproduce_words.inc"

namespace tautline::bench {

namespace {

using namespace fmt::literals;

/// What becomes of a case, in one word or two.
std::string outcome(const ChapterCase& solved) {
  if (!solved.settling.lock) {
    return "bounces on";
  }
  return solved.settling.lock->rests ? "rest" : "swing";
}

ChapterCell lock_number(const ChapterCase& solved, double Lock::*member) {
  const auto& lock = solved.settling.lock;
  return lock ? ChapterCell((*lock).*member) : ChapterCell();
}

ChapterCell swing_number(const ChapterCase& solved, double Swing::*member) {
  const auto& lock = solved.settling.lock;
  return lock && lock->swing ? ChapterCell((*lock->swing).*member) : ChapterCell();
}

/// What is printed in a row of the table, then what was computed.
std::vector<ChapterCell> row_of(const PrintedCase& printed, const ChapterCase& solved,
                                double h_error) {
  std::vector<ChapterCell> row = {std::string(printed.study)};
  for (const std::string_view cell : split(printed.cells)) {
    row.emplace_back(std::string(cell));
  }
  row.insert(
      row.end(),
      {h_error, outcome(solved),
       count(impact_count(solved.the_case, solved.solution, counted_speed)), largest_angle(solved),
       lock_number(solved, &Lock::time), swing_number(solved, &Swing::energy),
       swing_number(solved, &Swing::amplitude), swing_number(solved, &Swing::period)});
  return row;
}

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
  return fmt::format(words::ends_nothing, "speed"_a = speed,
                     "energy"_a = speed * speed / 2 + value(3), "before"_a = std::prev(next)->time,
                     "next"_a = next->time, "rest"_a = point.settling.lock->time);
}

/// Parameters and starts, and what becomes of them.
ChapterTable starts_table(const ChapterStudy& study) {
  ChapterTable table{"Table 5.1",
                     "Parameters and starts as printed, and what becomes of them.",
                     "table_5_1.csv",
                     2,
                     {{"study", "", ""}, {"case", "", ""}},
                     {},
                     {}};
  for (const char* name : {"r", "h", "e", "a", "b", "x", "vx", "y", "vy", "theta", "vtheta"}) {
    table.columns.push_back({name, "", ""});
  }
  const std::vector<ChapterColumn> results = {{"h off by", "S", "{:.0e}"},
                                              {"outcome", "", ""},
                                              {"impacts", "", ""},
                                              {"largest angle", "rad", "{:.4f}"},
                                              {"lock", "sqrt(S/g)", "{:.4f}"},
                                              {"swing energy", "mgS", "{:.6f}"},
                                              {"amplitude", "rad", "{:.4f}"},
                                              {"period", "sqrt(S/g)", "{:.4f}"}};
  table.columns.insert(table.columns.end(), results.begin(), results.end());
  double uncertainty = 0.0;
  double worst_h = 0.0;  // in half units of its last digit
  for (const PrintedCase& printed : printed_table_5_1()) {
    const std::vector<std::string_view> cells = split(printed.cells);
    const ChapterCase& solved = study.at(cells.front());
    const Breakwater& p = solved.parameters;
    const double h_error =
        printed_value(cells[2]) - std::sqrt(p.r * p.r - (1.0 - p.a) * (1.0 - p.a));
    worst_h = std::max(worst_h, std::abs(h_error) / half_unit(cells[2]));
    table.rows.push_back(row_of(printed, solved, h_error));
    if (const auto& lock = solved.settling.lock) {
      uncertainty = std::max(uncertainty, lock->uncertainty);
    }
  }
  table.notes = {
      fmt::format("{} rows, {} distinct cases: the standard case opens most studies.",
                  table.rows.size(), study.cases.size()),
      fmt::format(
          "*h off by* is printed less exact: at most {:.2f} of half a unit of its last digit.",
          worst_h),
      fmt::format(words::columns_of_starts, "speed"_a = counted_speed,
                  "uncertainty"_a = uncertainty),
      fmt::format(words::elastic_case, "until"_a = study.at("1110121100").the_case.duration,
                  "limit"_a = study.limit_time)};
  return table;
}

/// Moments of inertia.
ChapterTable inertias_table() {
  ChapterTable table{"Table 5.2",
                     "Moments of inertia, printed and exact.",
                     "table_5_2.csv",
                     1,
                     {{"shape", "", ""},
                      {"a", "S", ""},
                      {"b", "S", ""},
                      {"printed I", "mS^2", ""},
                      {"exact I", "mS^2", "{:.7f}"},
                      {"error", "mS^2", "{:+.1e}"},
                      {"half a unit", "mS^2", "{:.1e}"}},
                     {},
                     {}};
  double worst = 0.0;
  for (const PrintedInertia& printed : printed_table_5_2()) {
    const std::vector<std::string_view> cells = split(printed.cells);
    Breakwater body;
    body.a = printed_value(cells[0]);
    body.b = printed_value(cells[1]);
    body.shape = printed.shape == "circle" ? Shape::ring : Shape::box;
    const double exact = breakwater(body, "").body.inertia;
    double error = printed_value(cells[2]) - exact;
    error = std::abs(error) <= printed_rounding ? 0.0 : error;
    worst = std::max(worst, std::abs(error) / half_unit(cells[2]));
    table.rows.push_back({std::string(printed.shape), std::string(cells[0]), std::string(cells[1]),
                          std::string(cells[2]), exact, error, half_unit(cells[2])});
  }
  table.notes = {
      fmt::format("*Error* is printed less exact; the worst is {:.2f} of half a unit of "
                  "the last digit: {}.",
                  worst, worst <= 1.0 ? "every digit is right" : "not all are right")};
  return table;
}

/// States of the point mass.
ChapterTable states_table(const ChapterStudy& study) {
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
      words::printed_twice,
      fmt::format("Up to t = 15 there are {} impacts, which the chapter locates to 1e-6 in g.",
                  std::count_if(point.solution.events().begin(), point.solution.events().end(),
                                [](const Event& event) { return event.time < 15.0; })),
      last_impact_note(study)};
  return table;
}

}  // namespace

std::string cell_text(const ChapterCell& cell, const ChapterColumn& column) {
  if (const auto* const words = std::get_if<std::string>(&cell)) {
    return *words;
  }
  if (const auto* const number = std::get_if<double>(&cell)) {
    return fmt::format(fmt::runtime(column.format), *number);
  }
  const auto* const whole = std::get_if<long>(&cell);
  return whole != nullptr ? std::to_string(*whole) : "–";
}

std::vector<ChapterTable> chapter_tables(const ChapterStudy& study) {
  return {starts_table(study), inertias_table(), states_table(study)};
}

std::vector<double> table_5_3_errors(const ChapterStudy& study, std::string_view instant) {
  const std::vector<std::string_view> printed = split(find_printed_state(instant).cells);
  return differences(printed, exact_numbers(study, instant, printed_value(printed.front())));
}

ChapterReport chapter_report(const ChapterStudy& study) {
  return {fmt::format(words::introduction, "source"_a = source_chapter),
          {words::units, fmt::format(words::how_solved, "digits"_a = chapter_digits),
           words::how_computed},
          chapter_tables(study),
          chapter_figures(study),
          chapter_corrections(study)};
}

}  // namespace tautline::bench
