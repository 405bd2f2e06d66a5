#include "tautline/accumulation.hpp"

#include "instantiate.hpp"
#include "slow_bounces.hpp"
#include "tautline/geometry.hpp"
#include "tautline/impact.hpp"
#include "tautline/projection.hpp"
#include "tautline/rounding.hpp"
#include "tautline/series.hpp"

namespace tautline {
namespace {

/// Bounces shared by several cables last longer than the slowest cable's own series: measured on
/// the 21 cases of Table 5.1, up to 2.3 times as long [-].
constexpr double several_cables = 4.0;

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
template <class Real>
Real twice_normal_energy(const BasicCase<Real>& the_case, const BasicState<Real>& state,
                         CableSet touching, CableSet cables,
                         const BasicCableVector<Real>& tension) {
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
template <class Real>
Real most_kept(const BasicCase<Real>& the_case, std::size_t index, const Real& speed) {
  Real most(0);
  for (const BasicCable<Real>& cable : the_case.cables) {
    if (side_by_side(cable, the_case.cables[index])) {
      most = max(most, Real(restitution_up_to(cable, speed)));
    }
  }
  return most;
}

/// What the bounces of all cables come to.
template <class Real>
class BouncingSum {
 public:
  BouncingSum(const BasicCase<Real>& the_case, const BasicState<Real>& state,
              const Scales<Real>& scale)
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
  const BasicCase<Real>& case_;
  const BasicState<Real>& state_;
  const Scales<Real>& scale_;
  Bouncing<Real> sum_{true, Real(0), Real(0), Real(0), Real(0), infinity<Real>()};
  Real heights_ = Real(0);  // [m s], the largest integral over time of a gap (Eq. 20)
  Real least_pull_ = infinity<Real>();
};

/// From the normal energy of `cables` and the tensions that will hold them; none if a tension is
/// not certain to stay > 0 until the bounces are over.
template <class Real>
std::optional<Bouncing<Real>> bouncing(const BasicCase<Real>& the_case,
                                       const BasicState<Real>& state, CableSet touching,
                                       CableSet cables, const BasicCableVector<Real>& tension,
                                       const Scales<Real>& scale) {
  const Real energy = twice_normal_energy(the_case, state, touching, cables, tension);
  BouncingSum<Real> sum(the_case, state, scale);
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
template <class Real>
std::optional<Bouncing<Real>> bouncing_alone(const BasicCase<Real>& the_case,
                                             const BasicState<Real>& state, std::size_t index,
                                             const Scales<Real>& scale) {
  BouncingSum<Real> sum(the_case, state, scale);
  const bool pulls = sum.add(index, delassus(the_case, state, index),
                             Real(-free_gap_acceleration(the_case, index, state)),
                             Real(abs(gap_rate(the_case.cables[index], state))));
  return pulls ? sum.of_all(1) : std::nullopt;
}

/// One cable's bounces: their geometric series with the first order of the change of the pull
/// (Eq. 21).
template <class Real>
void refine(Bouncing<Real>& bounces, const BasicCase<Real>& the_case, const BasicState<Real>& state,
            const BasicState<Real>& after, std::size_t index) {
  const BasicCable<Real>& cable = the_case.cables[index];
  const TautSeries<Real> motion(the_case, after, CableSet::of(index), 3);
  const auto lever = motion.lever(index);
  const auto tension = motion.tension(index);
  const Eigen::Matrix<Real, 3, 1> weight = inverse_mass(the_case.body);
  const Real k = cable.length * cable.length * weight[0] + lever[0] * lever[0] * weight[2];
  const Real k_rate = 2 * lever[0] * lever[1] * weight[2];
  const Real root = sqrt(k);
  const Real c = tension[0] * root / cable.length;
  const Real c_rate = (tension[1] * root + tension[0] * k_rate / (2 * root)) / cable.length;
  const Real s = abs(gap_rate(cable, state)) * cable.length / root;
  const Real lost = 1 - restitution_up_to(cable, bounces.speed);
  const Real first = 2 * s / (c * lost);
  const Real second = -first * 2 * c_rate * s / (3 * c * c * lost);
  bounces.remaining = first + second;
  bounces.uncertainty = abs(second) + 4 * epsilon<Real>() * first;
}

/// The cables outside `cables` that could close before the bounces on `cables` are over.
template <class Real>
CableSet within_reach(const BasicCase<Real>& the_case, const BasicState<Real>& state,
                      CableSet cables, const Bouncing<Real>& bounces, const Scales<Real>& scale) {
  const Real remaining = bounces.remaining + bounces.uncertainty;
  const Real change = scale.margin * scale.acceleration * remaining;  // [m/s], of a rate
  CableSet result;
  for (std::size_t index = 0; index < the_case.cables.size(); ++index) {
    if (cables.contains(index)) {
      continue;
    }
    const BasicCable<Real>& cable = the_case.cables[index];
    const Real rate = gap_rate(cable, state);
    const Real own = delassus(the_case, state, index);
    // what the impulses of the bounces change its rate by, of which each turns one of them round
    const Real shaken = 2 * bounces.speed * sqrt(Real(own / bounces.weakest));
    const bool opens = rate > shaken + change;  // all the time
    const Real reach = (max(Real(0), Real(-rate)) + change) * remaining;
    if (!opens && gap(cable, state) <= reach) {
      result.insert(index);
    }
  }
  return result;
}

/// True where the bounces of a cable that begin with `rebound` [m/s] may meet the limits: where
/// they would with a pull as large as the accelerations of the motion. A stronger one has to wait a
/// little.
template <class Real>
bool may_be_slow(const BasicCable<Real>& cable, const BasicState<Real>& state, const Real& rebound,
                 const CompletionLimits& limits, const Scales<Real>& scale) {
  return is_slow(restitution_up_to(cable, rebound), rounding_of_gap(cable, state), rebound, limits,
                 scale);
}

/// The touching cables slow enough to be candidates; empty if one of them is still closing.
template <class Real>
CableSet slow_contacts(const BasicCase<Real>& the_case, const BasicState<Real>& state,
                       const BasicTouching<Real>& touching, const CompletionLimits& limits,
                       const Scales<Real>& scale) {
  CableSet slow;
  for (const std::size_t index : touching.cables) {
    const BasicCable<Real>& cable = the_case.cables[index];
    const Real rate = gap_rate(cable, state);
    if (rate < -touching.rounding(cable)) {
      return {};
    }
    if (may_be_slow(cable, state, rate, limits, scale)) {
      slow.insert(index);
    }
  }
  return slow;
}

/// True where all of `cables` are as slow as candidates are. Those that are not have to bounce
/// more, or to leave, before anything can be said of them.
template <class Real>
bool are_slow(const BasicCase<Real>& the_case, const BasicState<Real>& state, CableSet cables,
              const CompletionLimits& limits, const Scales<Real>& scale) {
  for (const std::size_t index : cables) {
    const BasicCable<Real>& cable = the_case.cables[index];
    if (!may_be_slow(cable, state, Real(abs(gap_rate(cable, state))), limits, scale)) {
      return false;
    }
  }
  return true;
}

/// Those of `cables` that `held` pulls at. They are independent; the others leave, or are
/// redundant.
template <class Real>
CableSet pulled(CableSet cables, const BasicTensions<Real>& held) {
  CableSet result;
  Eigen::Index row = 0;
  for (const std::size_t index : cables) {
    if (held.tension[row++] > 0) {
      result.insert(index);
    }
  }
  return result;
}

/// The cables of `cables` that are at zero gap and rate, up to rounding.
template <class Real>
CableSet at_zero(const BasicCase<Real>& the_case, const BasicState<Real>& state,
                 const BasicTouching<Real>& touching, CableSet cables) {
  constexpr double drift = 1e3;  // [-] roundings of a gap
  CableSet result;
  for (const std::size_t index : cables) {
    const BasicCable<Real>& cable = the_case.cables[index];
    if (abs(gap(cable, state)) <= drift * rounding_of_gap(cable, state) &&
        abs(gap_rate(cable, state)) <= touching.rounding(cable)) {
      result.insert(index);
    }
  }
  return result;
}

/// `after` without what rounding has added to the energy of `before`: the end of bounces gains
/// none.
template <class Real>
BasicState<Real> without_energy_gained(const BasicCase<Real>& the_case,
                                       const BasicState<Real>& before, BasicState<Real> after) {
  const Real gained = energy(the_case, after) - energy(the_case, before);
  const Real kinetic = kinetic_energy(the_case.body, after);
  if (gained > few_roundings * rounding_of_energy(the_case, before) && gained < kinetic) {
    const Real part = sqrt(Real(1 - gained / kinetic));
    after.velocity *= part;
    after.spin *= part;
  }
  return after;
}

/// True where `state` stretches a cable outside `cables`.
template <class Real>
bool overstretches(const BasicCase<Real>& the_case, const BasicState<Real>& state,
                   CableSet cables) {
  for (std::size_t index = 0; index < the_case.cables.size(); ++index) {
    const BasicCable<Real>& cable = the_case.cables[index];
    if (!cables.contains(index) &&
        gap(cable, state) < -rounding_margin * rounding_of_gap(cable, state)) {
      return true;
    }
  }
  return false;
}

/// The cables of `cables` that move: not at exactly zero gap and rate.
template <class Real>
CableSet moving(const BasicCase<Real>& the_case, const BasicState<Real>& state,
                const BasicTouching<Real>& touching, CableSet cables) {
  CableSet result;
  for (const std::size_t index : cables) {
    if (!touching.cables.contains(index) ||
        abs(gap_rate(the_case.cables[index], state)) > touching.rounding(the_case.cables[index])) {
      result.insert(index);
    }
  }
  return result;
}

}  // namespace

template <class Real>
std::optional<BasicCompletion<Real>> completion(const BasicCase<Real>& the_case,
                                                const BasicState<Real>& state,
                                                const BasicTouching<Real>& touching,
                                                const CompletionLimits& limits) {
  const Scales<Real> scale(the_case, state, limits.margin);
  CableSet cables = slow_contacts(the_case, state, touching, limits, scale);
  // a round loses cables that leave or gains one that takes part; few rounds settle it
  for (std::size_t round = 0; round < 2 * max_cables && !cables.empty(); ++round) {
    if (moving(the_case, state, touching, cables).empty()) {
      return std::nullopt;
    }
    std::optional<Bouncing<Real>> bounces;
    if (cables.size() == 1 && touching.cables.contains(*cables.begin())) {
      bounces = bouncing_alone(the_case, state, *cables.begin(), scale);
    } else {
      const auto held = resting_tensions(the_case, state, cables);
      if (!held || !held->tension.allFinite() || !held->acceleration.allFinite()) {
        return std::nullopt;
      }
      if (const CableSet rest = pulled(cables, *held); rest != cables) {
        cables = rest;
        continue;
      }
      bounces = bouncing(the_case, state, touching.cables, cables, held->tension, scale);
    }
    if (!bounces ||
        (limits.speed ? bounces->speed > *limits.speed : !(bounces->error <= limits.error))) {
      return std::nullopt;
    }
    CableSet near = within_reach(the_case, state, cables, *bounces, scale);
    if (!are_slow(the_case, state, near, limits, scale)) {
      return std::nullopt;
    }
    const BasicState<Real> after = projected(the_case, state, cables);
    // redundant: where the others end taut, so do these
    const CableSet carried = at_zero(the_case, after, touching, near);
    near = near - carried;
    if (near.empty()) {
      // cables almost dependent, which the body had to go far to close
      if (!(energy(the_case, after) - energy(the_case, state) <=
            rounding_margin * rounding_of_energy(the_case, state)) ||  // also where it overflows
          overstretches(the_case, after, cables | carried)) {
        return std::nullopt;
      }
      if (cables.size() == 1 && bounces->ends) {
        refine(*bounces, the_case, state, after, *cables.begin());
      }
      return BasicCompletion<Real>{
          cables | carried,     bounces->ends,  bounces->remaining,
          bounces->uncertainty, bounces->error, without_energy_gained(the_case, state, after)};
    }
    cables = cables | near;
  }
  return std::nullopt;
}

template std::optional<BasicCompletion<Instance>> completion(const BasicCase<Instance>&,
                                                             const BasicState<Instance>&,
                                                             const BasicTouching<Instance>&,
                                                             const CompletionLimits&);

}  // namespace tautline
