// The rule of an elastic cable: how it asks a host engine's solver for its pull in one step.
// Bullet's and ODE's drop-in cables share it; it knows neither, and needs C++11 alone. It computes
// in double.
//
// The law, with the stretch s [m] by which the ends are farther apart than the cable is long:
//   T = max(0, f(s) + c s') where s > 0, else 0;   f(s) = k1 s + k2 s^2 + ...               (E1)
//
// A step of h is implicit. The ends close at u0 before it and at u1 after it, and a straight step
// leads `keeps` out of the circle around the other end (see CableRule), so the stretch grows at
// v = u1 + keeps, and the impulse is
//   p = h max(0, f(s) + d v),   d = max(c, h k),
// where f(s) + h k v = f(s + h v): an implicit spring damps, and the damper has that share already.
// This is a row of the solve, which asks for the gap rate
//   -u1 = keeps + f(s) / d   and gives by   1 / (h d)   of its impulse.
// k is the secant of f between the ends of the step as the cable by itself would have it: exact
// where f is linear. A cable that is slack as a step begins has no damping in it; with damping it
// would pull before it has its length.
//
// Energy never rises, at any step. A host steps v' = v + h (forces + cables), x' = x + h v'. With
// the velocity at the pose, v + h forces / 2, a step under constant forces changes kinetic and
// potential energy of the bodies by exactly
//   -p (u0 + u1) / 2   for each cable.
// An account of this is what the cable has taken from them since it was slack. It gives no more
// back: a stretch counts as far as the account pays for it,
//   s <= stored^-1(account),   stored(s) = integral of f,
// and not at all if the ends come closer by more than it in the step. Then no step takes more out
// of the account than is in it. With x = h |u0| / s <= 1 and y = h |v| / s, a linear cable gives
//   p |u0 + u1| / 2 <= k s^2 / 2 (1 - y) (x + y) <= k s^2 / 2
// if it shrinks, and has (1 + y) (x - y) there if the other cables turn it around. So the energy of
// the bodies and the accounts never rises: where k h^2 / m is large, where lines turn by radians in
// a step, and next to other cables. In steps that resolve the motion the account has more than the
// cable stores, by what its damper or the implicit step has taken (an undamped load that swings up
// and down with the frequency w is damped by a ratio of w h / 2), and the bound is not felt.

#pragma once

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <limits>
#include <vector>

#include "tautline/cable_rule.h"

// NOLINTBEGIN(modernize-use-nodiscard): C++11 does not know it
namespace tautline {

/// How an elastic cable pulls, see (E1); without stiffness it does not stretch. At most one of both
/// dampings is above 0.
struct CableElasticity {
  std::vector<double> stiffness;  // k1 > 0, k2, ... >= 0 [N/m, N/m^2, ...]
  double damping = 0;             // c [N s/m], >= 0
  double damping_ratio = 0;  // [-], >= 0: c = 2 ratio sqrt(k1 m) with the mass m that the cable
                             // feels in the step in which it becomes stretched

  CableElasticity() = default;
  /// Linear, of `the_stiffness` [N/m].
  explicit CableElasticity(double the_stiffness, double ratio = 0)
      : stiffness(1, the_stiffness), damping_ratio(ratio) {}

  /// The first error of it, as a sentence; null if there is none.
  const char* problem() const {
    for (std::size_t power = 0; power < stiffness.size(); ++power) {
      if (!(stiffness[power] >= 0 && stiffness[power] < infinite())) {
        return "each stiffness of an elastic cable must be a finite number of at least 0";
      }
    }
    if (!stiffness.empty() && !(stiffness[0] > 0)) {
      return "the first stiffness of an elastic cable must be above 0 N/m";
    }
    if (!(damping >= 0 && damping < infinite() && damping_ratio >= 0 &&
          damping_ratio < infinite())) {
      return "the damping of an elastic cable must be a finite number of at least 0";
    }
    if (damping > 0 && damping_ratio > 0) {
      return "an elastic cable must have a damping or a damping ratio, not both";
    }
    if (stiffness.empty() && (damping > 0 || damping_ratio > 0)) {
      return "a cable with damping must have a stiffness";
    }
    return nullptr;
  }

