#include "bench/check/claims/measures.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <array>

#include "bench/check/cases.hpp"
#include "bench/check/stepping.hpp"

namespace tautline::bench {
namespace {

/// Of the numbers that a run changes, one in 2^29 is a float by chance in double, and all may be in
/// float.
constexpr double rounded_limit = 0.01;
constexpr double rounded_limit_in_float = 1.0;

constexpr double watched_until = 0.3;  // [s], with a hit, which changes the spin

std::array<double, 6> numbers_of(const State& state) {
  return {state.position.x(), state.position.y(), state.angle,
          state.velocity.x(), state.velocity.y(), state.spin};
}
constexpr std::array number_names = {"x", "y", "the angle", "vx", "vy", "the spin"};

/// True if the 29 bits that a double has beyond a float are zero.
bool is_float(double number) { return static_cast<double>(static_cast<float>(number)) == number; }

/// How often one number of the state changed, and to what.
struct Changes {
  int all = 0;
  int to_float = 0;

  [[nodiscard]] double share() const { return all > 0 ? static_cast<double>(to_float) / all : 0.0; }
};

}  // namespace

Measure measure_state_echo(const Subject& subject) {
  double largest = 0.0;
  for (Case the_case : {spinning_on_one_cable(0.5), shipped_case("plate-four-cables")}) {
    the_case.initial.angle += 20.0;  // three turns and some: not wrapped
    for (Cable& cable : the_case.cables) {
      cable.length += 2.0;  // slack at any angle
    }
    largest = std::max(
        largest, largest_difference(subject.start(the_case, 1e-2)->state(), the_case.initial));
  }
  const double limit = 20.0 * subject.rounding();  // of the angle
  constexpr double float_rounding = 20.0 * 1e-6;
  std::string sentence = fmt::format("the initial state comes back to {:.2g}", largest);
  if (largest > limit && largest < float_rounding) {
    sentence += ": it is rounded to float, although float64 is declared";
  } else if (largest > limit) {
    sentence += ": not the state the run was given";
  }
  return {largest, limit, sentence};
}

Measure measure_precision(const Subject& subject) {
  constexpr double step = 1e-3;  // [s], no float
  const auto simulation = subject.start(spinning_on_one_cable(0.05), step);
  std::array<Changes, number_names.size()> changes;
  run_whole(*simulation, step, watched_until, [&](const Moment& moment) {
    const auto before = numbers_of(moment.before);
    const auto after = numbers_of(moment.after);
    for (std::size_t k = 0; k < changes.size(); ++k) {
      if (after[k] != before[k] && after[k] != 0.0) {
        ++changes[k].all;
        changes[k].to_float += is_float(after[k]) ? 1 : 0;
      }
    }
  });
  const auto worst =
      std::max_element(changes.begin(), changes.end(),
                       [](const Changes& a, const Changes& b) { return a.share() < b.share(); });
  const double limit = subject.in_double() ? rounded_limit : rounded_limit_in_float;
  std::string sentence = subject.in_double() ? "states have the digits of float64 after every step"
                                             : "float32 is declared: states may be rounded to it";
  if (worst->share() > limit) {
    sentence = fmt::format(
        "{} is rounded to float in {} of the {} steps that change it, although float64 is declared",
        number_names.at(static_cast<std::size_t>(worst - changes.begin())), worst->to_float,
        worst->all);
  }
  return {worst->share(), limit, sentence};
}

}  // namespace tautline::bench
