#include "tautline/solve.hpp"

#include <algorithm>
#include <cmath>
#include <stdexcept>
#include <utility>

#include "tautline/accumulation.hpp"
#include "tautline/first_contact.hpp"
#include "tautline/flight.hpp"
#include "tautline/geometry.hpp"
#include "tautline/impact.hpp"

namespace tautline {
namespace {

/// Rounding of a gap rate against the fastest speed so far [-]: some ten operations of one ulp
/// each. Not against the present speed: the body may be stopped within an instant by ever smaller
/// impacts, and what is left then is rounding of the speeds before.
constexpr double rate_rounding = 1e-14;

/// The instant that ends a flight, and what happens there.
struct Stop {
  double dt;                     // [s] from the start of the flight; NaN: numbers overflowed
  std::optional<Ending> ending;  // none: `cables` become taut, and the motion goes on
  CableSet cables;
};

/// True while the state, its energy and the squares of its numbers fit a double.
bool fits(const Case& the_case, const State& state) {
  return std::isfinite(energy(the_case, state)) && std::isfinite(state.angle) &&
         std::isfinite(state.position.squaredNorm()) &&
         std::isfinite(state.velocity.squaredNorm()) && std::isfinite(state.spin * state.spin);
}

/// The motion so far: where it is now, and what has been recorded.
class Motion {
 public:
  explicit Motion(const Case& the_case, const SolveOptions& options)
      : case_(the_case), options_(options), state_(the_case.initial) {
    note_speed();
    for (std::size_t index = 0; index < case_.cables.size(); ++index) {
      const Cable& cable = case_.cables[index];
      if (gap(cable, state_) <= gap_rounding * cable.length) {
        touching_.cables.insert(index);
      }
    }
  }

  /// The whole algorithm.
  Solution run() {
    for (std::size_t round = 0; round < options_.max_events; ++round) {
      if (const auto taut = capture(case_, state_, touching_, options_.capture_speed)) {
        return finish_taut(*taut);
      }
      const Stop stop = next_stop();
      if (std::isnan(stop.dt) || !fits(case_, fly(state_, case_.gravity, stop.dt))) {
        return finish(Ending::overflow);
      }
      fly_to(stop);
      if (stop.ending) {
        return finish(*stop.ending);
      }
      if (!hit()) {
        return finish(Ending::overflow);
      }
    }
    return finish(Ending::event_limit);
  }

 private:
  /// The earliest of: a contact, a limit of the case's validity, the end of the duration.
  [[nodiscard]] Stop next_stop() const {
    const double remaining = case_.duration - time_;
    Stop stop{remaining, Ending::reached_duration, {}};
    if (const auto search = first_contact(case_, state_, touching_, stop.dt); search.contact) {
      stop = {search.contact->dt, std::nullopt, search.contact->cables};
    }
    if (std::isnan(stop.dt)) {
      return stop;
    }
    if (const auto dt = time_to_angle_limit(case_, state_, stop.dt)) {
      stop = {*dt, Ending::angle_limit, {}};
    }
    if (const auto dt = time_to_ceiling(case_, state_, stop.dt)) {
      stop = {*dt, Ending::ceiling, {}};
    }
    return stop;
  }

  /// Appends the arc of the flight and moves to its end.
  void fly_to(const Stop& stop) {
    const double end = stop.ending == Ending::reached_duration ? case_.duration : time_ + stop.dt;
    arcs_.push_back({time_, end, state_, {}});
    state_ = fly(state_, case_.gravity, stop.dt);
    close_gaps(stop.cables);
    time_ = end;
    touching_.cables = stop.dt > 0.0 ? stop.cables : touching_.cables | stop.cables;
    note_speed();
  }

  /// Takes back what rounding has left of the gaps of cables at zero gap once it is more than a few
  /// flights leave: over thousands of bounces it would add up.
  void close_gaps(CableSet cables) {
    constexpr double drift = 1e-14;  // [-] of a cable's length; one flight leaves some 1e-16
    for (const std::size_t index : cables) {
      const Cable& cable = case_.cables[index];
      const double left = gap(cable, state_);
      if (std::abs(left) > drift * cable.length) {
        state_.position += left * (attachment_point(state_, cable) - cable.anchor).normalized();
      }
    }
  }

  /// Keeps the rounding of gap rates up to date.
  void note_speed() {
    touching_.rate_rounding =
        std::max(touching_.rate_rounding, rate_rounding * speed_scale(case_, state_));
  }

  /// Resolves the impact of the touching cables that close or rest; one that grazes is left alone.
  /// False, and nothing done, where the rebound does not fit a double.
  [[nodiscard]] bool hit() {
    CableSet closing;
    for (const std::size_t index : touching_.cables) {
      if (gap_rate(case_.cables[index], state_) <= touching_.rate_rounding) {
        closing.insert(index);
      }
    }
    if (closing.empty()) {
      return true;
    }
    Impact impact = newton_impact(case_, state_, closing);
    if (!fits(case_, impact.after) || !impact.impulses.allFinite()) {
      return false;
    }
    events_.push_back(
        {time_, EventKind::impact, closing, std::move(impact.impulses), state_, impact.after});
    state_ = impact.after;
    return true;
  }

  Solution finish_taut(const Capture& taut) {
    const auto count = static_cast<Eigen::Index>(taut.cables.size());
    events_.push_back(
        {time_, EventKind::taut, taut.cables, CableVector::Zero(count), state_, taut.after});
    state_ = taut.after;
    if (taut.remaining == 0.0) {  // exactly: resting cables have no bounces left
      return finish(Ending::taut);
    }
    accumulation_ = Accumulation{time_ + taut.remaining, taut.uncertainty, taut.cables, taut.after,
                                 energy(case_, taut.after)};
    return finish(Ending::zeno);
  }

  Solution finish(Ending ending) {
    if (ending != Ending::reached_duration) {
      arcs_.push_back({time_, time_, state_, {}});  // the last state, after its event
    }
    return {case_.gravity, std::move(arcs_), std::move(events_), ending, std::move(accumulation_)};
  }

  const Case& case_;
  const SolveOptions& options_;
  double time_ = 0.0;
  State state_;
  Touching touching_;
  std::vector<Arc> arcs_;
  std::vector<Event> events_;
  std::optional<Accumulation> accumulation_;
};

}  // namespace

Solution solve(const Case& the_case, const SolveOptions& options) {
  if (const auto broken = problems(the_case); !broken.empty()) {
    throw std::invalid_argument(broken.front());
  }
  return Motion(the_case, options).run();
}

}  // namespace tautline
