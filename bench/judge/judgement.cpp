#include "bench/judge/judgement.hpp"

#include <algorithm>
#include <cmath>
#include <limits>
#include <type_traits>

#include "bench/judge/states.hpp"
#include "bench/measure/compare.hpp"
#include "tautline/case_or_system.hpp"
#include "tautline/elastic_contacts.hpp"
#include "tautline/model_table.hpp"

namespace tautline::bench {
namespace {

/// Beside every allowance: of the shortest cable [-].
constexpr double least_part = 1e-7;

/// This part of the fall in a step is allowed [-]. In the plane the derivative of the motion has
/// it.
template <class TheCase>
constexpr double of_first_step = std::is_same_v<TheCase, Case> ? 0.0 : 1.0;

/// [m/s^2], at the start.
double weight_of(const Case& the_case) { return the_case.gravity.norm(); }
double weight_of(const SpatialSystem& system) { return system.gravity.at(0.0).norm(); }

/// True where `body` turns on as it does.
bool keeps_spin(const SpatialBody& body) {
  return body.inertia.minCoeff() == body.inertia.maxCoeff() && body.spin_drag == 0.0 &&
         body.moment.empty();
}

/// True where an engine's own steps take a body that flies to its exact place, and all cables, too:
/// otherwise they turn it, and add up what is given over time, as well as they can.
bool flies_exactly(const Case& /*the_case*/) { return true; }
bool flies_exactly(const SpatialSystem& system) {
  return keeps_energy(system) &&
         std::all_of(system.bodies.begin(), system.bodies.end(),
                     [](const SpatialBody& body) { return keeps_spin(body) && body.drag == 0.0; });
}

/// Within what time of an exact impact a run has it [s], if it has it.
double reach(const Allowance& allowance, const ExactHit& hit) {
  return 2.5 * allowance.step + 1.5 * allowance.of_cables(hit.time) / hit.speed;
}

template <class TheCase>
const BasicRecordedImpact<TheCase>* nearest(const BasicTrajectory<TheCase>& run,
                                            const ExactHit& hit, double within) {
  const BasicRecordedImpact<TheCase>* found = nullptr;
  auto impact = std::lower_bound(run.impacts.begin(), run.impacts.end(), hit.time - within,
                                 [](const auto& one, double time) { return one.time < time; });
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
template <class TheReference, class TheCase>
std::optional<StaysTaut> stays_taut(const BasicExpectation<TheReference>& expectation,
                                    const Allowance& allowance,
                                    const BasicTrajectory<TheCase>& run) {
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
    const auto* const found = nearest(run, hit, reach(allowance, hit));
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
template <class TheReference>
double end_of_flight(const TheReference& reference) {
  const auto& solution = reference.solution;
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
template <class TheReference>
double first_contact(const TheReference& reference) {
  const auto& solution = reference.solution;
  if (!solution.arcs().front().taut.empty()) {
    return 0.0;
  }
  const auto& events = solution.events();
  return events.empty() ? std::numeric_limits<double>::infinity() : events.front().time;
}

/// True if all cables are elastic, and a whole contact ends up to `until` [s], or the motion does:
/// a load that hangs on its cable has no contact that ends.
bool tells_contacts(const ReferenceSystem& reference, double until) {
  const auto& cables = reference.the_case.cables;
  if (!std::all_of(cables.begin(), cables.end(), [](const auto& one) { return is_elastic(one); })) {
    return false;
  }
  const auto contacts = elastic_contacts(reference.solution);
  return until >= reference.solution.end_time() ||
         std::any_of(contacts.begin(), contacts.end(),
                     [&](const auto& one) { return one.exit && *one.exit <= until; });
}

template <class TheReference, class TheCase>
Following following(const BasicExpectation<TheReference>& expectation, const Allowance& allowance,
                    const BasicTrajectory<TheCase>& run, std::string_view precision) {
  const TheReference& reference = expectation.reference();
  const double shortest = shortest_cable(reference.the_case);
  const double taut = end_of_flight(reference);
  Following result;
  result.located = locates(run) && flies_exactly(reference.the_case);
  // a cable that starts taut may be slack by a rounding, and act a step later
  const double fall =
      reference.solution.arcs().front().taut.empty()
          ? 0.0
          : of_first_step<TheCase> * expectation.acceleration() * run.step * run.step;
  // a free flight alone says nothing of cables
  const bool tells = allowance.until > first_contact(reference);
  double worst = 0.0;
  for (const auto& point : run.points) {
    if (point.time > allowance.until) {
      break;
    }
    result.until = point.time;
    if (point.time <= 0.0) {
      continue;
    }
    worst = std::max(worst, apart(point.state, reference.solution.at(point.time)));
    const double grown = rounding_of(precision) * expectation.rounding_at(point.time, run.step);
    const double allowed = allowance.at(point.time) + least_part * shortest + fall;
    if (tells && (!result.ratio || worst > *result.ratio * allowed)) {
      result.ratio = worst / allowed;
      result.time = point.time;
      result.error = worst;
    }
    if (result.located && point.time < taut && grown > 0.0) {
      result.rounding = std::max(result.rounding.value_or(0.0), worst / grown);
    }
  }
  return result;
}

template <class TheReference, class TheCase>
Expected expected(const BasicExpectation<TheReference>& expectation, const Allowance& allowance,
                  const BasicTrajectory<TheCase>& run) {
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

/// The flights of `run` that say something: where all cables are slack by more than `slack` [m],
/// nothing but gravity and what is given acts. `use` gets the first and the last point of each.
template <class TheCase, class Use>
void each_flight(const TheCase& the_case, const BasicTrajectory<TheCase>& run, double slack,
                 const Use& use) {
  const double spacing = run.step * static_cast<double>(run.stride);  // [s]
  const auto flies = [&](const auto& point) {
    return std::all_of(the_case.cables.begin(), the_case.cables.end(),
                       [&](const auto& cable) { return gap(cable, point.state) > slack; });
  };
  const auto end = run.points.end();
  for (auto from = std::find_if(run.points.begin(), end, flies); from != end;) {
    const auto over = std::find_if_not(from, end, flies);
    const auto last = std::prev(over);
    if (last->time - from->time > steps_of_flight * spacing) {
      use(from, last);
    }
    from = std::find_if(over, end, flies);
  }
}

/// By how much the velocity of a body is off after a flight of `time` [s], or of an attachment
/// point by a spin that changes [m/s].
double off_after(const Case& the_case, const State& from, const State& last, double time) {
  double arm = 0.0;  // [m]
  for (const Cable& cable : the_case.cables) {
    arm = std::max(arm, cable.attachment.norm());
  }
  const Vec2 gained = last.velocity - from.velocity;
  const double turned = arm * std::abs(last.spin - from.spin);
  return std::max((gained - time * the_case.gravity).norm(), turned);
}
/// Bodies of a system count where nothing but one gravity accelerates them, and spins where they
/// last.
double off_after(const SpatialSystem& system, const SpatialSystemState& from,
                 const SpatialSystemState& last, double time) {
  const Eigen::Vector3d gravity = system.gravity.at(0.0);
  double off = 0.0;
  for (std::size_t index = 0; index < system.bodies.size(); ++index) {
    const SpatialBody& body = system.bodies[index];
    const SpatialState& one = from.bodies[index];
    const SpatialState& other = last.bodies[index];
    if (system.gravity.is_constant() && body.drag == 0.0 && body.force.empty()) {
      off = std::max(off, (other.velocity - one.velocity - time * gravity).norm());
    }
    if (keeps_spin(body)) {
      off = std::max(off, longest_arm(system, index) * (other.spin - one.spin).norm());
    }
  }
  return off;
}

/// The largest difference [m/s^2] of a mean acceleration in flight from what acts. `rounding` [m/s]
/// is what a step adds.
template <class TheCase>
double off_in_flight(const TheCase& the_case, const BasicTrajectory<TheCase>& run, double slack,
                     double rounding) {
  double worst = 0.0;
  each_flight(the_case, run, slack, [&](const auto from, const auto last) {
    const double time = last->time - from->time;
    const double off = off_after(the_case, from->state, last->state, time);
    worst = std::max(worst, (off - rounding * time / run.step) / time);
  });
  return worst;
}

/// The largest change [-] of a body's angular momentum in flight, which nothing changes, as part of
/// it and in units of what a scheme of first order explains: the square of the turn in a step, for
/// each step. None where no body turns in flight.
std::optional<double> turned_in_flight(const SpatialSystem& system, const SystemTrajectory& run,
                                       double slack, double rounding) {
  constexpr double least_steps = 10.0;  // what rounding leaves of a slow turn is small against that
  std::optional<double> worst;
  each_flight(system, run, slack, [&](const auto from, const auto last) {
    for (std::size_t index = 0; index < system.bodies.size(); ++index) {
      const SpatialBody& body = system.bodies[index];
      if (!has_inertia(body.inertia) || body.spin_drag > 0.0 || !body.moment.empty()) {
        continue;
      }
      const auto momentum = [&](const auto& point) {
        const SpatialState& state = point.state.bodies[index];
        return in_the_world(state, Eigen::Vector3d(body.inertia.cwiseProduct(state.spin)));
      };
      const double spin = from->state.bodies[index].spin.norm();
      const Eigen::Vector3d before = momentum(*from);
      for (auto point = from; spin > 0.0 && point != last;) {
        ++point;
        const double steps = (point->time - from->time) / run.step;
        const double turned = spin * run.step;  // [rad], in a step
        const double explained =
            turned * turned * (steps + least_steps) + rounding * (1.0 + turned) * steps;
        worst = std::max(worst.value_or(0.0),
                         (momentum(*point) - before).norm() / (explained * before.norm()));
      }
    }
  });
  return worst;
}

/// The largest rise of the energy outside of contacts [J].
template <class TheCase>
double largest_rise(const TheCase& the_case, const BasicTrajectory<TheCase>& run) {
  constexpr double margin = 1.01;  // steps around a contact
  double least = energy(the_case, run.points.front().state);
  double rise = 0.0;
  double busy = -std::numeric_limits<double>::infinity();  // [s], until a contact has ended
  auto contact = run.impacts.begin();
  for (const auto& point : run.points) {
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

template <class TheReference, class TheCase>
Judgement judge(const BasicExpectation<TheReference>& expectation,
                const BasicTrajectory<TheCase>& run, const std::vector<AuditedImpact>& impacts,
                std::string_view precision) {
  const TheCase& the_case = expectation.reference().the_case;
  const Allowance& allowance = expectation.allowance(run.step, precision);
  Judgement result;
  result.rebounds = rebounds_of(impacts, stays_taut(expectation, allowance, run));
  result.following = following(expectation, allowance, run, precision);
  if constexpr (!std::is_same_v<TheCase, Case>) {
    const double until = result.following.until + run.step * static_cast<double>(run.stride);
    if (result.rebounds.word == Rebound::too_few && result.following.ratio &&
        tells_contacts(expectation.reference(), until)) {
      result.rebounds.word = Rebound::elastic;
    }
  }
  result.impacts = expected(expectation, allowance, run);
  const double acceleration = expectation.acceleration() + expectation.turning();  // [m/s^2]
  const double speed = expectation.speed() + acceleration * run.step;              // [m/s]
  const double steps = run.points.back().time / run.step;
  const double floats = rounding_of(precision);
  constexpr double tiny = std::numeric_limits<double>::min();  // where nothing moves
  const double weight = weight_of(the_case);
  const double slack = 4.0 * run.step * static_cast<double>(run.stride) * speed +
                       floats * expectation.extent() * steps;  // [m]
  result.flight = off_in_flight(the_case, run, slack, 2.0 * floats * expectation.speed()) /
                  ((weight > 0.0 ? weight : acceleration) + tiny);
  result.overstretch = run.overstretch / (run.step * speed + 1e-6 * shortest_cable(the_case) +
                                          floats * expectation.extent() * std::sqrt(steps));
  if constexpr (!std::is_same_v<TheCase, Case>) {
    result.rotation = turned_in_flight(the_case, run, slack, floats);
  }
  const double start = std::abs(energy(the_case, the_case.initial));
  const double force =
      heaviest(the_case) * std::max(expectation.acceleration(), expectation.change());  // [N]
  const double far = std::max(shortest_cable(the_case), expectation.extent());          // [m]
  if (keeps_energy(the_case) && !first_elastic(the_case)) {
    result.energy = largest_rise(the_case, run) /
                    (force * expectation.speed() * run.step + 1e-9 * start +
                     1e-6 * kinetic_energy(bodies_of(the_case), the_case.initial) +
                     floats * std::max(start, force * far) * steps + tiny);
  }
  return result;
}

template Judgement judge(const Expectation&, const Trajectory&, const std::vector<AuditedImpact>&,
                         std::string_view);
template Judgement judge(const SystemExpectation&, const SystemTrajectory&,
                         const std::vector<AuditedImpact>&, std::string_view);

template <class TheReference>
std::size_t readable_impacts(const TheReference& reference, double step) {
  const std::vector<ExactHit> hits = exact_hits(reference, reference.solution.end_time());
  return static_cast<std::size_t>(std::count_if(hits.begin(), hits.end(), [&](const ExactHit& hit) {
    const auto& cable = reference.the_case.cables[hit.cable];
    return hit.alone &&
           doubt_of_rates(cable, hit.speed, step * hit.change) <= readable_part * hit.speed;
  }));
}

template std::size_t readable_impacts(const ReferenceCase&, double);
template std::size_t readable_impacts(const ReferenceSystem&, double);

}  // namespace tautline::bench
