#pragma once

#include <optional>
#include <vector>

#include "tautline/detail/series.hpp"
#include "tautline/system_geometry.hpp"

// How elastic cables change between slack, engaged and loose (E4). A switch is a stop of the loop
// without a jump of velocities.

namespace tautline {

/// True where elastic cable `index` is longer than its length.
template <class Real, int D>
[[nodiscard]] bool is_stretched(const BasicSystemState<Real, D>& state, std::size_t index) {
  return state.elastic.stretched().contains(index);
}

/// The damping [N s/m] of an elastic cable: the present one where it is stretched, else the one
/// that it would have if it became so.
template <class Real, int D>
[[nodiscard]] Real damping_of(const BasicSystem<Real, D>& system, std::size_t index,
                              const BasicSystemState<Real, D>& state) {
  if (is_stretched(state, index)) {
    return state.elastic.damping[index];
  }
  const BasicElasticity<Real>& law = *system.cables[index].elasticity;
  return law.damping_ratio > 0 ? Real(2 * law.damping_ratio *
                                      sqrt(Real(law.stiffness[0] / delassus(system, state, index))))
                               : law.damping;
}

/// The size of the tensions [N] that a cable has at this `stretch` [m] and its `rate` [m/s], and
/// within a part of a period: its `response` [1/kg] gives the period.
template <class Real>
[[nodiscard]] Real tension_size(const BasicElasticity<Real>& law, const Real& damping,
                                const Real& response, const Real& stretch, const Real& rate) {
  const Real stiffness = abs(spring_stiffness(law, stretch));
  return abs(spring_force(law, stretch)) + (damping + sqrt(Real(stiffness / response))) * abs(rate);
}

/// Lets elastic cable `index` be stretched from now on in `state`.
template <class Real, int D>
void begin_stretch(const BasicSystem<Real, D>& system, std::size_t index,
                   BasicSystemState<Real, D>& state) {
  const Real damping = damping_of(system, index, state);
  state.elastic.damping.resize(system.cables.size(), Real(0));
  state.elastic.damping[index] = damping;
  state.elastic.engaged.insert(index);
}

/// `state` after these `switches`.
template <class Real, int D>
[[nodiscard]] BasicSystemState<Real, D> switched(const BasicSystem<Real, D>& system,
                                                 BasicSystemState<Real, D> state,
                                                 const ElasticSwitches& switches) {
  auto& [engaged, loose, damping] = state.elastic;
  for (const std::size_t index : switches.engaging) {
    if (loose.contains(index)) {
      loose.erase(index);
      engaged.insert(index);
    } else {
      begin_stretch(system, index, state);
    }
  }
  for (const std::size_t index : switches.letting_go) {
    if (engaged.contains(index) && damping[index] > 0) {
      loose.insert(index);
    } else {
      loose.erase(index);
    }
    engaged.erase(index);
  }
  return state;
}

/// Sorts elastic cable `index` in `state` by the sign of its tension, if it is `stretched` now;
/// else it is slack.
template <class Real, int D>
void sort_zone(const BasicSystem<Real, D>& system, std::size_t index, bool stretched,
               BasicSystemState<Real, D>& state) {
  if (stretched && !is_stretched(state, index)) {
    begin_stretch(system, index, state);
  }
  const bool pulls = stretched && elastic_tension(system, index, state) > 0;
  state.elastic.engaged.erase(index);
  state.elastic.loose.erase(index);
  if (stretched) {
    (pulls ? state.elastic.engaged : state.elastic.loose).insert(index);
  }
}

/// `state` with the zones that elastic cables have where rates may have jumped, and where they
/// begin or cease to act: at the start, at knots and after impacts.
template <class Real, int D>
[[nodiscard]] BasicSystemState<Real, D> with_zones(const BasicSystem<Real, D>& system,
                                                   BasicSystemState<Real, D> state) {
  for (std::size_t index = 0; index < system.cables.size(); ++index) {
    const auto& cable = system.cables[index];
    if (cable.elasticity &&
        (is_stretched(state, index) ||
         (cable.from_time.value_or(Real(0)) == state.time && gap(cable, state) < 0))) {
      sort_zone(system, index, cable.acts_at(state.time), state);
    }
  }
  return state;
}

/// The switches of elastic cables at an instant.
template <class Real>
struct FirstSwitch {
  Real dt;  // [s]; NaN: unknown, numbers overflowed
  ElasticSwitches switches;
};

/// The first switch of an elastic cable along `motion`, which starts at `state`, before `until` [s]
/// (E4). The zero that the cables `at_zero` start with is known, and no switch.
template <class Real, int D, class Motion>
[[nodiscard]] std::optional<FirstSwitch<Real>> first_switch(const BasicSystem<Real, D>& system,
                                                            const BasicSystemState<Real, D>& state,
                                                            const Motion& motion, CableSet at_zero,
                                                            const Real& until) {
  std::optional<FirstSwitch<Real>> result;
  std::vector<Real> turned;
  const auto look = [&](std::size_t index, std::span<const Real> f, bool is_turned,
                        std::size_t zeros, bool engages) {
    if (is_turned) {
      turned.assign(f.begin(), f.end());
      for (Real& coefficient : turned) {
        coefficient = -coefficient;
      }
    }
    const Real& horizon = result ? result->dt : until;
    const auto search = first_root_if_any(
        Polynomial<Real>(is_turned ? std::span<const Real>(turned) : f, zeros), horizon);
    if (search.root && !(*search.root >= horizon)) {
      const CableSet one = CableSet::of(index);
      result = {*search.root, engages ? ElasticSwitches{one, {}} : ElasticSwitches{{}, one}};
    }
  };
  for (std::size_t index = 0; index < system.cables.size(); ++index) {
    if (!system.cables[index].elasticity) {
      continue;
    }
    const std::size_t zeros = at_zero.contains(index) ? 1 : 0;
    if (state.elastic.engaged.contains(index)) {
      look(index, motion.tension(index), false, zeros, false);
    } else if (state.elastic.loose.contains(index)) {
      look(index, motion.tension(index), true, zeros, true);
      look(index, motion.gap(index), true, 0, false);
    } else {
      look(index, motion.gap(index), false, zeros, true);
    }
    if (result && isnan(result->dt)) {
      return result;
    }
  }
  return result;
}

/// Those of `switches` whose gap or tension is exactly zero afterwards: all but that of a cable
/// that engages from slack and is damped.
template <class Real, int D>
[[nodiscard]] CableSet at_zero_after(const ElasticSwitches& switches,
                                     const BasicSystemState<Real, D>& before,
                                     const BasicSystemState<Real, D>& after) {
  CableSet result = switches.letting_go;
  for (const std::size_t index : switches.engaging) {
    if (is_stretched(before, index) || after.elastic.damping[index] == 0) {
      result.insert(index);
    }
  }
  return result;
}

}  // namespace tautline
