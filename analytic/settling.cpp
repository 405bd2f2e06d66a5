#include "tautline/settling.hpp"

#include "instantiate.hpp"
#include "tautline/geometry.hpp"
#include "tautline/hold.hpp"
#include "tautline/projection.hpp"
#include "tautline/root_search.hpp"
#include "tautline/solve.hpp"

namespace tautline {
namespace {

/// A kinetic energy this small against the swing's is zero at a turning point [-].
constexpr double turning = 1e-9;

/// An instant at which the kinetic energy is least or largest.
template <class Real>
struct Extreme {
  Real time;
  BasicState<Real> state;
  Real kinetic;  // [J]
};

/// The rate of the kinetic energy [W] `dt` after the start of an arc of taut motion, from
/// velocities and accelerations: near the equilibrium both are small, and so is their rounding.
template <class Real>
Real power(const BasicBody<Real>& body, const BasicArc<Real>& arc, const Real& dt) {
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

/// Where in [low, high] after the start of `arc` the kinetic energy stops rising or falling; none
/// if it does not.
template <class Real>
std::optional<Real> stationary(const BasicBody<Real>& body, const BasicArc<Real>& arc, Real low,
                               Real high) {
  Real at_low = power(body, arc, low);
  Real at_high = power(body, arc, high);
  if ((at_low < 0) == (at_high < 0)) {
    return std::nullopt;
  }
  // Illinois' method: the bracket always holds, and no derivative is needed
  constexpr int enough = 200;  // some 10 are for a double, 20 for 60 digits
  for (int step = 0; step < enough; ++step) {
    const Real middle = (low * at_high - high * at_low) / (at_high - at_low);
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

/// The stationary kinetic energies along `solution`, in rising time.
template <class Real>
std::vector<Extreme<Real>> extremes(const BasicCase<Real>& the_case,
                                    const BasicSolution<Real>& solution) {
  std::vector<Extreme<Real>> result;
  std::optional<bool> falling;  // at the end of the arc before
  const auto add = [&](const BasicArc<Real>& arc, const Real& dt) {
    const BasicState<Real> state = arc.after(dt, the_case.gravity);
    result.push_back({arc.start + dt, state, kinetic_energy(the_case.body, state)});
  };
  constexpr int pieces = 16;  // of an arc, which is at most half a swing: one extreme in each
  for (const BasicArc<Real>& arc : solution.arcs()) {
    const Real length = arc.end - arc.start;
    const bool falls = power(the_case.body, arc, Real(0)) < 0;
    if (falling && *falling != falls) {
      add(arc, Real(0));  // rounding between two arcs hides the change of sign
    }
    for (int piece = 0; piece < pieces; ++piece) {
      const Real low = length * piece / pieces;
      const Real high = length * (piece + 1) / pieces;
      if (const auto dt = stationary(the_case.body, arc, low, high)) {
        add(arc, *dt);
      }
    }
    falling = power(the_case.body, arc, length) < 0;
  }
  return result;
}

/// The swing that `found` shows; none with less than a period of it.
template <class Real>
std::optional<BasicSwing<Real>> measure(const std::vector<Extreme<Real>>& found) {
  BasicSwing<Real> result{Real(0), Real(0), Real(0), Real(0), Real(0)};
  for (const auto& extreme : found) {
    result.energy = max(result.energy, extreme.kinetic);
  }
  std::vector<const Extreme<Real>*> turns;
  for (const auto& extreme : found) {
    if (extreme.kinetic <= turning * result.energy) {
      turns.push_back(&extreme);
    }
  }
  if (turns.size() < 3) {
    return std::nullopt;
  }
  result.period = turns[2]->time - turns[0]->time;
  result.least = min(turns[0]->state.angle, turns[1]->state.angle);
  result.largest = max(turns[0]->state.angle, turns[1]->state.angle);
  result.amplitude = (result.largest - result.least) / 2;
  return result;
}

/// The cables at zero gap and rate at `state`, beyond rounding.
template <class Real>
CableSet resting_at(const BasicCase<Real>& the_case, const BasicState<Real>& state) {
  const Real slow = sqrt(epsilon<Real>()) * speed_scale(the_case, state);
  CableSet result;
  for (std::size_t index = 0; index < the_case.cables.size(); ++index) {
    const BasicCable<Real>& cable = the_case.cables[index];
    if (abs(gap(cable, state)) <= gap_rounding * cable.length &&
        abs(gap_rate(cable, state)) <= slow) {
      result.insert(index);
    }
  }
  return result;
}

/// Some multiple of this is the period of any swing of `the_case` [s].
template <class Real>
Real time_scale(const BasicCase<Real>& the_case) {
  Real longest(0);
  for (const BasicCable<Real>& cable : the_case.cables) {
    longest = max(longest, cable.length);
  }
  return sqrt(Real(longest / the_case.gravity.norm()));
}

}  // namespace

template <class Real>
std::optional<BasicSwing<Real>> swing(const BasicCase<Real>& the_case,
                                      const BasicState<Real>& state) {
  const CableSet taut = resting_at(the_case, state);
  if (taut.empty() || !(the_case.gravity.norm() > 0)) {
    return std::nullopt;
  }
  BasicCase<Real> free = the_case;
  free.initial = projected(the_case, state, taut);
  free.angle_limit.reset();
  free.ceiling.reset();
  for (BasicCable<Real>& cable : free.cables) {  // after a release nothing matters: be quick there
    cable.restitution = Real(0);
    cable.restitution_table.clear();
  }
  const auto held = hold<Real>(free, free.initial, {taut, Real(0)}, taut);
  const std::size_t freedoms = is_point_mass(the_case) ? 2 : 3;
  if (!held || held->pulling.size() + 1 != freedoms) {
    return std::nullopt;
  }
  SolveOptions limited;
  limited.max_steps = 20'000;  // steps of its series; a period of a usual swing takes a hundred
  // [time scales]; near-critical swings are slow
  for (const int length : {8, 16, 32, 64, 128, 256}) {
    free.duration = length * time_scale(the_case);
    const BasicSolution<Real> motion = solve(free, limited);
    if (motion.ending() != Ending::reached_duration || motion.events().size() != 1) {
      return std::nullopt;  // it comes to rest, or loses a cable, or hits another one
    }
    if (auto found = measure(extremes(the_case, motion))) {
      return found;
    }
  }
  return std::nullopt;
}

template <class Real>
BasicSettling<Real> settling(const BasicCase<Real>& the_case, const BasicSolution<Real>& solution) {
  BasicSettling<Real> result;
  for (const int parts : {100, 1000}) {
    BasicLastImpact<Real> last{Real(1) / parts, std::nullopt};
    for (const BasicEvent<Real>& event : solution.events()) {
      if (event.kind == EventKind::impact &&
          gap_rates(the_case, event.before, event.cables).minCoeff() < -last.speed) {
        last.time = event.time;
      }
    }
    result.last_impacts.push_back(std::move(last));
  }
  const bool whole =
      solution.ending() == Ending::reached_duration || solution.ending() == Ending::rest;
  if (!whole || solution.events().empty() || solution.events().back().kind != EventKind::taut) {
    return result;
  }
  const BasicEvent<Real>& last = solution.events().back();
  BasicLock<Real> lock{last.time, Real(0), solution.arcs().back().taut, false, false, {}};
  if (!solution.accumulations().empty() && solution.accumulations().back().start == last.time) {
    lock.time = solution.accumulations().back().time;
    lock.uncertainty = solution.accumulations().back().uncertainty;
  }
  lock.rests = solution.ending() == Ending::rest;
  if (!lock.rests) {
    lock.swing = swing(the_case, last.after);
  }
  lock.permanent = lock.rests || lock.swing.has_value();
  result.lock = std::move(lock);
  return result;
}

template std::optional<BasicSwing<Instance>> swing(const BasicCase<Instance>&,
                                                   const BasicState<Instance>&);
template BasicSettling<Instance> settling(const BasicCase<Instance>&,
                                          const BasicSolution<Instance>&);

}  // namespace tautline
