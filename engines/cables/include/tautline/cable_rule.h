// What a cable asks of a host engine's solver in one fixed step. Bullet's and ODE's drop-in cables
// share it; it knows neither, and needs C++11 alone.
//
// The rule, for a cable that begins a step with the gap g and closes at c = -(its gap rate):
//   1. A slack cable has no row. If it closes once it has run out of gap, that is an impact: the
//      row asks for the gap rate e c.
//   2. Once it has rebounded, or rests, closing that the forces, the swinging and the other cables'
//      pulls of one step explain is no impact; until it has been slack again, or closes faster.
//   3. A cable that rests taut is held: its row asks for as much as keeps it at its length while
//      it swings, and never for more than c. Where nothing presses a swing outwards, what a step
//      takes out of it on its way to the circle, the steps after it give back.
//   4. While it is held, a part of its overstretch is taken out per step by moving its ends, at no
//      more than a given speed, or that of the ends themselves. What a step could not follow goes
//      out at once, and what turns too far for it is slowed.
//   5. So no row asks for more than c, and no step's impulses add energy: but for what 3 gives
//   back,
//      and at most 9e-4 of a swing's own for the time of two steps, as it starts.
//
// Why 5: a host steps v' = v + h (forces + cables), x' = x + h v'. Its velocities are half a step
// older than its positions; with the velocity at the pose, v + h forces / 2, a step under constant
// forces, on lines that it does not turn, changes kinetic and potential energy by exactly
//   sum of 1/2 impulse (gap rate after + gap rate before),
// and a row that pulls ends with the rate r it asked for, r <= c = -(rate before). That holds for
// one cable and for any number that are solved together; beside contacts and joints as far as the
// host's solver converges. What 4 lifts out had sunk too deep before: a load that has come to rest
// at zero gap has the least energy of all that hang there.

#pragma once

#include <algorithm>
#include <cmath>
#include <limits>

// NOLINTBEGIN(modernize-use-nodiscard): C++11 does not know it
namespace tautline {

/// One cable from step to step. Rates are gap rates [m/s]: negative while the ends move apart
/// faster than the cable is paid out.
template <typename Real>
class CableRule {
 public:
  /// What the row of a step asks for: a gap rate of at least `rate`, by an impulse >= 0.
  struct Row {
    bool acts;
    Real rate;  // [m/s]
  };

  /// A cable as it stands when a step begins.
  struct Start {
    Real gap;    // [m]
    Real rate;   // [m/s]
    Real fall;   // closing rate that forces add in the step [m/s]
    Real turn;   // twice the rate that keeps the distance in the step, see `cable_turn` [m/s]
    Real most;   // closing rate that swinging and turning can add in a step, at most [m/s]
    Real angle;  // by which the cable or a body turns in the step [rad]
    Real speed;  // of the ends relative to each other [m/s]
    Real dt;     // [s]
  };

  Real length = 0;            // [m], >= 0
  Real length_rate = 0;       // at which it is paid out, negative: hauled in [m/s]
  Real restitution = 0;       // e [-], in [0, 1]
  Real threshold = 0;         // slower closing does not rebound [m/s], >= 0
  Real erp = Real(0.2);       // part of the overstretch that a step takes out [-], in [0, 1]
  Real correction_speed = 1;  // at which it does so at most, unless the ends are faster [m/s], >= 0
  bool by_energy = false;     // rebound with e^2 of the energy instead of e times the rate

  /// Rounding lets the gap of a resting load go to and fro by less than this part of the length
  /// [-]: a hundred times the rounding of float, in coordinates of a hundred lengths.
  static Real slack_rounding() { return Real(1e-5); }

  /// A step follows what turns by less than this in it [rad].
  static Real followed() { return Real(0.3); }

  /// True if a gap of `gap` [m] may need a row: it has run out, or the cable rests and is off its
  /// length by no more than a step's fall.
  bool touches(Real gap) const {
    return gap <= (held() ? std::max(reach_, slack_rounding() * length) : Real(0));
  }

  /// True while the cable rests taut, rather than being slack or rebounding.
  bool held() const { return state_ == State::held; }
  /// True once it has been out of any overstretch since it last pulled.
  bool slack() const { return state_ == State::slack; }
  void hold() { state_ = State::held; }
  void rebounds() { state_ = State::rebounding; }
  void release() {
    state_ = State::slack;
    taken_ = reach_ = over_ = 0;
  }

  /// What one step explains of a closing rate [m/s].
  Real explained(const Start& at) const {
    return std::max(std::max(taken_, at.fall), Real(0)) + at.most;
  }

  /// True if closing as `at` says is an impact, not what one step explains.
  bool is_impact(const Start& at) const {
    return -at.rate > (state_ == State::slack ? Real(0) : explained(at));
  }

  /// The rebound of an impact [m/s].
  Real rebound(Real closing) const { return closing > threshold ? restitution * closing : Real(0); }

