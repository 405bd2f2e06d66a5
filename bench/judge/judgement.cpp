#include "bench/judge/judgement.hpp"

#include <algorithm>
#include <cmath>
#include <limits>

#include "tautline/geometry.hpp"

namespace tautline::bench {
namespace {

/// Beside every allowance: of the shortest cable [-].
constexpr double least_part = 1e-7;

/// Within what time of an exact impact a run has it [s], if it has it.
double reach(const Allowance& allowance, const ExactHit& hit) {
  return 2.5 * allowance.step + 1.5 * allowance.of_cables(hit.time) / hit.speed;
}

const RecordedImpact* nearest(const Trajectory& run, const ExactHit& hit, double within) {
  const RecordedImpact* found = nullptr;
  auto impact =
      std::lower_bound(run.impacts.begin(), run.impacts.end(), hit.time - within,
                       [](const RecordedImpact& one, double time) { return one.time < time; });
  for (; impact != run.impacts.end() && impact->time <= hit.time + within; ++impact) {
    if (impact->cable == hit.cable && (found == nullptr || std::abs(impact->time - hit.time) <
                                                               std::abs(found->time - hit.time))) {
      found = &*impact;
    }
  }
  return found;
}

/// Steps that a flight must last before a run that is taut for half of it says something.
constexpr double least_flight = 8.0;

/// The first exact impact with a rebound that lasts, after which the run stays taut.
std::optional<StaysTaut> stays_taut(const Expectation& expectation, const Allowance& allowance,
                                    const Trajectory& run) {
  const double end = expectation.reference().solution.end_time();
  const std::vector<ExactHit> hits = exact_hits(expectation.reference(), end);
  for (std::size_t place = 0; place < hits.size(); ++place) {
    const ExactHit& hit = hits[place];
    if (hit.time > allowance.until) {
      break;
    }
    double landing = end;
    bool disturbed = !hit.alone || (place > 0 && hits[place - 1].cable != hit.cable &&
                                    hits[place - 1].time > hit.time - 3.0 * run.step);
    if (place + 1 < hits.size()) {  // the next is either the landing or disturbs it
      disturbed = disturbed || hits[place + 1].cable != hit.cable;
      landing = hits[place + 1].time;
    }
    const double flight = landing - hit.time;
    if (disturbed || hit.rebound < 3.0 * hit.change * run.step ||
        flight < least_flight * run.step || hit.restitution < 0.1) {
      continue;
    }
    const RecordedImpact* const found = nearest(run, hit, reach(allowance, hit));
    if (found == nullptr) {
      break;
    }
    if (static_cast<double>(found->steps) * run.step >= 0.5 * flight) {
      return StaysTaut{hit.speed};
    }
  }
  return std::nullopt;
}

/// The end of the stretch in which rounding alone is to blame [s]: a start on taut cables has none,
/// and where impacts accumulate, an engine may end them a little before.
double end_of_flight(const ReferenceCase& reference) {
  const Solution& solution = reference.solution;
  if (!solution.arcs().front().taut.empty()) {
    return 0.0;
  }
  const double taut = first_taut(solution);
  const std::vector<ExactHit> hits = exact_hits(reference, taut);
  const auto first_slow = std::find_if(hits.begin(), hits.end(), [](const ExactHit& hit) {
    return hit.speed < RecordOptions().slowest;
  });
  return first_slow != hits.end() ? first_slow->time : taut;
}

/// When a cable first acts in the exact motion [s]; after its end if none does.
double first_contact(const ReferenceCase& reference) {
  const Solution& solution = reference.solution;
  if (!solution.arcs().front().taut.empty()) {
    return 0.0;
  }
  const std::vector<Event>& events = solution.events();
  return events.empty() ? std::numeric_limits<double>::infinity() : events.front().time;
}

Following following(const Expectation& expectation, const Allowance& allowance,
                    const Trajectory& run, std::string_view precision) {
  const ReferenceCase& reference = expectation.reference();
  const double shortest = shortest_cable(reference.the_case);
  const double taut = end_of_flight(reference);
  Following result;
  result.located = locates(run);
  // a free flight alone says nothing of cables
  const bool tells = allowance.until > first_contact(reference);
  double worst = 0.0;
  for (const Point& point : run.points) {
    if (point.time > allowance.until) {
      break;
    }
    result.until = point.time;
    if (point.time <= 0.0) {
      continue;
    }
    worst =
        std::max(worst, (point.state.position - reference.solution.at(point.time).position).norm());
    const double grown = rounding_of(precision) * expectation.rounding_at(point.time, run.step);
    const double allowed = allowance.at(point.time) + least_part * shortest;
    if (tells && (!result.ratio || worst > *result.ratio * allowed)) {
      result.ratio = worst / allowed;
      result.time = point.time;
      result.error = worst;
    }
    if (result.located && point.time < taut) {
      result.rounding = std::max(result.rounding.value_or(0.0), worst / grown);
    }
  }
  return result;
}

Expected expected(const Expectation& expectation, const Allowance& allowance,
                  const Trajectory& run) {
  const double last = run.stop ? run.stop->time : run.points.back().time;
  const double until = std::min(allowance.until, last - 5.0 * run.step);
  // one more than is judged: what follows the last too closely makes it unsure
  const std::vector<ExactHit> hits =
      exact_hits(expectation.reference(), expectation.reference().solution.end_time());
  Expected result;
  for (std::size_t place = 0; place < hits.size() && hits[place].time <= until; ++place) {
    const ExactHit& hit = hits[place];
    double room = std::numeric_limits<double>::infinity();  // [s], to the nearest other impact
    if (place > 0) {
      room = hit.time - hits[place - 1].time;
    }
    if (place + 1 < hits.size()) {
      room = std::min(room, hits[place + 1].time - hit.time);
    }
    const double within = reach(allowance, hit);
    if (!hit.alone || hit.speed < 2.0 * RecordOptions().slowest ||  // slower ones are not recorded
        room < 4.0 * run.step || within > 0.5 * room || hit.speed < 5.0 * run.step * hit.change) {
      continue;
    }
    ++result.due;
    result.missed += nearest(run, hit, within) == nullptr ? 1U : 0U;
  }
  return result;
}

/// Flights that are no longer than this many steps say nothing of the acceleration.
constexpr double steps_of_flight = 7.5;

/// The largest difference [m/s^2] of a mean acceleration in flight from gravity, or of an
/// attachment point by a spin that changes: where all cables are slack by more than `slack` [m],
/// nothing but gravity acts. `rounding` [m/s] is what a step adds.
double off_in_flight(const Case& the_case, const Trajectory& run, double slack, double rounding) {
  double arm = 0.0;  // [m]
  for (const Cable& cable : the_case.cables) {
    arm = std::max(arm, cable.attachment.norm());
  }
  const double spacing = run.step * static_cast<double>(run.stride);  // [s]
  const auto flies = [&](const Point& point) {
    return std::all_of(the_case.cables.begin(), the_case.cables.end(),
                       [&](const Cable& cable) { return gap(cable, point.state) > slack; });
  };
  double worst = 0.0;
  const auto end = run.points.end();
  for (auto from = std::find_if(run.points.begin(), end, flies); from != end;) {
    const auto over = std::find_if_not(from, end, flies);
    const Point& last = *std::prev(over);
    const double time = last.time - from->time;
    if (time > steps_of_flight * spacing) {
      const Vec2 gained = last.state.velocity - from->state.velocity;
      const double turned = arm * std::abs(last.state.spin - from->state.spin);
      const double off = std::max((gained - time * the_case.gravity).norm(), turned);
      worst = std::max(worst, (off - rounding * time / run.step) / time);
    }
    from = std::find_if(over, end, flies);
  }
  return worst;
}

/// The largest rise of the energy outside of contacts [J].
double largest_rise(const Case& the_case, const Trajectory& run) {
  constexpr double margin = 1.01;  // steps around a contact
  double least = energy(the_case, run.points.front().state);
  double rise = 0.0;
  double busy = -std::numeric_limits<double>::infinity();  // [s], until a contact has ended
  auto contact = run.impacts.begin();
  for (const Point& point : run.points) {
    for (; contact != run.impacts.end() && contact->time - margin * run.step < point.time;
         ++contact) {
      const double steps = static_cast<double>(std::max<std::size_t>(1, contact->steps));
      busy = std::max(busy, contact->time + (steps + margin) * run.step);
    }
    if (point.time < busy) {
      continue;
    }
    const double now = energy(the_case, point.state);
    least = std::min(least, now);
    rise = std::max(rise, now - least);
  }
  return rise;
}

}  // namespace

bool locates(const Trajectory& run) {
  return !run.impacts.empty() &&
         std::all_of(run.impacts.begin(), run.impacts.end(),
                     [](const RecordedImpact& impact) { return impact.steps == 0; });
}

Judgement judge(const Expectation& expectation, const Trajectory& run,
                const std::vector<AuditedImpact>& impacts, std::string_view precision) {
  const Case& the_case = expectation.reference().the_case;
  const Allowance& allowance = expectation.allowance(run.step, precision);
  Judgement result;
  result.rebounds = rebounds_of(impacts, stays_taut(expectation, allowance, run));
  result.following = following(expectation, allowance, run, precision);
  result.impacts = expected(expectation, allowance, run);
  const double acceleration = expectation.acceleration() + expectation.turning();  // [m/s^2]
  const double speed = expectation.speed() + acceleration * run.step;              // [m/s]
  const double steps = run.points.back().time / run.step;
  const double floats = rounding_of(precision);
  constexpr double tiny = std::numeric_limits<double>::min();  // where nothing moves
  const double weight = the_case.gravity.norm();
  const double slack = 4.0 * run.step * static_cast<double>(run.stride) * speed +
                       floats * expectation.extent() * steps;  // [m]
  result.flight = off_in_flight(the_case, run, slack, 2.0 * floats * expectation.speed()) /
                  ((weight > 0.0 ? weight : acceleration) + tiny);
  result.overstretch = run.overstretch / (run.step * speed + 1e-6 * shortest_cable(the_case) +
                                          floats * expectation.extent() * std::sqrt(steps));
  const double start = std::abs(energy(the_case, the_case.initial));
  const double force =
      the_case.body.mass * std::max(expectation.acceleration(), expectation.change());  // [N]
  const double far = std::max(shortest_cable(the_case), expectation.extent());          // [m]
  result.energy =
      largest_rise(the_case, run) / (force * expectation.speed() * run.step + 1e-9 * start +
                                     1e-6 * kinetic_energy(the_case.body, the_case.initial) +
                                     floats * std::max(start, force * far) * steps + tiny);
  return result;
}

std::size_t readable_impacts(const ReferenceCase& reference, double step) {
  const std::vector<ExactHit> hits = exact_hits(reference, reference.solution.end_time());
  return static_cast<std::size_t>(std::count_if(hits.begin(), hits.end(), [&](const ExactHit& hit) {
    const Cable& cable = reference.the_case.cables[hit.cable];
    return hit.alone &&
           doubt_of_rates(cable, hit.speed, step * hit.change) <= readable_part * hit.speed;
  }));
}

}  // namespace tautline::bench
