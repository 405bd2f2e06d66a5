#include "bench/tools/reproduce/study.hpp"

#include <algorithm>
#include <cmath>
#include <stdexcept>
#include <utility>

#include "bench/base/listed.hpp"
#include "tautline/geometry.hpp"
#include "tautline/multiprecision.hpp"
#include "tautline/solve.hpp"

namespace tautline::bench {
namespace {

double rounded(const Multi& value) { return static_cast<double>(value); }

Vec2 rounded(const BasicVec2<Multi>& value) { return {rounded(value.x()), rounded(value.y())}; }

State rounded(const BasicState<Multi>& state) {
  return {rounded(state.position), rounded(state.angle), rounded(state.velocity),
          rounded(state.spin)};
}

Arc rounded(const BasicArc<BasicCase<Multi>>& arc) {
  Arc result{rounded(arc.start), rounded(arc.end), rounded(arc.initial), arc.taut, {}};
  result.series.resize(arc.series.rows(), 3);
  for (Eigen::Index row = 0; row < arc.series.rows(); ++row) {
    for (Eigen::Index column = 0; column < 3; ++column) {
      result.series(row, column) = rounded(arc.series(row, column));
    }
  }
  return result;
}

Event rounded(const BasicEvent<BasicCase<Multi>>& event) {
  CableVector impulses(event.impulses.size());
  for (Eigen::Index row = 0; row < impulses.size(); ++row) {
    impulses[row] = rounded(event.impulses[row]);
  }
  return {rounded(event.time),   event.kind,          event.cables, impulses,
          rounded(event.before), rounded(event.after)};
}

Accumulation rounded(const BasicAccumulation<Multi>& one) {
  return {rounded(one.start), rounded(one.time), rounded(one.uncertainty), one.cables,
          rounded(one.energy_lost)};
}

Solution rounded(const BasicSolution<BasicCase<Multi>>& solution) {
  const auto of_each = [](const auto& all) {
    return listed(all, [](const auto& one) { return rounded(one); });
  };
  std::optional<Repetition> repetition;
  if (const auto& again = solution.repetition()) {
    repetition = {again->first, rounded(again->period), rounded(again->turn), rounded(again->end)};
  }
  return {in_double(solution.system()),
          of_each(solution.arcs()),
          of_each(solution.events()),
          solution.ending(),
          of_each(solution.accumulations()),
          std::nullopt,
          repetition};
}

ChapterCase solved(std::string_view number, const BasicCase<Multi>& the_case,
                   const Breakwater& parameters) {
  const Case in_doubles = in_double(the_case);
  Solution solution = rounded(solve(the_case, SolveOptions{}));
  Settling settled = settling(in_doubles, solution);
  return {std::string(number), parameters, in_doubles, std::move(solution), std::move(settled)};
}

/// Where the spin of `arc` changes its sign, by halving; its end if it does not.
double turning_angle(const Arc& arc, const Vec2& gravity) {
  double low = 0.0;
  double high = arc.end - arc.start;
  const bool rises = arc.initial.spin > 0.0;
  if ((arc.after(high, gravity).spin > 0.0) == rises) {
    return arc.after(high, gravity).angle;
  }
  constexpr int halvings = 60;  // more than a double has digits
  for (int step = 0; step < halvings; ++step) {
    const double middle = (low + high) / 2;
    ((arc.after(middle, gravity).spin > 0.0) == rises ? low : high) = middle;
  }
  return arc.after(low, gravity).angle;
}

}  // namespace

const ChapterCase& ChapterStudy::at(std::string_view number) const {
  const ChapterCase* const found = find_by(cases, &ChapterCase::number, number);
  if (found == nullptr) {
    throw std::out_of_range("no case " + std::string(number) + " in Table 5.1");
  }
  return *found;
}

ChapterStudy solve_chapter(const std::function<void(std::size_t)>& ended) {
  const tautline::Digits digits(chapter_digits);
  const std::vector<TableRow> in_doubles = table_5_1();
  std::vector<ChapterCase> cases;
  std::optional<ChapterCase> rigid_point;
  double limit_time = 0.0;
  for (std::size_t index = 0; const auto& [number, parameters] : table_5_1<Multi>()) {
    BasicCase<Multi> the_case = breakwater(parameters, "breakwater/" + std::string(number));
    const bool point = is_point_mass(the_case);
    the_case.duration = point ? 40 : 20;  // every e < 1 is locked well before
    cases.push_back(solved(number, the_case, in_doubles[index].parameters));
    if (point) {
      the_case.body.inertia = 1;  // any: the cables have no lever arm
      rigid_point = solved(number, the_case, in_doubles[index].parameters);
    }
    if (parameters.e == 1) {
      the_case.angle_limit = 2 * atan(Multi(1));
      limit_time = rounded(solve(the_case, SolveOptions{}).end_time());
    }
    ended(++index);
  }
  return {std::move(cases), std::move(rigid_point).value(), limit_time};
}

std::size_t impact_count(const Case& the_case, const Solution& solution, double speed) {
  return static_cast<std::size_t>(
      std::count_if(solution.events().begin(), solution.events().end(), [&](const Event& event) {
        return event.kind == EventKind::impact &&
               closing_speed(the_case, event.cables, event.before) > speed;
      }));
}

double fastest_impact(const ChapterCase& solved) {
  double fastest = 0.0;
  for (const Event& event : solved.solution.events()) {
    fastest = std::max(fastest, closing_speed(solved.the_case, event.cables, event.before));
  }
  return fastest;
}

double largest_difference(const ChapterCase& one, const ChapterCase& other) {
  const double end = std::min(one.solution.end_time(), other.solution.end_time());
  double largest = 0.0;
  for (int index = 0; index <= static_cast<int>(100.0 * end); ++index) {
    const State here = one.solution.at(index / 100.0);
    const State there = other.solution.at(index / 100.0);
    largest = std::max({largest, (here.position - there.position).cwiseAbs().maxCoeff(),
                        (here.velocity - there.velocity).cwiseAbs().maxCoeff()});
  }
  return largest;
}

double largest_angle(const ChapterCase& solved) {
  double largest = 0.0;
  for (const Arc& arc : solved.solution.arcs()) {
    largest = std::max({largest, std::abs(arc.initial.angle),
                        std::abs(turning_angle(arc, solved.solution.gravity())),
                        std::abs(solved.solution.at(arc.end).angle)});
  }
  return largest;
}

}  // namespace tautline::bench
