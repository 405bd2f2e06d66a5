#include "bench/check/strike.hpp"

#include <cmath>
#include <exception>
#include <limits>

#include "bench/check/hit.hpp"
#include "tautline/geometry.hpp"

namespace tautline::bench {
namespace {

/// An engine that looks ahead sees the cable in time [steps].
constexpr double steps_before = 5.0;

/// A contact longer than this is a cable that is held taut [steps].
constexpr double steps_after = 200.0;

/// The fraction of the golden section: its multiples fill a step evenly, however many there are.
constexpr double golden = 0.6180339887498949;

double restitution_of(const Subject& subject, const Case& the_case, double step) {
  constexpr double none = std::numeric_limits<double>::quiet_NaN();
  try {
    const Cable& cable = the_case.cables.front();
    const std::optional<Hit> hit = first_hit(subject, the_case, step, the_case.duration);
    return hit ? -gap_rate(cable, hit->after) / gap_rate(cable, hit->before) : none;
  } catch (const std::exception&) {  // it threw, stopped, or has no numbers any more
    return none;
  }
}

}  // namespace

Case struck_case(const Strike& strike, double restitution, double step, double phase) {
  Cable cable;
  cable.attachment = Vec2(strike.arm, 0.0);
  cable.length = 1.0;
  cable.restitution = restitution;
  Case result;
  result.name = "strike";
  result.gravity = Vec2::Zero();
  result.body = {1.0, strike.inertia};
  // back from the strike, at which the cable is at a right angle to the arm
  const double flight = (steps_before + phase) * step;
  const double spin = strike.arm > 0.0 ? -strike.spin_part * strike.speed / strike.arm : 0.0;
  const double velocity = -strike.speed - spin * strike.arm;
  result.initial.position = Vec2(-strike.arm, -cable.length - velocity * flight);
  result.initial.angle = -spin * flight;
  result.initial.velocity = Vec2(0.0, velocity);
  result.initial.spin = spin;
  result.duration = (steps_before + 1.0 + steps_after) * step;
  result.cables = {cable};
  return result;
}

std::vector<double> restitutions_of(const Subject& subject, const std::vector<Strike>& strikes,
                                    double step, double wanted) {
  std::vector<double> result;
  for (std::size_t index = 0; index < strikes.size(); ++index) {
    const double turns = golden * static_cast<double>(index + 1);
    const double phase = turns - std::floor(turns);
    result.push_back(
        restitution_of(subject, struck_case(strikes[index], wanted, step, phase), step));
  }
  return result;
}

}  // namespace tautline::bench
