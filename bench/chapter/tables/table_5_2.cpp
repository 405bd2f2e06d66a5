#include "bench/chapter/tables/tables.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <string>

#include "bench/chapter/tables/print.hpp"
#include "tautline/scenarios.hpp"

namespace tautline::bench {

ChapterTable chapter_table_5_2() {
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

}  // namespace tautline::bench
