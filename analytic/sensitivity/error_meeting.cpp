// Where motions that have come apart are alike again: on the taut cables on which all of them end.

#include <Eigen/Eigenvalues>
#include <algorithm>
#include <cmath>

#include "error_tracker.hpp"
#include "linearised.hpp"
#include "rounding.hpp"
#include "tautline/geometry.hpp"
#include "tautline/projection.hpp"
#include "tautline/solve.hpp"

namespace tautline {

/// Where all motions that are still alike at `place` end on the same taut cables, because their
/// bounces there accumulate.
std::optional<ErrorTracker::Meeting> ErrorTracker::meeting_from(const Place& place) const {
  const Event& event = solution_.events()[place.event];
  const Touching touching{place.taut | event.cables, 45 * epsilon<double>() * fastest_};
  CompletionLimits limits;
  auto done = completion(case_, event.after, touching, limits);
  while (!done && limits.error < largest_part) {
    limits.error *= 2.0;
    done = completion(case_, event.after, touching, limits);
  }
  if (!done || !done->ends) {
    return std::nullopt;
  }
  const CableSet all = place.taut | done->cables;
  CableSet taut = place.taut;
  for (std::size_t index = place.event + 1; index < solution_.events().size(); ++index) {
    const Event& later = solution_.events()[index];
    if (!(later.time <= event.time + done->remaining + done->uncertainty)) {
      return std::nullopt;
    }
    taut = later.kind == EventKind::taut    ? taut | later.cables
           : later.kind == EventKind::slack ? taut - later.cables
                                            : taut;
    if (later.kind == EventKind::taut && taut == all) {
      Meeting result{index, mapped(place.spread, projection_derivative(case_, event.after, all)),
                     event.time, event.time + done->remaining + done->uncertainty};
      const double speed = limits.error * speed_scale(case_, done->after);
      const double shift = limits.error * shortest_length(case_);
      StateVector errors;
      errors << shift, shift, shift * turned(case_), speed, speed, speed * turned(case_);
      add_errors(result.spread, errors);
      return result;
    }
  }
  return std::nullopt;
}

/// Of those of all places, the one that leaves the smallest errors.
std::optional<ErrorTracker::Meeting> ErrorTracker::meeting() const {
  std::optional<Meeting> best;
  const double inertia = case_.body.inertia / case_.body.mass;
  const auto size = [&](const Spread& spread) {
    return spread(3, 3) + spread(4, 4) + inertia * spread(5, 5);
  };
  for (const Place& place : places_) {
    const auto found = meeting_from(place);
    if (found && (!best || size(found->spread) < size(best->spread))) {
      best = found;
    }
  }
  return best || places_.empty() ? best : sampled_meeting(places_.back());
}

/// Where bounces are still too large for a certificate: motions from starts at the bounds of the
/// errors, each way along their largest axes, are followed until all are on the same taut cables.
std::optional<ErrorTracker::Meeting> ErrorTracker::sampled_meeting(const Place& place) const {
  constexpr Eigen::Index axes = 2;       // the largest; errors across them are far smaller
  constexpr double sample_margin = 3.0;  // [-], for what lies between samples: up to 1.9 was seen
  const Event& event = solution_.events()[place.event];
  const auto last =
      std::find_if(solution_.events().rbegin(), solution_.events().rend(),
                   [](const Event& other) { return other.kind != EventKind::impact; });
  if (last == solution_.events().rend() || last->kind != EventKind::taut ||
      last->time <= event.time || last != solution_.events().rbegin()) {
    return std::nullopt;  // no final set of taut cables
  }
  Case neighbour = case_;
  neighbour.duration =
      std::min(2.0 * (last->time - event.time) + 0.01 * last->time, case_.duration - event.time);
  const double until = event.time + neighbour.duration;
  const CableSet all = solution_.arcs().back().taut;
  const State end = solution_.at(until);
  StateVector rate;
  rate << event.after.velocity, event.after.spin, case_.gravity, 0.0;
  const Eigen::SelfAdjointEigenSolver<StateMatrix> split(at_instant(place.spread, rate));
  StateVector errors = StateVector::Zero();
  for (Eigen::Index axis = 6 - axes; axis < 6; ++axis) {
    for (const double way : {-1.0, 1.0}) {
      const StateVector by =
          way * bound(split.eigenvalues()[axis]) * split.eigenvectors().col(axis);
      neighbour.initial = event.after;
      neighbour.initial.position += by.head<2>();
      neighbour.initial.angle += by[2];
      neighbour.initial.velocity += by.segment<2>(3);
      neighbour.initial.spin += by[5];
      CableSet close = place.taut | event.cables;
      for (std::size_t index = 0; index < case_.cables.size(); ++index) {
        if (gap(case_.cables[index], neighbour.initial) < 0.0) {
          close.insert(index);
        }
      }
      neighbour.initial = with_zero_gaps(case_, neighbour.initial, close);
      if (!problems(neighbour).empty()) {
        return std::nullopt;
      }
      const Solution motion = solve(neighbour, options_);
      if (motion.arcs().back().taut != all || motion.end_time() < neighbour.duration) {
        return std::nullopt;
      }
      const State there = motion.at(neighbour.duration);
      StateVector apart;
      apart << there.position - end.position, there.angle - end.angle,
          there.velocity - end.velocity, there.spin - end.spin;
      errors = errors.cwiseMax(apart.cwiseAbs());
    }
  }
  Meeting result{solution_.events().size() - 1, Spread::Zero(), event.time, until};
  add_errors(result.spread, sample_margin * errors);
  return result;
}

/// Goes on from where all motions have met.
void ErrorTracker::meet(const Event& event) {
  lost_ = false;
  now_ = meeting_->spread;
  result_.unsure_.back().until = std::max(event.time, meeting_->until);
  const double late = std::max(event.time - meeting_->from, meeting_->until - event.time);
  const State errors = bounds(now_.topLeftCorner<6, 6>());
  result_.events_[next_] =
      EventErrors{late, 0.0, CableVector::Zero(event.impulses.size()), errors, errors};
  places_.clear();
  meeting_.reset();
}

}  // namespace tautline
