#include "bench/measure/attribution/carry.hpp"

#include <utility>

#include "tautline/detail/flight.hpp"
#include "tautline/detail/projection.hpp"
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

State moved(State state, const StateDifference& by) {
  state.position += by.head<2>();
  state.angle += by[2];
  state.velocity += by.segment<2>(3);
  state.spin += by[5];
  return state;
}

}  // namespace

std::optional<Carried> Carried::by(Case restarted, ImpactLaw law) {
  if (!problems(restarted).empty()) {
    return std::nullopt;
  }
  Carried result(restarted.initial);
  result.solution_ = std::make_shared<const Solution>(
      solve(restarted, {.law = law, .max_events = most_events, .max_steps = most_events}));
  if (result.solution_->end_time() < restarted.duration) {
    return std::nullopt;
  }
  result.position_ = result.solution_->at(restarted.duration).position;
  result.case_ = std::move(restarted);
  result.law_ = law;
  return result;
}

Vec2 Carried::to_first_order(const StateDifference& difference) const {
  if (!solution_) {
    return difference.head<2>();
  }
  const StateDifference start = flight_ * difference;
  if (start.isZero(0.0)) {
    return Vec2::Zero();
  }
  for (const double scale : {nearness / start.norm(), -nearness / start.norm()}) {
    Case neighbour = case_;
    neighbour.initial = moved(case_.initial, scale * start);
    if (const auto carried = by(std::move(neighbour), law_)) {
      return (carried->position() - position_) / scale;
    }
  }
  return Sensitivity(case_, *solution_, law_).at(case_.duration).topRows<2>() * start;
}

CableSet overstretched(const Case& the_case, const State& state) {
  CableSet result;
  for (std::size_t index = 0; index < the_case.cables.size(); ++index) {
    if (gap(the_case.cables[index], state) < 0.0) {
      result.insert(index);
    }
  }
  return result;
}

std::optional<Carried> Carrier::carry(const State& state, double time) const {
  Case restarted = case_;
  restarted.initial = state;
  restarted.duration = until_ - time;
  restarted.angle_limit.reset();
  restarted.ceiling.reset();
  return Carried::by(std::move(restarted), law_);
}

std::optional<Carried> Carrier::carry_out(const State& state, double time, double patience) const {
  constexpr int tries = 16;
  for (int index = 0; index <= tries; ++index) {
    const double wait = patience * index / tries;
    if (time + wait >= until_) {
      return Carried(fly(state, case_.gravity, until_ - time));
    }
    const State later = fly(state, case_.gravity, wait);
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

}  // namespace tautline::bench
