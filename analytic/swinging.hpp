#pragma once

#include <array>
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
    const std::size_t known = extremes_.size();
    if (swings_) {
      add_extremes(the_case, arc);
    }
    return extremes_.size() > known && swing().has_value();
  }

  /// The swing that is shown so far; none with less than a period of it.
  [[nodiscard]] std::optional<BasicSwing<Real>> swing() const {
    BasicSwing<Real> result{Real(0), Real(0), Real(0), Real(0), Real(0)};
    for (const Extreme& extreme : extremes_) {
      result.energy = max(result.energy, extreme.kinetic);
    }
    std::array<const Extreme*, 3> turns{};
    std::size_t count = 0;
    for (const Extreme& extreme : extremes_) {
      if (extreme.kinetic <= turning * result.energy && count < turns.size()) {
        turns[count++] = &extreme;
      }
    }
    if (count < turns.size()) {
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

  /// Whether the power is below zero at the start of an arc and at the ends of its pieces. Tensions
  /// do no work, so that gravity's power is all of it: one polynomial, a fraction of the cost.
  /// Where it is near zero the sign is that of `power`.
  static std::array<bool, pieces + 1> falls_along(const BasicCase<Real>& the_case,
                                                  const BasicArc<Real>& arc) {
    const Real length = arc.end - arc.start;
    std::array<Real, pieces> at;         // the ends of the pieces
    std::array<Real, pieces> work_rate;  // there, of a body of mass 1
    for (int piece = 1; piece <= pieces; ++piece) {
      at[static_cast<std::size_t>(piece - 1)] = length * piece / pieces;
    }
    work_rate.fill(Real(0));
    Real term(0);  // in the end that at the start of the arc
    for (Eigen::Index k = arc.series.rows() - 1; k >= 1; --k) {
      term = static_cast<double>(k) *
             (the_case.gravity[0] * arc.series(k, 0) + the_case.gravity[1] * arc.series(k, 1));
      for (std::size_t place = 0; place < at.size(); ++place) {
        work_rate[place] = work_rate[place] * at[place] + term;
      }
    }
    const Real sure = least_sure_power(the_case, arc);
    const auto falls = [&](const Real& dt, const Real& rate) {
      const Real by_gravity = the_case.body.mass * rate;
      return (abs(by_gravity) > sure ? by_gravity : power(the_case.body, arc, dt)) < 0;
    };
    std::array<bool, pieces + 1> result{falls(Real(0), term)};
    for (std::size_t place = 0; place < at.size(); ++place) {
      result[place + 1] = falls(at[place], work_rate[place]);
    }
    return result;
  }

  /// Above this gravity's power and `power` are of one sign [W]. They differ by the rate of what
  /// rounding, and the end of the series, add to the energy of an arc: its rounding times some
  /// hundreds, for a series of thirty terms, over the length of the arc.
  static Real least_sure_power(const BasicCase<Real>& the_case, const BasicArc<Real>& arc) {
    constexpr double margin = 1e-9;     // [-], a million times as much in a double
    constexpr double too_short = 1e-4;  // [-]: there one more factor of 1 / length counts
    Real reach = arc.initial.position.norm();
    for (const BasicCable<Real>& cable : the_case.cables) {
      reach = max(reach, Real(cable.length + cable.attachment.norm()));
    }
    const Real gravity = the_case.gravity.norm();
    const Real length = arc.end - arc.start;
    if (!(length * length * gravity > too_short * reach)) {
      return infinity<Real>();
    }
    return margin *
           (kinetic_energy(the_case.body, arc.initial) + the_case.body.mass * gravity * reach) /
           length;
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
    const auto falls = falls_along(the_case, arc);
    if (falling_ && *falling_ != falls.front()) {
      add(Real(0));  // rounding between two arcs hides the change of sign
    }
    for (int piece = 1; piece <= pieces; ++piece) {
      const auto place = static_cast<std::size_t>(piece);
      if (falls[place - 1] != falls[place]) {
        const Real low = length * (piece - 1) / pieces;
        const Real high = length * piece / pieces;
        add(stationary(the_case.body, arc, low, power(the_case.body, arc, low), high,
                       power(the_case.body, arc, high)));
      }
    }
    falling_ = falls.back();
  }

  std::optional<std::size_t> events_;
  bool swings_ = false;
  std::optional<bool> falling_;  // the kinetic energy, at the end of the arc before
  std::vector<Extreme> extremes_;
};

}  // namespace tautline
