// Where motions that have come apart are alike again: on the taut cables on which all of them end.

#include <algorithm>

#include "error_tracker.hpp"
#include "neighbours.hpp"
#include "simultaneous.hpp"
#include "tangent.hpp"
#include "tautline/detail/rounding.hpp"

namespace tautline {
namespace {

/// How many times its scale a derivative may be while the bounces last [-]. The scale is itself a
/// bound from the sizes of a system; the default margin of a completion holds the motion to
/// rounding, this one to what is printed.
constexpr double steadiness = 2.0;

}  // namespace

/// Where all motions that are still alike at the start of this arc end on the same taut cables,
/// because their bounces there accumulate.
std::optional<ErrorTracker::Meeting> ErrorTracker::meeting_from(std::size_t arc) const {
  const State& start = solution_.arcs()[arc].initial;
  const CableSet held = solution_.arcs()[arc].taut;
  const double from = solution_.arcs()[arc].start;
  const std::size_t next = arrived_[arc];
  const Touching touching{held | solution_.events()[next - 1].cables,
                          few_roundings * epsilon<double>() * fastest_};
  const auto done = completion(case_, start, touching,
                               {.error = largest_part, .speed = {}, .margin = steadiness});
  if (!done || !done->ends) {
    return std::nullopt;
  }
  const CableSet all = held | done->cables;
  const double until = from + done->remaining + done->uncertainty;
  CableSet taut = held;
  for (std::size_t index = next; index < solution_.events().size(); ++index) {
    const Event& later = solution_.events()[index];
    if (!(later.time <= until)) {
      return std::nullopt;
    }
    taut = taut_after(later, taut);
    if (later.kind == EventKind::taut && taut == all) {
      const Tangent onto = tangent(case_, done->after, basis(case_, done->after, all));
      Meeting result{index, projected(result_.starts_[arc], onto), until,
                     std::max(later.time - from, until - later.time)};
      const double speed = done->error * sizes_.speed(done->after);
      const double shift = done->error * sizes_.shortest;
      StateVector errors;
      errors << shift, shift, shift * sizes_.turned, speed, speed, speed * sizes_.turned;
      add_errors(result.spread, errors);
      return result;
    }
  }
  return std::nullopt;
}

/// From those of the last places after an impact that leave the smallest errors. Further back the
/// errors are smaller and the certificate is worse: where that no longer pays, it is not tried on.
std::optional<ErrorTracker::Meeting> ErrorTracker::meeting() const {
  constexpr std::size_t most_places = 32;
  constexpr std::size_t most_in_vain = 8;  // errors of several cables come in fives
  std::optional<Meeting> best;
  std::optional<std::size_t> last;
  const double inertia = case_.body.inertia / case_.body.mass;
  const auto size = [&](const Spread& spread) {
    return spread(3, 3) + spread(4, 4) + inertia * spread(5, 5);
  };
  std::size_t places = 0;
  std::size_t in_vain = 0;
  for (std::size_t arc = arrived_.size();
       arc-- > first_place_ && places < most_places && in_vain < most_in_vain;) {
    const std::size_t next = arrived_[arc];
    if (next == 0 || solution_.events()[next - 1].kind != EventKind::impact ||
        (arc > 0 && arrived_[arc - 1] == next)) {
      continue;
    }
    ++places;
    ++in_vain;
    last = last.value_or(arc);
    const auto found = meeting_from(arc);
    if (found && (!best || size(found->spread) < size(best->spread))) {
      best = found;
      in_vain = 0;
    }
  }
  return best || !last ? best : sampled_meeting(*last);
}

/// Where bounces are still too large for a certificate: neighbours are followed until all are on
/// the same taut cables, which most are soon after the solution is.
std::optional<ErrorTracker::Meeting> ErrorTracker::sampled_meeting(std::size_t arc) const {
  const auto set = final_set(solution_);
  if (!set || set->time <= solution_.arcs()[arc].start ||
      merges_after(case_, options_.law, solution_, arc)) {
    return std::nullopt;
  }
  const auto found = sampled_until(arc, 0.1);
  return found ? found : sampled_until(arc, 1.0);
}

/// The same with neighbours followed for `more` of the time that the solution takes to its lock
/// after it.
std::optional<ErrorTracker::Meeting> ErrorTracker::sampled_until(std::size_t arc,
                                                                 double more) const {
  const double from = solution_.arcs()[arc].start;
  const double lock = final_set(solution_)->time;
  const double until = std::min(lock + more * (lock - from) + 0.01 * lock,
                                solution_.end_time());  // a limit may end it
  const auto others =
      neighbours(case_, solution_, options_, {arc, result_.starts_[arc], until - from});
  const State end = solution_.at(until);
  StateVector errors = StateVector::Zero();
  for (const Solution& motion : others) {
    const State there = motion.at(until - from);
    StateVector apart;
    apart << there.position - end.position, there.angle - end.angle, there.velocity - end.velocity,
        there.spin - end.spin;
    errors = errors.cwiseMax(apart.cwiseAbs());
  }
  const auto late = spread_of_locks(solution_, from, others);
  if (!late) {
    return std::nullopt;
  }
  Meeting result{solution_.events().size() - 1, Spread::Zero(), until, *late};
  const double completed = neighbour_completion * sizes_.speed(end);
  errors.tail<3>() += completed * StateVector::Ones().tail<3>();
  add_errors(result.spread, neighbour_margin * errors);
  return result;
}

/// Goes on from where all motions have met.
void ErrorTracker::meet(const Event& event) {
  lost_ = false;
  now_ = meeting_->spread;
  result_.unsure_.back().until = std::max(event.time, meeting_->until);
  const State errors = bounds(now_.topLeftCorner<6, 6>(), sizes_, event.after);
  result_.events_[next_] =
      EventErrors{meeting_->late, 0.0, CableVector::Zero(event.impulses.size()), errors, errors};
  first_place_ = arrived_.size();
  meeting_.reset();
}

}  // namespace tautline
