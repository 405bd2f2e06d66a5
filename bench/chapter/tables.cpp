#include "bench/chapter/tables.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <map>
#include <stdexcept>

#include "bench/chapter/print.hpp"
#include "tautline/geometry.hpp"

namespace tautline::bench {
namespace {

using nlohmann::ordered_json;
using Row = std::vector<ordered_json>;

/// What becomes of a case, in one word or two.
std::string outcome(const ChapterCase& solved) {
  if (!solved.settling.lock) {
    return "bounces on";
  }
  return solved.settling.lock->rests ? "rest" : "swing";
}

ordered_json lock_number(const ChapterCase& solved, double Lock::*member) {
  const auto& lock = solved.settling.lock;
  return lock ? ordered_json((*lock).*member) : ordered_json();
}

ordered_json swing_number(const ChapterCase& solved, double Swing::*member) {
  const auto& lock = solved.settling.lock;
  return lock && lock->swing ? ordered_json((*lock->swing).*member) : ordered_json();
}

ChapterTable cases_table(const ChapterStudy& study) {
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
  const std::vector<Column> results = {{"h off by", "S", "{:.0e}"},
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
    Row row = {printed.study};
    row.insert(row.end(), cells.begin(), cells.end());
    const Breakwater& p = solved.parameters;
    const double h_error =
        printed_value(cells[2]) - std::sqrt(p.r * p.r - (1.0 - p.a) * (1.0 - p.a));
    worst_h = std::max(worst_h, std::abs(h_error) / half_unit(cells[2]));
    row.insert(
        row.end(),
        {h_error, outcome(solved), impact_count(solved.the_case, solved.solution, counted_speed),
         largest_angle(solved), lock_number(solved, &Lock::time),
         swing_number(solved, &Swing::energy), swing_number(solved, &Swing::amplitude),
         swing_number(solved, &Swing::period)});
    table.rows.push_back(std::move(row));
    uncertainty = std::max(uncertainty, lock_number(solved, &Lock::uncertainty).is_null()
                                            ? 0.0
                                            : solved.settling.lock->uncertainty);
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

ChapterTable inertia_table() {
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
    table.rows.push_back(
        {printed.shape, cells[0], cells[1], cells[2], exact, error, half_unit(cells[2])});
  }
  table.notes = {
      fmt::format("*Error* is printed less exact; the worst is {:.2f} of half a unit of "
                  "the last digit: {}.",
                  worst, worst <= 1.0 ? "every digit is right" : "not all are right")};
  return table;
}

}  // namespace

std::vector<ChapterTable> chapter_tables(const ChapterStudy& study) {
  return {cases_table(study), inertia_table(), table_5_3(study)};
}

}  // namespace tautline::bench
