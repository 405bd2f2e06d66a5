#pragma once

#include "batch/bounce_lanes.hpp"

namespace tautline {

// `Pack` says how numbers of lanes are computed with: its V, so many at once, from(LaneNumbers,
// first) and to(V, LaneNumbers&, first), and Mask, from(...) > 0, to(Mask, ...).

template <class Pack>
Pair<typename Pack::V> lanes_of(const Pair<LaneNumbers>& pair, std::size_t first) {
  return {Pack::from(pair.x, first), Pack::from(pair.y, first)};
}

template <class Pack>
void put(const Pair<typename Pack::V>& pair, Pair<LaneNumbers>& into, std::size_t first) {
  Pack::to(pair.x, into.x, first);
  Pack::to(pair.y, into.y, first);
}

template <class Pack>
void bounce_lanes(const LaneQuestion& question, LaneAnswer& answer) {
  using V = typename Pack::V;
  using Mask = typename Pack::Mask;
  for (std::size_t first = 0; first < lanes; first += Pack::size) {
    const auto number = [first](const LaneNumbers& of_lanes) {
      return Pack::from(of_lanes, first);
    };
    const auto pair = [first](const Pair<LaneNumbers>& of_lanes) {
      return lanes_of<Pack>(of_lanes, first);
    };
    const FlightWorld<LaneNumbers>& w = question.world;
    const FlightWorld<V> world{pair(w.gravity),   number(w.gravity_size), number(w.mass),
                               number(w.inertia), number(w.per_mass),     number(w.per_inertia),
                               number(w.radius),  number(w.shortest)};
    const Flyer<LaneNumbers>& f = question.from;
    const Flyer<V> from{pair(f.position), number(f.angle),         pair(f.velocity),
                        number(f.spin),   number(f.rate_rounding), number(f.spin_rounding)};
    const auto cable = [&](std::size_t place) {
      const FlightCable<LaneNumbers>& c = question.cables[place];
      return FlightCable<V>{pair(c.anchor),        pair(c.attachment), number(c.length),
                            number(c.per_length),  number(c.radius),   number(c.operand),
                            number(c.restitution), number(c.tried)};
    };
    const Mask touches = number(question.touches) > V(0);
    const Bounce<V, Mask> bounce = next_bounce(world, from, cable, question.count, touches,
                                               number(question.horizon), question.limits);
    const auto put_number = [first](const V& v, LaneNumbers& into) { Pack::to(v, into, first); };
    put_number(select(bounce.ordinary, V(1), V(0)), answer.ordinary);
    put_number(bounce.dt, answer.dt);
    put_number(bounce.place, answer.place);
    put<Pack>(bounce.before.position, answer.before.position, first);
    put_number(bounce.before.angle, answer.before.angle);
    put<Pack>(bounce.before.velocity, answer.before.velocity, first);
    put_number(bounce.before.spin, answer.before.spin);
    put_number(bounce.before.rate_rounding, answer.before.rate_rounding);
    put_number(bounce.before.spin_rounding, answer.before.spin_rounding);
    put_number(bounce.impulse, answer.impulse);
    put<Pack>(bounce.velocity, answer.velocity, first);
    put_number(bounce.spin, answer.spin);
    put_number(select(bounce.leaves, V(1), V(0)), answer.leaves);
    put_number(bounce.tried, answer.tried);
  }
}

}  // namespace tautline
