#pragma once

#include <optional>
#include <vector>

#include "system/turning_series.hpp"
#include "tautline/detail/rounding.hpp"
#include "tautline/system_geometry.hpp"

// How elastic cables change between slack, engaged and loose (E4). A switch is a stop of the loop
// without a jump of velocities.

namespace tautline {

/// True where elastic cable `index` is longer than its length.
template <class Real, int D>
[[nodiscard]] bool is_stretched(const BasicSystemState<Real, D>& state, std::size_t index) {
  return state.elastic.stretched().contains(index);
}

/// The damping [N s/m] of an elastic cable: the present one where it is stretched or resists, else
/// the one that it would have if it became stretched.
template <class Real, int D>
[[nodiscard]] Real damping_of(const BasicSystem<Real, D>& system, std::size_t index,
                              const BasicSystemState<Real, D>& state) {
  if ((state.elastic.stretched() | state.elastic.resisting).contains(index)) {
    return state.elastic.damping[index];
  }
  const BasicElasticity<Real>& law = *system.cables[index].elasticity;
  if (!(law.damping_ratio > 0)) {
    return law.damping;
  }
  const Real stiffness = spring_stiffness(law, Real(0), length_at(system.cables[index], state));
  return 2 * law.damping_ratio * sqrt(Real(stiffness / delassus(system, state, index)));
}

/// The size of the tensions [N] that a cable of this `length` [m] has at this `stretch` [m] and its
/// `rate` [m/s], and within a part of a period: its `response` [1/kg] gives the period.
template <class Real>
[[nodiscard]] Real tension_size(const BasicElasticity<Real>& law, const Real& length,
                                const Real& damping, const Real& response, const Real& stretch,
                                const Real& rate) {
  const Real stiffness = abs(spring_stiffness(law, stretch, length));
  return abs(spring_force(law, stretch, length)) +
         (damping + sqrt(Real(stiffness / response))) * abs(rate);
}

/// The force f(x) = constant + slope x + k2 x^2 + ... of a law that is past some corners, with
/// the energy of x: `energy` + constant x + slope x^2 / 2 + k2 x^3 / 3 + ...
template <class Real>
struct ForcePiece {
  Real constant = Real(0);  // [N]
  Real slope = Real(0);     // [N/m], or [N]
  Real energy = Real(0);    // [J], or [N]
};
template <class Real>
[[nodiscard]] ForcePiece<Real> force_piece(const BasicElasticity<Real>& law, std::size_t past) {
  ForcePiece<Real> result{Real(0), past == 0 ? law.stiffness[0] : law.corners[past - 1].stiffness,
                          Real(0)};
  for (std::size_t i = 0; i < past; ++i) {
    const Real& at = law.corners[i].stretch;
    const Real fall = rise_at(law, i) * at;
    result.constant -= fall;
    result.energy += fall * at / 2;
  }
  return result;
}

/// Lets the damper of elastic cable `index` act from now on in `state`, which slack cables have.
template <class Real, int D>
void begin_resisting(const BasicSystem<Real, D>& system, std::size_t index,
                     BasicSystemState<Real, D>& state) {
  const Real damping = damping_of(system, index, state);
  state.elastic.damping.resize(system.cables.size(), Real(0));
  state.elastic.damping[index] = damping;
  state.elastic.resisting.insert(index);
}

/// Lets elastic cable `index` be stretched from now on in `state`.
template <class Real, int D>
void begin_stretch(const BasicSystem<Real, D>& system, std::size_t index,
                   BasicSystemState<Real, D>& state) {
  begin_resisting(system, index, state);
  state.elastic.resisting.erase(index);
  state.elastic.engaged.insert(index);
  const BasicCableOfSystem<Real, D>& cable = system.cables[index];
  if (const BasicElasticity<Real>& law = *cable.elasticity; !law.corners.empty()) {
    state.elastic.past.resize(system.cables.size(), 0);
    const Real x = -gap(cable, state) / base_of(law, length_at(cable, state));
    std::size_t& past = state.elastic.past[index];
    for (past = 0; past < law.corners.size() && x > law.corners[past].stretch;) {
      ++past;
    }
  }
}

/// True where elastic cable `index` lets go while it is still stretched: its damper takes all that
/// its spring pulls with, or the force of its spring f(x) = x (k1 + k2 x + ...) has turned down to
/// zero.
template <class Real, int D>
[[nodiscard]] bool lets_go_stretched(const BasicSystem<Real, D>& system, std::size_t index,
                                     const BasicSystemState<Real, D>& state) {
  const BasicCableOfSystem<Real, D>& cable = system.cables[index];
  const std::vector<Real>& stiffness = cable.elasticity->stiffness;
  const Real x = -gap(cable, state) / base_of(*cable.elasticity, length_at(cable, state));
  Real slope(0);  // of the line to the force
  for (std::size_t i = stiffness.size(); i-- > 0;) {
    slope = slope * x + stiffness[i];
  }
  return state.elastic.damping[index] > 0 || slope < stiffness[0] / 2;
}

/// `state` after these `switches`.
template <class Real, int D>
[[nodiscard]] BasicSystemState<Real, D> switched(const BasicSystem<Real, D>& system,
                                                 BasicSystemState<Real, D> state,
                                                 const ElasticSwitches& switches) {
  auto& [engaged, loose, resisting, damping, past] = state.elastic;
  for (const std::size_t index : switches.passing) {
    ++past[index];
  }
  for (const std::size_t index : switches.returning) {
    --past[index];
  }
  for (const std::size_t index : switches.engaging) {
    if (loose.contains(index)) {
      loose.erase(index);
      engaged.insert(index);
    } else {
      begin_stretch(system, index, state);
    }
  }
  for (const std::size_t index : switches.letting_go) {
    const ElasticCut cut = system.cables[index].elasticity->cut;
    if (cut == ElasticCut::never) {
      resisting.insert(index);
    } else if (cut == ElasticCut::force && engaged.contains(index) &&
               lets_go_stretched(system, index, state)) {
      loose.insert(index);
    } else {
      loose.erase(index);
    }
    engaged.erase(index);
  }
  return state;
}

/// Sorts elastic cable `index` in `state`, `stretched` now or slack, by what it pulls with; one
/// that does not act has no zone.
template <class Real, int D>
void sort_zone(const BasicSystem<Real, D>& system, std::size_t index, bool stretched, bool acts,
               BasicSystemState<Real, D>& state) {
  const ElasticCut cut = system.cables[index].elasticity->cut;
  if (stretched && !is_stretched(state, index)) {
    begin_stretch(system, index, state);
  }
  const bool pulls =
      stretched && acts && (cut != ElasticCut::force || elastic_tension(system, index, state) > 0);
  auto& zones = state.elastic;
  const bool was_stretched = is_stretched(state, index);
  zones.engaged.erase(index);
  zones.loose.erase(index);
  if (!acts) {
    zones.resisting.erase(index);
  } else if (stretched) {
    (pulls ? zones.engaged : zones.loose).insert(index);
  } else if (was_stretched && cut == ElasticCut::never) {
    zones.resisting.insert(index);  // with the damper that it had
  } else if (cut == ElasticCut::never) {
    begin_resisting(system, index, state);
  }
}

/// `state` with the zones that elastic cables have where rates may have jumped, and where they
/// begin or cease to act: at the start, at knots and after impacts.
template <class Real, int D>
[[nodiscard]] BasicSystemState<Real, D> with_zones(const BasicSystem<Real, D>& system,
                                                   BasicSystemState<Real, D> state) {
  for (std::size_t index = 0; index < system.cables.size(); ++index) {
    const auto& cable = system.cables[index];
    if (cable.elasticity) {
      const bool begins = cable.from_time.value_or(Real(0)) == state.time && gap(cable, state) < 0;
      sort_zone(system, index, is_stretched(state, index) || begins, cable.acts_at(state.time),
                state);
    }
  }
  return state;
}

/// Elastic cables with something that is exactly zero at an instant: that is no switch.
struct ElasticZeros {
  CableSet pull;      // the gap of a slack one, what ends the pull of a stretched one
  CableSet passed;    // the stretch beyond the corner that it has passed last
  CableSet returned;  // the stretch up to its next corner
};

/// All that is exactly zero after `switches`, with all that was `before` where no time has passed:
/// what is searched for but the tension of a damped cable that engages from slack and may not push.
template <class Real, int D>
[[nodiscard]] ElasticZeros zeros_after(const BasicSystem<Real, D>& system,
                                       const ElasticZeros& before, const ElasticSwitches& switches,
                                       const BasicSystemState<Real, D>& state,
                                       const BasicSystemState<Real, D>& after) {
  ElasticZeros result = before;
  result.pull = result.pull | switches.letting_go;
  for (const std::size_t index : switches.engaging) {
    if (is_stretched(state, index) || after.elastic.damping[index] == 0 ||
        system.cables[index].elasticity->cut != ElasticCut::force) {
      result.pull.insert(index);
    }
  }
  result.passed = (result.passed - switches.returning) | switches.passing;
  result.returned = (result.returned - switches.passing) | switches.returning;
  return result;
}

/// The switches of elastic cables at an instant.
template <class Real>
struct FirstSwitch {
  Real dt;  // [s]; NaN: unknown, numbers overflowed
  ElasticSwitches switches;
};

/// A polynomial of time that falls to zero where an elastic cable switches.
template <class Real>
struct Searched {
  std::size_t index;                   // of the cable
  Polynomial<Real> f;                  // without the `zeros` that its leading coefficients are
  std::size_t zeros;                   // 0 or 1
  bool of_tension;                     // else of a length
  CableSet ElasticSwitches::*becomes;  // the set of those that switch so
};

/// Calls `look` with all that is above zero as long as cable `index` stays in its zone and between
/// its corners.
template <class Real, int D, class Motion, class Look>
void each_searched(const BasicSystem<Real, D>& system, const BasicSystemState<Real, D>& state,
                   const Motion& motion, const ElasticZeros& zeros, std::size_t index,
                   const Look& look) {
  const auto see = [&](std::span<const Real> f, bool is_zero, bool of_tension,
                       CableSet ElasticSwitches::*becomes) {
    const std::size_t leading = is_zero ? 1 : 0;
    look(Searched<Real>{index, Polynomial<Real>(f, leading), leading, of_tension, becomes});
  };
  const auto turned = [](std::span<const Real> f) {
    return series::polynomial<Real>(f.size(), [&](std::size_t k) { return Real(-f[k]); });
  };
  const bool at_zero = zeros.pull.contains(index);
  if (state.elastic.engaged.contains(index) &&
      system.cables[index].elasticity->cut != ElasticCut::force) {
    see(turned(motion.gap(index)), at_zero, false, &ElasticSwitches::letting_go);
  } else if (state.elastic.engaged.contains(index)) {
    see(motion.tension(index), at_zero, true, &ElasticSwitches::letting_go);
  } else if (state.elastic.loose.contains(index)) {
    see(turned(motion.tension(index)), at_zero, true, &ElasticSwitches::engaging);
    see(turned(motion.gap(index)), false, false, &ElasticSwitches::letting_go);
  } else {
    see(motion.gap(index), at_zero, false, &ElasticSwitches::engaging);
    return;
  }
  const std::vector<BasicCorner<Real>>& corners = system.cables[index].elasticity->corners;
  const std::size_t past = state.elastic.corners_past(index);
  if (past < corners.size()) {
    see(turned(motion.beyond(index, corners[past].stretch)), zeros.returned.contains(index), false,
        &ElasticSwitches::passing);
  }
  if (past > 0) {
    see(motion.beyond(index, corners[past - 1].stretch), zeros.passed.contains(index), false,
        &ElasticSwitches::returning);
  }
}

/// True where `one` has fallen to zero from clearly above it at `dt` [s], as far as the stretch of
/// its cable can tell.
template <class Real, int D>
[[nodiscard]] bool is_zero_at(const BasicSystem<Real, D>& system,
                              const BasicSystemState<Real, D>& state, const Searched<Real>& one,
                              const Real& dt) {
  const BasicCableOfSystem<Real, D>& cable = system.cables[one.index];
  const Real length = length_at(cable, state);
  Real rounding = few_roundings * epsilon<Real>() * length;
  if (one.of_tension) {
    rounding *= spring_stiffness(*cable.elasticity, Real(-gap(cable, state)), length);
  }
  const auto now = one.f.at(dt);
  const Real factor = one.zeros == 0 ? Real(1) : dt;
  return now.rate < 0 && now.value * factor <= rounding &&
         one.f.at_start().value * factor > 2 * rounding;
}

/// The first switch of elastic cables along `motion`, which starts at `state`, before `until` [s]
/// (E4), with all that are at that instant as far as numbers can tell.
template <class Real, int D, class Motion>
[[nodiscard]] std::optional<FirstSwitch<Real>> first_switch(const BasicSystem<Real, D>& system,
                                                            const BasicSystemState<Real, D>& state,
                                                            const Motion& motion,
                                                            const ElasticZeros& zeros,
                                                            const Real& until) {
  std::optional<FirstSwitch<Real>> result;
  const auto each = [&](const auto& look) {
    for (std::size_t index = 0; index < system.cables.size(); ++index) {
      if (system.cables[index].elasticity) {
        each_searched(system, state, motion, zeros, index, look);
      }
    }
  };
  each([&](const Searched<Real>& one) {
    if (result && isnan(result->dt)) {
      return;
    }
    const Real& horizon = result ? result->dt : until;
    const auto search = first_root_if_any(one.f, horizon);
    if (search.root && !(*search.root >= horizon)) {
      result = {*search.root, {}};
      result->switches.*one.becomes = CableSet::of(one.index);
    }
  });
  if (result && result->dt > 0) {
    each([&](const Searched<Real>& one) {
      ElasticSwitches& found = result->switches;
      if (!found.all().contains(one.index) && is_zero_at(system, state, one, result->dt)) {
        (found.*one.becomes).insert(one.index);
      }
    });
  }
  return result;
}

}  // namespace tautline
