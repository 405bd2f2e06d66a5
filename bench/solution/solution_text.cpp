#include "bench/solution/texts.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <span>
#include <utility>

#include "bench/solution/digits/summary.hpp"
#include "tautline/geometry.hpp"
#include "tautline/rounding.hpp"

namespace tautline::bench {
namespace {

/// The bound of the error of the time of the event at `time`; < 0 where it is not sure.
double time_error(const Solution& solution, const Uncertainty& uncertainty, double time,
                  EventKind kind) {
  for (std::size_t index = solution.events().size(); index-- > 0;) {
    const Event& event = solution.events()[index];
    if (event.time == time && event.kind == kind) {
      return uncertainty.events()[index] ? uncertainty.events()[index]->time : -1.0;
    }
  }
  return -1.0;
}

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
        last.time ? time_error(solution, uncertainty, *last.time, EventKind::impact) : 0.0);
  }
  if (settling.lock) {
    const double start = solution.events().back().time;
    const double error =
        uncertainty.lock().value_or(time_error(solution, uncertainty, start, EventKind::taut));
    errors.lock = error < 0.0 ? error : error + settling.lock->uncertainty;
    if (settling.lock->swing && errors.energy >= 0.0) {
      swing_errors(the_case, solution.events().back().after, *settling.lock->swing, errors);
    }
  }
  if (solution.ending() == Ending::rest || solution.ending() == Ending::unstable_rest) {
    errors.end_time = time_error(solution, uncertainty, solution.events().back().time,
                                 solution.events().back().kind);
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

/// Stretches after which all motions are alike again, the first of them in full.
std::string meetings_text(std::span<const Unsure> stretches) {
  constexpr std::size_t most_in_full = 3;
  std::string result;
  for (const Unsure& stretch : stretches.first(std::min(stretches.size(), most_in_full))) {
    const auto [from, until] = told_apart(stretch.from, stretch.until);
    result += fmt::format(
        "Between t = {} and {} the order of impacts is beyond the horizon: one of many motions, "
        "which all come to the same taut cables.\n",
        from, until);
  }
  if (stretches.size() > most_in_full) {
    const std::size_t more = stretches.size() - most_in_full;
    const auto [from, until] = told_apart(stretches.back().from, stretches.back().until);
    result += more == 1 ? fmt::format("So it is between t = {} and {}.\n", from, until)
                        : fmt::format("So it is in {} more stretches up to t = {}.\n", more, until);
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
    const std::string left =
        error < 0.0 ? ""
                    : fmt::format(", {} there,",
                                  right_general(energy(the_case, solution.at(before)), error, 6));
    result += fmt::format(
        "From t = {:.6g} on all is beyond the horizon: one of many motions. Sure is that the "
        "energy{} does not grow. --digits N computes this one, which may take long.\n",
        since, left);
  }
  return result;
}

}  // namespace

std::string solution_text(const Case& the_case, const Solution& solution, const Settling& settling,
                          const Uncertainty& uncertainty) {
  const SummaryErrors<double> errors = summary_errors(the_case, solution, settling, uncertainty);
  return Summary<double>(the_case, solution, settling, errors, Figures{}).text() +
         rest_tensions_text(the_case, solution, uncertainty) +
         horizon_text(the_case, solution, uncertainty);
}

}  // namespace tautline::bench
