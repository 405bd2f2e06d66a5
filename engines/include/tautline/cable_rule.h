// What a cable asks of a host engine's solver in one fixed step. Bullet's and ODE's drop-in cables
// share it; it knows neither, and needs C++11 alone.
//
// A host steps v' = v + h (forces + cable), x' = x + h v'. Its positions then lie on the true
// parabola, but v is the velocity of half a step ago: at the pose x it is v - fall / 2, with `fall`
// the closing rate that the forces add in a step. A row that asks for v' = -e v, as the contacts of
// both engines do, therefore reflects the true velocity at e = 1, and retraces the way it came:
//   kinetic energy gained = 1/2 impulse (asked rate + rate before),
// which is zero for v' = -v. Whatever asks for more than the rate of arrival feeds energy; so a
// correction of the overstretch is never added to a bounce, and not made in the step of one.

#pragma once

#include <cmath>

// NOLINTBEGIN(modernize-use-nodiscard): C++11 does not know it
namespace tautline {

/// One cable from step to step. Rates are gap rates [m/s]: negative while the ends move apart.
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
    Real gap;   // [m]
    Real rate;  // [m/s]
    Real fall;  // closing rate that forces add in the step [m/s]
    Real dt;    // [s]
  };

  Real length = 0;         // [m], >= 0
  Real restitution = 0;    // e [-], in [0, 1]
  Real threshold = 0;      // slower closing does not rebound [m/s]
  Real erp = Real(0.2);    // part of the overstretch that a step takes out [-], in [0, 1]
  bool by_energy = false;  // rebound with e^2 of the energy instead of e times the rate

  /// Rounding lets the gap of a resting load go to and fro by less than this part of the length
  /// [-]: a hundred times the rounding of float, in coordinates of a hundred lengths.
  static Real slack_rounding() { return Real(1e-5); }

  /// True if a gap of `gap` [m] may need a row.
  bool touches(Real gap) const { return gap <= (held_ ? slack_rounding() * length : Real(0)); }

  /// True while the cable rests taut, rather than being slack or bouncing.
  bool held() const { return held_; }
  void hold() {
    held_ = true;
    taken_ = 0;
  }
  void release() { held_ = false; }

  /// The impulse of the last step [N s] is in: without one the cable has gone slack.
  void pulled(Real impulse) { held_ = held_ && impulse > 0; }

  /// True if closing at `closing` [m/s] is an impact, not what a load that rests or swings taut
  /// does between two steps: that is no more than the row of the last step took out.
  bool is_impact(Real closing) const { return closing > 0 && !(held_ && closing <= taken_); }

  /// The rebound of an impact [m/s].
  Real rebound(Real closing) const { return closing > threshold ? restitution * closing : Real(0); }

  /// True if the row of a step that begins with the gap rate `rate` [m/s] may ask for a rebound.
  bool may_bounce(Real rate) const { return restitution > 0 && (!held_ || is_impact(-rate)); }

  /// The row of the step that begins with `at`.
  Row step(const Start& at) {
    if (!touches(at.gap)) {
      held_ = false;
      return Row{false, 0};
    }
    if (is_impact(-at.rate)) {
      const Real rate = by_energy ? rebound_by_energy(at) : rebound(-at.rate);
      held_ = !(rate > 0);
      return pull(at, rate);
    }
    if (held_) {
      return rest(at);
    }
    // opening, but not yet out of the overstretch
    if (at.rate >= at.fall / 2) {
      return Row{false, 0};
    }
    // the forces turn it around in there: an elastic cable turns it back, without a gain, any other
    // keeps it
    if (restitution >= 1) {
      return Row{true, -at.rate};
    }
    held_ = true;
    return rest(at);
  }

  /// The row of a cable that rests taut: some of the overstretch out, or no more than the gap in.
  Row rest(const Start& at) {
    return pull(at, at.gap > 0 ? -at.gap / at.dt : -at.gap * erp / at.dt);
  }

 private:
  Row pull(const Start& at, Real rate) {
    taken_ = rate - at.rate + at.fall;
    return Row{true, rate};
  }

  /// The rate after which the load passes zero gap with e times the speed it passed it with before.
  Real rebound_by_energy(const Start& at) const {
    const Real arrival = -at.rate + at.fall / 2;                               // at this pose
    const Real climb = at.fall > 0 ? -2 * at.gap * at.fall / at.dt : Real(0);  // 2 a overstretch
    const Real passing = arrival * arrival - climb;
    if (!(passing > threshold * threshold)) {
      return 0;
    }
    const Real rate = std::sqrt(restitution * restitution * passing + climb) - at.fall / 2;
    return rate > 0 ? rate : Real(0);
  }

  bool held_ = true;  // a load that starts at its cable's end hangs there
  Real taken_ = 0;    // closing rate that the last row took out [m/s]
};

}  // namespace tautline
// NOLINTEND(modernize-use-nodiscard)
