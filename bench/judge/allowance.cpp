#include "bench/judge/allowance.hpp"

#include <Eigen/Core>
#include <algorithm>
#include <cmath>
#include <limits>
#include <optional>
#include <type_traits>
#include <utility>

#include "bench/judge/states.hpp"
#include "bench/measure/audit_impacts.hpp"
#include "tautline/case_or_system.hpp"
#include "tautline/detail/flight.hpp"
#include "tautline/detail/sensitivity.hpp"
#include "tautline/geometry.hpp"
#include "tautline/plain_scheme.hpp"

namespace tautline::bench {
namespace {

/// Parts of the exact motion at which numbers along it are kept, in addition to its events.
constexpr std::size_t parts = 1000;

/// Impacts slower than this part of the fastest move nobody [-].
constexpr double slow = 1e-4;

/// An allowance of this part of the shortest cable says nothing any more [-]. Between 0.02 and 0.5
/// the worst correct run keeps the same distance from what is allowed.
constexpr double too_much = 0.1;

/// Schemes may part where two outcomes are closer than this part of the allowance [-].
constexpr double guard_of_forks = 0.25;

/// Near misses are looked for at this many instants.
constexpr std::size_t looks = 4000;

/// A gap below this part of the cable is an impact's or a taut cable's [-].
constexpr double no_gap = 1e-7;

/// Shifts of the first step, of either way to act; in very many steps fewer.
constexpr int shifts = 16;
constexpr int few_shifts = 6;
constexpr double many_steps = 20000.0;

/// A step of a system takes dozens of times as long.
template <class TheReference>
constexpr bool is_system = std::is_same_v<TheReference, ReferenceSystem>;

/// This many times the error of the plain scheme is allowed [-] where nothing else says how far a
/// scheme may be off. In the suites of systems sound models reach 1.7 in flight, and 2.6 on taut
/// cables.
template <class TheReference>
constexpr double of_yardstick = is_system<TheReference> ? 3.0 : 1.0;

/// No run is judged by its position for longer than this many steps: a body that has come to rest
/// would be followed for ever.
constexpr double most_steps_judged = 200000.0;

/// Impacts and arcs whose errors are carried along a motion. After more of them the yardstick alone
/// says how far a scheme may be off.
constexpr std::size_t most_parts = 2000;

/// In a shorter stretch rounding is all that differences of velocities show [-], of the whole.
constexpr double shortest_stretch = 1e-6;

using StateVector = Eigen::Matrix<double, 6, 1>;

StateVector vector_of(const State& state) {
  StateVector result;
  result << state.position, state.angle, state.velocity, state.spin;
  return result;
}

/// The derivative of the state after an impact by a delay of it: what `before` flies on by is
/// resolved later, and `after` has flown less.
StateVector by_delay(const ReferenceCase& reference, const Event& event) {
  const Case& the_case = reference.the_case;
  const double moment = 1e-6 * std::min(1.0, reference.solution.end_time());  // [s]
  StateVector sum = StateVector::Zero();
  for (const double dt : {moment, -moment}) {
    const State late = resolve_impact(reference.law, the_case,
                                      fly(event.before, the_case.gravity, dt), event.cables)
                           .after;
    sum += (vector_of(late) - vector_of(fly(event.after, the_case.gravity, dt))) / (2.0 * dt);
  }
  return sum;
}

/// By what a scheme of first order is off per unit of time and step, `dt` [s] after the start of
/// `arc`: half of the acceleration as a rate of the pose, and, on taut cables, half of its rate as
/// a rate of the velocity. `moment` [s] is short against the arc.
StateVector defect(const Arc& arc, double dt, double moment, const Vec2& gravity) {
  StateVector result = StateVector::Zero();
  if (arc.taut.empty()) {
    result.head<2>() = 0.5 * gravity;
    return result;
  }
  const StateVector before = vector_of(arc.after(dt - moment, gravity));
  const StateVector here = vector_of(arc.after(dt, gravity));
  const StateVector after = vector_of(arc.after(dt + moment, gravity));
  result.head<3>() = (after - before).tail<3>() / (4.0 * moment);
  result.tail<3>() = (after - 2.0 * here + before).tail<3>() / (2.0 * moment * moment);
  return result;
}

/// The ends of `count` equal parts of a motion, and its events.
template <class TheSolution>
std::vector<double> instants(const TheSolution& solution, double end, std::size_t count = parts) {
  std::vector<double> times;
  for (std::size_t part = 0; part <= count; ++part) {
    times.push_back(part == count ? end
                                  : end * static_cast<double>(part) / static_cast<double>(count));
  }
  for (const auto& event : solution.events()) {
    if (event.time > 0.0 && event.time < end) {
      times.push_back(event.time);
    }
  }
  std::sort(times.begin(), times.end());
  times.erase(std::unique(times.begin(), times.end()), times.end());
  return times;
}

/// The largest acceleration of the body on taut cables [m/s^2], between some `times` [s].
double largest_acceleration(const std::vector<Arc>& arcs, const std::vector<double>& times,
                            const Vec2& gravity) {
  double largest = 0.0;
  std::size_t arc = 0;
  for (std::size_t place = 1; place < times.size(); ++place) {
    const double start = times[place - 1];
    const double length = times[place] - start;
    while (arc + 1 < arcs.size() && arcs[arc].end <= start) {
      ++arc;
    }
    if (arcs[arc].taut.empty() || length <= shortest_stretch * times.back()) {
      continue;
    }
    const double middle = start - arcs[arc].start + 0.5 * length;
    const Vec2 change = arcs[arc].after(middle + 0.25 * length, gravity).velocity -
                        arcs[arc].after(middle - 0.25 * length, gravity).velocity;
    largest = std::max(largest, change.norm() / (0.5 * length));
  }
  return largest;
}

/// The first near miss before `end` [s]: a gap that is least at an instant and no more than a part
/// of what a run may be off by then, or what it closes by in a step.
template <class TheReference>
std::optional<double> near_miss(const TheReference& reference, const Allowance& allowance,
                                double end) {
  const std::vector<double> times = instants(reference.solution, end, looks);
  std::vector<decltype(reference.the_case.initial)> states;
  states.reserve(times.size());
  for (const double time : times) {
    states.push_back(reference.solution.at(time));
  }
  std::optional<double> first;
  for (const auto& cable : reference.the_case.cables) {
    double earlier = 0.0;  // [m], the gap a look before
    double speed = 0.0;    // [m/s], at which it closed until then
    for (std::size_t place = 0; place < times.size(); ++place) {
      const double now = gap(cable, states[place]);
      // a scheme that looks a step ahead takes a cable for taut that closes by the gap in it
      const double near =
          guard_of_forks * allowance.of_cables(times[place]) + allowance.step * speed;
      if (speed > 0.0 && earlier <= now && std::isfinite(now) &&
          earlier > no_gap * length_of(cable, states[place]) && earlier < near) {
        first = std::min(first.value_or(end), times[place - 1]);
        break;
      }
      if (place > 0) {  // a cable that is hooked up then has come from nowhere
        speed = std::isfinite(earlier) ? (earlier - now) / (times[place] - times[place - 1]) : 0.0;
      }
      earlier = now;
    }
  }
  return first;
}

/// The first instant before `end` [s] at which impacts of two cables may swap. Cables that are
/// struck in one instant are struck together, which only the law that does so by itself is sure of.
template <class TheReference>
std::optional<double> swap_of_impacts(const TheReference& reference, const Allowance& allowance,
                                      double end) {
  const bool together = reference.law == ImpactLaw::simultaneous;
  const std::vector<ExactHit> hits = exact_hits(reference, end);
  for (std::size_t place = 1; place < hits.size(); ++place) {
    const ExactHit& one = hits[place - 1];
    const ExactHit& two = hits[place];
    if (one.cable == two.cable || (together && two.time == one.time)) {
      continue;
    }
    const double unsure =
        allowance.of_cables(one.time) / one.speed + allowance.of_cables(two.time) / two.speed;
    if (two.time == one.time || two.time - one.time < guard_of_forks * unsure) {
      return one.time;
    }
  }
  return std::nullopt;
}

/// The plain scheme with one shift of its first step.
template <class TheCase>
struct ShiftedRun {
  BasicPlainScheme<TheCase> scheme;
  double first;             // [s], its first step
  double time = 0.0;        // [s]
  double worst = 0.0;       // [m]
  double attachment = 0.0;  // [m]

