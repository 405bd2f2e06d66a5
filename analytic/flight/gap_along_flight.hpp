#pragma once

#include <tuple>

#include "flight/turn.hpp"
#include "tautline/case.hpp"
#include "tautline/detail/root_search.hpp"
#include "tautline/geometry.hpp"

namespace tautline {

/// `v` as two numbers.
template <class Real>
[[nodiscard]] Pair<Real> pair(const BasicVec2<Real>& v) {
  return {v.x(), v.y()};
}

/// A cable, and what is asked of it in every flight.
template <class V>
struct FlightCable {
  Pair<V> anchor;      // [m]
  Pair<V> attachment;  // [m], in the body's frame
  V length;            // [m]
  V per_length;        // [1/m]
  V radius;            // [m], attachment to centre of mass
  V operand;           // [m], the largest number of its own that its gap is computed from
  V restitution;       // [-]
  V tried;             // [m/s], as in `NextAttempt`

  static constexpr auto members() {
    using C = FlightCable;
    return std::tuple(&C::anchor, &C::attachment, &C::length, &C::per_length, &C::radius,
                      &C::operand, &C::restitution, &C::tried);
  }
};

template <class Real>
[[nodiscard]] FlightCable<Real> flight_cable(const BasicCable<Real>& cable) {
  const Real radius = cable.attachment.norm();
  return {pair<Real>(cable.anchor),
          pair<Real>(cable.attachment),
          cable.length,
          Real(Real(1) / cable.length),
          radius,
          max(max(cable.length, radius), Real(cable.anchor.norm())),
          cable.restitution,
          infinity<Real>()};
}

/// A body that turns farther within a search takes some hundred steps [rad].
inline constexpr double many_turns = 100.0;

/// A free flight from its start on, as the gap of every cable sees it.
template <class V>
struct Flight {
  Pair<V> position;     // [m], of the centre
  Direction<V> facing;  // of the body
  Pair<V> velocity;     // [m/s]
  V spin;               // [rad/s]
  Pair<V> gravity;      // [m/s^2]
  V gravity_size;       // [m/s^2]
  V speed;              // [m/s]
  V spin_squared;       // [rad^2/s^2]
};

/// A point of the body in the world, from the centre [m].
template <class V>
[[nodiscard]] Pair<V> arm_of(const Pair<V>& in_body, const Direction<V>& facing) {
  return {facing.cosine * in_body.x - facing.sine * in_body.y,
          facing.sine * in_body.x + facing.cosine * in_body.y};
}

/// f = (length^2 - distance^2) / (2 length) of one cable along a flight: smooth everywhere, zero
/// with the gap, and with the gap's rate there (Eq. 11).
///
/// Computed from the way d(s) the attachment has gone, f(s) = f(0) - (D(0) + d / 2) . d / length:
/// a short flight then has a small rounding error. Taking squared distances instead leaves 1e-16
/// however short it is, which moves the return of a bounce of speed v by 1e-16 / v.
template <class V>
class GapAlongFlight {
 public:
  /// `at_zero`: f(0) is zero, and f'(0) too where it is within `rate_rounding` below.
  template <class Mask>
  GapAlongFlight(const Flight<V>& flight, const FlightCable<V>& cable, const Mask& at_zero,
                 const V& rate_rounding)
      : flight_(flight),
        arm_(arm_of(cable.attachment, flight.facing)),
        from_anchor_(flight.position + arm_ - cable.anchor),
        per_length_(cable.per_length),
        value_(select(at_zero, V(0),
                      V((cable.length * cable.length - dot(from_anchor_, from_anchor_)) *
                        (per_length_ / 2)))) {
    const V rate =
        -dot(from_anchor_, flight.velocity + flight.spin * turned_left(arm_)) * per_length_;
    drift_ = select(at_zero && rate < V(0) && rate >= V(-rate_rounding), V(-rate), V(0));
    const V turning = flight.spin_squared * cable.radius;
    const V acceleration = flight.gravity_size + turning;
    const V snap = flight.spin_squared * turning;
    const V spin = abs(flight.spin);
    fastest_ = flight.speed + spin * cable.radius;
    snap_ = 3 * acceleration * acceleration * per_length_ + snap;
    snap_of_speed_ = 4 * spin * turning * per_length_;
    snap_of_way_ = snap * per_length_;
  }

  [[nodiscard]] BasicSample<V> at(const V& s) const {
    const auto [sine, versine] = turn(V(flight_.spin * s));
    const Pair<V> turned = sine * turned_left(arm_) - versine * arm_;
    const Pair<V> fallen = s * flight_.gravity;
    const Pair<V> way = s * (flight_.velocity + V(0.5) * fallen) + turned;
    const Pair<V> from_anchor = from_anchor_ + way;
    return sample(value_ + s * drift_ - dot(from_anchor_ + from_anchor, way) * (per_length_ / 2),
                  from_anchor, flight_.velocity + fallen, arm_ + turned);
  }

  /// at(0), which takes no turn.
  [[nodiscard]] BasicSample<V> at_start() const {
    return sample(value_, from_anchor_, flight_.velocity, arm_);
  }

  /// |f''''| <= (3 A^2 + 4 V Y + D Z) / length (Eq. 12): V, A, Y, Z bound the attachment's speed,
  /// acceleration, jerk and snap over the window, and D the distance, which is at most the length
  /// until the first root and at most V w beyond it after.
  [[nodiscard]] V snap_bound(const V& s, const V& window) const {
    const V speed = fastest_ + (s + window) * flight_.gravity_size;
    return snap_ + speed * (snap_of_speed_ + window * snap_of_way_);
  }

 private:
  /// Where the centre has the velocity `of_centre` and the attachment is at `arm` from it.
  [[nodiscard]] BasicSample<V> sample(const V& value, const Pair<V>& from_anchor,
                                      const Pair<V>& of_centre, const Pair<V>& arm) const {
    const Pair<V> across = flight_.spin * turned_left(arm);
    const Pair<V> velocity = of_centre + across;
    const Pair<V> acceleration = flight_.gravity - flight_.spin_squared * arm;
    return {value, drift_ - dot(from_anchor, velocity) * per_length_,
            -(dot(velocity, velocity) + dot(from_anchor, acceleration)) * per_length_,
            (flight_.spin_squared * dot(from_anchor, across) - 3 * dot(velocity, acceleration)) *
                per_length_};
  }

  const Flight<V>& flight_;
  Pair<V> arm_;          // [m], centre of mass to attachment at the start
  Pair<V> from_anchor_;  // [m], anchor to attachment at the start
  V per_length_;         // [1/m]
  V value_;              // [m], f at the start
  V drift_;              // [m/s], takes away a closing rate that is rounding
  V fastest_;            // [m/s], a bound of the attachment's speed but for what it falls
  // of the bound of f'''': alone, times the speed, and times the speed and the window
  V snap_;           // [m/s^4]
  V snap_of_speed_;  // [1/s^3]
  V snap_of_way_;    // [1/s^4]
};

}  // namespace tautline
