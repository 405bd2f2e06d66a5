#include "bench/measure/attribution/carry.hpp"

#include <cmath>
#include <limits>
#include <utility>

#include "tautline/case_or_system.hpp"
#include "tautline/detail/flight.hpp"
#include "tautline/detail/projection.hpp"
#include "tautline/detail/sensitivity.hpp"
#include "tautline/geometry.hpp"
#include "tautline/solve.hpp"

namespace tautline::bench {
namespace {

/// How far the near neighbour of `to_first_order` is, in the units of the case [-]: the square of
/// it and the rounding of the motion over it are equally small.
constexpr double nearness = 1e-7;

/// A motion with more events and taut steps than this is not followed: an elastic cable that is as
/// good as taut bounces a million times.
constexpr std::size_t most_events = 10'000;

template <class TheCase>
StateOf<TheCase> moved_by(const StateOf<TheCase>& state, const StateDifference<TheCase>& by) {
  const Eigen::Index half = by.size() / 2;
  const RowOf<TheCase> pose = by.head(half);
  const RowOf<TheCase> rates = by.tail(half);
  return with_gain(moved(state, pose), rates);
}

/// The cables that are longer than they can be at `state`.
template <class TheCase>
CableSet overstretched(const TheCase& the_case, const StateOf<TheCase>& state) {
  CableSet result;
  for (std::size_t index = 0; index < the_case.cables.size(); ++index) {
    if (gap(the_case.cables[index], state) < 0.0) {
      result.insert(index);
    }
  }
  return result;
}

/// The turn that leads from one orientation to another [rad], in the axes of the body.
Eigen::Vector3d turn_from(const Quaternion& from, const Quaternion& to) {
  Quaternion turn = product<double>(conjugate<double>(from), to);
  if (turn[0] < 0.0) {
    turn = -turn;
  }
  const Eigen::Vector3d axis = turn.tail<3>();
  const double sine = axis.norm();  // of half the angle
  return sine > 0.0 ? Eigen::Vector3d(2.0 * std::atan2(sine, turn[0]) / sine * axis) : 2.0 * axis;
}

/// The derivative of where the motion of `the_case` is at its end, applied to `start`.
StateDifference<Case> derivative(const Case& the_case, const Solution& solution, ImpactLaw law,
                                 const StateDifference<Case>& start) {
  StateDifference<Case> result = StateDifference<Case>::Zero();
  result.head<2>() =
      Sensitivity(the_case, solution, law).at(the_case.duration).topRows<2>() * start;
  return result;
}
/// A system offers no derivative.
StateDifference<SpatialSystem> derivative(const SpatialSystem& /*system*/,
                                          const BasicSolution<SpatialSystem>& /*solution*/,
                                          ImpactLaw /*law*/,
                                          const StateDifference<SpatialSystem>& start) {
  return StateDifference<SpatialSystem>::Constant(start.size(),
                                                  std::numeric_limits<double>::infinity());
}

}  // namespace

Case restarted(const Case& the_case, const State& state, double /*time*/, double duration) {
  Case result = the_case;
  result.initial = state;
  result.duration = duration;
  result.angle_limit.reset();
  result.ceiling.reset();
  return result;
}

SpatialSystem restarted(const SpatialSystem& system, const SpatialSystemState& state, double time,
                        double duration) {
  SpatialSystem result = system;
  each_function(result, [&](auto& function) {
    for (auto& piece : function.pieces) {
      piece.from -= time;
    }
    for (auto& wave : function.waves) {
      wave.phase += wave.frequency * time;
    }
  });
  for (SpatialCable& cable : result.cables) {
    if (cable.cut_at && *cable.cut_at <= time) {
      cable.cut_at.reset();
      cable.from_time = 2.0 * (duration + 1.0);
      continue;
    }
    for (std::optional<double>* const instant : {&cable.from_time, &cable.cut_at}) {
      if (*instant) {
        **instant -= time;
      }
    }
    if (cable.from_time && *cable.from_time <= 0.0) {
      cable.from_time.reset();
    }
  }
  result.initial = state;
  result.initial.time = 0.0;
  result.duration = duration;
  return result;
}

StateDifference<Case> difference(const State& a, const State& b) {
  StateDifference<Case> result;
  result << a.position - b.position, a.angle - b.angle, a.velocity - b.velocity, a.spin - b.spin;
  return result;
}

StateDifference<SpatialSystem> difference(const SpatialSystemState& a,
                                          const SpatialSystemState& b) {
  const RowOf<SpatialSystem> rates = motion_of(a) - motion_of(b);
  StateDifference<SpatialSystem> result(2 * rates.size());
  Eigen::Index row = 0;
  for (std::size_t body = 0; body < a.bodies.size(); ++body) {
    const SpatialState& one = a.bodies[body];
    const SpatialState& other = b.bodies[body];
    result.segment<6>(row) << one.position - other.position,
        turn_from(other.orientation, one.orientation);
    row += 6;
  }
  result.tail(rates.size()) = rates;
  return result;
}

State flown(const Case& the_case, const State& state, double time) {
  return fly(state, the_case.gravity, time);
}

SpatialSystemState flown(const SpatialSystem& system, const SpatialSystemState& state,
                         double time) {
  if (!(time > 0.0)) {
    return state;
  }
  SpatialSystem free = restarted(system, state, state.time, time);
  free.cables.clear();
  SpatialSystemState result = solve(free).at(time);
  result.time = state.time + time;
  return result;
}

template <class TheCase>
std::optional<Carried<TheCase>> Carried<TheCase>::by(TheCase restarted, ImpactLaw law) {
  if (!problems(restarted).empty()) {
    return std::nullopt;
  }
  Carried result(restarted.initial);
  result.solution_ = std::make_shared<const BasicSolution<TheCase>>(
      solve(restarted, {.law = law, .max_events = most_events, .max_steps = most_events}));
  if (result.solution_->end_time() < restarted.duration) {
    return std::nullopt;
  }
  result.end_ = result.solution_->at(restarted.duration);
  result.case_ = std::move(restarted);
  result.law_ = law;
  return result;
}

template <class TheCase>
StateDifference<TheCase> Carried<TheCase>::to_first_order(
    const StateDifference<TheCase>& difference) const {
  if (!solution_) {
    return difference;
  }
  StateDifference<TheCase> start = difference;
  start.head(start.size() / 2) += wait_ * difference.tail(start.size() / 2);
  if (start.isZero(0.0)) {
    return start;
  }
  for (const double scale : {nearness / start.norm(), -nearness / start.norm()}) {
    TheCase neighbour = case_;
    neighbour.initial = moved_by<TheCase>(case_.initial, scale * start);
    if (const auto carried = by(std::move(neighbour), law_)) {
      return bench::difference(carried->end(), end_) / scale;
    }
  }
  return derivative(case_, *solution_, law_, start);
}

template <class TheCase>
std::optional<Carried<TheCase>> Carrier<TheCase>::carry(const StateOf<TheCase>& state,
                                                        double time) const {
  return Carried<TheCase>::by(restarted(case_, state, time, until_ - time), law_);
}

template <class TheCase>
std::optional<Carried<TheCase>> Carrier<TheCase>::carry_out(const StateOf<TheCase>& state,
                                                            double time, double patience) const {
  constexpr int tries = 16;
  for (int index = 0; index <= tries; ++index) {
    const double wait = patience * index / tries;
    if (time + wait >= until_) {
      return Carried<TheCase>(flown(case_, state, until_ - time));
    }
    const StateOf<TheCase> later = flown(case_, state, wait);
    if (overstretched(case_, later).empty()) {
      auto result = carry(later, time + wait);
      if (result) {
        result->was_flown(wait);
      }
      return result;
    }
  }
  return carry(with_zero_gaps(case_, state, overstretched(case_, state)), time);
}

template class Carried<Case>;
template class Carried<SpatialSystem>;
template class Carrier<Case>;
template class Carrier<SpatialSystem>;

}  // namespace tautline::bench
