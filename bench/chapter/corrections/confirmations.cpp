#include "bench/chapter/corrections/corrections.hpp"

#include <fmt/format.h>

#include <limits>
#include <numbers>
#include <string>

#include "bench/chapter/tables/tables.hpp"
#include "tautline/geometry.hpp"

namespace tautline::bench {
namespace {

Correction rotation_limit(const ChapterStudy& study) {
  std::size_t others = 0;
  for (const ChapterCase& one : study.cases) {
    others += one.parameters.e < 1.0 && largest_angle(one) >= std::numbers::pi / 2 ? 1U : 0U;
  }
  return {true,
          "Section 5.8.1, e = 1",
          "Without losses the rotation passes pi/2.",
          "It does.",
          fmt::format("Case 1110121100 reaches it at t = {:.5f}; {} other case does.",
                      study.limit_time, others == 0 ? "no" : std::to_string(others)),
          {{"time", {study.limit_time}}, {"others", {count(others)}}}};
}

Correction admissible_starts(const ChapterStudy& study) {
  double largest = -std::numeric_limits<double>::infinity();  // of g1 and g2
  std::string closest;
  for (const ChapterCase& one : study.cases) {
    for (const Cable& cable : one.the_case.cables) {
      const double open = gap(cable, one.the_case.initial);
      const double g = open * (open - 2.0 * cable.length);
      if (g > largest) {
        largest = g;
        closest = one.number;
      }
    }
  }
  return {true,
          "Table 5.1",
          "Every case starts with both cables slack.",
          "It does.",
          fmt::format("The largest g of {} starts is {:.4f}, below 0, of case {}.",
                      study.cases.size(), largest, closest),
          {{"cases", {count(study.cases.size())}}, {"largest_g", {largest}}, {"case", {closest}}}};
}

Correction first_impact_holds(const ChapterStudy& study) {
  const double exact = study.point_mass().solution.events().front().time;
  const double error = table_5_3_errors(study, "1st impact -").front();
  return {true,
          "Table 5.3, first impact",
          fmt::format("At t = {:.6f}.", exact + error),
          "To the last printed digit.",
          fmt::format("Exact: t = {:.10f}.", exact),
          {{"exact", {exact}}, {"error", {error}}}};
}

}  // namespace

std::vector<Correction> confirmations(const ChapterStudy& study) {
  return {admissible_starts(study), rotation_limit(study), first_impact_holds(study)};
}

}  // namespace tautline::bench
