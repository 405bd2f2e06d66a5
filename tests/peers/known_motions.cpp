#include <algorithm>

#include "problems.hpp"
#include "tautline/geometry.hpp"
#include "tautline/multiprecision.hpp"
#include "tautline/scenarios.hpp"
#include "tautline/solve.hpp"

namespace tautline::peers {
namespace {

/// Impacts are followed as long as flights last longer [s]: twice what tells one impact from
/// another.
constexpr double shortest_flight = 2.0 * other_impact;

constexpr unsigned digits = 40;  // 16 of the doubles, and 24 that a dozen impacts may cost

BasicVec2<Multi> in_many_digits(const Vec2& v) { return {Multi(v.x()), Multi(v.y())}; }

BasicCase<Multi> in_many_digits(const Case& the_case) {
  const State& start = the_case.initial;
  BasicCase<Multi> result;
  result.name = the_case.name;
  result.body = {Multi(the_case.body.mass), Multi(the_case.body.inertia)};
  for (const Cable& cable : the_case.cables) {
    result.cables.push_back({in_many_digits(cable.anchor),
                             in_many_digits(cable.attachment),
                             Multi(cable.length),
                             Multi(cable.restitution),
                             Multi(0),
                             {}});
  }
  result.gravity = in_many_digits(the_case.gravity);
  result.initial = {in_many_digits(start.position), Multi(start.angle),
                    in_many_digits(start.velocity), Multi(start.spin)};
  result.duration = Multi(the_case.duration);
  return result;
}

bool is_common(const Case& the_case) {
  if (the_case.cables.size() > 2 || the_case.angle_limit || the_case.ceiling) {
    return false;
  }
  for (const Cable& cable : the_case.cables) {
    if (depends_on_speed(cable) || gap(cable, the_case.initial) <= gap_rounding * cable.length) {
      return false;
    }
  }
  return true;
}

}  // namespace

std::vector<KnownMotion> known_motions(std::size_t most) {
  const Digits in_force(digits);
  SolveOptions options;
  options.max_events = most + 1;
  std::vector<KnownMotion> result;
  for (Case& the_case : shipped_cases()) {
    if (!is_common(the_case)) {
      continue;
    }
    KnownMotion motion{std::move(the_case), {}, {}};
    double end = motion.the_case.duration;
    double last = 0.0;
    const BasicSolution<BasicCase<Multi>> exact = solve(in_many_digits(motion.the_case), options);
    for (const auto& event : exact.events()) {
      const auto time = static_cast<double>(event.time);
      if (event.kind != EventKind::impact || motion.impacts.size() == most ||
          time - last < shortest_flight) {
        end = time;
        break;
      }
      motion.impacts.push_back({time, event.cables});
      last = time;
    }
    if (!motion.impacts.empty()) {
      motion.stop = {std::max((last + end) / 2, last + other_impact), motion.impacts.size()};
      result.push_back(std::move(motion));
    }
  }
  return result;
}

}  // namespace tautline::peers
