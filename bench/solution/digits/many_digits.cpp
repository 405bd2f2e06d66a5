#include "bench/solution/digits/many_digits.hpp"

#include <fmt/format.h>
#include <mpfr.h>

#include <algorithm>
#include <cmath>
#include <cstdlib>

#include "bench/base/table.hpp"
#include "bench/base/text.hpp"
#include "bench/solution/digits/in_digits.hpp"
#include "bench/solution/digits/right_digits.hpp"
#include "bench/solution/digits/summary.hpp"
#include "bench/solution/texts.hpp"
#include "tautline/geometry.hpp"
#include "tautline/scenarios.hpp"
#include "tautline/uncertainty.hpp"

namespace tautline::bench {
namespace {

/// Decimal digits of the first solution beside those asked for, and of the motion after the lock,
/// which loses a few.
constexpr int spare_digits = 15;

/// Where no more digits are tried: a solution of so many takes minutes.
constexpr int enough_digits = 800;

/// Those of the first solution for errors that grow from impact to impact: the doubles of
/// `solution` last up to its horizon. Counted are impacts of another cable than the one before:
/// while a body bounces on one, errors hardly grow. A motion beyond the horizon has other impacts,
/// so it may be too few.
int growing_digits(const Case& the_case, const SolveOptions& options, const Solution& solution) {
  constexpr double of_doubles = 16.0;
  constexpr double most = 200.0;
  const double horizon =
      Uncertainty(the_case, solution, options).horizon().value_or(solution.end_time());
  double sure = 1.0;
  double all = 1.0;
  CableSet before;
  for (const Event& event : solution.events()) {
    const bool other = event.cables != before;
    all += other ? 1.0 : 0.0;
    sure += other && event.time < horizon ? 1.0 : 0.0;
    before = event.cables;
  }
  return static_cast<int>(std::min(most, of_doubles * all / sure));
}

/// The decimals that the doubles of a case are read from.
class Decimals {
 public:
  explicit Decimals(const Literals& written) : written_(written) {}

  /// As it is written in the file at `place`, if that is where the double is from; else the
  /// shortest decimal that it is the nearest to.
  [[nodiscard]] Multi number(const std::string& place, double value) const {
    const auto found = written_.find(place);
    const bool from_there =
        found != written_.end() && std::strtod(found->second.c_str(), nullptr) == value;
    return Multi(from_there ? found->second : shortest(value));
  }
  [[nodiscard]] BasicVec2<Multi> pair(const std::string& place, const Vec2& value) const {
    return {number(place + "[0]", value.x()), number(place + "[1]", value.y())};
  }

