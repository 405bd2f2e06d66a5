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

/// Keeps `value` where it is the largest so far, the first of those that are equal to rounding.
template <class Real>
void keep_largest(std::optional<BasicPeak<Real>>& most, const Real& value, const Real& time) {
  if (!most || value > most->value * (1 + same_tension)) {
    most = {value, time};
  }
}

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
    if (event.impulses[row] > 0) {
      keep_largest(result.impulse, event.impulses[row], event.time);
    }
  }
  return result;
}

/// The share of elastic cable `index` in a run of this `duration` [s], with these contacts.
template <class Real>
BasicCableUse<Real> elastic_use(const std::vector<BasicElasticContact<Real>>& contacts,
                                std::size_t index, const Real& duration) {
  BasicCableUse<Real> result;
  for (const auto& contact : contacts) {
    if (contact.cable == index) {
      result.taut_share += (contact.exit.value_or(duration) - contact.entry) / duration;
      keep_largest(result.tension, contact.peak, contact.peak_time);
      if (contact.exit) {  // of one that goes on it grows with the duration
        keep_largest(result.impulse, contact.impulse, contact.entry);
      }
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
  system.initial.elastic = {};  // found again
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
  const CableSet held = cables - state.elastic.stretched();
  BasicSystem<Real, D> calm =
      calmed(system, held.empty() ? still : projected(system, still, held), rate);
  constexpr double times = 300.0;  // of the scale of time: soft motions are slower
  calm.duration = times / rate;
  if (!problems(in_double(calm)).empty()) {  // too stiff a spring for that long
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
  CableSet wanted;  // `cables`, in the numbers of those that act
  std::size_t number = 0;
  for (std::size_t i = 0; i < system.cables.size(); ++i) {
    if (system.cables[i].acts_at(state.time)) {
      if (cables.contains(i)) {
        wanted.insert(number);
      }
      ++number;
    }
  }
  const auto& last = solution.arcs().back();
  if (!whole || left > enough * scale ||
      (last.taut | (last.initial.elastic.engaged & wanted)) != wanted) {
    return std::nullopt;
  }
  return energy(calm, end);
}

/// Energies of the only body of a system, on an engaged elastic cable.
template <class Real>
struct HangingEnergy {
  Real equilibrium;  // [J], at rest on this cable alone
  Real letting_go;   // [J], at least, where the cable lets go (E11)
};
/// None where the cable is bent or moved, or its force is not linear.
template <class Real, int D>
std::optional<HangingEnergy<Real>> hanging_energy(const BasicSystem<Real, D>& system,
                                                  const BasicSystemState<Real, D>& state,
                                                  std::size_t index) {
  const auto& cable = system.cables[index];
  const auto& law = *cable.elasticity;
  const BasicEnd<Real, D>& anchor = cable.from.body ? cable.to : cable.from;
  const BasicEnd<Real, D>& attachment = cable.from.body ? cable.from : cable.to;
  const auto& body = system.bodies[0];
  if (system.bodies.size() != 1 || !cable.through.empty() || law.stiffness.size() != 1 ||
      !law.corners.empty() || !body.moment.empty()) {
    return std::nullopt;
  }
  const BasicVector<Real, D> load =
      body.mass * system.gravity.at(state.time) + body.force.at(state.time);
  const BasicVector<Real, D> place = anchor.at + anchor.motion.at(state.time);
  const Real arm = attachment.at.norm();
  const Real weight = load.norm();
  const Real length = length_at(cable, state);
  const Real stiffness = spring_stiffness(law, Real(0), length);
  const Real damping = state.elastic.damping[index];
  // of no pose is it larger
  const Real response =
      1 / body.mass + (has_inertia(body.inertia) ? Real(arm * arm / least_moment(body)) : Real(0));
  const Real unstretched = -load.dot(place) - weight * (length + arm);
  const Real stretched = weight * weight / (2 * stiffness);
  const Real square = damping * damping * response / stiffness;  // 4 ratio^2
  const Real share = law.cut == ElasticCut::force ? Real(square / (1 + square)) : Real(0);
  return HangingEnergy<Real>{unstretched - stretched, unstretched - share * stretched};
}

/// True where cable `index` does not let go any more.
template <class Real, int D>
bool is_certain(const BasicSystem<Real, D>& system, const BasicSystemState<Real, D>& end,
                std::size_t index) {
  const auto hanging = hanging_energy(system, end, index);
  const Real rounding = few_roundings * rounding_of_energy(system, end);
  return hanging && energy(system, end) + rounding < hanging->letting_go;
}

/// How the stretch of an engaged elastic cable rings.
template <class Real>
struct Ringing {
  Real frequency;  // [rad/s], without damping
  Real decay;      // [1/s], of the slower part; 0 without damping
};
template <class Real, int D>
Ringing<Real> ringing(const BasicSystem<Real, D>& system, const BasicSystemState<Real, D>& state,
                      std::size_t index) {
  const auto& cable = system.cables[index];
  const Real response = delassus(system, state, index);
  const Real square = response * spring_stiffness(*cable.elasticity, Real(-gap(cable, state)),
                                                  length_at(cable, state));
  const Real half = state.elastic.damping[index] * response / 2;
  const Real over = half * half - square;
  return {sqrt(square), over > 0 ? Real(square / (half + sqrt(over))) : half};
}

/// The elastic cables that stay engaged after the end: as is certain, or as it seems, since they
/// are damped and have been engaged for a whole period.
template <class Real, int D>
CableSet staying_engaged(const BasicSystem<Real, D>& system,
                         const BasicSolution<BasicSystem<Real, D>>& solution,
                         const BasicSystemState<Real, D>& end) {
  if (solution.ending() == Ending::rest) {
    return end.elastic.engaged;
  }
  CableSet result;
  for (const std::size_t index : end.elastic.engaged) {
    Real since(0);
    for (const auto& event : solution.events()) {
      if (event.kind == EventKind::entry && event.cables.contains(index)) {
        since = event.time;
      }
    }
    const Ringing<Real> rings = ringing(system, end, index);
    const Real period = 4 * acos(Real(0)) / rings.frequency;
    const bool seems = rings.decay > 0 && end.time - since > period;
    if (seems || is_certain(system, end, index)) {
      result.insert(index);
    }
  }
  return result;
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
  const auto end = solution.at(solution.end_time());
  const CableSet held = solution.arcs().back().taut;
  const CableSet engaged = staying_engaged(system, solution, end);
  const CableSet taut = held | engaged;
  if (!whole || taut.empty()) {
    return std::nullopt;
  }
  const bool rests = solution.ending() == Ending::rest;
  BasicSystemLock<Real> lock{Real(0), Real(0), taut, rests, rests, {}, {}, {}};
  // the last event at which this set began to be all that is taut
  for (auto event = solution.events().rbegin(); event != solution.events().rend(); ++event) {
    const bool of_elastic = event->kind == EventKind::entry || event->kind == EventKind::exit;
    if (of_elastic ? !(event->cables & engaged).empty() : event->kind != EventKind::impact) {
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
  const bool drags = std::any_of(system.bodies.begin(), system.bodies.end(), [](const auto& body) {
    return body.drag > 0 || body.spin_drag > 0;
  });
  bool is_low = held.empty();  // the energy
  for (const std::size_t index : engaged) {
    is_low = is_low && is_certain(system, end, index);
    if (const Ringing<Real> rings = ringing(system, end, index); rings.decay > 0) {
      lock.ring_down = max(lock.ring_down.value_or(Real(0)), Real(1 / rings.decay));
    }
  }
  const Real now = energy(system, end);
  const auto hangs = held.empty() && engaged.size() == 1 && system.cables.size() == 1
                         ? hanging_energy(system, end, 0)
                         : std::nullopt;
  const auto least = rests   ? std::optional<Real>(now)
                     : hangs ? std::optional<Real>(hangs->equilibrium)
                             : least_energy(system, end, taut);
  lock.certain = rests || is_low;
  if (least) {
    lock.residual_energy = max(Real(0), Real(now - *least));
    if (drags || lock.ring_down) {
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
