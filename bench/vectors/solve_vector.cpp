#include "bench/vectors/solve_vector.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <cstdlib>
#include <limits>
#include <utility>

#include "bench/base/text.hpp"
#include "bench/data/coordinates.hpp"
#include "bench/solution/cable_words.hpp"
#include "bench/solution/digits_ties.hpp"
#include "bench/solution/in_digits.hpp"
#include "bench/vectors/growth.hpp"
#include "bench/vectors/steps.hpp"
#include "tautline/geometry.hpp"
#include "tautline/solve.hpp"
#include "tautline/uncertainty.hpp"

namespace tautline::bench {
namespace {

/// Decimal digits of the first solution. Its errors grow by some 1e20 in the shipped cases before
/// they lock; the rest is for the doubles.
constexpr int first_digits = 60;

/// With more digits than this nothing is tried: a solution takes minutes.
constexpr int enough_digits = 500;

/// Digits that a number of a solution may lose; smaller numbers than the others are zero.
constexpr double lost_part = 0.6;

/// The doubles follow the exact motion while their events are no further off than this [-], of the
/// duration. A growth has three digits.
constexpr double still_followed = 1e-6;

/// An event that has a row. Events that complete an accumulation are at its limit.
template <class Real>
struct Notable {
  Real time;  // [s]
  const BasicEvent<BasicCase<Real>>* event;
};

template <class Real>
std::vector<Notable<Real>> notable_events(const BasicCase<Real>& the_case,
                                          const BasicSolution<BasicCase<Real>>& solution,
                                          double slowest) {
  std::vector<Notable<Real>> result;
  auto limit = solution.accumulations().begin();
  for (const auto& event : solution.events()) {
    Real time = event.time;
    if (event.kind == EventKind::taut && limit != solution.accumulations().end() &&
        limit->start == event.time) {
      time = limit++->time;
    }
    if (event.kind != EventKind::impact ||
        closing_speed(the_case, event.cables, event.before) >= slowest) {
      result.push_back({time, &event});
    }
  }
  return result;
}

/// The nearest double; what is zero but for rounding is zero.
double nearest_double(const Multi& value, int digits) {
  const auto result = static_cast<double>(value);
  return std::abs(result) < std::pow(10.0, -lost_part * digits) ? 0.0 : result;
}

std::array<double, 6> numbers_of(const BasicState<Multi>& state, int digits) {
  std::array<double, 6> result{};
  std::size_t place = 0;
  for (const auto& one : coordinates(state)) {
    result[place++] = nearest_double(one.value, digits);
  }
  return result;
}

/// `value` rounded to this number of significant digits.
double rounded_to(double value, int digits) {
  return std::strtod(fmt::format("{:.{}e}", value, digits - 1).c_str(), nullptr);
}

/// `value` rounded down to this number of significant digits.
double rounded_down(double value, int digits) {
  const double unit =
      value > 0.0 ? std::pow(10.0, std::floor(std::log10(value)) - digits + 1) : 1.0;
  return rounded_to(std::floor(value / unit) * unit, digits);
}

/// Times of about `count` samples between 0 and `end` [s], at an interval of two digits.
std::vector<double> times_of_samples(double end, int count) {
  const double interval = rounded_to(end / count, 2);
  std::vector<double> result = {0.0};
  for (int index = 1; index * interval < end * (1.0 - 1e-9); ++index) {
    constexpr int digits = 12;  // of a product of two short decimals
    result.push_back(rounded_to(index * interval, digits));
  }
  return result;
}

VectorRow event_row(const BasicCase<Multi>& the_case, const VectorOptions& options,
                    const BasicSolution<BasicCase<Multi>>& solution, const Notable<Multi>& notable,
                    int digits) {
  const BasicEvent<BasicCase<Multi>>& event = *notable.event;
  VectorRow row;
  row.time = nearest_double(notable.time, digits);
  row.kind = event.kind;
  row.cables = event.cables;
  if (event.kind != EventKind::impact) {
    row.state = numbers_of(solution.at(notable.time), digits);
    return row;
  }
  row.state = numbers_of(event.after, digits);
  row.rate = nearest_double(closing_speed(the_case, event.cables, event.before), digits);
  const std::array<double, 6> before = numbers_of(event.before, digits);
  row.velocity = {before[3], before[4], before[5]};
  if (indeterminate(options.law, the_case, event).empty()) {
    for (const Multi& impulse : event.impulses) {
      row.impulses.push_back(nearest_double(impulse, digits));
    }
  }
  return row;
}

/// The rows without growth and step, from one solution.
struct Rows {
  std::vector<VectorRow> rows;
  Ending ending;
  bool locks = false;                 // at the last row
  std::optional<NumberTie> tie = {};  // the first that its digits do not decide
};

Rows rows_with(const Case& the_case, const VectorOptions& options, int digits) {
  if (options.on_attempt) {
    options.on_attempt(digits);
  }
  const Digits precision(static_cast<unsigned>(digits));
  const BasicCase<Multi> in_many = in_digits(the_case);
  SolveOptions solve_options;
  solve_options.law = options.law;
  // a solution of more digits has a smaller error here, too: both have to agree
  constexpr int spare = 10;
  solve_options.completion.error = std::pow(10.0, -std::min(300, digits - spare));
  const auto solution = solve(in_many, solve_options);
  Rows result{{}, solution.ending()};
  result.tie = first_tie(in_many, solution, digits);
  double end = nearest_double(solution.end_time(), digits);
  const auto events = notable_events(in_many, solution, options.slowest);
  if (!events.empty() && events.back().event->kind == EventKind::taut && events.back().time > 0) {
    result.locks = true;
    end = nearest_double(events.back().time, digits);
  }
  for (const Notable<Multi>& notable : events) {
    result.rows.push_back(event_row(in_many, options, solution, notable, digits));
  }
  std::vector<double> samples = times_of_samples(end, options.samples);
  if (!result.locks) {
    samples.push_back(end);
  }
  for (const double time : samples) {
    const auto state = solution.at(min(Multi(time), solution.end_time()));
    VectorRow row;
    row.time = time;
    row.state = numbers_of(state, digits);
    row.energy = nearest_double(energy(in_many, state), digits);
    result.rows.push_back(std::move(row));
  }
  std::stable_sort(result.rows.begin(), result.rows.end(),
                   [](const VectorRow& one, const VectorRow& two) { return one.time < two.time; });
  return result;
}

/// The cables that hold the body at a dead point as it starts.
CableSet dead_when_it_starts(const Case& the_case, int digits) {
  const Digits precision(static_cast<unsigned>(digits));
  return dead_at_start(in_digits(the_case));
}

bool same(const VectorRow& one, const VectorRow& two) {
  return one.time == two.time && one.kind == two.kind && one.state == two.state &&
         one.energy == two.energy && one.cables == two.cables && one.rate == two.rate &&
         one.impulses == two.impulses && one.velocity == two.velocity;
}

/// The time of the first row that is not in both [s]; none if all are.
std::optional<double> first_difference(const Rows& one, const Rows& two) {
  const auto [mine, other] =
      std::mismatch(one.rows.begin(), one.rows.end(), two.rows.begin(), two.rows.end(), same);
  if (mine == one.rows.end() && other == two.rows.end()) {
    return std::nullopt;
  }
  return mine == one.rows.end() ? other->time : mine->time;
}

/// Until when [s] the solution in doubles has the events of the rows.
double followed_until(const Case& the_case, const Solution& solution, double slowest,
                      const std::vector<VectorRow>& rows) {
  const auto events = notable_events(the_case, solution, slowest);
  auto event = events.begin();
  double until = 0.0;
  for (const VectorRow& row : rows) {
    if (!row.kind) {
      continue;
    }
    if (event == events.end() || event->event->kind != *row.kind ||
        event->event->cables != row.cables ||
        !(std::abs(event->time - row.time) <= still_followed * the_case.duration)) {
      return until;
    }
    until = row.time;
    ++event;
  }
  return std::numeric_limits<double>::infinity();
}

/// Gives each row the largest growth up to it, from the solution in doubles.
void add_growth(Vector& vector, const Solution& solution) {
  const Growth growth(vector.the_case, solution, vector.law);
  const double until = followed_until(vector.the_case, solution, vector.slowest, vector.rows);
  double largest = 1.0;
  constexpr int digits = 3;
  constexpr double beside = 1e-9;  // [-], of the time of a row
  for (VectorRow& row : vector.rows) {
    const double time = std::min(row.time, solution.end_time());
    // a scheme may be early or late: at an event the growth on both sides counts
    const double later = std::min(time * (1.0 + beside), solution.end_time());
    largest = std::max({largest, growth.at(time * (1.0 - beside)), growth.at(later)});
    if (!(row.time <= until) || !std::isfinite(largest)) {
      return;
    }
    row.growth = rounded_to(largest, digits);
  }
}

double fastest_of(const std::vector<VectorRow>& rows, double radius) {
  double fastest = 0.0;
  for (const VectorRow& row : rows) {
    const auto& s = row.state;
    fastest = std::max(fastest, std::hypot(s[3], s[4], radius * s[5]));
    if (row.velocity) {
      const auto& v = *row.velocity;
      fastest = std::max(fastest, std::hypot(v[0], v[1], radius * v[2]));
    }
  }
  return fastest;
}

bool given_up(Ending ending) {
  return ending != Ending::reached_duration && ending != Ending::rest &&
         ending != Ending::unstable_rest && ending != Ending::angle_limit &&
         ending != Ending::ceiling;
}

}  // namespace

VectorReading vector_of(const Case& the_case, const VectorOptions& options) {
  const auto none = [&](const std::string& sentence) {
    return VectorReading{std::nullopt, printable(the_case.name) + ": " + sentence};
  };
  const std::string shorter = " End the vector before that, with --until.";
  int digits = first_digits;
  if (const CableSet dead = dead_when_it_starts(the_case, digits); !dead.empty()) {
    return none(tie_sentence(EventKind::taut, dead, "0"));
  }
  Rows few = rows_with(the_case, options, digits);
  while (true) {
    if (given_up(few.ending)) {
      return none(fmt::format("the solver follows the motion no further than t = {:.6g} ({}).",
                              few.rows.back().time, to_string(few.ending)) +
                  shorter);
    }
    digits += digits / 2;
    Rows many = rows_with(the_case, options, digits);
    const auto tie = common_tie(few.tie, many.tie);
    if (tie && tie->time <= many.rows.back().time) {
      const std::string time = fmt::format("{:.6g}", static_cast<double>(tie->time));
      return none(tie_sentence(tie->tie.kind, tie->tie.cables, time) + shorter);
    }
    const auto difference = first_difference(few, many);
    if (!difference && few.ending == many.ending) {
      break;
    }
    few = std::move(many);
    if (digits + digits / 2 > enough_digits) {
      return none(fmt::format("{} digits do not decide how the motion goes on from t = {:.6g}.",
                              digits, difference.value_or(0.0)) +
                  shorter);
    }
  }
  Vector vector;
  vector.the_case = the_case;
  vector.law = options.law;
  vector.slowest = options.slowest;
  constexpr int digits_of_rule = 6;
  vector.radius = gyration_radius(the_case);
  vector.ends = few.locks ? "lock" : std::string(to_string(few.ending));
  vector.rows = std::move(few.rows);
  vector.fastest = rounded_to(fastest_of(vector.rows, vector.radius), digits_of_rule);
  SolveOptions solve_options;
  solve_options.law = options.law;
  const Solution solution = solve(the_case, solve_options);
  add_growth(vector, solution);
  set_steps(vector, solution);
  for (VectorRow& row : vector.rows) {
    constexpr int digits_of_step = 2;
    row.step = rounded_down(row.step, digits_of_step);
  }
  return {std::move(vector), ""};
}

}  // namespace tautline::bench
