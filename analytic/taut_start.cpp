#include <algorithm>
#include <cmath>
#include <optional>
#include <string>
#include <vector>

#include "tautline/detail/projection.hpp"
#include "tautline/detail/rounding.hpp"
#include "tautline/geometry.hpp"
#include "words.hpp"

namespace tautline {
namespace {

/// A gap up to this is zero to the solver as well, of the rounding that rounding.hpp names [m].
double closed(const Cable& cable, const State& state) {
  return std::max(gap_rounding * cable.length, few_roundings * rounding_of_gap(cable, state));
}

bool are_closed(const Case& the_case, const State& state, CableSet cables) {
  for (const std::size_t index : cables) {
    const Cable& cable = the_case.cables[index];
    if (!(std::abs(gap(cable, state)) <= closed(cable, state))) {
      return false;
    }
  }
  return true;
}

/// "0+1".
std::string list(CableSet cables) {
  std::string result;
  for (const std::size_t index : cables) {
    result += (result.empty() ? "" : "+") + std::to_string(index);
  }
  return result;
}

/// One sentence for each of `cables` that is too far from taut.
std::vector<std::string> too_far(const Case& the_case, CableSet cables) {
  std::vector<std::string> result;
  for (const std::size_t index : cables) {
    const Cable& cable = the_case.cables[index];
    const double open = gap(cable, the_case.initial);
    if (!(std::abs(open) <= most_taken_up * cable.length)) {
      result.push_back(cable_name(index) + ": cannot start taut: its ends are " +
                       text(cable.length - open) + " m apart, its length is " + text(cable.length) +
                       " m; at most " + text(most_taken_up) + " of the length is taken up");
    }
  }
  return result;
}

/// Those of `cables` whose rate a typed start has by its rounding alone.
CableSet with_typed_rates(const Case& the_case, const State& state, CableSet cables) {
  CableSet result;
  bool any = false;
  for (const std::size_t index : cables) {
    const Cable& cable = the_case.cables[index];
    const double rate = std::abs(gap_rate(cable, state));
    if (rate <= most_taken_up * attachment_velocity(state, cable).norm()) {
      result.insert(index);
      any = any || rate > few_roundings * rounding_of_rate(cable, state);
    }
  }
  return any ? result : CableSet{};
}

}  // namespace

TautStart taut_start(const Case& the_case, CableSet cables) {
  const State& typed = the_case.initial;
  TautStart result{std::nullopt, too_far(the_case, cables), 0.0, 0.0, 0.0, 0.0};
  if (!result.problems.empty()) {
    return result;
  }
  State start = typed;
  if (!are_closed(the_case, typed, cables)) {
    start = with_zero_gaps(the_case, typed, cables);
    double longest = 0.0;
    for (const std::size_t index : cables) {
      longest = std::max(longest, the_case.cables[index].length);
    }
    const double way = (start.position - typed.position).norm() +
                       std::abs(start.angle - typed.angle) * attachment_radius(the_case);
    constexpr double oblique = 10.0;  // [-], the way that cables nearly in line ask for
    if (!are_closed(the_case, start, cables) || !(way <= oblique * most_taken_up * longest)) {
      result.problems.push_back("cables " + list(cables) +
                                " cannot start taut together: no pose near the start closes all of "
                                "their gaps");
      return result;
    }
  }
  const CableSet typed_rates = with_typed_rates(the_case, start, cables);
  start = with_zero_rates(the_case, start, typed_rates);
  result.moved = (start.position - typed.position).norm();
  result.turned = std::abs(start.angle - typed.angle);
  result.slowed = (start.velocity - typed.velocity).norm();
  result.spun = std::abs(start.spin - typed.spin);
  result.start = start;
  return result;
}

}  // namespace tautline
