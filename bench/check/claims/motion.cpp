#include "bench/check/claims/measures.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <numbers>

#include "bench/check/cases.hpp"
#include "bench/check/stepping.hpp"
#include "tautline/geometry.hpp"
#include "tautline/scenarios.hpp"

namespace tautline::bench {
namespace {

/// Gravity's part of a contact that takes `longest_contact` steps: the scheme gives that back or
/// takes it at the next hit. In a contact of one step it is half a step's.
constexpr double energy_limit = longest_contact;  // of m g v dt

/// A spring on which a bounce takes `longest_contact` steps of dt stretches by v dt times that over
/// pi, and a hit may be noticed a step late.
constexpr double overstretch_limit = longest_contact / std::numbers::pi + 1.0;  // of v dt

/// A swing of 0.5 m/s on a cable that is held in its rate alone lengthens by 1e-3 m in this time;
/// with any correction it does not lengthen.
constexpr double growth_limit = 1e-4;  // [m]

/// The highest rise of the energy of `the_case` above its start, of m g v dt, where v is the speed
/// it gives at the origin, which is the lowest pose.
double energy_rise(const Subject& subject, const Case& the_case, double end) {
  const auto simulation = subject.start(the_case, usual_step);
  const double start = energy(the_case, the_case.initial);
  double rise = 0.0;
  run_whole(*simulation, usual_step, end, [&](const Moment& moment) {
    rise = worse(rise, energy(the_case, moment.after) - start);
  });
  const double weight = the_case.body.mass * the_case.gravity.norm();
  const double speed = std::sqrt(2.0 * start / the_case.body.mass);
  return rise / (weight * speed * usual_step);
}

/// A pendulum that starts to swing on its taut cable.
Case swing() {
  Case result;
  result.name = "swing";
  result.body = {1.0, 0.05};
  result.cables = {{Vec2(0.0, 1.3), Vec2(0.0, 0.3), 1.0, 0.0}};
  result.initial.velocity = Vec2(0.5, 0.0);
  result.duration = 20.0;
  return result;
}

/// A rule that takes every step of a swing for an impact takes w^2 h t of its energy, 4 % in this
/// time; rounding to float is 1 % of the speed that a step turns by [-].
constexpr double turning_limit = 2e-2;

/// A body that goes round on its taut cable and turns with it, without gravity.
Case turning() {
  Case result;
  result.name = "turning";
  result.body = {1.0, 0.05};
  result.gravity = Vec2::Zero();
  result.cables = {{Vec2::Zero(), Vec2(-0.3, 0.0), 0.7, 0.0}};
  result.initial = {Vec2(1.0, 0.0), 0.0, Vec2(0.0, 2.0), 2.0};
  result.duration = 10.0;
  return result;
}

/// What became of it.
struct Turned {
  double energy = 0.0;   // the largest change of it, of it [-]
  double tension = 0.0;  // the largest error of it, of m v^2 / r; 0 if none is reported [-]
  int slack = 0;         // steps without a pull, where others have one
};

Turned turned(const Subject& subject) {
  const Case the_case = turning();
  const auto simulation = subject.start(the_case, usual_step);
  const double start = energy(the_case, the_case.initial);
  const double radius = the_case.initial.position.norm();
  const double right = the_case.body.mass * the_case.initial.velocity.squaredNorm() / radius;
  const double settled = 0.1;  // [s]; the first steps bring it onto its circle
  Turned result;
  double error = 0.0;
  int pulls = 0;
  run_whole(*simulation, usual_step, the_case.duration, [&](const Moment& moment) {
    result.energy = worse(result.energy, std::abs(energy(the_case, moment.after) / start - 1.0));
    if (moment.time > settled && !simulation->impulses().empty()) {
      const double impulse = simulation->impulses().front();
      pulls += impulse > 0.0 ? 1 : 0;
      result.slack += impulse > 0.0 ? 0 : 1;
      error = worse(error, std::abs(impulse / (right * usual_step) - 1.0));
    }
  });
  // some report the impulses of impacts alone
  const bool reported = pulls > result.slack / 2;
  result.tension = reported ? error : 0.0;
  result.slack = reported ? result.slack : 0;
  return result;
}

/// The largest overstretch of any cable [m].
double overstretch(const Case& the_case, const State& state) {
  double largest = 0.0;
  for (const Cable& cable : the_case.cables) {
    largest = worse(largest, -gap(cable, state));
  }
  return largest;
}

}  // namespace

Measure measure_energy(const Subject& subject) {
  double found = 0.0;
  for (const Case& the_case :
       {bouncing_ball(1.0), standard_breakwater(1.0), standard_breakwater(0.9)}) {
    found = worse(found, energy_rise(subject, the_case, 6.0));
  }
  return {found, energy_limit,
          found <= energy_limit
              ? fmt::format("energy rises by no more than {:.2g} m g v dt", found)
              : fmt::format("hits add energy: it rises by {:.3g} m g v dt above what the run "
                            "began with",
                            found)};
}

Measure measure_overstretch(const Subject& subject) {
  const Case the_case = bouncing_ball(0.5);
  const double speed = std::sqrt(2.0 * the_case.initial.position.y());  // at the first hit, g = 1
  const auto simulation = subject.start(the_case, usual_step);
  double largest = 0.0;
  run_whole(*simulation, usual_step, 5.0, [&](const Moment& moment) {
    largest = std::max(largest, overstretch(the_case, moment.after));
  });
  const double found = largest / (speed * usual_step);
  return {found, overstretch_limit,
          found <= overstretch_limit
              ? fmt::format("a cable overstretches by {:.2g} m, {:.2g} v dt", largest, found)
              : fmt::format("a cable overstretches by {:.2g} m, {:.3g} v dt: the body flies on "
                            "through its end",
                            largest, found)};
}

Measure measure_taut_growth(const Subject& subject) {
  const Case the_case = swing();
  const auto simulation = subject.start(the_case, usual_step);
  double early = 0.0;  // [m], while the first swings settle
  double late = 0.0;
  run_whole(*simulation, usual_step, the_case.duration, [&](const Moment& moment) {
    double& largest = moment.time < 0.5 * the_case.duration ? early : late;
    largest = std::max(largest, overstretch(the_case, moment.after));
  });
  const double found = std::max(0.0, late - early);
  return {
      found, growth_limit,
      found <= growth_limit
          ? fmt::format("a taut cable overstretches by {:.2g} m and does not lengthen", early)
          : fmt::format("a taut cable lengthens: by {:.2g} m in the first 10 s, {:.2g} m in the "
                        "next",
                        early, late)};
}

Measure measure_taut_turning(const Subject& subject) {
  const Turned of = turned(subject);
  const double found = worse(of.energy, of.tension);
  if (found <= turning_limit) {
    return {found, turning_limit,
            fmt::format("a taut body that turns without gravity keeps its energy to {:.2g} and its "
                        "tension to {:.2g} in 10 s",
                        of.energy, of.tension)};
  }
  if (!(of.energy <= turning_limit)) {
    return {found, turning_limit,
            fmt::format("a taut swing is braked, though nothing presses it outwards: a body that "
                        "turns without gravity changes its energy by {:.3g} % in 10 s",
                        100.0 * of.energy)};
  }
  return {found, turning_limit,
          fmt::format("the tension of a taut body that turns without gravity is off by {:.3g} of "
                      "m v^2 / r; slack in {} steps of 10 s",
                      of.tension, of.slack)};
}

}  // namespace tautline::bench