 private:
  const Literals& written_;
};

BasicCable<Multi> in_decimals(const Decimals& read, const std::string& place, const Cable& cable) {
  BasicCable<Multi> result{read.pair(place + ".anchor", cable.anchor),
                           read.pair(place + ".attachment", cable.attachment),
                           read.number(place + ".length", cable.length),
                           read.number(place + ".restitution", cable.restitution),
                           read.number(place + ".capture_speed", cable.capture_speed),
                           {}};
  for (std::size_t index = 0; index < cable.restitution_table.size(); ++index) {
    const RestitutionPoint& point = cable.restitution_table[index];
    const BasicVec2<Multi> same = read.pair(fmt::format("{}.restitution_table[{}]", place, index),
                                            {point.speed, point.restitution});
    result.restitution_table.push_back({same.x(), same.y()});
  }
  return result;
}

/// `the_case` with the numbers of Table 5.1 as they are printed if it is of no file, or with the
/// decimals that its doubles are read from.
BasicCase<Multi> in_decimals(const Case& the_case, const Literals& written) {
  const Decimals read(written);
  BasicCase<Multi> result = in_digits(the_case);
  result.duration = read.number("duration", the_case.duration);
  for (const auto& row : table_5_1<Multi>()) {
    if (written.empty() && the_case.name == "breakwater/" + std::string(row.number)) {
      const Multi duration = result.duration;
      result = breakwater<Multi>(row.parameters, the_case.name);
      result.duration = duration;
      return result;
    }
  }
  result.body = {read.number("body.mass", the_case.body.mass),
                 read.number("body.inertia", the_case.body.inertia)};
  result.gravity = read.pair("gravity", the_case.gravity);
  if (the_case.angle_limit) {
    result.angle_limit = read.number("angle_limit", *the_case.angle_limit);
  }
  if (the_case.ceiling) {
    result.ceiling = read.number("ceiling", *the_case.ceiling);
  }
  const State& start = the_case.initial;
  result.initial = {
      read.pair("initial.position", start.position), read.number("initial.angle", start.angle),
      read.pair("initial.velocity", start.velocity), read.number("initial.spin", start.spin)};
  for (std::size_t index = 0; index < the_case.cables.size(); ++index) {
    result.cables[index] =
        in_decimals(read, fmt::format("cables[{}]", index), the_case.cables[index]);
  }
  return result;
}

/// A number rounded to the digits that numbers have now.
Multi rounded(const Multi& value, int digits) { return Multi(value.str(digits)); }

BasicState<Multi> rounded(const BasicState<Multi>& state, int digits) {
  const auto one = [&](const Multi& value) { return rounded(value, digits); };
  return {{one(state.position.x()), one(state.position.y())},
          one(state.angle),
          {one(state.velocity.x()), one(state.velocity.y())},
          one(state.spin)};
}

/// A solution with many digits, and what it settles into.
struct Run {
  BasicCase<Multi> the_case;
  BasicSolution<Multi> solution;
  BasicSettling<Multi> settling;
};

/// Computes `the_case` with many digits up to its lock, and the swing after it, which is as well
/// conditioned as a pendulum, with those that are asked for.
class Solver {
 public:
  Solver(const Case& the_case, const SolveOptions& options, const Solution& solution,
         const ManyDigits& asked)
      : case_(the_case), options_(options), asked_(asked) {
    // the limit of an accumulation is as good as the bounces are small, whose cube is the error
    options_.completion.error = std::pow(10.0, -std::min(300, 3 * asked.digits + 4));
    const Settling settled = settling(the_case, solution);
    // one from the start is no time to end at
    if (settled.lock && settled.lock->permanent && !settled.lock->rests &&
        settled.lock->time > 0.0) {
      constexpr double margin = 0.02;  // [-], of the time of the lock: other motions lock later
      locked_by_ = settled.lock->time * (1.0 + margin) + 2.0 * settled.lock->uncertainty;
    }
  }

  /// With numbers of `digits`.
  [[nodiscard]] Run run(int digits) const {
    if (asked_.on_attempt) {
      asked_.on_attempt(digits);
    }
    const tautline::Digits precision(static_cast<unsigned>(digits));
    BasicCase<Multi> the_case =
        asked_.decimal ? in_decimals(case_, asked_.written) : in_digits(case_);
    const Multi duration = the_case.duration;
    // motions that start alike lock about then, or later: a swing takes longer than the impacts
    for (const double longer : {1.0, 1.2, 1.5}) {
      if (!locked_by_ || Multi(longer * *locked_by_) >= duration) {
        break;
      }
      the_case.duration = Multi(longer * *locked_by_);
      BasicSolution<Multi> solution = solve(the_case, options_);
      BasicSettling<Multi> settled = settled_at(the_case, solution);
      the_case.duration = duration;
      if (settled.lock && settled.lock->swing) {
        return {the_case, std::move(solution), std::move(settled)};
      }
    }
    BasicSolution<Multi> solution = solve(the_case, options_);
    BasicSettling<Multi> settled = settled_at(the_case, solution);
    return {std::move(the_case), std::move(solution), std::move(settled)};
  }