  /// f at a stretch, 0 where it is slack [N].
  double force(double stretch) const { return stretch > 0 ? stretch * secant(0, stretch) : 0; }
  /// The energy that the spring stores [J].
  double stored(double stretch) const {
    double result = 0;
    for (std::size_t power = stiffness.size(); power-- > 0;) {
      result = result * stretch + stiffness[power] / static_cast<double>(power + 2);
    }
    return stretch > 0 ? result * stretch * stretch : 0;
  }
  /// (f(two) - f(one)) / (two - one), and f' where both are the same [N/m]; both >= 0.
  double secant(double one, double two) const {
    double value = 0;
    double slope = 0;
    for (std::size_t power = stiffness.size(); power-- > 0;) {
      slope = slope * two + value;
      value = value * one + stiffness[power];
    }
    return slope * two + value;
  }
  /// The stretch up to `most` that stores no more than `energy` [m].
  double stretch_of(double energy, double most) const {
    if (stored(most) <= energy) {
      return most;
    }
    double low = 0;
    double high = energy > 0 ? most : 0;
    const int halvings = 60;
    for (int done = 0; done < halvings && low < high; ++done) {
      const double middle = low + (high - low) / 2;
      (stored(middle) > energy ? high : low) = middle;
    }
    return low;
  }

 private:
  static double infinite() { return std::numeric_limits<double>::infinity(); }
};

/// The damping ratio [-] with which an elastic cable throws a load back with `restitution` of its
/// speed, in (0, 1], where no other force acts; infinite for 0, which no damping gives.
inline double cable_damping_ratio(double restitution) {
  double low = 0;
  double high = 1;
  if (!(restitution > 0)) {
    return std::numeric_limits<double>::infinity();
  }
  // of e = exp(-ratio p), p = 2 acos(ratio) / sqrt(1 - ratio^2), which falls with the ratio
  const auto rebounds = [](double ratio) {
    const double root = std::sqrt(std::abs(1 - ratio * ratio));
    const double angle = ratio < 1 ? std::atan2(root, ratio) : std::log(ratio + root);
    return std::exp(-2 * ratio * (root > 1e-6 ? angle / root : 1.0));
  };
  while (rebounds(high) > restitution) {
    high *= 2;
  }
  const int halvings = 60;
  for (int done = 0; done < halvings; ++done) {
    const double middle = (low + high) / 2;
    (rebounds(middle) > restitution ? low : high) = middle;
  }
  return restitution < 1 ? high : 0;
}

/// One elastic cable from step to step.
class CableSpring {
 public:
  /// A cable as a step begins.
  struct Start {
    double stretch;       // [m], negative: slack
    double rate;          // of the gap [m/s]
    double fall;          // closing rate that forces add in the step [m/s]
    double turn;          // twice `keeps` [m/s]
    double way;           // of the ends in the step, at most [m]
    double inverse_mass;  // J M^-1 J^T [1/kg]
    double dt;            // [s]
    bool in_parabola;     // forces move the bodies by half of their change of the velocity

    /// The start that the rule of the cable has, with what it does not have.
    template <typename StartOfRule>
    Start(const StartOfRule& at, double the_inverse_mass, bool parabola)
        : stretch(-at.gap),
          rate(at.rate),
          fall(at.fall),
          turn(at.turn),
          way(2.0 * (at.speed + at.most + std::abs(at.rate) + std::abs(at.fall)) * at.dt),
          inverse_mass(the_inverse_mass),
          dt(at.dt),
          in_parabola(parabola) {}
  };

  /// The row of a step: a gap rate of at least `rate` by an impulse >= 0, and each N s of it lets
  /// the rate be smaller by `compliance`.
  struct Row {
    bool acts;          // else it is slack all the step
    double rate;        // [m/s]
    double compliance;  // [1/kg]
  };

  bool is_elastic() const { return !law_.stiffness.empty(); }  // else the rule has the cable
  const CableElasticity& law() const { return law_; }          // as it was set last
  /// A law without problem.
  void set(const CableElasticity& law) {
    law_ = law;
    damping_ = law.damping;
    forget();
  }
  /// The user has changed what the cable is stretched by: that stretch counts.
  void forget() { known_ = false; }
  /// As `forget` where a length is set that is not the one a winch has wound already [m].
  template <typename Length>
  void set_length(Length from, Length to) {
    const Length rounding = 16 * std::numeric_limits<Length>::epsilon();
    if (!(std::abs(to - from) <= rounding * std::max(from, to))) {
      forget();
    }
  }
  /// The largest tension since the cable became stretched last [N].
  double peak() const { return peak_; }

