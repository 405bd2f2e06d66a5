#pragma once

#include <cstddef>
#include <tuple>

#include "flight/gap_along_flight.hpp"
#include "shortcuts/members.hpp"
#include "slow_bounces.hpp"
#include "tautline/detail/accumulation.hpp"
#include "tautline/detail/first_contact.hpp"
#include "tautline/detail/rounding.hpp"

namespace tautline {

// What happens most, written for one body or several side by side: a body in free flight is caught
// by one cable and leaves it. It is the loop's own flight and impact (solve.cpp), without the
// questions whose answers are known here: nothing rests, and no accumulation is to be completed.

/// What all flights of a case have in common.
template <class V>
struct FlightWorld {
  Pair<V> gravity;  // [m/s^2]
  V gravity_size;   // [m/s^2]
  V mass;           // [kg]
  V inertia;        // [kg m^2]
  V per_mass;       // [1/kg]
  V per_inertia;    // [1/(kg m^2)]; 0 for a point mass
  V radius;         // [m], of the farthest attachment
  V shortest;       // [m], the length of the shortest cable

  static constexpr auto members() {
    using W = FlightWorld;
    return std::tuple(&W::gravity, &W::gravity_size, &W::mass, &W::inertia, &W::per_mass,
                      &W::per_inertia, &W::radius, &W::shortest);
  }
};

/// A body between two impacts.
template <class V>
struct Flyer {
  Pair<V> position;     // [m]
  V angle;              // [rad], at most `farthest_turn` in size
  Direction<V> facing;  // `direction` of it
  Pair<V> velocity;     // [m/s]
  V spin;               // [rad/s]
  V rate_rounding;      // as in BasicTouching [m/s]
  V spin_rounding;      // [rad/s]

  static constexpr auto members() {
    using F = Flyer;
    return std::tuple(&F::position, &F::angle, &F::facing, &F::velocity, &F::spin,
                      &F::rate_rounding, &F::spin_rounding);
  }
};

/// An impact on one cable at the end of a flight.
template <class V, class Mask>
struct Bounce {
  Mask is_all;       // that happens; if false, ignore the rest: the general path decides
  V dt;              // [s], of the flight
  V place;           // of the cable in the order of the search
  Flyer<V> before;   // the impact
  V impulse;         // [N s]
  Pair<V> velocity;  // after the impact [m/s]
  V spin;            // [rad/s]
  Mask is_due;       // to be tried as the end of an accumulation, or the cable does not open
  V tried;           // of the cable, from now on