 private:
  /// `settling`, but for the swing, which it finds with fewer digits.
  [[nodiscard]] BasicSettling<Multi> settled_at(const BasicCase<Multi>& the_case,
                                                const BasicSolution<Multi>& solution) const {
    BasicSettling<Multi> result;
    for (const int parts : {100, 1000}) {
      BasicLastImpact<Multi> last{Multi(1) / parts, std::nullopt};
      for (const BasicEvent<Multi>& event : solution.events()) {
        for (const std::size_t index : event.cables) {
          if (event.kind == EventKind::impact &&
              gap_rate(the_case.cables[index], event.before) < -last.speed) {
            last.time = event.time;
          }
        }
      }
      result.last_impacts.push_back(std::move(last));
    }
    const auto& events = solution.events();
    const bool whole =
        solution.ending() == Ending::reached_duration || solution.ending() == Ending::rest;
    if (!whole || events.empty() || events.back().kind != EventKind::taut) {
      return result;
    }
    BasicLock<Multi> lock{
        events.back().time, Multi(0), solution.arcs().back().taut, false, false, {}};
    const auto& accumulations = solution.accumulations();
    if (!accumulations.empty() && accumulations.back().start == lock.time) {
      lock.time = accumulations.back().time;
      lock.uncertainty = accumulations.back().uncertainty;
    }
    lock.rests = solution.ending() == Ending::rest;
    if (!lock.rests) {
      const int few = asked_.digits + spare_digits;
      const tautline::Digits precision(static_cast<unsigned>(few));
      BasicCase<Multi> same =
          asked_.decimal ? in_decimals(case_, asked_.written) : in_digits(case_);
      lock.swing = swing(same, rounded(events.back().after, few));
    }
    lock.permanent = lock.rests || lock.swing.has_value();
    result.lock = std::move(lock);
    return result;
  }

