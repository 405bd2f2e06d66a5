// Systems in space without gravity.

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <functional>
#include <optional>
#include <string>
#include <vector>

#include "bench/check/cases.hpp"
#include "bench/check/claims/measures.hpp"
#include "bench/check/hit.hpp"
#include "bench/check/stepping.hpp"
#include "bench/data/coordinates.hpp"
#include "tautline/solve.hpp"
#include "tautline/system_geometry.hpp"

namespace tautline::bench {
namespace {

using Point = Eigen::Vector3d;

/// The largest difference of one of the numbers of two states, each in its own unit. A quaternion
/// and its negative are the same.
double largest_difference(const SpatialSystemState& a, SpatialSystemState b) {
  double largest = 0.0;
  for (std::size_t index = 0; index < a.bodies.size(); ++index) {
    const SpatialState& one = a.bodies[index];
    SpatialState& other = b.bodies[index];
    if (one.orientation.dot(other.orientation) < 0.0) {
      other.orientation *= -1.0;
    }
    const auto numbers = coordinates(one);
    const auto others = coordinates(other);
    for (std::size_t k = 0; k < numbers.size(); ++k) {
      largest = worse(largest, std::abs(numbers[k].value - others[k].value));
    }
  }
  return largest;
}

/// A mistake of an adapter: how it tells a body, as what it takes one, and a sentence on that.
struct Mistake {
  SpatialState (*told)(SpatialState body);
  SpatialState (*taken)(SpatialState body);
  const char* sentence;
};
SpatialState with_spin_in_the_world(SpatialState body) {
  body.spin = in_the_world(body, body.spin);
  return body;
}
SpatialState with_spin_in_the_body(SpatialState body) {
  body.spin = in_the_body(body, body.spin);
  return body;
}
SpatialState conjugated(SpatialState body) {
  body.orientation = conjugate<double>(body.orientation);
  return body;
}
SpatialState with_scalar_last(SpatialState body) {
  const Quaternion q = body.orientation;
  body.orientation = Quaternion(q[1], q[2], q[3], q[0]);
  return body;
}
SpatialState with_last_as_scalar(SpatialState body) {
  const Quaternion q = body.orientation;
  body.orientation = Quaternion(q[3], q[0], q[1], q[2]);
  return body;
}
constexpr std::array mistakes = {
    Mistake{with_spin_in_the_world, with_spin_in_the_body,
            "spins are in the axes of the world, not of the body"},
    Mistake{conjugated, conjugated,
            "orientations are from the axes of the world to those of the body"},
    Mistake{with_scalar_last, with_last_as_scalar,
            "the scalar of a quaternion comes last, not first"}};

/// `state` with each body as `mistaken`.
SpatialSystemState with_bodies(SpatialSystemState state, SpatialState (*mistaken)(SpatialState)) {
  std::transform(state.bodies.begin(), state.bodies.end(), state.bodies.begin(), mistaken);
  return state;
}

/// Steps and end of the flights of a body that turns [s].
constexpr double coarse_turn_step = 1e-2;
constexpr double fine_turn_step = 2e-3;
constexpr double turn_end = 2.0;

/// A mistaken motion explains a run that is nearer to it than this part of the distance to the
/// exact motion [-]. A run that is damped, too, drifts away from both.
constexpr double mistaken_for = 0.5;

/// A body that nothing pulls and that is far from turning about one of its axes alone.
SpatialSystem turning_in_space() {
  SpatialSystem result = body_in_space(Point(0.02, 0.03, 0.045));
  SpatialState& start = result.initial.bodies.front();
  start.orientation = quaternion_of<double>(Point(0.4, -0.7, 0.3));
  start.spin = Point(1.5, 1.0, 2.0);
  return result;
}

/// An orientation over time [s].
using Orientation = std::function<Quaternion(double time)>;

/// How the body of `system` turns by Euler's equations, where an adapter makes a mistake.
Orientation exact_turn(SpatialSystem system, const Mistake& mistake) {
  system.initial = with_bodies(system.initial, mistake.taken);
  return [motion = solve(system), told = mistake.told](double time) {
    return told(motion.at(time).bodies.front()).orientation;
  };
}

/// How far a run of `system` is from each of `motions` at most [rad].
std::vector<double> turned_apart(const Subject& subject, const SpatialSystem& system, double step,
                                 const std::vector<Orientation>& motions) {
  std::vector<double> result(motions.size());
  const auto simulation = subject.start(system, step);
  run_whole(*simulation, step, turn_end, [&](const SystemMoment& moment) {
    for (std::size_t k = 0; k < motions.size(); ++k) {
      result[k] = worse(result[k], angle_between<double>(moment.after.bodies.front().orientation,
                                                         motions[k](moment.time)));
    }
  });
  return result;
}

/// A step's impulse may act anywhere along the step, in which bodies go 1e-3 m and turn as much; a
/// contact of 20 steps likewise [-].
constexpr double pair_limit = 0.03;

constexpr double pair_until = 0.3;  // [s], long after the hit

/// A hit at 1 m/s on an anchor that goes with this velocity [m/s].
SpatialSystem hit_on_anchor(const Point& velocity) {
  SpatialSystem result = body_in_space(Point::Constant(0.05));
  SpatialState& start = result.initial.bodies.front();
  start.orientation = quaternion_of<double>(Point(0.3, -0.5, 0.2));
  start.velocity = velocity - struck_direction();
  SpatialCable& cable = result.cables.front();
  cable.from.at = Point(0.1, -0.2, 0.15);
  cable.to.at = in_the_world(start, cable.from.at) + (1.0 - way_to_strike) * struck_direction();
  cable.length = Function<1>::constant(1.0);
  if (!velocity.isZero()) {
    cable.to.motion.pieces = {{0.0, {Point::Zero(), velocity}}};
  }
  return result;
}

constexpr double anchor_end = 0.1;  // [s], long after the hit

/// The positions of the body after each step of such a run [m], and the restitution of the hit.
struct OnAnchor {
  std::vector<Point> positions;
  double restitution = std::nan("");  // [-]; not a number if there was no hit
};
OnAnchor hit_and_away(const Subject& subject, const SpatialSystem& system) {
  OnAnchor result;
  const auto simulation = subject.start(system, usual_step);
  run_whole(*simulation, usual_step, anchor_end, [&](const SystemMoment& moment) {
    result.positions.push_back(moment.after.bodies.front().position);
  });
  if (const auto hit = first_hit(subject, system, usual_step, anchor_end)) {
    const SpatialCable& cable = system.cables.front();
    result.restitution = -gap_rate(cable, hit->after) / gap_rate(cable, hit->before);
  }
  return result;
}

}  // namespace

Measure measure_space_echo(const Subject& subject) {
  const SpatialSystem system = pair_on_a_cable(0.5);
  const SpatialSystemState state = subject.start(system, usual_step)->state();
  const double found = largest_difference(state, system.initial);
  const double limit = 20.0 * subject.rounding();  // of an orientation made a matrix, and back
  constexpr double float_rounding = 20.0 * 1e-6;
  std::string sentence = fmt::format("the initial state of a system comes back to {:.2g}", found);
  if (found > limit && found < float_rounding) {
    sentence += ": it is rounded to float, although float64 is declared";
  } else if (found > limit) {
    std::string why = "not the state the run was given";
    for (const Mistake& mistake : mistakes) {
      if (largest_difference(state, with_bodies(system.initial, mistake.told)) < float_rounding) {
        why = mistake.sentence;
      }
    }
    sentence += ": " + why;
  }
  return {found, limit, sentence};
}

Measure measure_gyroscopic_term(const Subject& subject) {
  const SpatialSystem system = turning_in_space();
  const SpatialState& start = system.initial.bodies.front();
  const auto as_it_is = [](SpatialState body) { return body; };
  const Orientation left_out = [&](double time) {
    return turned(start, time * start.spin).orientation;
  };
  std::vector<Orientation> motions = {exact_turn(system, {as_it_is, as_it_is, ""}), left_out};
  for (const Mistake& mistake : mistakes) {
    motions.push_back(exact_turn(system, mistake));
  }
  const std::vector<double> coarse = turned_apart(subject, system, coarse_turn_step, motions);
  const std::vector<double> fine = turned_apart(subject, system, fine_turn_step, motions);
  const double turn = start.spin.norm() * fine_turn_step;  // [rad], in a step
  // a scheme of first order errs by less than the square of the turn in a step, in each step
  const double limit = turn * turn * (turn_end / fine_turn_step);
  const std::string numbers =
      fmt::format("off by {:.2g} rad within {:g} s at a step of {:g} s, by {:.2g} at {:g} s",
                  coarse[0], turn_end, coarse_turn_step, fine[0], fine_turn_step);
  std::string sentence = "a free body does not turn as Euler's equations say: " + numbers;
  // among the wrong motions
  const auto nearest = std::min_element(fine.begin() + 1, fine.end());
  const auto place = static_cast<std::size_t>(nearest - fine.begin());
  const bool explained = *nearest <= std::max(limit, mistaken_for * fine[0]);
  if (fine[0] <= limit) {
    sentence = "a free body turns as Euler's equations say: " + numbers;
  } else if (explained && place == 1) {
    sentence = fmt::format(
        "leaves the gyroscopic term out: a free body turns as if it kept its spin in the world, to "
        "{:.2g} rad, and is {}",
        *nearest, numbers);
  } else if (explained) {
    sentence = fmt::format("{}: a free body turns so to {:.2g} rad, and is {}",
                           mistakes.at(place - 2).sentence, *nearest, numbers);
  }
  return {fine[0], limit, sentence};
}

Measure measure_pair_momentum(const Subject& subject) {
  const SpatialSystem pair = pair_on_a_cable(0.5);
  const Point about = Point::Zero();
  const double length = pair.cables.front().length.at(0.0)[0];
  const auto simulation = subject.start(pair, usual_step);
  double impulse = 0.0;             // [N s]
  Point gained = Point::Zero();     // [N s], of momentum, where the cable pulls
  Point turned_by = Point::Zero();  // [N m s], of angular momentum
  run_whole(*simulation, usual_step, pair_until, [&](const SystemMoment& moment) {
    if (const double now = simulation->impulses().front(); now > 0.0) {
      impulse += now;
      gained += momentum(pair, moment.after) - momentum(pair, moment.before);
      turned_by += angular_momentum(pair, moment.after, about) -
                   angular_momentum(pair, moment.before, about);
    }
  });
  if (!(impulse > 0.0)) {
    return never_hit(pair_limit);
  }
  const double changed = gained.norm() / impulse;
  const double turned = turned_by.norm() / (impulse * length);
  const double found = std::max(changed, turned);
  std::string sentence = fmt::format(
      "a cable between two bodies keeps their momentum to {:.2g} of its impulse, and their angular "
      "momentum to {:.2g} of that times its length",
      changed, turned);
  if (!(changed <= pair_limit)) {
    sentence = fmt::format(
        "a cable between two bodies changes their momentum, by {:.3g} of its impulse: it does not "
        "pull at both alike",
        changed);
  } else if (!(turned <= pair_limit)) {
    sentence = fmt::format(
        "a cable between two bodies changes their angular momentum, by {:.3g} of its impulse times "
        "its length: it does not pull at both along one line, or it turns other moments",
        turned);
  }
  return {found, pair_limit, sentence};
}

Measure measure_moving_anchor(const Subject& subject) {
  const SpatialSystem at_rest = hit_on_anchor(Point::Zero());
  const Point velocity = 0.5 * struck_direction() + 0.5 * Point(0.8, 0.0, -0.6);  // [m/s]
  // a hit noticed a step sooner or later moves the body by (1 + e) v dt
  const double limit =
      (1.0 + at_rest.cables.front().restitution) * (1.0 + velocity.norm()) * usual_step;  // [m]
  const OnAnchor still = hit_and_away(subject, at_rest);
  if (std::isnan(still.restitution)) {
    return never_hit(limit);
  }
  double found = 0.0;
  double shown = still.restitution;
  for (const double way : {1.0, -1.0}) {
    const OnAnchor moving = hit_and_away(subject, hit_on_anchor(way * velocity));
    double apart = 0.0;  // [m]
    for (std::size_t k = 0; k < still.positions.size(); ++k) {
      const Point gone = static_cast<double>(k + 1) * usual_step * way * velocity;
      apart = worse(apart, (moving.positions.at(k) - gone - still.positions[k]).norm());
    }
    if (apart >= found) {
      found = apart;
      shown = moving.restitution;
    }
  }
  if (found <= limit) {
    return {found, limit,
            fmt::format("on an anchor that moves evenly a body does what it does on one at rest, "
                        "to {:.2g} m",
                        found)};
  }
  const std::string hit =
      std::isnan(shown) ? "is not hit at all" : fmt::format("rebounds with {:.3g}", shown);
  return {
      found, limit,
      fmt::format("the speed of an anchor does not count as it should: a body on one that "
                  "moves evenly {}, on one at rest it rebounds with {:.3g}; it is off by {:.2g} "
                  "m after {:g} s",
                  hit, still.restitution, found, anchor_end)};
}

}  // namespace tautline::bench
