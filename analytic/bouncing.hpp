#pragma once

#include <optional>

#include "slow_bounces.hpp"
#include "tautline/cable_set.hpp"
#include "tautline/case.hpp"
#include "tautline/detail/projection.hpp"
#include "tautline/detail/rounding.hpp"
#include "tautline/detail/scalar.hpp"
#include "tautline/detail/series.hpp"
#include "tautline/geometry.hpp"
#include "tautline/impact.hpp"

// What the bounces that are left on a set of cables come to: how fast, how long, how much they
// change (analytic/README.md, section 5).

namespace tautline {

/// Bounces shared by several cables last longer than the slowest cable's own series: measured on
/// the 21 cases of Table 5.1, up to 2.3 times as long [-].
inline constexpr double several_cables = 4.0;

/// How the bounces on a set of almost taut cables go on.
template <class Real>
struct Bouncing {
  bool ends;         // false: one of the cables is elastic and never stops
  Real speed;        // [m/s], the fastest rebound their normal energy allows
  Real error;        // [-], of later velocities, if the bounces are replaced by their end
  Real remaining;    // [s] until all bounces are over
  Real uncertainty;  // [s] of `remaining`
  Real weakest;      // [1/kg], the least response of a cable to an impulse of its own
};

/// The normal energy of `cables`, twice, per mass of the normal coordinates (Eq. 17).
template <class TheCase, class Real = RealOf<TheCase>>
Real twice_normal_energy(const TheCase& the_case, const StateOf<TheCase>& state, CableSet touching,
                         CableSet cables, const BasicCableVector<Real>& tension) {
  const BasicCableVector<Real> rate = gap_rates(the_case, state, cables);
  const BasicCableVector<Real> solved = multipliers(the_case, state, cables, rate);
  Real result = rate.dot(solved);
  Eigen::Index row = 0;
  for (const std::size_t index : cables) {
    const Real height = max(Real(0), gap(the_case.cables[index], state));
    result += touching.contains(index) ? Real(0) : Real(2 * tension[row] * height);
    ++row;
  }
  return result;
}

/// True where `pull` [m/s^2] changes by a small part of itself in a time of `dt` [s].
template <class Real>
bool is_steady(const Real& pull, const Real& dt, const Scales<Real>& scale) {
  return pull > scale.margin * scale.acceleration * scale.rate * dt;  // false for infinities
}

/// The largest restitution up to `speed` of the cable and those that hang side by side with it.
template <class TheCase, class Real = RealOf<TheCase>>
Real most_kept(const TheCase& the_case, std::size_t index, const Real& speed) {
  Real most(0);
  for (const CableOf<TheCase>& cable : the_case.cables) {
    if (side_by_side(cable, the_case.cables[index])) {
      most = max(most, Real(restitution_up_to(cable, speed)));
    }
  }
  return most;
}

/// What the bounces of all cables come to.
template <class TheCase>
class BouncingSum {
 public:
  using Real = RealOf<TheCase>;

  BouncingSum(const TheCase& the_case, const StateOf<TheCase>& state, const Scales<Real>& scale)
      : case_(the_case), state_(state), scale_(scale) {}

  /// Those of a cable that its `pull` [m/s^2] closes and that rebounds with up to `speed` [m/s];
  /// `response` [1/kg] is its own to an impulse. False where nothing pulls.
  [[nodiscard]] bool add(std::size_t index, const Real& response, const Real& pull,
                         const Real& speed) {
    if (!(pull > 0)) {
      return false;
    }
    least_pull_ = min(least_pull_, pull);
    sum_.weakest = min(sum_.weakest, response);
    sum_.speed = max(sum_.speed, speed);
    const Real kept = most_kept(case_, index, speed);
    const Real flight = 2 * speed / pull;
    const Real height = speed * flight / 4;
    const Real series = flight / (1 - kept);  // [s], infinite for an elastic cable
    const bool is_over = is_steady(pull, series, scale_);
    if (!is_over && height <= rounding_of_gap(case_.cables[index], state_)) {
      sum_.ends = false;  // it bounces on, too low for a gap to tell
      sum_.remaining = max(sum_.remaining, flight);
    } else if (kept < 1) {
      sum_.remaining = max(sum_.remaining, series);
      heights_ = max(heights_, Real(2 * height * flight / (3 * (1 - kept * kept * kept))));
    } else {  // it bounces for ever, at this height
      sum_.ends = false;
      sum_.remaining = max(sum_.remaining, flight);
      heights_ = max(heights_, Real(height / scale_.rate));
    }
    return true;
  }

