#include "bench/attribution_carry.hpp"

#include <utility>

#include "tautline/flight.hpp"
#include "tautline/geometry.hpp"
#include "tautline/projection.hpp"
#include "tautline/solve.hpp"

namespace tautline::bench {

Carried::Carried(const State& state) : position_(state.position) {
  growth_.emplace(Growth::Zero()).leftCols<2>().setIdentity();
}

std::optional<Carried> Carried::by(Case restarted, ImpactLaw law) {
  if (!problems(restarted).empty()) {
    return std::nullopt;
  }
  Carried result(restarted.initial);
  result.solution_ = std::make_shared<const Solution>(solve(restarted, {.law = law}));
  if (result.solution_->end_time() < restarted.duration) {
    return std::nullopt;
  }
  result.position_ = result.solution_->at(restarted.duration).position;
  result.growth_.reset();
  result.case_ = std::move(restarted);
  result.law_ = law;
  return result;
}

const Growth& Carried::growth() {
  if (!growth_) {
    growth_ = Sensitivity(case_, *solution_, law_).at(case_.duration).topRows<2>() * flight_;
  }
  return *growth_;
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
