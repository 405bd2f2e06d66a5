#include "cable_events.hpp"

#include <algorithm>
#include <limits>
#include <utility>

#include "newton.hpp"
#include "tautline/geometry.hpp"

namespace tautline::simbody {
namespace {

/// A cable this near to its length, or longer, is at it [-], of the length: some roundings.
constexpr double touch_rounding = 1e-14;

/// A rate that is none [-], of the speed of the body.
constexpr double rate_rounding = 1e-12;

/// A rebound that would be slower than this is none, and the cable is taut if it pulls [m/s]: of
/// impacts that accumulate, rebounds of 1e-12 of a metre are left out.
constexpr double capture_speed = 1e-6;

/// A cable whose gap closes faster than this has turned back [m/s]: more than rounding, and nothing
/// next to the slowest rebound.
constexpr double turn_speed = 1e-3 * capture_speed;

/// A step with more reactions is given up.
constexpr std::size_t most_reactions = 10'000;

/// A cable longer than this was not struck when it should have been [-], of the length: far above
/// rounding and what the integrator lets rods err by.
constexpr double overlooked = 1e-6;

/// Zero is no sign: Simbody's search for an event fails an assertion if it meets one.
double with_sign(double value) { return value == 0.0 ? std::numeric_limits<double>::min() : value; }

}  // namespace

template <class TheCase>
CableEvents<TheCase>::CableEvents(Bodies<TheCase>& bodies)
    : bodies_(bodies), rods_(bodies), impulses_(rods_.size()) {}

template <class TheCase>
double CableEvents<TheCase>::overstretch(const SimTK::State& state, std::size_t cable) const {
  constexpr double no_event = -1.0;  // any
  return rods_.is_on(state, cable) || leaving_.contains(cable)
             ? no_event
             : with_sign(rods_.overstretch(state, cable));
}

template <class TheCase>
double CableEvents<TheCase>::opening(const SimTK::State& state, std::size_t cable) const {
  constexpr double no_event = 1.0;  // any
  return leaving_.contains(cable) ? with_sign(rate(state, cable) + turn_speed) : no_event;
}

template <class TheCase>
double CableEvents<TheCase>::tension(const SimTK::State& state, std::size_t cable) const {
  constexpr double no_event = 1.0;  // any
  return rods_.is_on(state, cable) ? with_sign(rods_.tension(state, cable)) : no_event;
}

template <class TheCase>
void CableEvents<TheCase>::react(SimTK::State& state) {
  if (++reactions_ > most_reactions) {
    trouble_ = "more than " + std::to_string(most_reactions) + " events in one step";
    return;
  }
  bodies_.system().realize(state, SimTK::Stage::Dynamics);
  const CableSet cables = touching(state);
  strike_closing(state, cables);
  CableSet resting;
  for (const std::size_t index : cables) {
    if (rate(state, index) <= capture_speed) {
      resting.insert(index);
    }
  }
  if (!rods_.hold(state, resting)) {
    trouble_ = "no tensions are found that hold the cables at rest";
  }
  leaving_ = leaving_ | cables;
  for (const std::size_t index : leaving_) {
    if (rods_.is_on(state, index) || rate(state, index) <= -turn_speed) {
      leaving_.erase(index);
    }
  }
  state.invalidateAll(SimTK::Stage::Position);  // Simbody keeps the values it watches with the pose
}

template <class TheCase>
void CableEvents<TheCase>::check(const SimTK::State& state) {
  for (std::size_t index = 0; index < rods_.size(); ++index) {
    if (rods_.overstretch(state, index) > overlooked * bodies_.length(index)) {
      trouble_ = "cable " + std::to_string(index) + " is overstretched: an impact was overlooked";
    }
  }
}

template <class TheCase>
void CableEvents<TheCase>::start_step() {
  events_.clear();
  std::fill(impulses_.begin(), impulses_.end(), 0.0);
  reactions_ = 0;
}

/// Of the gap [m/s].
template <class TheCase>
double CableEvents<TheCase>::rate(const SimTK::State& state, std::size_t cable) const {
  return gap_rate(bodies_.the_case().cables[cable], bodies_.state_of(state));
}

template <class TheCase>
CableSet CableEvents<TheCase>::touching(const SimTK::State& state) const {
  CableSet result;
  for (std::size_t index = 0; index < rods_.size(); ++index) {
    if (rods_.is_on(state, index) ||
        rods_.overstretch(state, index) >= -touch_rounding * bodies_.length(index)) {
      result.insert(index);
    }
  }
  return result;
}

/// Strikes those of `cables` that are taut, close or rest, if one of them closes.
template <class TheCase>
void CableEvents<TheCase>::strike_closing(SimTK::State& state, CableSet cables) {
  const StateOf<TheCase> before = bodies_.state_of(state);
  const double rounding = rate_rounding * speed_of(bodies_.the_case(), before);
  CableSet struck;
  CableVector wanted(static_cast<Eigen::Index>(cables.size()));
  Eigen::Index count = 0;
  double fastest = 0.0;  // [m/s], closing
  for (const std::size_t index : cables) {
    const double closing = -gap_rate(cable(index), before);
    const bool taut = rods_.is_on(state, index);
    if (taut || closing >= -rounding) {
      struck.insert(index);
      const double rebound = closing * restitution(cable(index), closing);
      wanted[count++] = rebound > capture_speed ? rebound : 0.0;
      fastest = std::max(fastest, taut ? 0.0 : closing);
    }
  }
  if (fastest <= rounding) {
    return;
  }
  CableVector impulses = strike(bodies_, state, struck, wanted.head(count));
  Eigen::Index row = 0;
  for (const std::size_t index : struck) {
    impulses_[index] += impulses[row++];
  }
  events_.push_back({state.getTime(), EventKind::impact, struck, std::move(impulses), before,
                     bodies_.state_of(state)});
}

template class CableEvents<Case>;
template class CableEvents<SpatialSystem>;

}  // namespace tautline::simbody