  /// None if a pull is not certain to stay > 0 until the bounces are over.
  [[nodiscard]] std::optional<Bouncing<Real>> of_all(std::size_t cables) {
    sum_.error =
        error_margin * scale_.rate * scale_.rate * scale_.rate * heights_ / scale_.acceleration;
    if (!is_steady(least_pull_, sum_.remaining, scale_)) {
      return std::nullopt;
    }
    if (cables > 1) {  // how the cables hand the energy to each other is open
      sum_.error *= several_cables;
      sum_.remaining *= several_cables / 2;
      sum_.uncertainty = sum_.remaining;
    }
    return sum_;
  }

 private:
  const TheCase& case_;
  const StateOf<TheCase>& state_;
  const Scales<Real>& scale_;
  Bouncing<Real> sum_{true, Real(0), Real(0), Real(0), Real(0), infinity<Real>()};
  Real heights_ = Real(0);  // [m s], the largest integral over time of a gap (Eq. 20)
  Real least_pull_ = infinity<Real>();
};

/// From the normal energy of `cables` and the tensions that will hold them; none if a tension is
/// not certain to stay > 0 until the bounces are over.
template <class TheCase, class Real = RealOf<TheCase>>
std::optional<Bouncing<Real>> bouncing(const TheCase& the_case, const StateOf<TheCase>& state,
                                       CableSet touching, CableSet cables,
                                       const BasicCableVector<Real>& tension,
                                       const Scales<Real>& scale) {
  const Real energy = twice_normal_energy(the_case, state, touching, cables, tension);
  BouncingSum<TheCase> sum(the_case, state, scale);
  Eigen::Index row = 0;
  for (const std::size_t index : cables) {
    const Real g = delassus(the_case, state, index);
    if (!sum.add(index, g, Real(tension[row++] * g), Real(sqrt(Real(energy * g))))) {
      return std::nullopt;
    }
  }
  return sum.of_all(cables.size());
}

/// The same of one touching cable: its energy is that of its own rate, and its pull what closes it
/// in flight.
template <class TheCase, class Real = RealOf<TheCase>>
std::optional<Bouncing<Real>> bouncing_alone(const TheCase& the_case, const StateOf<TheCase>& state,
                                             std::size_t index, const Scales<Real>& scale) {
  BouncingSum<TheCase> sum(the_case, state, scale);
  const bool pulls = sum.add(index, delassus(the_case, state, index),
                             Real(-free_gap_acceleration(the_case, index, state)),
                             Real(abs(gap_rate(the_case.cables[index], state))));
  return pulls ? sum.of_all(1) : std::nullopt;
}

/// One cable's bounces: their geometric series with the first order of the change of the pull
/// (Eq. 21).
template <class TheCase, class Real = RealOf<TheCase>>
void refine(Bouncing<Real>& bounces, const TheCase& the_case, const StateOf<TheCase>& state,
            const StateOf<TheCase>& after, std::size_t index) {
  const CableOf<TheCase>& cable = the_case.cables[index];
  constexpr std::size_t order = 3;
  const SeriesOf<TheCase> motion(the_case, after, CableSet::of(index), order);
  const auto tension = motion.tension(index);
  const auto [k, k_rate, length] = scaled_response(the_case, after, motion, index);
  const Real root = sqrt(k);
  const Real c = tension[0] * root / length;
  const Real c_rate = (tension[1] * root + tension[0] * k_rate / (2 * root)) / length;
  const Real s = abs(gap_rate(cable, state)) * length / root;
  const Real lost = 1 - restitution_up_to(cable, bounces.speed);
  const Real first = 2 * s / (c * lost);
  const Real second = -first * 2 * c_rate * s / (3 * c * c * lost);
  bounces.remaining = first + second;
  bounces.uncertainty = abs(second) + 4 * epsilon<Real>() * first;
}

}  // namespace tautline
