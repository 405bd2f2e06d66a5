#pragma once

#include <optional>
#include <vector>

#include "tautline/geometry.hpp"
#include "tautline/rows.hpp"
#include "tautline/solution.hpp"
#include "tautline/swing.hpp"

namespace tautline {

/// Follows motion on taut cables that leave one degree of freedom, arc by arc, until it has come
/// round. Its energy is kept, so it goes on like this for ever: no tension falls to zero that has
/// not within a period.
template <class Real>
class Swinging {
 public:
  /// Goes on with `arc`, which `events` events precede: the first of others begins anew. True once
  /// a period of a swing is shown.
  bool follow(const BasicCase<Real>& the_case, const BasicArc<Real>& arc, std::size_t events) {
    if (!events_ || *events_ != events) {
      *this = {};
      events_ = events;
      swings_ = !arc.taut.empty() && has_one_freedom(the_case, arc);
    }
    if (swings_) {
      add_extremes(the_case, arc);
    }
    return swings_ && swing().has_value();
  }

  /// The swing that is shown so far; none with less than a period of it.
  [[nodiscard]] std::optional<BasicSwing<Real>> swing() const {
    BasicSwing<Real> result{Real(0), Real(0), Real(0), Real(0), Real(0)};
    for (const Extreme& extreme : extremes_) {
      result.energy = max(result.energy, extreme.kinetic);
    }
    std::vector<const Extreme*> turns;
    for (const Extreme& extreme : extremes_) {
      if (extreme.kinetic <= turning * result.energy) {
        turns.push_back(&extreme);
      }
    }
    if (turns.size() < 3) {
      return std::nullopt;
    }
    result.period = turns[2]->time - turns[0]->time;
    result.least = min(turns[0]->angle, turns[1]->angle);
    result.largest = max(turns[0]->angle, turns[1]->angle);
    result.amplitude = (result.largest - result.least) / 2;
    return result;
  }

 private:
  /// A kinetic energy this small against the swing's is zero at a turning point [-].
  static constexpr double turning = 1e-9;

  /// Of an arc, which is at most half a swing: one extreme in each.
  static constexpr int pieces = 8;

  /// An instant at which the kinetic energy is least or largest.
  struct Extreme {
    Real time;     // [s]
    Real angle;    // [rad]
    Real kinetic;  // [J]
  };

  static bool has_one_freedom(const BasicCase<Real>& the_case, const BasicArc<Real>& arc) {
    const CableRows<Real> rows(the_case, arc.initial, arc.taut);
    const std::size_t freedoms = is_point_mass(the_case) ? 2 : 3;
    return rows.most_independent().size() + 1 == freedoms;
  }

  /// The rate of the kinetic energy [W] `dt` after the start of an arc, from velocities and
  /// accelerations: near the equilibrium both are small, and so is their rounding.
  static Real power(const BasicBody<Real>& body, const BasicArc<Real>& arc, const Real& dt) {
    using Pose = Eigen::Matrix<Real, 1, 3>;
    Pose pose = Pose::Zero();
    Pose rate = Pose::Zero();
    Pose half_curvature = Pose::Zero();
    for (Eigen::Index k = arc.series.rows() - 1; k >= 0; --k) {
      half_curvature = (half_curvature * dt + rate).eval();
      rate = (rate * dt + pose).eval();
      pose = (pose * dt + arc.series.row(k)).eval();
    }
    return 2 * (body.mass * (rate[0] * half_curvature[0] + rate[1] * half_curvature[1]) +
                body.inertia * rate[2] * half_curvature[2]);
  }

  /// Where in [low, high] after the start of `arc` the power, of other signs there, is zero.
  static Real stationary(const BasicBody<Real>& body, const BasicArc<Real>& arc, Real low,
                         Real at_low, Real high, Real at_high) {
    // Illinois' method: the bracket always holds, and no derivative is needed
    constexpr int enough = 200;  // some 10 are for a double, 20 for 60 digits
    for (int step = 0; step < enough; ++step) {
      Real middle = (low * at_high - high * at_low) / (at_high - at_low);
      const Real value = power(body, arc, middle);
      if (value == 0 || abs(high - low) <= 4 * epsilon<Real>() * (arc.end - arc.start) ||
          middle == high) {
        return middle;
      }
      if ((value < 0) == (at_high < 0)) {
        at_low = at_low / 2;
      } else {
        low = high;
        at_low = at_high;
      }
      high = middle;
      at_high = value;
    }
    return high;
  }

  /// The stationary kinetic energies of `arc`.
  void add_extremes(const BasicCase<Real>& the_case, const BasicArc<Real>& arc) {
    const Real length = arc.end - arc.start;
    if (!(length > 0)) {
      return;
    }
    const auto add = [&](const Real& dt) {
      const BasicState<Real> state = arc.after(dt, the_case.gravity);
      const Real same = sqrt(epsilon<Real>()) * length;  // seen from both sides of a turning point
      if (!extremes_.empty() && arc.start + dt - extremes_.back().time <= same) {
        return;
      }
      extremes_.push_back({arc.start + dt, state.angle, kinetic_energy(the_case.body, state)});
    };
    Real low(0);
    Real at_low = power(the_case.body, arc, low);
    if (falling_ && *falling_ != (at_low < 0)) {
      add(low);  // rounding between two arcs hides the change of sign
    }
    for (int piece = 1; piece <= pieces; ++piece) {
      const Real high = length * piece / pieces;
      const Real at_high = power(the_case.body, arc, high);
      if ((at_low < 0) != (at_high < 0)) {
        add(stationary(the_case.body, arc, low, at_low, high, at_high));
      }
      low = high;
      at_low = at_high;
    }
    falling_ = at_low < 0;
  }

  std::optional<std::size_t> events_;
  bool swings_ = false;
  std::optional<bool> falling_;  // the kinetic energy, at the end of the arc before
  std::vector<Extreme> extremes_;
};

}  // namespace tautline