  /// The row of the step that begins with `at`.
  Row step(const Start& at) {
    swings_ = false;
    way_ = 0;
    if (!touches(at.gap)) {
      release();
      return Row{false, 0};
    }
    if (is_impact(at)) {
      const Real rate = by_energy ? rebound_by_energy(at) : rebound(-at.rate);
      state_ = rate > 0 ? State::rebounding : State::held;
      return pull(at, rate);
    }
    if (state_ != State::held && (at.rate >= 0 || restitution >= 1)) {
      // on its way out of the overstretch: what turns it around in there, turns it around and no
      // more; an elastic cable turns it back
      state_ = State::rebounding;
      return pull(at, -at.rate);
    }
    state_ = State::held;
    return rest(at);
  }

  /// The row of a cable that rests taut: at the end of the step it is at its length, if that takes
  /// no energy.
  Row rest(const Start& at) {
    const Real keeps = std::max(at.turn, Real(0)) / 2;
    const Real outward = std::max(std::max(taken_, at.fall), Real(0));
    swings_ = outward < keeps;
    // in short steps, a gap of rounding would be more than a swing's whole rate
    const Real rounding = 32 * std::numeric_limits<Real>::epsilon() * length;
    const Real back = std::max(swings_ ? at.gap - rounding : at.gap, Real(0)) / at.dt;
    const Real modest = std::min(keeps, -at.rate);
    modest_ = modest - back;
    way_ = swings_ ? keeps * at.dt : Real(0);
    return pull(at, (swings_ ? swing(at, keeps, outward) : modest) - back);
  }

  /// The row of the step for a cable beside others that pull at its bodies, or beside contacts: by
  /// how much these pull is not known before the solve, and so not what a swing may be given back.
  Row beside_others(Row row) {
    if (row.acts && swings_) {
      asked_ += modest_ - row.rate;
      row.rate = modest_;
    }
    swings_ = false;
    return row;
  }

  /// The row of a part of a step that is split at the impacts, of a cable that rests taut: the load
  /// is where the forces take it in a parabola, and what closing is left is taken out afterwards.
  /// That keeps the energy while a part turns nothing by much; if it does, the row asks for no more
  /// than the closing rate, as in a fixed step.
  Row step_by_events(const Start& at) {
    const Real straight = (std::max(at.turn, Real(0)) - at.fall) / 2;
    const Real rate = at.angle < followed() ? straight : std::min(straight, -at.rate);
    return pull(at, rate - std::max(at.gap, Real(0)) / at.dt);
  }

  /// A step of `dt` [s] of the winch.
  void pay_out(Real dt) {
    length = std::max(length + length_rate * dt, Real(0));
    length_rate = length > 0 ? length_rate : Real(0);
  }

  /// The overstretch that a step takes out by moving the ends [m]: not of a load that bounces, for
  /// that brings it out by itself, nor what the chord of a swing's straight step needs. What has
  /// come in the last step on top of a step's way, because that step could not follow how the
  /// bodies turned, goes out at once.
  Real correction(const Start& at) {
    const Real over = std::max(-at.gap, Real(0));
    const Real come = std::min(over - over_, (at.most + at.speed) * at.dt);  // or the user did it
    over_ = over;
    const Real way = at.speed * at.dt;
    if (state_ == State::held) {
      const Real share =
          std::min(std::max(over - way_, Real(0)) * erp, std::max(correction_speed * at.dt, way));
      return std::max(share, std::min(come, over - way));
    }
    const Real twice = 2 * way;  // what a bounce leaves it with is less
    return restitution < 1 ? std::max(std::min(come, over - twice), Real(0)) : Real(0);
  }

  /// The impulse of the step is in [N s]; `inverse_mass` is J M^-1 J^T [1/kg].
  void pulled(Real impulse, Real inverse_mass) {
    if (!(impulse > 0)) {
      taken_ = reach_ = 0;
      if (gap_ > 0) {
        release();
      }
      return;
    }
    // what the forces and the other cables closed in the step, and the gap that this is
    taken_ = std::max(impulse * inverse_mass - asked_, Real(0));
    reach_ = taken_ * dt_;
    spare_ = swings_ ? spare_ + impulse * spent_ : std::min(spare_, Real(0));
    inverse_mass_ = inverse_mass;
  }

 private:
  enum class State { slack, rebounding, held };

  Row pull(const Start& at, Real rate) {
    asked_ = rate - at.rate;
    gap_ = at.gap;
    dt_ = at.dt;
    spent_ = -at.rate - rate;
    return Row{true, rate};
  }

