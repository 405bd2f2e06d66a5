#pragma once

#include <algorithm>
#include <numeric>
#include <optional>
#include <string>
#include <utility>
#include <vector>

#include "local_origin.hpp"
#include "single_impact.hpp"
#include "system/elastic.hpp"
#include "system/energetic.hpp"
#include "system/rows.hpp"
#include "system/series.hpp"
#include "system/sizes.hpp"
#include "tautline/detail/hold.hpp"
#include "tautline/detail/limits.hpp"
#include "tautline/impact.hpp"
#include "tautline/solution.hpp"
#include "tautline/system_geometry.hpp"

// The functions by which the loop asks a system (analytic/README.md, "Kinds of cases").

namespace tautline {

// ---- states

/// `state` moving `part` times as fast [-].
template <class Real, int D>
[[nodiscard]] BasicSystemState<Real, D> times_as_fast(BasicSystemState<Real, D> state,
                                                      const std::type_identity_t<Real>& part) {
  for (auto& body : state.bodies) {
    body = times_as_fast(body, part);
  }
  return state;
}

/// `state` with `part` [-] of the jump from `before` to `after` added to its velocities.
template <class Real, int D>
[[nodiscard]] BasicSystemState<Real, D> with_jump(BasicSystemState<Real, D> state,
                                                  const BasicSystemState<Real, D>& before,
                                                  const BasicSystemState<Real, D>& after,
                                                  const std::type_identity_t<Real>& part) {
  for (std::size_t i = 0; i < state.bodies.size(); ++i) {
    state.bodies[i] = with_jump(state.bodies[i], before.bodies[i], after.bodies[i], part);
  }
  return state;
}

/// The state with these poses and their rates, `dt` [s] after `like`.
template <class Real, int D>
[[nodiscard]] BasicSystemState<Real, D> state_of(
    const BasicSystemState<Real, D>& like,
    const Eigen::Matrix<Real, 1, Eigen::Dynamic, Eigen::RowMajor, 1,
                        BasicSystem<Real, D>::most_pose_numbers>& pose,
    const Eigen::Matrix<Real, 1, Eigen::Dynamic, Eigen::RowMajor, 1,
                        BasicSystem<Real, D>::most_pose_numbers>& rate,
    const Real& dt) {
  constexpr int numbers = Turning<Real, D>::pose_numbers;
  BasicSystemState<Real, D> result = like;
  result.time += dt;
  Eigen::Index column = 0;
  for (auto& body : result.bodies) {
    body = body_of(body, pose.template segment<numbers>(column),
                   rate.template segment<numbers>(column));
    column += numbers;
  }
  return result;
}

/// Taylor coefficients of the poses of bodies that stay where they are, but for their spins; none
/// where turns at a constant spin are no polynomials (see `fly`).
template <class Real, int D>
[[nodiscard]] PosesOf<BasicSystem<Real, D>> resting_poses(const BasicSystemState<Real, D>& state) {
  constexpr Eigen::Index numbers = Turning<Real, D>::pose_numbers;
  PosesOf<BasicSystem<Real, D>> result(2, static_cast<Eigen::Index>(state.bodies.size()) * numbers);
  result.setZero();
  Eigen::Index column = 0;
  for (const auto& body : state.bodies) {
    if (!write_resting(body, result.template middleCols<numbers>(column))) {
      return {};
    }
    column += numbers;
  }
  return result;
}

/// Nothing: no motion of a system is known to repeat.
template <class Real, int D>
void add_turns(BasicSystemState<Real, D>& /*start*/, PosesOf<BasicSystem<Real, D>>& /*poses*/,
               const std::type_identity_t<Real>& /*turns*/) {}

/// True while the state and the squares of its numbers fit a Real.
template <class Real, int D>
[[nodiscard]] bool fits(const BasicSystem<Real, D>& system,
                        const BasicSystemState<Real, D>& state) {
  for (const auto& body : state.bodies) {
    if (!numbers_fit(body)) {
      return false;
    }
  }
  return isfinite(energy(system, state));
}

/// An arc without a series lasts for an instant, or is a rest: its state, where bodies turn on.
template <class Real, int D>
[[nodiscard]] BasicSystemState<Real, D> fly(BasicSystemState<Real, D> state,
                                            const BasicFunction<Real, D>& /*gravity*/,
                                            const std::type_identity_t<Real>& dt) {
  state.time += dt;
  for (auto& body : state.bodies) {
    body = turned(body, Real(dt) * spin_of(body));
  }
  return state;
}

// ---- cables

/// True where both cables are inextensible and their gaps are equal at all poses and times.
template <class Real, int D>
[[nodiscard]] bool side_by_side(const BasicCableOfSystem<Real, D>& a,
                                const BasicCableOfSystem<Real, D>& b) {
  return !a.elasticity && !b.elasticity && a.from == b.from && a.through == b.through &&
         a.to == b.to && a.length == b.length && a.from_time == b.from_time && a.cut_at == b.cut_at;
}

/// One cable closes: Newton's law in closed form (Eq. 14).
template <class Real, int D>
struct SingleSystemImpact {
  Real rate;     // [m/s], of the gap, before
  Real kept;     // [-], the restitution at that rate
  Real impulse;  // [N s], 0 where the cable opens
  BasicSystemState<Real, D> after;
};
template <class Real, int D>
[[nodiscard]] SingleSystemImpact<Real, D> single_impact(
    const std::vector<BasicBodyOfSystem<Real, D>>& bodies, const BasicCableOfSystem<Real, D>& cable,
    const BasicSystemState<Real, D>& before) {
  using Row = RowOf<BasicSystem<Real, D>>;
  const Row row = gap_gradient(cable, before);
  const Row response = row.cwiseProduct(inverse_mass(bodies));
  const Real rate = gap_rate(cable, before);
  const Real kept = restitution(cable, rate);
  SingleSystemImpact<Real, D> impact{rate, kept, -(1 + kept) * rate / row.dot(response), before};
  if (!(impact.impulse > 0)) {  // it opens
    impact.impulse = isfinite(impact.impulse) ? Real(0) : impact.impulse;
  }
  impact.after = with_gain(before, Row(impact.impulse * response));
  return impact;
}

/// The bodies that the ends of `cable` are on.
template <class Real, int D>
[[nodiscard]] std::vector<std::size_t> bodies_on(const BasicCableOfSystem<Real, D>& cable) {
  std::vector<std::size_t> result;
  for (std::size_t i = 0; i <= cable.segments(); ++i) {
    if (cable.end(i).body) {
      result.push_back(*cable.end(i).body);
    }
  }
  return result;
}

/// For each body the first one that `cables` join it to, itself or another.
template <class Real, int D>
[[nodiscard]] std::vector<std::size_t> joined(const BasicSystem<Real, D>& system, CableSet cables) {
  std::vector<std::size_t> first(system.bodies.size());
  std::iota(first.begin(), first.end(), 0);
  for (std::size_t round = 0; round < first.size(); ++round) {
    for (const std::size_t index : cables) {
      const std::vector<std::size_t> on = bodies_on(system.cables[index]);
      std::size_t least = first.size();
      for (const std::size_t body : on) {
        least = std::min(least, first[body]);
      }
      for (const std::size_t body : on) {
        first[body] = least;
      }
    }
  }
  return first;
}

/// The parts of `cables` that share no bodies.
template <class Real, int D>
[[nodiscard]] std::vector<CableSet> clusters(const BasicSystem<Real, D>& system, CableSet cables) {
  const std::vector<std::size_t> first = joined(system, cables);
  std::vector<CableSet> of_first(first.size());
  for (const std::size_t index : cables) {
    of_first[first[bodies_on(system.cables[index]).front()]].insert(index);
  }
  std::erase(of_first, CableSet{});
  return of_first;
}

/// The reason why `system` cannot be solved by `law`, if there is one.
template <class Real, int D>
[[nodiscard]] std::optional<std::string> refusal(const BasicSystem<Real, D>& system,
                                                 ImpactLaw law) {
  const auto count =
      static_cast<std::size_t>(std::count_if(system.cables.begin(), system.cables.end(),
                                             [](const auto& cable) { return !cable.elasticity; }));
  if (law != ImpactLaw::energetic || count <= most_energetic) {
    return std::nullopt;
  }
  return "impact law energetic takes up to " + std::to_string(most_energetic) +
         " cables between bodies that they join; here are " + std::to_string(count) +
         ": choose simultaneous, poisson or sequential";
}

// ---- time

/// The work of what moves ends and lengths at an instant [J]: of each impulse on `cables`, by the
/// rate that bodies at rest would leave.
template <class Real, int D>
[[nodiscard]] Real work_of_impulses(const BasicSystem<Real, D>& system,
                                    const BasicSystemState<Real, D>& before, CableSet cables,
                                    const BasicCableVector<Real>& impulses) {
  const BasicSystemState<Real, D> still = standing_still(before);
  Real result(0);
  Eigen::Index row = 0;
  for (const std::size_t index : cables) {
    result -= impulses[row++] * gap_rate(system.cables[index], still);
  }
  return result;
}

/// The next instant [s] at which something given over time is not smooth; infinite: never.
template <class Real, int D>
[[nodiscard]] Real next_knot(const BasicSystem<Real, D>& system,
                             const BasicSystemState<Real, D>& state) {
  const Real& now = state.time;
  Real result = infinity<Real>();
  each_function(system,
                [&](const auto& function) { result = min(result, function.next_knot(now)); });
  for (const auto& cable : system.cables) {
    for (const auto& change : {cable.from_time, cable.cut_at}) {
      result = change && *change > now ? min(result, *change) : result;
    }
  }
  return result;
}

/// How long after `state` that is [s].
template <class Real, int D>
[[nodiscard]] Real time_to_knot(const BasicSystem<Real, D>& system,
                                const BasicSystemState<Real, D>& state) {
  return next_knot(system, state) - state.time;
}

/// True where nothing given over time changes from `state` on.
template <class Real, int D>
[[nodiscard]] bool is_constant_from(const BasicSystem<Real, D>& system,
                                    const BasicSystemState<Real, D>& state) {
  bool result = !isfinite(next_knot(system, state));
  each_function(system, [&](const auto& function) {
    result = result && function.is_constant_from(state.time);
  });
  return result;
}

/// The cables of `touching` that act from this knot on, and those at zero gap that are hooked up at
/// it.
template <class Real, int D>
[[nodiscard]] CableSet touching_at_knot(const BasicSystem<Real, D>& system,
                                        const BasicSystemState<Real, D>& state, CableSet touching) {
  for (std::size_t index = 0; index < system.cables.size(); ++index) {
    const auto& cable = system.cables[index];
    if (!cable.acts_at(state.time)) {
      touching.erase(index);
    } else if (cable.from_time == state.time && starts_at_zero(cable, state)) {
      touching.insert(index);
    }
  }
  return touching;
}

/// The ending at a knot where a cable is hooked up whose ends are already too far apart.
template <class Real, int D>
[[nodiscard]] std::optional<Ending> ending_at_knot(const BasicSystem<Real, D>& system,
                                                   const BasicSystemState<Real, D>& state) {
  for (const auto& cable : system.cables) {
    if (cable.from_time == state.time && starts_at_zero(cable, state) &&
        gap(cable, state) < -max(Real(gap_rounding * cable.length.at(state.time)[0]),
                                 Real(few_roundings * rounding_of_gap(cable, state)))) {
      return Ending::singular;
    }
  }
  return std::nullopt;
}

/// `state` at `time` [s].
template <class Real, int D>
[[nodiscard]] BasicSystemState<Real, D> at_time(BasicSystemState<Real, D> state,
                                                const std::type_identity_t<Real>& time) {
  state.time = time;
  return state;
}

/// Nothing ends the motion of a system but its duration.
template <class Real, int D, class Along>
[[nodiscard]] std::optional<ReachedLimit<Real>> reached_limit(const BasicSystem<Real, D>&,
                                                              const Along&, const Real&) {
  return std::nullopt;
}

// ---- rest

/// True where the spin of a body may go on for ever, and no cable notices: none has an arm across
/// it.
template <class Real, int D>
[[nodiscard]] bool spins_unnoticed(const BasicSystem<Real, D>& system,
                                   const BasicSystemState<Real, D>& state, std::size_t body) {
  bool result = gyroscopic(system.bodies[body].inertia, state.bodies[body]).isZero(0);
  for (const auto& cable : system.cables) {
    for (std::size_t i = 0; i <= cable.segments(); ++i) {
      const auto& end = cable.end(i);
      result = result && (end.body != body || is_along(state.bodies[body], end.at));
    }
  }
  return result;
}

/// True where all that turns are bodies whose spins no cable notices.
template <class Real, int D>
[[nodiscard]] bool turns_freely(const BasicSystem<Real, D>& system,
                                const BasicSystemState<Real, D>& state, CableSet /*taut*/) {
  for (std::size_t i = 0; i < system.bodies.size(); ++i) {
    if (!spins_unnoticed(system, state, i)) {
      return false;
    }
  }
  return true;
}

/// The bodies of `state` at rest; spins that no cable notices go on.
template <class Real, int D>
[[nodiscard]] BasicSystemState<Real, D> resting(const BasicSystem<Real, D>& system,
                                                const BasicSystemState<Real, D>& state,
                                                CableSet /*taut*/) {
  BasicSystemState<Real, D> still = standing_still(state);
  for (std::size_t i = 0; i < system.bodies.size(); ++i) {
    if (spins_unnoticed(system, state, i)) {
      still.bodies[i].spin = state.bodies[i].spin;
    }
  }
  return still;
}

/// The ending of a motion without speed, by `held`; none where it will move, or something given
/// will.
template <class Real, int D>
[[nodiscard]] std::optional<Ending> equilibrium(const BasicSystem<Real, D>& system,
                                                const BasicSystemState<Real, D>& state,
                                                const BasicHold<BasicSystem<Real, D>>& held);

// ---- seen from near by (local_origin.hpp)

/// An end in the world that is many lengths away from the origin, else the origin.
template <class Real, int D>
[[nodiscard]] BasicVector<Real, D> local_origin(const BasicSystem<Real, D>& system) {
  constexpr double far = 16.0;  // [-] lengths: four bits of a gap
  for (const auto& cable : system.cables) {
    for (std::size_t i = 0; i <= cable.segments(); ++i) {
      if (const auto& end = cable.end(i); !end.body) {
        return end.at.norm() > far * cable.length.at(Real(0))[0]
                   ? end.at
                   : BasicVector<Real, D>(BasicVector<Real, D>::Zero());
      }
    }
  }
  return BasicVector<Real, D>::Zero();
}

/// `state` with the world's origin at `origin`.
template <class Real, int D>
[[nodiscard]] BasicSystemState<Real, D> seen_from(const BasicVector<Real, D>& origin,
                                                  BasicSystemState<Real, D> state) {
  for (auto& body : state.bodies) {
    body.position -= origin;
  }
  return state;
}

/// `system` with the world's origin at `origin`.
template <class Real, int D>
[[nodiscard]] BasicSystem<Real, D> seen_from(const BasicVector<Real, D>& origin,
                                             BasicSystem<Real, D> system) {
  const auto move = [&](BasicEnd<Real, D>& end) {
    end.at -= end.body ? BasicVector<Real, D>(BasicVector<Real, D>::Zero()) : origin;
  };
  for (auto& cable : system.cables) {
    move(cable.from);
    move(cable.to);
    for (auto& ring : cable.through) {
      move(ring);
    }
  }
  system.initial = seen_from(origin, std::move(system.initial));
  return system;
}

/// Its solution keeps all of a system.
template <class Real, int D>
[[nodiscard]] BasicSystem<Real, D> system_of(
    const BasicSystem<Real, D>& system, std::vector<BasicCableOfSystem<Real, D>> /*room*/ = {}) {
  return system;
}

/// `solution` of `system` with the world's origin at `origin`.
template <class Real, int D>
[[nodiscard]] BasicSolution<BasicSystem<Real, D>> seen_from(
    const BasicVector<Real, D>& origin, const BasicSolution<BasicSystem<Real, D>>& solution,
    const BasicSystem<Real, D>& system) {
  auto arcs = solution.arcs();
  for (auto& arc : arcs) {
    arc.initial = seen_from(origin, std::move(arc.initial));
    for (Eigen::Index column = 0; arc.series.rows() > 0 && column < arc.series.cols();
         column += Turning<Real, D>::pose_numbers) {
      arc.series.row(0).template segment<D>(column) -= origin.transpose();
    }
  }
  auto events = solution.events();
  for (auto& event : events) {
    event.before = seen_from(origin, std::move(event.before));
    event.after = seen_from(origin, std::move(event.after));
  }
  return {system,
          std::move(arcs),
          std::move(events),
          solution.ending(),
          solution.accumulations(),
          solution.swing(),
          solution.repetition()};
}

}  // namespace tautline