  const Case& case_;
  SolveOptions options_;
  ManyDigits asked_;
  std::optional<double> locked_by_;  // [s]; none: it has no swing to be found apart
};

Multi apart(const Multi& a, const Multi& b) { return abs(Multi(a - b)); }

/// How far two runs are apart in what the summary says, and so how wrong the better one may be.
SummaryErrors<Multi> differences(const Run& few, const Run& many, const Multi& rounding) {
  SummaryErrors<Multi> errors;
  errors.end_time = apart(few.solution.arcs().back().start, many.solution.arcs().back().start);
  if (many.solution.ending() != Ending::rest) {
    errors.end_time = apart(few.solution.end_time(), many.solution.end_time());
  }
  for (std::size_t index = 0; index < many.settling.last_impacts.size(); ++index) {
    const auto& a = few.settling.last_impacts[index].time;
    const auto& b = many.settling.last_impacts[index].time;
    errors.last_impacts.push_back(a && b ? apart(*a, *b) : Multi(a || b ? -1 : 0));
  }
  const auto& a = few.settling.lock;
  const auto& b = many.settling.lock;
  if (a && b && a->cables == b->cables) {
    errors.lock = apart(a->time, b->time) + b->uncertainty;
    if (a->swing && b->swing) {
      errors.amplitude = apart(a->swing->amplitude, b->swing->amplitude) + rounding;
      errors.period = apart(a->swing->period, b->swing->period) + rounding;
      errors.energy = apart(a->swing->energy, b->swing->energy) + rounding;
      return errors;
    }
  }
  const auto end_energy = [](const Run& run) {
    return energy(run.the_case, run.solution.at(run.solution.end_time()));
  };
  errors.energy = few.solution.ending() == many.solution.ending()
                      ? Multi(apart(end_energy(few), end_energy(many)) + rounding)
                      : Multi(-1);
  return errors;
}

bool agree(const Multi& value, const Multi& error, int digits) {
  return error >= 0 && error <= abs(value) * pow(Multi(10), -digits) / 2;
}

/// True where what the summary says is right to `digits`.
bool agree(const Run& many, const SummaryErrors<Multi>& errors, int digits) {
  const auto& lock = many.settling.lock;
  const bool impacts = std::all_of(
      errors.last_impacts.begin(), errors.last_impacts.end(),
      [&](const Multi& error) { return error >= 0 && error <= pow(Multi(10), -digits); });
  if (!lock) {
    return impacts && errors.energy >= 0;
  }
  return impacts && agree(lock->time, errors.lock, digits) &&
         (!lock->swing || agree(lock->swing->energy, errors.energy, digits));
}

/// The events that both have, one row each.
std::string events_of(const Run& few, const Run& many, const ManyDigits& asked,
                      const TerminalStyle& style) {
  const auto& events = many.solution.events();
  if (events.empty()) {
    return "";
  }
  Table table({ranked("event at", 0), ranked("kind", 0), ranked("cables", 0), ranked("impulse", 1),
               ranked("x", 2), ranked("y", 2), ranked("angle", 2), ranked("vx", 3), ranked("vy", 3),
               ranked("spin", 3)});
  const std::size_t most = asked.all_events ? events.size() : std::min(events.size(), most_events);
  std::size_t shown = 0;
  for (; shown < std::min(most, few.solution.events().size()); ++shown) {
    const BasicEvent<Multi>& a = few.solution.events()[shown];
    const BasicEvent<Multi>& b = events[shown];
    if (a.kind != b.kind || a.cables != b.cables) {
      break;  // followed further with more digits
    }
    const auto cell = [&](const Multi& one, const Multi& other) {
      return right_fixed(other, apart(one, other), asked.digits);
    };
    const BasicState<Multi>& p = a.after;
    const BasicState<Multi>& q = b.after;
    const bool impact = b.kind == EventKind::impact;
    table.add(std::vector<std::string>{
        right_general(b.time, apart(a.time, b.time), asked.digits), std::string(to_string(b.kind)),
        cable_list(b.cables),
        impact ? right_scientific(Multi(b.impulses.sum()),
                                  apart(a.impulses.sum(), b.impulses.sum()), asked.digits - 1)
               : dash,
        cell(p.position.x(), q.position.x()), cell(p.position.y(), q.position.y()),
        cell(p.angle, q.angle), cell(p.velocity.x(), q.velocity.x()),
        cell(p.velocity.y(), q.velocity.y()), cell(p.spin, q.spin)});
  }
  const std::string rest = shown < events.size()
                               ? fmt::format("and {} more{}", events.size() - shown,
                                             asked.all_events ? ", bounces too low to be told apart"
                                                              : ": --events prints more")
                               : "";
  return "\n" + table.plain(style) + wrapped(rest, style.text);
}

}  // namespace

std::string many_digits_text(const Case& the_case, const SolveOptions& options,
                             const Solution& solution, const ManyDigits& asked,
                             const TerminalStyle& style) {
  const Solver solver(the_case, options, solution, asked);
  int digits = asked.digits + 2 * spare_digits +
               std::max(asked.digits, growing_digits(the_case, options, solution));
  Run few = solver.run(digits);
  int more = std::max(digits / 8, spare_digits);  // enough to tell the errors of the fewer
  while (true) {
    digits += more;
    more = digits / 2;
    Run many = solver.run(digits);
    const tautline::Digits precision(static_cast<unsigned>(digits));
    const Multi rounding = pow(Multi(10), -(asked.digits + spare_digits - 3));
    const SummaryErrors<Multi> errors = differences(few, many, rounding);
    if (!agree(many, errors, asked.digits) && digits <= enough_digits) {
      few = std::move(many);
      continue;
    }
    const Figures figures{asked.digits, asked.digits};
    return fmt::format("{}: {} right digits of its {}, with numbers of {} digits\n\n",
                       printable(the_case.name), asked.digits,
                       asked.decimal ? "decimals" : "doubles", digits) +
           wrapped_lines(
               Summary<Multi>(many.the_case, many.solution, many.settling, errors, figures).text(),
               style.text) +
           events_of(few, many, asked, style);
  }
}

}  // namespace tautline::bench
