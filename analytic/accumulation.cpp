#include "tautline/detail/accumulation.hpp"

#include "bouncing.hpp"
#include "instantiate.hpp"
#include "slow_bounces.hpp"
#include "tautline/detail/projection.hpp"
#include "tautline/detail/rounding.hpp"
#include "tautline/geometry.hpp"
#include "tautline/impact.hpp"

namespace tautline {
namespace {

/// The cables outside `cables` that could close before the bounces on `cables` are over.
template <class TheCase, class Real = RealOf<TheCase>>
CableSet within_reach(const TheCase& the_case, const StateOf<TheCase>& state, CableSet cables,
                      const Bouncing<Real>& bounces, const Scales<Real>& scale) {
  const Real remaining = bounces.remaining + bounces.uncertainty;
  const Real change = scale.margin * scale.acceleration * remaining;  // [m/s], of a rate
  CableSet result;
  for (std::size_t index = 0; index < the_case.cables.size(); ++index) {
    const CableOf<TheCase>& cable = the_case.cables[index];
    if (cables.contains(index) || is_elastic(cable)) {
      continue;
    }
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
template <class TheCase, class Real = RealOf<TheCase>>
bool may_be_slow(const CableOf<TheCase>& cable, const StateOf<TheCase>& state, const Real& rebound,
                 const CompletionLimits& limits, const Scales<Real>& scale) {
  return is_slow(restitution_up_to(cable, rebound), rounding_of_gap(cable, state), rebound, limits,
                 scale);
}

/// The touching cables slow enough to be candidates; empty if one of them is still closing.
template <class TheCase, class Real = RealOf<TheCase>>
CableSet slow_contacts(const TheCase& the_case, const StateOf<TheCase>& state,
                       const TouchingOf<TheCase>& touching, const CompletionLimits& limits,
                       const Scales<Real>& scale) {
  CableSet slow;
  for (const std::size_t index : touching.cables) {
    const CableOf<TheCase>& cable = the_case.cables[index];
    const Real rate = gap_rate(cable, state);
    if (rate < -touching.rounding(cable)) {
      return {};
    }
    if (may_be_slow<TheCase>(cable, state, rate, limits, scale)) {
      slow.insert(index);
    }
  }
  return slow;
}

/// True where all of `cables` are as slow as candidates are. Those that are not have to bounce
/// more, or to leave, before anything can be said of them.
template <class TheCase, class Real = RealOf<TheCase>>
bool are_slow(const TheCase& the_case, const StateOf<TheCase>& state, CableSet cables,
              const CompletionLimits& limits, const Scales<Real>& scale) {
  for (const std::size_t index : cables) {
    const CableOf<TheCase>& cable = the_case.cables[index];
    if (!may_be_slow<TheCase>(cable, state, Real(abs(gap_rate(cable, state))), limits, scale)) {
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
template <class TheCase>
CableSet at_zero(const TheCase& the_case, const StateOf<TheCase>& state,
                 const TouchingOf<TheCase>& touching, CableSet cables) {
  constexpr double drift = 1e3;  // [-] roundings of a gap
  CableSet result;
  for (const std::size_t index : cables) {
    const CableOf<TheCase>& cable = the_case.cables[index];
    if (abs(gap(cable, state)) <= drift * rounding_of_gap(cable, state) &&
        abs(gap_rate(cable, state)) <= touching.rounding(cable)) {
      result.insert(index);
    }
  }
  return result;
}

/// `after` without what rounding has added to the energy of `before`: the end of bounces gains
/// none.
template <class TheCase>
StateOf<TheCase> without_energy_gained(const TheCase& the_case, const StateOf<TheCase>& before,
                                       StateOf<TheCase> after) {
  using Real = RealOf<TheCase>;
  if (is_driven(the_case, before)) {
    return after;
  }
  const Real gained = energy(the_case, after) - energy(the_case, before);
  const Real kinetic = kinetic_energy(bodies_of(the_case), after);
  if (gained > few_roundings * rounding_of_energy(the_case, before) && gained < kinetic) {
    const Real part = sqrt(Real(1 - gained / kinetic));
    after = times_as_fast(after, part);
  }
  return after;
}

/// True where the end of bounces gains energy beyond rounding, or overflows: nothing that moves the
/// ends of cables can have given it.
template <class TheCase>
bool gains_energy(const TheCase& the_case, const StateOf<TheCase>& before,
                  const StateOf<TheCase>& after) {
  using Real = RealOf<TheCase>;
  const Real gained = energy(the_case, after) - energy(the_case, before);
  return is_driven(the_case, before)
             ? !isfinite(gained)
             : !(gained <= rounding_margin * rounding_of_energy(the_case, before));
}

/// True where `state` stretches a cable outside `cables`.
template <class TheCase>
bool overstretches(const TheCase& the_case, const StateOf<TheCase>& state, CableSet cables) {
  for (std::size_t index = 0; index < the_case.cables.size(); ++index) {
    const CableOf<TheCase>& cable = the_case.cables[index];
    if (!cables.contains(index) && !is_elastic(cable) &&
        gap(cable, state) < -rounding_margin * rounding_of_gap(cable, state)) {
      return true;
    }
  }
  return false;
}

/// The cables of `cables` that move: not at exactly zero gap and rate.
template <class TheCase>
CableSet moving(const TheCase& the_case, const StateOf<TheCase>& state,
                const TouchingOf<TheCase>& touching, CableSet cables) {
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

template <class TheCase>
std::optional<BasicCompletion<TheCase>> completion(const TheCase& the_case,
                                                   const StateOf<TheCase>& state,
                                                   const TouchingOf<TheCase>& touching,
                                                   const CompletionLimits& limits) {
  using Real = RealOf<TheCase>;
  const Scales<Real> scale = scales_of(the_case, state, limits.margin);
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
        (limits.speed ? bounces->speed > *limits.speed : !(bounces->error <= limits.error)) ||
        bounces->remaining + bounces->uncertainty > time_to_knot(the_case, state)) {
      return std::nullopt;
    }
    if constexpr (TheCase::has_several_bodies) {
      if (may_engage(the_case, state, Real(bounces->remaining + bounces->uncertainty), scale)) {
        return std::nullopt;
      }
    }
    CableSet near = within_reach(the_case, state, cables, *bounces, scale);
    if (!are_slow(the_case, state, near, limits, scale)) {
      return std::nullopt;
    }
    const StateOf<TheCase> after = projected(the_case, state, cables);
    // redundant: where the others end taut, so do these
    const CableSet carried = at_zero(the_case, after, touching, near);
    near = near - carried;
    if (near.empty()) {
      // cables almost dependent, which the body had to go far to close
      if (gains_energy(the_case, state, after) ||
          overstretches(the_case, after, cables | carried)) {
        return std::nullopt;
      }
      if (cables.size() == 1 && bounces->ends) {
        refine(*bounces, the_case, state, after, *cables.begin());
      }
      return BasicCompletion<TheCase>{
          cables | carried,     bounces->ends,  bounces->remaining,
          bounces->uncertainty, bounces->error, without_energy_gained(the_case, state, after)};
    }
    cables = cables | near;
  }
  return std::nullopt;
}

template std::optional<BasicCompletion<InstanceCase>> completion(const InstanceCase&,
                                                                 const StateOf<InstanceCase>&,
                                                                 const TouchingOf<InstanceCase>&,
                                                                 const CompletionLimits&);

}  // namespace tautline
