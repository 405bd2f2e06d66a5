#include "tautline/impacts_between_parts.hpp"

#include <algorithm>

#include "system/kernel.hpp"
#include "tautline/cable_row.hpp"
#include "tautline/geometry.hpp"
#include "tautline/impulses_by_hand.hpp"

namespace tautline {
namespace {

/// A cable may have been hit where its gap is at most so many roundings of its length [-]: drop-in
/// cables take 100 for zero, and the engine's pose adds its own.
constexpr double touching = 1000.0;

/// The rates of a jump may contradict each other by so many roundings of the speed [-].
constexpr double contradicting = 1000.0;

/// An impulse below so many roundings of the momentum is one [-]: that of a cable that is near zero
/// gap while another is hit.
constexpr double pulling = 20.0;

/// The largest speed of a point of a body around a jump [m/s].
template <class TheCase>
double speed_around(const TheCase& the_case, const StateOf<TheCase>& before,
                    const StateOf<TheCase>& after) {
  return std::max(speed_scale(the_case, before), speed_scale(the_case, after));
}

/// The cables that `state` leaves no room.
template <class TheCase>
CableSet touched(const TheCase& the_case, const StateOf<TheCase>& state, double rounding) {
  CableSet result;
  for (std::size_t index = 0; index < the_case.cables.size(); ++index) {
    const auto& cable = the_case.cables[index];
    if (gap(cable, state) <= touching * rounding * length_of(cable, state)) {
      result.insert(index);
    }
  }
  return result;
}

/// The impulses of `cables` that change the velocity of `before` to that of `after`.
template <class TheCase>
CableVector impulses_of_jump(const TheCase& the_case, const StateOf<TheCase>& before,
                             const StateOf<TheCase>& after, CableSet cables, double rounding) {
  CableVector jumps(static_cast<Eigen::Index>(cables.size()));
  Eigen::Index row = 0;
  for (const std::size_t index : cables) {
    const auto& cable = the_case.cables[index];
    jumps[row++] = gap_rate(cable, after) - gap_rate(cable, before);
  }
  return impulses_by_hand(delassus(the_case, before, cables), -jumps,
                          contradicting * rounding * speed_around(the_case, before, after),
                          rank_of<TheCase>);
}

}  // namespace

template <class TheCase>
ImpactsBetweenParts<TheCase>::ImpactsBetweenParts(const TheCase& the_case, double rounding)
    : case_(the_case), rounding_(rounding), impulses_(the_case.cables.size()) {}

template <class TheCase>
void ImpactsBetweenParts<TheCase>::begin_step(const State& now) {
  last_ = now;
  parts_ = 0.0;
  events_.clear();
  std::fill(impulses_.begin(), impulses_.end(), 0.0);
}

template <class TheCase>
void ImpactsBetweenParts<TheCase>::end_part(double dt, const State& now, CableSet pulled) {
  parts_ += dt;
  last_ = now;
  taut_ = pulled;
}

template <class TheCase>
void ImpactsBetweenParts<TheCase>::end_step(double dt, const State& now) {
  parts_ = dt;  // in float, the sum is off by rounding
  look(now);
  start_.advance(dt);
}

template <class TheCase>
void ImpactsBetweenParts<TheCase>::look(const State& now) {
  // exactly: nothing else changes the velocity between two parts
  if (motion_of(now) == motion_of(last_)) {
    return;
  }
  // the pose may have been corrected at the end of a part
  const State before = with_velocities(now, last_);
  last_ = now;
  const CableSet candidates = touched(case_, now, rounding_);
  if ((candidates - taut_).empty()) {
    return;
  }
  const CableVector all = impulses_of_jump(case_, before, now, candidates, rounding_);
  const double least =
      pulling * rounding_ * heaviest(case_) * speed_around(case_, before, now);  // [N s]
  Event event{start_.now() + parts_, EventKind::impact, {}, {}, before, now};
  std::vector<double> impulses;
  Eigen::Index row = 0;
  for (const std::size_t index : candidates) {
    const double impulse = all[row++];
    if (impulse > least) {
      event.cables.insert(index);
      impulses.push_back(impulse);
    }
  }
  if ((event.cables - taut_).empty()) {
    return;
  }
  event.impulses = Eigen::Map<const Eigen::VectorXd>(impulses.data(),
                                                     static_cast<Eigen::Index>(impulses.size()));
  row = 0;
  for (const std::size_t index : event.cables) {
    impulses_[index] += event.impulses[row++];
  }
  events_.push_back(std::move(event));
}

template class ImpactsBetweenParts<Case>;
template class ImpactsBetweenParts<SpatialSystem>;

}  // namespace tautline