  /// The row of the step that begins with `at`.
  Row step(const Start& at) {
    const double way = at.way + way_;
    if (!known_ || std::abs(at.stretch - stretch_) > way) {  // or the user did it
      account_ = law_.stored(at.stretch);
    }
    known_ = true;
    if (!(at.stretch > 0)) {
      account_ = std::min(account_, 0.0);
      stretched_ = false;
    } else if (!stretched_) {
      stretched_ = true;
      peak_ = 0;
      if (law_.damping_ratio > 0 && at.inverse_mass > 0) {
        damping_ = 2 * law_.damping_ratio * std::sqrt(law_.stiffness[0] / at.inverse_mass);
      }
    }
    stretch_ = at.stretch;
    way_ = at.way;
    closing_ = -at.rate;
    dt_ = at.dt;
    inverse_mass_ = at.inverse_mass;
    fall_ = at.fall;
    half_fall_ = at.in_parabola ? at.fall / 2 : 0;
    keeps_ = std::min(std::max(at.turn, 0.0) / 2, std::max(closing_, 0.0));
    return row(at.stretch + at.way > 0);
  }
  /// The row again after the host has moved the ends apart by `farther` [m].
  Row moved(double farther) {
    stretch_ += farther;
    return row(true);
  }

  /// The impulse of the step is in [N s].
  void pulled(double impulse) {
    const double rate = row_.rate - row_.compliance * impulse;
    account_ += impulse * (closing_ - 2 * half_fall_ - rate) / 2;
    peak_ = std::max(peak_, impulse / dt_);
  }

 private:
  double active_damping() const { return stretched_ ? damping_ : 0; }

  Row row(bool acts) {
    counted_ = stretch_ > 0 ? law_.stretch_of(account_, stretch_) : stretch_;
    if (-closing_ * dt_ > counted_) {
      counted_ = std::min(counted_, 0.0);
    }
    const double from = std::max(counted_, 0.0);
    const double k = law_.secant(from, std::max(end(), 0.0));
    const double damper = std::max(active_damping(), dt_ * k);
    const double force = law_.force(from) + k * (counted_ - from);
    row_.acts = acts;
    row_.rate = keeps_ - half_fall_ + force / damper;
    row_.compliance = 1 / (dt_ * damper);
    return row_;
  }
  /// The stretch at the end of the step if no other cable pulls [m]; any, of a linear law.
  double end() const {
    const double free = keeps_ + closing_ + fall_ - half_fall_;
    if (law_.stiffness.size() < 2) {
      return counted_;
    }
    // of growth + impulse / mass = free, where both terms rise with the growth
    double low = std::min(free, -std::max(counted_, 0.0) / dt_);
    double high = std::max(free, 0.0);
    const int halvings = 60;
    for (int done = 0; done < halvings; ++done) {
      const double growth = (low + high) / 2;
      const double damped = law_.force(counted_) + active_damping() * growth;
      const double force = std::max(law_.force(counted_ + dt_ * growth), growth > 0 ? damped : 0.0);
      (growth + inverse_mass_ * dt_ * force > free ? high : low) = growth;
    }
    return counted_ + dt_ * high;
  }

  CableElasticity law_;
  double damping_ = 0;      // c since it became stretched last [N s/m]
  bool stretched_ = false;  // as the last step began
  bool known_ = false;      // the account is
  double account_ = 0;      // of what it has taken and not given back [J]
  double peak_ = 0;         // [N]

  // of the last step
  double stretch_ = 0;  // [m]
  double counted_ = 0;  // of it, or all of the slack [m]
  double way_ = 0;      // [m]
  double closing_ = 0;  // before it [m/s]
  double keeps_ = 0;    // [m/s]
  double fall_ = 0;     // [m/s]
  double half_fall_ = 0;
  double inverse_mass_ = 0;  // [1/kg]
  double dt_ = 0;            // [s]
  Row row_ = {false, 0, 0};
};

}  // namespace tautline
// NOLINTEND(modernize-use-nodiscard)
