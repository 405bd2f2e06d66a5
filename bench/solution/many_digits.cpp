#include "bench/solution/many_digits.hpp"

#include <fmt/format.h>
#include <mpfr.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <optional>

#include "bench/base/text.hpp"
#include "bench/data/coordinates.hpp"
#include "bench/solution/digits_runs.hpp"
#include "bench/solution/digits_summary.hpp"
#include "bench/solution/digits_ties.hpp"
#include "bench/solution/in_decimals.hpp"
#include "bench/solution/in_digits.hpp"
#include "bench/solution/right_digits.hpp"
#include "bench/solution/texts.hpp"
#include "tautline/geometry.hpp"
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

/// A number rounded to the digits that numbers have now.
Multi rounded(const Multi& value, int digits) { return Multi(value.str(digits)); }

BasicState<Multi> rounded(const BasicState<Multi>& state, int digits) {
  BasicState<Multi> result = state;
  for (const auto& one : coordinates(result)) {
    one.value = rounded(one.value, digits);
  }
  return result;
}

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
      for (const double time : asked.at) {  // samples are of the motion itself
        locked_by_ = std::max(*locked_by_, time);
      }
    }
  }

  /// The cables at a dead point at the start, by numbers of `digits`: no solution needs to be
  /// tried.
  [[nodiscard]] CableSet dead_at_start(int digits) const {
    const tautline::Digits precision(static_cast<unsigned>(digits));
    return tautline::dead_at_start(asked_.decimal ? in_decimals(case_, asked_.written)
                                                  : in_digits(case_));
  }

  /// With numbers of `digits`.
  [[nodiscard]] DigitsRun run(int digits) const {
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
      BasicSolution<BasicCase<Multi>> solution = solve(the_case, options_);
      BasicSettling<Multi> settled = settled_at(the_case, solution);
      the_case.duration = duration;
      if (settled.lock && settled.lock->swing) {
        return {digits, the_case, std::move(solution), std::move(settled)};
      }
    }
    BasicSolution<BasicCase<Multi>> solution = solve(the_case, options_);
    BasicSettling<Multi> settled = settled_at(the_case, solution);
    return {digits, std::move(the_case), std::move(solution), std::move(settled)};
  }

 private:
  /// `settling`, but for the swing, which it finds with fewer digits.
  [[nodiscard]] BasicSettling<Multi> settled_at(
      const BasicCase<Multi>& the_case, const BasicSolution<BasicCase<Multi>>& solution) const {
    BasicSettling<Multi> result;
    result.last_impacts = last_impacts(the_case, solution);
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

/// How far two runs are apart in what the summary says, and so how wrong the better one may be.
SummaryErrors<Multi> differences(const DigitsRun& few, const DigitsRun& many,
                                 const Multi& rounding) {
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
  const auto end_energy = [](const DigitsRun& run) {
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

/// True where the samples are right to `digits`; of a number that may be zero so many after those
/// of the largest.
bool samples_agree(const DigitsRun& few, const DigitsRun& many, const std::vector<double>& times,
                   int digits) {
  return std::all_of(times.begin(), times.end(), [&](double time) {
    if (time > many.solution.end_time() || time > few.solution.end_time()) {
      return true;  // beyond what both have
    }
    const std::vector<Multi> a = sample_of(few, time);
    const std::vector<Multi> b = sample_of(many, time);
    Multi largest(0);
    for (const Multi& number : b) {
      largest = max(largest, Multi(abs(number)));
    }
    for (std::size_t index = 0; index < b.size(); ++index) {
      const Multi error = apart(a[index], b[index]);
      if (!agree(b[index], error, digits) &&
          !(error <= largest * pow(Multi(10), -digits - spare_digits))) {
        return false;
      }
    }
    return true;
  });
}

/// True where what the summary says is right to `digits`.
bool agree(const DigitsRun& many, const SummaryErrors<Multi>& errors, int digits) {
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

}  // namespace

std::string many_digits_text(const Case& the_case, const SolveOptions& options,
                             const Solution& solution, const ManyDigits& asked,
                             const TerminalStyle& style) {
  const Solver solver(the_case, options, solution, asked);
  int digits = asked.digits + 2 * spare_digits +
               std::max(asked.digits, growing_digits(the_case, options, solution));
  const auto head = [&] {
    return fmt::format("{}: {} right digits, for the {} of the case, computed in {} digits\n\n",
                       printable(the_case.name), asked.digits,
                       asked.decimal ? "decimals" : "doubles", digits);
  };
  const std::string open_end =
      "\nAfter that everything is beyond the horizon: more digits do not decide which of many "
      "motions "
      "follows.\n";
  if (const CableSet dead = solver.dead_at_start(digits); !dead.empty()) {
    return head() + wrapped_lines(tie_sentence(EventKind::taut, dead, "0") + open_end, style.text);
  }
  DigitsRun few = solver.run(digits);
  int more = std::max(digits / 8, spare_digits);  // enough to tell the errors of the fewer
  while (true) {
    digits += more;
    more = digits / 2;
    DigitsRun many = solver.run(digits);
    const tautline::Digits precision(static_cast<unsigned>(digits));
    const Multi rounding = pow(Multi(10), -(asked.digits + spare_digits - 3));
    const SummaryErrors<Multi> errors = differences(few, many, rounding);
    const auto tie = common_tie(first_tie(few.the_case, few.solution, few.digits),
                                first_tie(many.the_case, many.solution, many.digits));
    if (tie) {  // one that more digits do not decide
      const std::string time = fmt::format("{:.6g}", static_cast<double>(tie->time));
      return head() +
             wrapped_lines(tie_sentence(tie->tie.kind, tie->tie.cables, time) + open_end +
                               split_line(few, many, options, asked),
                           style.text) +
             samples_of(the_case, few, many, tie, asked, style) +
             events_of(few, many, tie, asked, style);
    }
    if (!(agree(many, errors, asked.digits) && samples_agree(few, many, asked.at, asked.digits)) &&
        digits <= enough_digits) {
      few = std::move(many);
      continue;
    }
    const Figures figures{asked.digits, asked.digits};
    return head() +
           wrapped_lines(
               Summary<Multi>(many.the_case, many.solution, many.settling, errors, figures).text() +
                   rest_tensions_of(few, many, asked) + split_line(few, many, options, asked),
               style.text) +
           samples_of(the_case, few, many, {}, asked, style) +
           events_of(few, many, {}, asked, style);
  }
}

}  // namespace tautline::bench
