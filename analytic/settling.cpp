#include "tautline/settling.hpp"

#include "instantiate.hpp"
#include "tautline/detail/hold.hpp"
#include "tautline/detail/projection.hpp"
#include "tautline/geometry.hpp"
#include "tautline/solve.hpp"
#include "tautline/uncertainty.hpp"

namespace tautline {
namespace {

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

/// Some multiple of this is the period of any swing of `the_case` [s], or of any turn.
template <class Real>
Real time_scale(const BasicCase<Real>& the_case, const BasicState<Real>& state) {
  Real longest(0);
  for (const BasicCable<Real>& cable : the_case.cables) {
    longest = max(longest, cable.length);
  }
  const Real gravity = the_case.gravity.norm();
  return gravity > 0 ? Real(sqrt(Real(longest / gravity)))
                     : Real(longest / speed_scale(the_case, state));
}

}  // namespace

template <class Real>
std::optional<BasicSwing<Real>> swing(const BasicCase<Real>& the_case,
                                      const BasicState<Real>& state) {
  const CableSet taut = resting_at(the_case, state);
  if (taut.empty() || !(the_case.gravity.norm() > 0 || speed_scale(the_case, state) > 0)) {
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
  const auto held = hold(free, free.initial, {taut, Real(0)}, taut);
  const std::size_t freedoms = is_point_mass(the_case) ? 2 : 3;
  if (!held || held->pulling.size() + 1 != freedoms) {
    return std::nullopt;
  }
  SolveOptions limited;
  limited.max_events = 2;      // the first is this: with another one it is no swing
  limited.max_steps = 20'000;  // steps of its series; a period of a usual swing takes a hundred
  limited.until_locked = true;
  free.duration = 256 * time_scale(the_case, state);  // near-critical swings are slow
  if (!problems(in_double(free)).empty()) {  // such as an angle beyond what a start may have
    return std::nullopt;
  }
  const BasicSolution<BasicCase<Real>> solution = solve(free, limited);
  return passes_dead_point(free, solution, Real(0)) ? std::nullopt : solution.swing();
}

template <class Real>
std::optional<BasicLock<Real>> last_lock(const BasicCase<Real>& the_case,
                                         const BasicSolution<BasicCase<Real>>& solution) {
  const bool whole = solution.ending() == Ending::reached_duration ||
                     solution.ending() == Ending::locked || solution.ending() == Ending::rest;
  if (!whole || solution.events().empty() || solution.events().back().kind != EventKind::taut) {
    return std::nullopt;
  }
  const BasicEvent<BasicCase<Real>>& last = solution.events().back();
  BasicLock<Real> lock{last.time, Real(0), solution.arcs().back().taut, false, false, {}};
  if (!solution.accumulations().empty() && solution.accumulations().back().start == last.time) {
    lock.time = solution.accumulations().back().time;
    lock.uncertainty = solution.accumulations().back().uncertainty;
  }
  lock.rests = solution.ending() == Ending::rest;
  if (!lock.rests) {
    lock.swing = solution.swing() && !passes_dead_point(the_case, solution, last.time)
                     ? solution.swing()
                     : swing(the_case, last.after);
  }
  lock.permanent = lock.rests || lock.swing.has_value();
  return lock;
}

template <class Real>
BasicSettling<Real> settling(const BasicCase<Real>& the_case,
                             const BasicSolution<BasicCase<Real>>& solution) {
  BasicSettling<Real> result;
  result.last_impacts = last_impacts(the_case, solution);
  result.lock = last_lock(the_case, solution);
  return result;
}

template std::optional<BasicSwing<Instance>> swing(const InstanceCase&,
                                                   const BasicState<Instance>&);
template std::optional<BasicLock<Instance>> last_lock(const InstanceCase&,
                                                      const BasicSolution<InstanceCase>&);
template BasicSettling<Instance> settling(const InstanceCase&, const BasicSolution<InstanceCase>&);

}  // namespace tautline