  /// The rate of a swing that nothing presses outwards by more than it does itself. A straight step
  /// that begins and ends on the circle closes with `keeps` when it ends, and goes on with as much.
  /// One that began along the circle ends outside of it, and closes with twice that. To ask for
  /// `keeps` then would brake the swing, and to turn the closing around would leave every second
  /// step slack. Here the next step is led to closing such that from then on `keeps` is right, and
  /// the energy of the two steps together is what it was. With a step's impulse (per inverse mass)
  /// of rate + closing + outward and its change of energy of (rate - closing) times that, which
  /// leaves `spare_` after it, and the next closing of 2 keeps - rate,
  ///   spare_ + (closing - rate) (closing + rate + outward)
  ///          + (next - keeps) (next + keeps + outward) = 0
  /// says which rate does.
  Real swing(const Start& at, Real keeps, Real outward) const {
    const Real closing = -at.rate;
    const Real spare = spare_ * inverse_mass_;
    const Real settles =
        (spare + closing * closing + 3 * keeps * keeps + outward * (closing + keeps)) /
        (4 * keeps + 2 * outward);
    // or what there is to give is less: a start may borrow a little
    const Real lent = lendable() * at.speed * at.speed;
    const Real given = std::max(spare + lent, Real(0));
    const Real middle = closing + outward / 2;
    return std::min(settles, std::sqrt(middle * middle + given) - outward / 2);
  }
  /// Of the square of a swing's speed [-]: less than the part in a thousand of its energy that a
  /// swing is promised to keep. It settles faster with it, within two steps up to 4.8 rad/s at
  /// 60 Hz.
  static Real lendable() { return Real(9e-4); }

  /// The rate after which the load passes zero gap with e times the speed it passed it with before.
  Real rebound_by_energy(const Start& at) const {
    const Real arrival = -at.rate + at.fall / 2;                               // at this pose
    const Real climb = at.fall > 0 ? -2 * at.gap * at.fall / at.dt : Real(0);  // 2 a overstretch
    const Real passing = arrival * arrival - climb;
    if (!(passing > threshold * threshold)) {
      return 0;
    }
    const Real rate = std::sqrt(restitution * restitution * passing + climb) - at.fall / 2;
    return std::min(std::max(rate, Real(0)), -at.rate);
  }

  State state_ = State::held;  // a load that starts at its cable's end hangs there
  Real asked_ = 0;             // change of the rate that the last row asked for [m/s]
  Real taken_ = 0;             // closing rate of forces and other cables in the last step [m/s]
  Real reach_ = 0;             // [m]
  Real over_ = 0;              // overstretch when the last step began [m]
  Real gap_ = 0;               // when the last row was asked for [m]
  Real dt_ = 0;                // of the last row [s]
  Real spent_ = 0;             // closing rate less the rate that the last row asked for [m/s]
  bool swings_ = false;        // the last row was of a swing that nothing presses outwards
  Real modest_ = 0;            // the rate it would have asked for beside others [m/s]
  Real way_ = 0;               // that a straight step of it may lead out of the circle [m]
  Real spare_ = 0;             // twice the energy that its rows took, less what they gave [J]
  Real inverse_mass_ = 0;      // of the last step [1/kg]
};

/// How the ends of a cable move at the beginning of a step.
template <typename Real>
struct CableSwing {
  Real across;  // square of their relative velocity across the cable [m^2/s^2]
  Real along;   // square of that along it [m^2/s^2]
  Real inward;  // what the turning of the bodies accelerates the gap's closing by [m/s^2]
  Real reach;   // spin^2 times arm, of both bodies: the most that this can be [m/s^2]
  Real spin;    // the faster of the bodies' [rad/s]
};

/// Completes `at` for a cable between ends that are `distance` [m] apart. A step is straight: the
/// rate that keeps the distance is the one that leads along a chord of the circle around the other
/// end, or through its centre if the step is longer than that. A step that began along a circle, or
/// inside of it, closes with no more than `most` when it ends.
template <typename Real>
void cable_turn(typename CableRule<Real>::Start& at, const CableSwing<Real>& swing, Real distance) {
  const Real speed = std::sqrt(swing.across);
  const Real radius = distance / at.dt;  // in a step [m/s]
  const Real beyond = radius > 0 ? swing.across / radius : Real(0);
  // r of (d - h r)^2 + (h speed)^2 = d^2, and the closing c of c d = h (speed^2 + c^2)
  const Real keeps = speed < radius
                         ? swing.across / (radius + std::sqrt(radius * radius - swing.across))
                         : std::max(radius, beyond / 2);
  const Real most =
      2 * speed < radius
          ? 2 * swing.across / (radius + std::sqrt(radius * radius - 4 * swing.across))
          : std::max(speed, beyond);
  const Real rounding = Real(1e-2);  // of float, far out; and of what turns the line meanwhile [-]
  at.turn = 2 * keeps + at.dt * swing.inward;
  at.most = (1 + rounding) * most + at.dt * swing.reach;
  at.speed = std::sqrt(swing.across + swing.along);
  at.angle = at.dt * std::max(swing.spin, distance > 0 ? speed / distance : Real(0));
}

}  // namespace tautline
// NOLINTEND(modernize-use-nodiscard)
