#include "bench/chapter/tables/tables.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include "bench/chapter/tables/print.hpp"

namespace tautline::bench {
namespace {

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

}  // namespace

ChapterTable chapter_table_5_1(const ChapterStudy& study) {
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
      fmt::format("*Impacts* counts those that close faster than {:g}. *Lock* is the instant from "
                  "which on the cables stay taut, the limit of the last accumulation of impacts, "
                  "within {:.0e}; *swing energy* is counted from the equilibrium.",
                  counted_speed, uncertainty),
      fmt::format("Case 1110121100 loses no energy and never locks: its numbers are those of the "
                  "first {:g} time units, beyond the chapter's rotation limit at t = {:.4f}.",
                  study.at("1110121100").the_case.duration, study.limit_time)};
  return table;
}

}  // namespace tautline::bench
