#include "bench/solution/texts.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <span>
#include <utility>

#include "bench/solution/cable_words.hpp"
#include "bench/solution/digits_summary.hpp"
#include "bench/solution/right_digits.hpp"
#include "bench/solution/time_errors.hpp"
#include "tautline/detail/rounding.hpp"
#include "tautline/geometry.hpp"

namespace tautline::bench {
namespace {

/// What errors of the energy do to the numbers of a swing: it is one of a family that differ in
/// energy alone, of which a neighbour is measured.
void swing_errors(const Case& the_case, const State& state, const Swing& found,
                  SummaryErrors<double>& errors) {
  constexpr double part = 1e-3;  // [-], of the velocity
  State neighbour = state;
  neighbour.velocity *= 1.0 + part;
  neighbour.spin *= 1.0 + part;
  const auto other = swing(the_case, neighbour);
  const double difference = other ? std::abs(other->energy - found.energy) : 0.0;
  if (difference > 0.0) {
    errors.amplitude = std::abs(other->amplitude - found.amplitude) / difference * errors.energy;
    errors.period = std::abs(other->period - found.period) / difference * errors.energy;
  } else {
    errors.amplitude = found.amplitude / found.energy * errors.energy;
    errors.period = found.period / found.energy * errors.energy;
  }
  // turning points are found to the root of rounding at worst, and the series to rounding
  constexpr double measured = 1e-11;                                                   // [-]
  errors.amplitude += measured * found.amplitude + few_roundings * epsilon<double>();  // of a rad
  errors.period += measured * found.period;
}

SummaryErrors<double> summary_errors(const Case& the_case, const Solution& solution,
                                     const Settling& settling, const Uncertainty& uncertainty) {
  SummaryErrors<double> errors;
  const double end = solution.end_time();
  errors.energy = uncertainty.energy(end).value_or(-1.0);
  for (const LastImpact& last : settling.last_impacts) {
    errors.last_impacts.push_back(
        last.time ? time_error(solution, uncertainty, *last.time, EventKind::impact).value_or(-1.0)
                  : 0.0);
  }
  if (settling.lock) {
    errors.lock = lock_error(solution, settling, uncertainty).value_or(-1.0);
    if (settling.lock->swing && errors.energy >= 0.0) {
      swing_errors(the_case, solution.events().back().after, *settling.lock->swing, errors);
    }
  }
  if (solution.ending() == Ending::rest || solution.ending() == Ending::unstable_rest) {
    const Event& last = solution.events().back();
    errors.end_time = time_error(solution, uncertainty, last.time, last.kind).value_or(-1.0);
  } else if (const auto state = uncertainty.at(end)) {  // where a limit of the case is passed
    const State last = solution.at(end);
    const double speed = last.velocity.norm() + std::abs(last.spin) * attachment_radius(the_case);
    const double off =
        state->position.norm() + state->angle * std::max(attachment_radius(the_case), 1.0);
    errors.end_time = speed > 0.0 ? off / speed + 1e-15 * end : -1.0;
  }
  return errors;
}

/// Two instants with as many digits as show that they differ.
std::pair<std::string, std::string> told_apart(double from, double until) {
  for (int digits = 6; digits < std::numeric_limits<double>::max_digits10; ++digits) {
    const std::string a = fmt::format("{:.{}g}", from, digits);
    const std::string b = fmt::format("{:.{}g}", until, digits);
    if (a != b) {
      return {a, b};
    }
  }
  return {shortest(from), shortest(until)};
}

/// What rounding decides at the start of `stretch`, a line; "" where errors have grown.
std::string tie_line(const Unsure& stretch) {
  return stretch.tie ? tie_sentence(stretch.tie->kind, stretch.tie->cables,
                                    fmt::format("{:.6g}", stretch.from)) +
                           "\n"
                     : "";
}

/// The first impact whose impulses may be split in other ways, and how many more there are.
std::string split_line(const Solution& solution, const Uncertainty& uncertainty) {
  const auto& all = uncertainty.events();
  const auto is_open = [](const std::optional<EventErrors>& errors) {
    return errors && !errors->indeterminate.empty();
  };
  const auto first = std::find_if(all.begin(), all.end(), is_open);
  if (first == all.end()) {
    return "";
  }
  const Event& event = solution.events()[static_cast<std::size_t>(first - all.begin())];
  std::string impulses;
  Eigen::Index row = 0;
  for (const std::size_t index : event.cables) {
    if ((*first)->indeterminate.contains(index)) {
      impulses += (impulses.empty() ? "" : ", ") +
                  number_in_words(event.impulses[row], (*first)->impulses[row], 6);
    }
    ++row;
  }
  return split_sentence((*first)->indeterminate, right_fixed(event.time, (*first)->time, 6),
                        impulses,
                        static_cast<std::size_t>(std::count_if(first + 1, all.end(), is_open))) +
         "\n";
}

/// Stretches after which all motions are alike again, the first of them in full.
std::string meetings_text(std::span<const Unsure> stretches) {
  constexpr std::size_t most_in_full = 3;
  std::string result;
  for (const Unsure& stretch : stretches.first(std::min(stretches.size(), most_in_full))) {
    const auto [from, until] = told_apart(stretch.from, stretch.until);
    result += tie_line(stretch);
    result += fmt::format(
        "Between t = {} and {} the order of impacts is beyond the horizon: this is one of many "
        "motions, which all have the same cables taut at its end.\n",
        from, until);
  }
  if (stretches.size() > most_in_full) {
    const std::size_t more = stretches.size() - most_in_full;
    const auto [from, until] = told_apart(stretches.back().from, stretches.back().until);
    result += more == 1
                  ? fmt::format("The same holds between t = {} and {}.\n", from, until)
                  : fmt::format("The same holds in {} more stretches up to t = {}.\n", more, until);
  }
  return result;
}

/// Where the solution is one of many, and what is sure there all the same.
std::string horizon_text(const Case& the_case, const Solution& solution,
                         const Uncertainty& uncertainty) {
  const std::vector<Unsure>& all = uncertainty.unsure();
  const bool lost = !all.empty() && !(all.back().until <= solution.end_time());  // to the end
  std::string result = meetings_text(std::span(all).first(all.size() - (lost ? 1U : 0U)));
  if (lost) {
    const double since = all.back().from;
    const double before = std::max(0.0, std::nextafter(since, 0.0));
    const double error = uncertainty.energy(before).value_or(-1.0);
    const double start = energy(the_case, the_case.initial);
    const double taken = start - energy(the_case, solution.at(before));
    const double rounding = error + few_roundings * epsilon<double>() * std::abs(start);
    const std::string left =
        error < 0.0
            ? ""
            : fmt::format(", and impacts have taken {} of it by then",
                          taken <= rounding ? "nothing" : number_in_words(taken, rounding, 6));
    result += tie_line(all.back());
    result += fmt::format(
        "From t = {:.6g} on the motion is beyond the horizon: this is one of many. Only its energy "
        "is "
        "certain: it does not grow{}. --digits N {}, which may take long.\n",
        since, left,
        all.back().tie ? "finds out whether more digits decide it" : "computes the right one");
  }
  return result;
}

}  // namespace

std::string solution_text(const Case& the_case, const Solution& solution, const Settling& settling,
                          const Uncertainty& uncertainty) {
  const SummaryErrors<double> errors = summary_errors(the_case, solution, settling, uncertainty);
  return Summary<double>(the_case, solution, settling, errors, Figures{}).text() +
         rest_tensions_text(the_case, solution, uncertainty) +
         period_tensions_text(the_case, solution, settling, uncertainty) +
         split_line(solution, uncertainty) + horizon_text(the_case, solution, uncertainty);
}

}  // namespace tautline::bench
