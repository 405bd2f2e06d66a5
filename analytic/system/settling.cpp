#include <cmath>
#include <limits>

#include "instantiate.hpp"
#include "system/kernel.hpp"
#include "tautline/detail/projection.hpp"
#include "tautline/detail/tension_extremes.hpp"
#include "tautline/elastic_contacts.hpp"
#include "tautline/solve.hpp"
#include "tautline/system_settling.hpp"

namespace tautline {
namespace {

/// The share of cable `index` in the run.
template <class Real, int D>
BasicCableUse<Real> use_of(const BasicSolution<BasicSystem<Real, D>>& solution, std::size_t index) {
  BasicCableUse<Real> result;
  Real taut(0);
  TensionExtremes<BasicSystem<Real, D>> extremes(solution, index);
  for (const auto& arc : solution.arcs()) {
    if (arc.taut.contains(index)) {
      taut += arc.end - arc.start;
      extremes.look_at(arc);
    }
  }
  if (solution.end_time() > 0) {
    result.taut_share = taut / solution.end_time();
  }
  if (const auto& found = extremes.largest(); found.arc != nullptr) {
    result.tension = {found.tension, Real(found.arc->start + found.dt)};
  }
  for (const auto& event : solution.events()) {
    if (event.kind != EventKind::impact || !event.cables.contains(index)) {
      continue;
    }
    Eigen::Index row = 0;
    for (const std::size_t other : event.cables) {
      row += other < index ? 1 : 0;
    }
    const Real& impulse = event.impulses[row];
    if (impulse > 0 && (!result.impulse || impulse > result.impulse->value * (1 + same_tension))) {
      result.impulse = {impulse, event.time};
    }
  }
  return result;
}

/// The share of elastic cable `index` in a run of this `duration` [s], with these contacts.
template <class Real>
BasicCableUse<Real> elastic_use(const std::vector<BasicElasticContact<Real>>& contacts,
                                std::size_t index, const Real& duration) {
  BasicCableUse<Real> result;
  const auto add = [](auto& most, const Real& value, const Real& time) {
    if (!most || value > most->value * (1 + same_tension)) {
      most = {value, time};
    }
  };
  for (const auto& contact : contacts) {
    if (contact.cable == index) {
      result.taut_share += (contact.exit.value_or(duration) - contact.entry) / duration;
      add(result.tension, contact.peak, contact.peak_time);
      add(result.impulse, contact.impulse, contact.entry);
    }
  }
  return result;
}

/// `system` with all that is given fixed as it is at `state`, at rest there, and with enough drag
/// to creep into an equilibrium; impacts have no rebound.
template <class Real, int D>
BasicSystem<Real, D> calmed(BasicSystem<Real, D> system, const BasicSystemState<Real, D>& state,
                            const Real& rate) {
  const Real now = state.time;
  const auto fix = [&](auto& function) {
    using Function = std::remove_reference_t<decltype(function)>;
    if (!function.empty()) {
      function = Function::constant(function.at(now));
    }
  };
  std::erase_if(system.cables, [&](const auto& cable) { return !cable.acts_at(now); });
  each_function(system, fix);
  for (auto& body : system.bodies) {
    body.drag = 2 * body.mass * rate;
    body.spin_drag = 2 * moments(body.inertia).maxCoeff() * rate;
  }
  for (auto& cable : system.cables) {
    cable.restitution = Real(cable.elasticity ? 1 : 0);  // an elastic one has none
    cable.restitution_table.clear();
    cable.from_time.reset();
    cable.cut_at.reset();
  }
  system.initial = standing_still(state);
  system.initial.time = Real(0);
  return system;
}

/// The energy [J] of the equilibrium on `cables` below `state`: where a lot of drag would stop the
/// motion. None where it ends on other cables, or not near enough.
template <class Real, int D>
std::optional<Real> least_energy(const BasicSystem<Real, D>& system,
                                 const BasicSystemState<Real, D>& state, CableSet cables) {
  const BasicSystemState<Real, D> still = standing_still(state);
  const Real shortest = shortest_length(system, still);
  const Real acceleration = acceleration_scale(system, still);
  if (!(acceleration > 0) || !isfinite(shortest)) {
    return std::nullopt;
  }
  const Real rate = sqrt(Real(acceleration / shortest));
  BasicSystem<Real, D> calm = calmed(system, projected(system, still, cables), rate);
  constexpr double times = 300.0;  // of the scale of time: soft motions are slower
  calm.duration = times / rate;
  if (!problems(in_double(calm)).empty()) {  // such as a spring that is too stiff for so long
    return std::nullopt;
  }
  SolveOptions limited;
  limited.max_events = 100;  // it hardly moves
  limited.max_steps = 500;   // with an equilibrium up to 300; without, it may fall into a ring
  const auto solution = solve(calm, limited);
  const auto end = solution.at(solution.end_time());
  const Real left = kinetic_energy(calm.bodies, end);
  constexpr double enough = 1e-20;  // [-], of the energy that the accelerations give in a length
  Real scale(0);
  for (const auto& body : system.bodies) {
    scale += body.mass * acceleration * shortest;
  }
  const bool whole =
      solution.ending() == Ending::reached_duration || solution.ending() == Ending::rest;
  std::size_t taut = 0;
  for (std::size_t i = 0; i < system.cables.size(); ++i) {
    taut += system.cables[i].acts_at(state.time) && cables.contains(i) ? 1U : 0U;
  }
  if (!whole || left > enough * scale || solution.arcs().back().taut.size() != taut) {
    return std::nullopt;
  }
  return energy(calm, end);
}

/// When the energy above `least` is a hundredth of what it is at `from` [s]; none if it never is.
/// It falls all the time.
template <class Real, int D>
std::optional<Real> when_one_percent(const BasicSystem<Real, D>& system,
                                     const BasicSolution<BasicSystem<Real, D>>& solution,
                                     const Real& from, const Real& least) {
  const auto above = [&](const Real& time) {
    return Real(energy(system, solution.at(time)) - least);
  };
  Real low = from;
  Real high = solution.end_time();
  const Real wanted = above(low) / 100;
  if (!(above(high) < wanted)) {
    return std::nullopt;
  }
  constexpr int enough = 200;  // halves, until nothing is between: fewer in double
  for (int k = 0; k < enough; ++k) {
    const Real middle = (low + high) / 2;
    if (!(low < middle && middle < high)) {
      break;
    }
    (above(middle) < wanted ? high : low) = middle;
  }
  return high;
}

template <class Real, int D>
std::optional<BasicSystemLock<Real>> lock_of(const BasicSystem<Real, D>& system,
                                             const BasicSolution<BasicSystem<Real, D>>& solution) {
  const bool whole =
      solution.ending() == Ending::reached_duration || solution.ending() == Ending::rest;
  const CableSet taut = solution.arcs().back().taut;
  if (!whole || taut.empty()) {
    return std::nullopt;
  }
  BasicSystemLock<Real> lock{Real(0), Real(0), taut, solution.ending() == Ending::rest, {}, {}};
  // the last event at which this set began to be all that is taut
  for (auto event = solution.events().rbegin(); event != solution.events().rend(); ++event) {
    if (event->kind == EventKind::taut || event->kind == EventKind::slack) {
      lock.time = event->time;
      break;
    }
  }
  for (const auto& one : solution.accumulations()) {
    if (one.start == lock.time) {
      lock.time = min(one.time, solution.end_time());
      lock.uncertainty = one.uncertainty;
      break;
    }
  }
  while (!is_constant_from(system, solution.at(lock.time))) {
    lock.time = next_knot(system, solution.at(lock.time));
    lock.uncertainty = Real(0);
    if (!(lock.time < solution.end_time())) {
      return std::nullopt;
    }
  }
  const auto end = solution.at(solution.end_time());
  const bool drags = std::any_of(system.bodies.begin(), system.bodies.end(), [](const auto& body) {
    return body.drag > 0 || body.spin_drag > 0;
  });
  if (lock.certain) {
    lock.residual_energy = Real(0);
  }
  const auto least =
      lock.certain ? std::optional<Real>(energy(system, end)) : least_energy(system, end, taut);
  if (least) {
    lock.residual_energy = max(Real(0), Real(energy(system, end) - *least));
    if (drags) {
      lock.one_percent = when_one_percent(system, solution, lock.time, *least);
    }
  }
  return lock;
}

/// How far two states are apart [-]: in the shortest length, the time in which the accelerations
/// take a body so far, and whole turns aside.
template <class Real, int D>
Real apart(const BasicSystem<Real, D>& system, const BasicSystemState<Real, D>& a,
           const BasicSystemState<Real, D>& b) {
  const Real length = shortest_length(system, a);
  const Real rate = sqrt(Real(acceleration_scale(system, a) / length));
  Real result(0);
  for (std::size_t i = 0; i < a.bodies.size(); ++i) {
    const auto& one = a.bodies[i];
    const auto& other = b.bodies[i];
    result = max(result, Real((one.position - other.position).norm() / length));
    result = max(result, Real((one.velocity - other.velocity).norm() / (length * rate)));
    result = max(result, turn_between(one, other));
    result = max(result, Real((spin_of(one) - spin_of(other)).cwiseAbs().maxCoeff() / rate));
  }
  return result;
}

/// The middle of the longest arc of the last `period` [s]: events there come a rounding earlier or
/// later.
template <class Real, int D>
Real between_events(const BasicSolution<BasicSystem<Real, D>>& solution, const Real& period) {
  const Real& end = solution.end_time();
  Real longest(0);
  Real at = end;
  for (const auto& arc : solution.arcs()) {
    if (arc.start >= end - period && arc.end - arc.start > longest) {
      longest = arc.end - arc.start;
      at = (arc.start + arc.end) / 2;
    }
  }
  return at;
}

/// Every how many periods the motion up to `at` [s] repeats; none: it does not in up to 16.
template <class Real, int D>
std::optional<std::size_t> repeats(const BasicSystem<Real, D>& system,
                                   const BasicSolution<BasicSystem<Real, D>>& solution,
                                   const Real& from, const Real& at, const Real& period) {
  constexpr std::size_t most = 16;
  constexpr int times = 3;
  constexpr double same = 1e-9;
  const auto state = solution.at(at);
  for (std::size_t every = 1; every <= most; ++every) {
    bool alike = at - times * static_cast<double>(every) * period >= from;
    for (int k = 1; alike && k <= times; ++k) {
      const Real before = at - k * static_cast<double>(every) * period;
      alike = apart(system, state, solution.at(before)) < same;
    }
    if (alike) {
      return every;
    }
  }
  return std::nullopt;
}

template <class Real, int D>
std::optional<BasicForcedMotion<Real>> forced(const BasicSystem<Real, D>& system,
                                              const BasicSolution<BasicSystem<Real, D>>& solution) {
  const auto period = common_period(system);
  if (!period) {
    return std::nullopt;
  }
  Real from(0);  // from here on all pieces are constant
  bool periodic = true;
  each_function(system, [&](const auto& function) {
    if (!function.pieces.empty()) {
      periodic = periodic && function.pieces.back().coefficients.size() < 2;
      from = function.pieces.size() > 1 ? max(from, function.pieces.back().from) : from;
    }
  });
  const Real& end = solution.end_time();
  if (!periodic || end - from < *period) {
    return std::nullopt;
  }
  const Real at = between_events(solution, *period);
  BasicForcedMotion<Real> result{*period, Real(0), repeats(system, solution, from, at, *period)};
  // in the last periods, whole repetitions of them
  const double whole = std::max(1.0, std::floor(static_cast<double>(Real((at - from) / *period))));
  const double every = static_cast<double>(result.repeats.value_or(1));
  const double last = std::min(std::max(every, std::floor(whole / 2.0)), whole);
  const double count = result.repeats ? every : last;
  std::size_t impacts = 0;
  for (const auto& event : solution.events()) {
    const bool late = event.time > at - count * *period && event.time <= at;
    impacts += event.kind == EventKind::impact && late ? 1U : 0U;
  }
  result.impacts = static_cast<double>(impacts) / count;
  return result;
}

}  // namespace

template <class Real, int D>
std::optional<Real> common_period(const BasicSystem<Real, D>& system) {
  constexpr int most = 64;
  constexpr double whole = 1e-9;  // [-], of a period: frequencies are typed numbers
  std::vector<Real> frequencies;
  each_function(system, [&](const auto& function) {
    for (const auto& wave : function.waves) {
      if (wave.varies()) {
        frequencies.push_back(wave.frequency);
      }
    }
  });
  if (frequencies.empty()) {
    return std::nullopt;
  }
  const Real slowest = *std::min_element(frequencies.begin(), frequencies.end());
  for (int count = 1; count <= most; ++count) {
    const bool fits =
        std::all_of(frequencies.begin(), frequencies.end(), [&](const Real& frequency) {
          const Real periods = count * frequency / slowest;
          return abs(Real(periods - floor(Real(periods + Real(0.5))))) <= whole * periods;
        });
    if (fits) {
      return count * 2 * acos(Real(-1)) / slowest;
    }
  }
  return std::nullopt;
}

template <class Real, int D>
BasicSystemSettling<Real> settling(const BasicSystem<Real, D>& system,
                                   const BasicSolution<BasicSystem<Real, D>>& solution) {
  BasicSystemSettling<Real> result;
  result.last_impacts = last_impacts(system, solution);
  const auto contacts = elastic_contacts(solution);
  for (std::size_t i = 0; i < system.cables.size(); ++i) {
    result.cables.push_back(system.cables[i].elasticity
                                ? elastic_use(contacts, i, solution.end_time())
                                : use_of(solution, i));
  }
  result.lock = lock_of(system, solution);
  result.forced = forced(system, solution);
  return result;
}

template BasicSystemSettling<Instance> settling(const InstanceCase&,
                                                const BasicSolution<InstanceCase>&);
template std::optional<Instance> common_period(const InstanceCase&);

}  // namespace tautline