  static constexpr auto members() {
    using B = Bounce;
    return std::tuple(&B::is_all, &B::dt, &B::place, &B::before, &B::impulse, &B::velocity,
                      &B::spin, &B::is_due, &B::tried);
  }
};

/// Where numbers of a motion and their squares fit a double.
template <class V>
[[nodiscard]] auto fits(const FlightWorld<V>& world, const Pair<V>& position, const V& angle,
                        const Pair<V>& velocity, const V& spin) {
  const V squares = dot(velocity, velocity);
  const V turning = spin * spin;
  const V energy = (world.mass * squares + world.inertia * turning) / 2 -
                   world.mass * dot(world.gravity, position);
  return is_finite(V(energy + squares + turning + dot(position, position) + abs(angle)));
}

/// Newton's law on one cable (Eq. 14) of a body that has come to it: fills what follows the flight.
template <class V, class Mask>
void rebound(const FlightWorld<V>& world, const FlightCable<V>& cable,
             const CompletionLimits& limits, Bounce<V, Mask>& bounce) {
  const Flyer<V>& before = bounce.before;
  const Pair<V> arm = arm_of(cable.attachment, before.facing);
  const Pair<V> from_anchor = before.position + arm - cable.anchor;
  const V distance = norm(from_anchor);
  const Pair<V> u = V(1.0 / distance) * from_anchor;
  const V lever = arm.x * u.y - arm.y * u.x;
  const V rate = -(dot(u, before.velocity) + lever * before.spin);
  const V impulse = -(1.0 + cable.restitution) * rate /
                    (world.per_mass * dot(u, u) + world.per_inertia * lever * lever);
  bounce.impulse = impulse;
  bounce.velocity = before.velocity - V(impulse * world.per_mass) * u;
  bounce.spin = before.spin - impulse * world.per_inertia * lever;

  const V rate_rounding = before.rate_rounding + before.spin_rounding * cable.radius;
  const V height_rounding = epsilon<V>() * most(cable.operand, norm(before.position));
  const Mask closes = rate < V(-rate_rounding);
  const Mask drifted = abs(cable.length - distance) > V(few_roundings * height_rounding);
  bounce.is_all = bounce.is_all && closes && !drifted &&
                  fits(world, before.position, before.angle, bounce.velocity, bounce.spin);

  const V rebound = -cable.restitution * rate;
  const V speed = norm(bounce.velocity) + abs(bounce.spin) * world.radius;
  const Scales<V> scale(world.gravity_size, world.radius, world.shortest, speed, bounce.spin,
                        limits.margin);
  const auto next = next_attempt(cable.restitution, height_rounding, rate_rounding, rebound,
                                 cable.tried, limits, scale);
  bounce.is_due = next.is_due;
  bounce.tried = next.tried;
}

/// The next impact of bodies that fly within `horizon` [s], each on the cables `cable(k)`, k <
/// count, of its own, of which it has left the first where `touches`. Requires that they leave it
/// and that its bounces are not due (`NextAttempt`).
template <class V, class Mask, class Cables>
[[nodiscard]] Bounce<V, Mask> next_bounce(const FlightWorld<V>& world, const Flyer<V>& from,
                                          const Cables& cable, std::size_t count,
                                          const Mask& touches, const V& horizon,
                                          const CompletionLimits& limits) {
  const Flight<V> flight{
      from.position, from.facing,        from.velocity,       from.spin,
      world.gravity, world.gravity_size, norm(from.velocity), V(from.spin * from.spin)};
  const double together = 1.0 + simultaneous<double>();
  V earliest = infinity<V>();
  V next = earliest;
  V place(0);
  FlightCable<V> hit = cable(0);
  Mask known = V(abs(from.angle)) <= V(farthest_turn);
  // what lies beyond many turns, or turns beyond count, the general way finds out
  const V spin = abs(from.spin);
  const V turns = select(V(spin * horizon) <= V(many_turns), horizon, V(many_turns / spin));
  const V reach = select(known, turns, V(0));
  for (std::size_t k = 0; k < count; ++k) {
    const FlightCable<V> one = cable(k);
    const Mask at_zero = touches && V(static_cast<double>(k)) == V(0);
    const GapAlongFlight<V> f(flight, one, at_zero,
                              V(from.rate_rounding + from.spin_rounding * one.radius));
    const V root = first_roots(f, least(reach, V(earliest * together)), at_zero).root;
    const Mask first = root < earliest;
    known = known && root <= infinity<V>();  // not NaN
    next = least(next, select(first, earliest, root));
    earliest = select(first, root, earliest);
    place = select(first, V(static_cast<double>(k)), place);
    each_number(hit, one,
                [&](V& of_hit, const V& of_one) { of_hit = select(first, of_one, of_hit); });
  }
  Bounce<V, Mask> bounce;
  bounce.is_all = known && earliest > V(0) && is_finite(earliest) && next > V(earliest * together);
  const V dt = select(bounce.is_all, earliest, V(0));
  bounce.dt = dt;
  bounce.place = place;
  const Pair<V> velocity = from.velocity + dt * world.gravity;
  const double rounding = few_roundings * epsilon<double>();  // of the fastest speeds so far
  const V angle = from.angle + dt * from.spin;
  bounce.before = {from.position + (dt * from.velocity + V(dt * dt / 2) * world.gravity),
                   angle,
                   direction(angle),
                   velocity,
                   from.spin,
                   most(from.rate_rounding, V(rounding * norm(velocity))),
                   most(from.spin_rounding, V(rounding * spin))};
  rebound(world, hit, limits, bounce);
  return bounce;
}

}  // namespace tautline
