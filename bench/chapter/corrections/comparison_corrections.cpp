#include "bench/chapter/corrections/corrections.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include "bench/chapter/figures/figure_data.hpp"
#include "bench/chapter/tables/print.hpp"
#include "bench/chapter/tables/tables.hpp"
#include "tautline/geometry.hpp"

namespace tautline::bench {
namespace {

Correction special_code(const ChapterStudy& study) {
  const double difference = largest_difference(study.point_mass(), study.rigid_point);
  return {
      false,
      "Section 5.8.2",
      "The point mass needs a modified matrix, or Eq. 5.80 is singular.",
      "It needs none: with a lever arm of 0 the closed form of the impulse holds at any inertia "
      "above 0. The angle then takes no part.",
      fmt::format("The point mass and a body with inertia {:g} and no lever arm differ by {:g} at "
                  "most, up to t = {:g}.",
                  study.rigid_point.the_case.body.inertia, difference,
                  study.rigid_point.solution.end_time()),
      {{"largest_difference", {difference}}}};
}

Correction state_at_15(const ChapterStudy& study) {
  const std::vector<double> errors = table_5_3_errors(study, "t = 15");
  return {
      false,
      "Table 5.3, t = 15",
      "Six decimals of the state after 15 time units.",
      "Not all of them are right: each impact is located to 1e-6 in g only, and there are many.",
      fmt::format("Printed less exact: x {:+.1e}, x' {:+.1e}, y {:+.1e}, y' {:+.1e}.", errors[1],
                  errors[2], errors[3], errors[4]),
      {{"x", {errors[1]}}, {"vx", {errors[2]}}, {"y", {errors[3]}}, {"vy", {errors[4]}}}};
}

Correction late_constraints(const ChapterStudy& study) {
  const std::vector<std::string_view> printed = split(find_printed_state("1st impact -").cells);
  const ChapterCase& point = study.point_mass();
  const Cable& right = point.the_case.cables[1];
  const auto g1 = [&](const Vec2& position) {
    State state;
    state.position = position;
    const double open = gap(right, state);
    return open * (open - 2.0 * right.length);
  };
  const double own = g1({printed_value(printed[1]), printed_value(printed[3])});
  const double end = std::ceil(printed_value(printed[0]) / figure_step) * figure_step;
  const Arc& flight = point.solution.arcs().front();
  const double later = g1(flight.after(end, point.solution.gravity()).position);
  return {
      false,
      "Table 5.3, g1 at the first impact",
      fmt::format("g1 = {} at the first impact.", printed[5]),
      "That is g1 at the end of the time step in which the impact falls, as if there had been no "
      "impact.",
      fmt::format("From the printed x and y of the impact: g1 = {:.6f}. From the flight before it, "
                  "followed to t = {:g}: g1 = {:.6f}.",
                  own, end, later),
      {{"printed", {printed_value(printed[5])}}, {"at_impact", {own}}, {"at_step_end", {later}}}};
}

Correction last_impact(const ChapterStudy& study) {
  const double printed = printed_value(split(printed_table_5_3().back().cells).front());
  const ChapterCase& point = study.point_mass();
  const auto later = std::count_if(
      point.solution.events().begin(), point.solution.events().end(), [&](const Event& event) {
        return event.time > printed && event.kind == EventKind::impact &&
               closing_speed(point.the_case, event) > counted_speed;
      });
  return {
      false,
      "Table 5.3, last impact",
      fmt::format("The last impact is at t = {:.6f}.", printed),
      "A program that cannot tell small bounces from none ends in the first accumulation of "
      "impacts on one cable. From there the body slides along that cable's boundary until it hits "
      "the other cable, again and again.",
      fmt::format("{} impacts faster than {:g} follow; the point mass rests from t = {:.4f} on.",
                  later, counted_speed, point.settling.lock.value().time),
      {{"printed", {printed}},
       {"later_impacts", {static_cast<long>(later)}},
       {"rest", {point.settling.lock.value().time}}}};
}

}  // namespace

std::vector<Correction> comparison_corrections(const ChapterStudy& study) {
  return {special_code(study), late_constraints(study), state_at_15(study), last_impact(study)};
}

}  // namespace tautline::bench