  /// Compares it with the `exact` state of now.
  void compare(const StateOf<TheCase>& exact) {
    worst = std::max(worst, apart(scheme.state(), exact));
    for (const auto& cable : scheme.system().cables) {
      attachment = std::max(attachment, ends_apart(cable, scheme.state(), exact));
    }
  }
};

/// How far the attachment point of `cable` moves by a small change of the state [m].
double moves(const State& state, const Cable& cable, const StateVector& change) {
  return (change.head<2>() + change[2] * perpendicular(attachment_arm(state, cable))).norm();
}

/// The first of `times` at which one of `values` has reached `enough`.
std::optional<double> reaching(const AlongMotion& along, double enough) {
  const auto found = std::find_if(along.values.begin(), along.values.end(),
                                  [enough](double value) { return value >= enough; });
  return found == along.values.end()
             ? std::nullopt
             : std::optional(along.times[static_cast<std::size_t>(found - along.values.begin())]);
}

/// The larger of `measured`, that many times, and what `tangent` says for `step`, as far as it
/// goes, with what `rounding` [m/s] adds.
AlongMotion largest_of(const std::vector<double>& times, const std::vector<double>& measured,
                       double often, const AlongMotion& tangent, double step, double rounding) {
  AlongMotion result{times, measured};
  double largest = 0.0;
  for (std::size_t place = 0; place < times.size(); ++place) {
    double& value = result.values[place];
    value *= often;
    if (times[place] <= tangent.times.back()) {
      value = std::max(value, step * tangent.at(times[place]));
    }
    value = largest = std::max(largest, value + rounding * times[place]);
  }
  return result;
}

}  // namespace

template <class TheReference>
std::vector<ExactHit> exact_hits(const TheReference& reference, double until) {
  std::vector<ExactHit> hits;
  const auto& the_case = reference.the_case;
  for (const auto& event : reference.solution.events()) {
    if (event.kind != EventKind::impact || event.time > until) {
      continue;
    }
    for (const std::size_t index : event.cables) {
      const auto& cable = the_case.cables[index];
      const double rate = gap_rate(cable, event.before);
      hits.push_back(
          {event.time, index, -rate, gap_rate(cable, event.after), restitution(cable, rate),
           change_of_rates(the_case, index, event.before, event.after), event.cables.size() == 1});
    }
  }
  return hits;
}

double AlongMotion::at(double time) const {
  const auto found = std::lower_bound(times.begin(), times.end(), time);
  return found == times.end() ? values.back()
                              : values[static_cast<std::size_t>(found - times.begin())];
}

template <class TheReference>
Yardstick yardstick(const TheReference& reference, double step, const std::vector<double>& times,
                    double enough) {
  using TheCase = std::remove_cvref_t<decltype(reference.the_case)>;
  using Scheme = BasicPlainScheme<TheCase>;
  const auto& solution = reference.solution;
  const double end = solution.end_time();
  const bool few = is_system<TheReference> || times.back() / step > many_steps;
  const int count = few ? few_shifts : shifts;
  std::vector<ShiftedRun<TheCase>> runs;
  for (const auto acts : {Scheme::Acts::late, Scheme::Acts::early}) {
    for (int shift = 0; shift < count; ++shift) {
      runs.push_back({Scheme(reference.the_case, acts), step * (shift + 0.5) / count});
    }
  }
  Yardstick result;
  for (const double until : times) {
    double worst = 0.0;
    double attachment = 0.0;
    double sum = 0.0;
    for (auto& run : runs) {
      while (run.time < until) {
        const double dt = run.time == 0.0 ? run.first : step;
        run.scheme.step(dt);
        run.time += dt;
        if (run.time <= end) {
          run.compare(solution.at(run.time));
        }
      }
      worst = std::max(worst, run.worst);
      attachment = std::max(attachment, run.attachment);
      sum += run.worst;
    }
    result.worst.push_back(worst);
    result.mean.push_back(sum / static_cast<double>(runs.size()));
    result.attachment.push_back(attachment);
    if (!(attachment < enough)) {
      break;
    }
  }
  return result;
}

template <class TheReference>
BasicExpectation<TheReference>::BasicExpectation(const TheReference& reference)
    : reference_(reference), end_(std::min(reference.solution.end_time(), reference.horizon)) {
  follow();
}

/// Carries what a step and what rounding is off by along the motion.
template <>
void BasicExpectation<ReferenceCase>::follow() {
  const Case& the_case = reference_.the_case;
  const Solution& solution = reference_.solution;
  const std::vector<double> times = instants(solution, end_);
  double fastest = 0.0;  // [m/s], of a cable
  double spin = 0.0;     // [rad/s], the largest
  double angle = 1.0;    // [rad]
  for (const Event& event : solution.events()) {
    fastest = std::max(fastest, closing_speed(the_case, event.cables, event.before));
  }
  speed_ = fastest;
  acceleration_ = the_case.gravity.norm();
  for (const ExactHit& hit : exact_hits(reference_, end_)) {
    change_ = std::max(change_, hit.change);
  }
  for (const double time : times) {
    const State state = solution.at(time);
    speed_ = std::max(speed_, state.velocity.norm());
    for (const Cable& cable : the_case.cables) {
      speed_ = std::max(speed_, attachment_velocity(state, cable).norm());
      turning_ = std::max(turning_, state.spin * state.spin * cable.attachment.norm());
    }
    extent_ = std::max(extent_, state.position.norm());
    spin = std::max(spin, std::abs(state.spin));
    angle = std::max(angle, std::abs(state.angle));
  }
  StateVector rounding;
  rounding << extent_, extent_, angle, speed_, speed_, spin;
  const StateMatrix squares = rounding.cwiseAbs2().asDiagonal();
  const Sensitivity sensitivity(the_case, solution, reference_.law);
  const std::vector<Arc> arcs = solution.arcs_until(end_);
  acceleration_ = std::max(acceleration_, largest_acceleration(arcs, times, the_case.gravity));
  std::vector<StateVector> parts_of_error;  // of impacts and arcs
  StateMatrix of_steps = StateMatrix::Zero();
  StateMatrix of_events = squares;
  double largest = 0.0;
  double largest_of_cables = 0.0;
  double largest_of_steps = 0.0;
  double largest_of_events = 0.0;
  const auto note = [&](double time) {
    double sum = 0.0;
    for (const StateVector& part : parts_of_error) {
      sum += part.head<2>().norm();
    }
    largest = std::max(largest, sum);
    const State state = solution.at(time);
    for (const Cable& cable : the_case.cables) {
      double of_cable = 0.0;
      for (const StateVector& part : parts_of_error) {
        of_cable += moves(state, cable, part);
      }
      largest_of_cables = std::max(largest_of_cables, of_cable);
    }
    largest_of_steps = std::max(largest_of_steps, of_steps.topLeftCorner<2, 2>().trace());
    largest_of_events = std::max(largest_of_events, of_events.topLeftCorner<2, 2>().trace());
    for (auto* along : {&tangent_, &of_cables_, &by_steps_, &by_events_}) {
      along->times.push_back(time);
    }
    tangent_.values.push_back(largest);
    of_cables_.values.push_back(largest_of_cables);
    by_steps_.values.push_back(largest_of_steps);
    by_events_.values.push_back(largest_of_events);
  };
  note(0.0);
  std::size_t arc = 0;
  std::size_t event = 0;
  const auto& events = solution.events();
  bool fresh = true;  // no part for the arc yet
  for (std::size_t place = 1; place < times.size(); ++place) {
    const double start = times[place - 1];
    const double length = times[place] - start;
    while (arc + 1 < arcs.size() && arcs[arc].end <= start) {
      ++arc;
      fresh = true;
    }
    if (fresh) {
      parts_of_error.emplace_back(StateVector::Zero());
      fresh = false;
    }
    const Arc& here = arcs[arc];
    const double middle = start - here.start + 0.5 * length;
    if (here.taut.empty() || length > shortest_stretch * end_) {
      parts_of_error.back() += length * defect(here, middle, 0.25 * length, the_case.gravity);
    }
    of_steps += length * squares;
    const StateMatrix flow = sensitivity.between(start, times[place]);
    if (!flow.allFinite() || parts_of_error.size() > most_parts) {
      break;  // no derivative exists, or it costs too much: the yardstick alone says what is
              // allowed
    }
    for (StateVector& part : parts_of_error) {
      part = (flow * part).eval();
    }
    of_steps = (flow * of_steps * flow.transpose()).eval();
    of_events = (flow * of_events * flow.transpose()).eval();
    bool struck = false;
    for (; event < events.size() && events[event].time <= times[place]; ++event) {
      if (events[event].kind == EventKind::impact &&
          closing_speed(the_case, events[event].cables, events[event].before) >= slow * fastest) {
        const StateVector delayed = by_delay(reference_, events[event]);
        parts_of_error.insert(parts_of_error.end() - 1, delayed);
        struck = true;
      }
    }
    if (struck) {
      of_events += squares;
    }
    note(times[place]);
  }
}

/// Notes how fast and how far the bodies move.
template <>
void BasicExpectation<ReferenceSystem>::follow() {
  const SpatialSystem& system = reference_.the_case;
  const auto& solution = reference_.solution;
  for (const ExactHit& hit : exact_hits(reference_, end_)) {
    speed_ = std::max(speed_, hit.speed);
    change_ = std::max(change_, hit.change);
  }
  const std::vector<double> times = instants(solution, end_);
  for (std::size_t place = 0; place < times.size(); ++place) {
    const SpatialSystemState state = solution.at(times[place]);
    const RowOf<SpatialSystem> falling = free_accelerations(system, state);
    for (std::size_t index = 0; index < state.bodies.size(); ++index) {
      const SpatialState& body = state.bodies[index];
      speed_ = std::max(speed_, body.velocity.norm());
      extent_ = std::max(extent_, body.position.norm());
      acceleration_ = std::max(
          acceleration_,
          falling.segment<3>(static_cast<Eigen::Index>(index) * freedoms_of_body<3>).norm());
    }
    for (const SpatialCable& cable : system.cables) {
      for (std::size_t end = 0; end <= cable.segments(); ++end) {
        speed_ = std::max(speed_, moving_point(cable.end(end), state).velocity.norm());
        if (const auto& body = cable.end(end).body) {
          turning_ =
              std::max(turning_, state.bodies[*body].spin.squaredNorm() * cable.end(end).at.norm());
        }
      }
    }
    const double length = place > 0 ? times[place] - times[place - 1] : 0.0;
    if (length > shortest_stretch * end_) {  // on taut cables
      const SpatialSystemState late = solution.at(times[place] - 0.25 * length);
      const SpatialSystemState early = solution.at(times[place] - 0.75 * length);
      for (std::size_t index = 0; index < state.bodies.size(); ++index) {
        const double change = (late.bodies[index].velocity - early.bodies[index].velocity).norm();
        acceleration_ = std::max(acceleration_, change / (0.5 * length));
      }
    }
  }
  for (auto* along : {&tangent_, &of_cables_, &by_steps_, &by_events_}) {
    *along = {{0.0}, {0.0}};
  }
}

template <class TheReference>
double BasicExpectation<TheReference>::rounding_at(double time, double step) const {
  return std::sqrt(by_steps_.at(time) / step + by_events_.at(time));
}

template <class TheReference>
Allowance BasicExpectation<TheReference>::made(double step, double rounding) const {
  const double enough = too_much * shortest_cable(reference_.the_case);
  Allowance result;
  result.step = step;
  const double end = std::min(end_, most_steps_judged * step);
  std::vector<double> times = instants(reference_.solution, end);
  const Yardstick plain = yardstick(reference_, step, times, enough);
  times.resize(plain.worst.size());
  const double drift = rounding * extent_ / step;  // [m/s]
  const double often = of_yardstick<TheReference>;
  result.position = largest_of(times, plain.worst, often, tangent_, step, drift);
  result.attachment = largest_of(times, plain.attachment, often, of_cables_, step, drift);
  const std::optional<double> grown = reaching(result.attachment, enough);
  result.barrier = grown ? Barrier::growth : end < end_ ? Barrier::effort : Barrier::end;
  result.until = grown.value_or(end);
  for (const auto& fork : {near_miss(reference_, result, result.until),
                           swap_of_impacts(reference_, result, result.until)}) {
    if (fork && *fork - 2.0 * step < result.until) {
      result.until = std::max(0.0, *fork - 2.0 * step);
      result.barrier = Barrier::fork;
    }
  }
  return result;
}

Expectations expectations_of(const std::vector<Reference>& references) {
  Expectations result;
  for (const Reference& reference : references) {
    std::visit(
        [&](const auto& one) {
          using TheReference = std::remove_cvref_t<decltype(one)>;
          result.emplace_back(std::in_place_type<BasicExpectation<TheReference>>, one);
        },
        reference);
  }
  return result;
}

template <class TheReference>
const Allowance& BasicExpectation<TheReference>::allowance(double step,
                                                           std::string_view precision) const {
  const std::pair key(step, rounding_of(precision));
  const std::scoped_lock lock(guard_);
  const auto found = allowances_.find(key);
  return found != allowances_.end()
             ? found->second
             : allowances_.emplace(key, made(key.first, key.second)).first->second;
}

double rounding_of(std::string_view precision) { return precision == "float32" ? 6e-8 : 1.2e-16; }

template class BasicExpectation<ReferenceCase>;
template class BasicExpectation<ReferenceSystem>;
template std::vector<ExactHit> exact_hits(const ReferenceCase&, double);
template std::vector<ExactHit> exact_hits(const ReferenceSystem&, double);
template Yardstick yardstick(const ReferenceCase&, double, const std::vector<double>&, double);
template Yardstick yardstick(const ReferenceSystem&, double, const std::vector<double>&, double);

}  // namespace tautline::bench
