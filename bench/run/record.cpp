#include "bench/run/record.hpp"

#include <algorithm>
#include <cmath>
#include <limits>
#include <stdexcept>
#include <string>
#include <utility>
#include <vector>

#include "tautline/case_or_system.hpp"

namespace tautline::bench {
namespace {

/// An impulse below this fraction of mass times speed is a solver's rounding, not a pull [-].
constexpr double least_impulse = 1e-12;

/// How fast gravity, forces and drag change a gap rate in a step, at most as they are at `state`
/// [m/s^2].
double pull_of_gravity(const Case& the_case, const State& /*state*/) {
  return the_case.gravity.norm();
}
double pull_of_gravity(const SpatialSystem& system, const SpatialSystemState& state) {
  const RowOf<SpatialSystem> accelerations = free_accelerations(system, state);
  double largest = 0.0;
  for (Eigen::Index row = 0; row < accelerations.size(); row += 6) {
    largest = std::max(largest, accelerations.segment<3>(row).norm());
  }
  return largest;
}

/// The impulse that the case makes likely at most [N s].
double likely_impulse(const Case& the_case) {
  double longest = 0.0;
  for (const Cable& cable : the_case.cables) {
    longest = std::max(longest, cable.length);
  }
  const double speed =
      speed_scale(the_case, the_case.initial) + std::sqrt(the_case.gravity.norm() * longest);
  return the_case.body.mass * speed;
}

double length_at_start(const SpatialCable& cable) { return cable.length.at(0.0)[0]; }

/// In a system the lightest body counts.
double likely_impulse(const SpatialSystem& system) {
  return std::ranges::min_element(system.bodies, {}, &SpatialBody::mass)->mass *
         likely_speed(system);
}

/// The state of `simulation` at `time` [s], which a system's state has, too.
State state_at(const Simulation& simulation, double /*time*/) { return simulation.state(); }
SpatialSystemState state_at(const SystemSimulation& simulation, double time) {
  SpatialSystemState result = simulation.state();
  result.time = time;
  return result;
}

/// Turns impulses and located events into impacts, step by step.
template <class TheCase>
class ImpactDetector {
 public:
  using State = StateOf<TheCase>;
  using RecordedImpact = BasicRecordedImpact<TheCase>;

  /// Impacts that close slower than `slowest` [m/s] are only counted.
  ImpactDetector(const TheCase& the_case, double slowest);

  /// Takes one step from `before` at `start` to `after`. Throws std::runtime_error if what the
  /// simulation says of it makes no sense.
  void take(double start, double dt, const State& before, const State& after,
            const BasicSimulation<TheCase>& simulation);

  /// Puts the impacts of the whole run into `run`, in rising time.
  void finish(BasicTrajectory<TheCase>& run);

 private:
  void take_located(const BasicEvent<TheCase>& event);
  [[nodiscard]] Eigen::Vector3d unexplained(const State& before, const State& after,
                                            std::span<const double> impulses, double dt) const;
  void extend(std::size_t index, double start, double dt, const State& before, const State& after,
              double impulse);
  void close(std::size_t index);
  void keep(const RecordedImpact& impact);

  const TheCase& case_;
  double slowest_;                                     // [m/s]
  std::vector<std::optional<RecordedImpact>> bursts_;  // one per cable: the impact now going on
  std::vector<bool> turned_;                           // of each burst: it closes no more
  double threshold_;                                   // [N s]
  std::vector<RecordedImpact> impacts_;
  std::size_t slow_impacts_ = 0;
};

/// True if an instant that an engine names is one of the run's, but for rounding.
bool within_run(const auto& the_case, double time) {
  constexpr double rounding = 1e-9;  // [-]
  return time >= 0.0 && time <= the_case.duration * (1.0 + rounding);
}

template <class TheCase>
ImpactDetector<TheCase>::ImpactDetector(const TheCase& the_case, double slowest)
    : case_(the_case),
      slowest_(slowest),
      bursts_(the_case.cables.size()),
      turned_(the_case.cables.size()),
      threshold_(least_impulse * likely_impulse(the_case)) {}

template <class TheCase>
void ImpactDetector<TheCase>::take(double start, double dt, const State& before, const State& after,
                                   const BasicSimulation<TheCase>& simulation) {
  if (!simulation.events().empty()) {
    for (const BasicEvent<TheCase>& event : simulation.events()) {
      take_located(event);
    }
    return;
  }
  const auto impulses = simulation.impulses();
  if (impulses.size() != bursts_.size()) {
    throw std::runtime_error("the engine gave " + std::to_string(impulses.size()) +
                             " impulses for " + std::to_string(bursts_.size()) + " cables");
  }
  const Eigen::Vector3d stray = unexplained(before, after, impulses, dt);
  const auto hits = [&](std::size_t index) {
    return impulses[index] > threshold_ && !is_elastic(case_.cables[index]);
  };
  std::size_t hit = 0;
  for (std::size_t index = 0; index < bursts_.size(); ++index) {
    hit += hits(index) ? 1U : 0U;
  }
  const bool shared = hit > 1;
  for (std::size_t index = 0; index < bursts_.size(); ++index) {
    if (hits(index)) {
      extend(index, start, dt, before, after, impulses[index]);
      bursts_[index]->stray += stray;
      bursts_[index]->shared = bursts_[index]->shared || shared;
    } else {
      close(index);
    }
  }
}

template <class TheCase>
void ImpactDetector<TheCase>::finish(BasicTrajectory<TheCase>& run) {
  for (std::size_t index = 0; index < bursts_.size(); ++index) {
    close(index);
  }
  std::stable_sort(impacts_.begin(), impacts_.end(),
                   [](const auto& a, const auto& b) { return a.time < b.time; });
  run.impacts = std::move(impacts_);
  run.slow_impacts = slow_impacts_;
}

template <class TheCase>
void ImpactDetector<TheCase>::take_located(const BasicEvent<TheCase>& event) {
  if (event.kind != EventKind::impact) {
    return;
  }
  const auto cables = event.cables.indices();
  if (cables.empty() || cables.back() >= case_.cables.size() ||
      event.impulses.size() != static_cast<Eigen::Index>(cables.size()) ||
      !within_run(case_, event.time)) {
    throw std::runtime_error("the engine gave an event that is not of this case");
  }
  std::vector<double> impulses(case_.cables.size(), 0.0);
  Eigen::Index row = 0;
  for (const std::size_t index : cables) {
    impulses[index] = event.impulses[row++];
  }
  const Eigen::Vector3d stray = unexplained(event.before, event.after, impulses, 0.0);
  for (const std::size_t index : cables) {
    const auto& cable = case_.cables[index];
    keep({event.time, index, impulses[index], gap_rate(cable, event.before),
          gap_rate(cable, event.after), 0, event.before, event.after, stray, event.time,
          cables.size() > 1, impulses[index], gap_rate(cable, event.after)});
  }
}

/// The change of momentum from `before` to `after`, less what gravity gives in `dt` [s] and less
/// `impulses` [N s] along the cables as they are at `before`.
template <class TheCase>
Eigen::Vector3d ImpactDetector<TheCase>::unexplained(
    [[maybe_unused]] const State& before, [[maybe_unused]] const State& after,
    [[maybe_unused]] std::span<const double> impulses, [[maybe_unused]] double dt) const {
  if constexpr (TheCase::has_several_bodies) {
    return Eigen::Vector3d::Zero();
  } else {
    Eigen::Vector3d result;
    result << case_.body.mass * (after.velocity - before.velocity - dt * case_.gravity),
        case_.body.inertia * (after.spin - before.spin);
    for (std::size_t index = 0; index < impulses.size(); ++index) {
      if (impulses[index] > 0.0) {
        result -= impulses[index] * gap_gradient(case_.cables[index], before);
      }
    }
    return result;
  }
}

/// The rates are of the engine's own velocities before and after the step, at the pose the step
/// started from: an engine bounces the velocity it stores, so this is its restitution as it means
/// it.
template <class TheCase>
void ImpactDetector<TheCase>::extend(std::size_t index, double start, double dt,
                                     const State& before, const State& after, double impulse) {
  const auto& cable = case_.cables[index];
  std::optional<RecordedImpact>& burst = bursts_[index];
  if (!burst) {
    burst = RecordedImpact{start, index, 0.0, gap_rate(cable, before), 0.0, 0, before, before};
    burst->snap = 0.0;
  }
  burst->ended = start;
  burst->after = with_velocities(before, after);
  burst->rate_after = gap_rate(cable, burst->after);
  if (burst->steps == 0) {
    burst->rate_first = burst->rate_after;
  }
  if (burst->steps == 0 || !turned_[index]) {
    burst->snap += impulse;
    // an engine may give a part of gravity's impulse after the cable has stopped the body
    turned_[index] = burst->rate_after > -(slowest_ + dt * pull_of_gravity(case_, before));
  }
  burst->impulse += impulse;
  ++burst->steps;
}

template <class TheCase>
void ImpactDetector<TheCase>::close(std::size_t index) {
  if (bursts_[index]) {
    if (bursts_[index]->rate_after > slowest_) {  // thrown back: all of it was the impact
      bursts_[index]->snap = bursts_[index]->impulse;
    }
    keep(*bursts_[index]);
    bursts_[index].reset();
  }
}

template <class TheCase>
void ImpactDetector<TheCase>::keep(const RecordedImpact& impact) {
  if (-impact.rate_before >= slowest_) {
    impacts_.push_back(impact);
  } else {
    ++slow_impacts_;
  }
}

/// A run is stopped as diverged where the body is further out than this many times the size of the
/// case [-].
constexpr double far_away = 1e3;

/// The body is finite and within `far_away` sizes of the case of where it can be.
bool reasonable(const Case& the_case, const State& state) {
  double size = 0.0;
  for (const Cable& cable : the_case.cables) {
    size = std::max(size, cable.length + cable.anchor.norm() + cable.attachment.norm());
  }
  const double distance = state.position.norm();
  return std::isfinite(distance) && std::isfinite(state.angle) && std::isfinite(state.spin) &&
         std::isfinite(state.velocity.norm()) && distance <= far_away * size;
}

/// In a system each body; where none holds it, it may fly as far as it gets.
bool reasonable(const SpatialSystem& system, const SpatialSystemState& state) {
  double size = 0.0;
  for (const SpatialCable& cable : system.cables) {
    size = std::max(size, length_at_start(cable));
    for (std::size_t i = 0; i <= cable.segments(); ++i) {
      size = std::max(size, cable.end(i).at.norm());
    }
  }
  const double duration = system.duration;
  size += 0.5 * duration * duration * pull_of_gravity(system, system.initial);
  for (const SpatialState& body : system.initial.bodies) {
    size = std::max(size, body.position.norm() + duration * body.velocity.norm());
  }
  for (const SpatialState& body : state.bodies) {
    const bool fine = std::isfinite(body.position.norm()) && std::isfinite(body.spin.norm()) &&
                      std::isfinite(body.orientation.norm()) &&
                      std::isfinite(body.velocity.norm()) &&
                      body.position.norm() <= far_away * size;
    if (!fine) {
      return false;
    }
  }
  return true;
}

template <class TheCase>
double worst_overstretch(const TheCase& the_case, const StateOf<TheCase>& state) {
  double worst = 0.0;
  for (const auto& cable : the_case.cables) {
    worst = is_elastic(cable) ? worst : std::max(worst, -gap(cable, state));
  }
  return worst;
}

/// The rate of the gap, also right before a cable is hooked up and after it is cut.
double rate_in_step(SpatialCable cable, const SpatialSystemState& state) {
  cable.from_time = cable.cut_at = std::nullopt;
  return gap_rate(cable, state);
}
double rate_in_step(const Cable& cable, const State& state) { return gap_rate(cable, state); }

/// The contacts of elastic cables, from the impulses of the steps.
template <class TheCase>
class ContactRecorder {
 public:
  ContactRecorder(const TheCase& the_case, const BasicSimulation<TheCase>& simulation,
                  std::vector<ElasticContact>& contacts)
      : case_(the_case),
        simulation_(simulation),
        told_(dynamic_cast<const TensionImpulses*>(&simulation)),
        open_(the_case.cables.size()),
        contacts_(contacts) {}

  /// Takes one step from `before` at `start` to `after`.
  void take(double start, double dt, const StateOf<TheCase>& before,
            const StateOf<TheCase>& after) {
    const auto impulses =
        told_ != nullptr ? told_->tension_impulses() : simulation_.impulses();  // [N s]
    // a step with located events may have none
    for (std::size_t index = 0; index < std::min(open_.size(), impulses.size()); ++index) {
      const auto& cable = case_.cables[index];
      if (!is_elastic(cable)) {
        continue;
      }
      std::optional<ElasticContact>& contact = open_[index];
      // with the cut `stretch` the impulse may be below 0 before the cable is slack, and with
      // `never` it goes on after: only what a stretched cable does is of the contact
      const bool stretched = gap(cable, after) < 0.0;
      const bool acts = impulses[index] > 0.0 ? stretched || gap(cable, before) < 0.0
                                              : impulses[index] < 0.0 && stretched;
      if (!acts) {
        close(contact, start, rate_in_step(cable, before));
        continue;
      }
      if (!contact) {
        contact = ElasticContact{
            .cable = index, .entry = start, .entry_speed = -rate_in_step(cable, before)};
      }
      contact->impulse += impulses[index];
      if (impulses[index] / dt > contact->peak) {
        contact->peak = impulses[index] / dt;
        contact->peak_time = start + 0.5 * dt;
      }
      contact->greatest_stretch =
          std::max({contact->greatest_stretch, -gap(cable, before), -gap(cable, after)});
    }
  }

  /// Those that go on have no exit.
  void finish() {
    for (const std::optional<ElasticContact>& contact : open_) {
      if (contact) {
        contacts_.push_back(*contact);
      }
    }
    std::ranges::stable_sort(contacts_, {}, &ElasticContact::entry);
  }

 private:
  void close(std::optional<ElasticContact>& contact, double exit, double speed) {
    if (contact) {
      contact->exit = exit;
      contact->exit_speed = speed;
      contacts_.push_back(*contact);
      contact.reset();
    }
  }

  const TheCase& case_;
  const BasicSimulation<TheCase>& simulation_;
  const TensionImpulses* told_;  // null: elastic cables are in the impulses of the simulation
  std::vector<std::optional<ElasticContact>> open_;  // by cable
  std::vector<ElasticContact>& contacts_;
};

/// The tensions of a run, from the impulses of its steps.
template <class TheCase>
class TensionRecorder {
 public:
  TensionRecorder(const TheCase& the_case, const BasicSimulation<TheCase>& simulation,
                  BasicTrajectory<TheCase>& run)
      : told_(dynamic_cast<const TensionImpulses*>(&simulation)),
        sums_(the_case.cables.size()),
        run_(run) {
    if (told_ != nullptr) {
      run_.tensions.assign(sums_.size(), std::numeric_limits<double>::quiet_NaN());
    }
  }

  void take_step() {
    if (told_ == nullptr) {
      return;
    }
    const auto impulses = told_->tension_impulses();
    if (impulses.size() != sums_.size()) {
      throw std::runtime_error("the engine gave " + std::to_string(impulses.size()) +
                               " impulses of tensions for " + std::to_string(sums_.size()) +
                               " cables");
    }
    for (std::size_t index = 0; index < sums_.size(); ++index) {
      sums_[index] += impulses[index];
    }
  }

  /// The last two points of the run are the ends of the stretch.
  void take_point() {
    if (told_ == nullptr) {
      return;
    }
    const double length = run_.points.back().time - run_.points.end()[-2].time;
    for (double& sum : sums_) {
      run_.tensions.push_back(sum / length);
      sum = 0.0;
    }
  }

 private:
  const TensionImpulses* told_;  // null: of none
  std::vector<double> sums_;     // [N s], since the last point
  BasicTrajectory<TheCase>& run_;
};

}  // namespace

template <class TheCase>
std::vector<SoftRow> soft_rows_of(const TheCase& the_case,
                                  const BasicSimulation<TheCase>& simulation) {
  const auto* const soft = dynamic_cast<const SoftCables*>(&simulation);
  if (soft == nullptr) {
    return {};
  }
  const auto rows = soft->soft_rows();
  if (!rows.empty() && rows.size() != the_case.cables.size()) {
    throw std::runtime_error("the engine gave " + std::to_string(rows.size()) + " soft rows for " +
                             std::to_string(the_case.cables.size()) + " cables");
  }
  for (const SoftRow& row : rows) {
    if (!(row.stiffness > 0.0 && std::isfinite(row.stiffness) && row.damping >= 0.0 &&
          std::isfinite(row.damping) && row.load >= 0.0 && row.load <= 1.0)) {
      throw std::runtime_error("the engine gave a soft row that is no spring and damper");
    }
  }
  return {rows.begin(), rows.end()};
}

double likely_speed(const SpatialSystem& system) {
  double longest = 0.0;
  for (const SpatialCable& cable : system.cables) {
    longest = std::max(longest, length_at_start(cable));
  }
  double fastest = std::sqrt(pull_of_gravity(system, system.initial) * longest);
  for (const SpatialState& body : system.initial.bodies) {
    fastest = std::max(fastest, body.velocity.norm() + body.spin.norm() * longest);
  }
  constexpr int instants = 50;  // at which moving ends and winches are looked at
  SpatialSystemState still = standing_still(system.initial);
  for (int k = 0; k <= instants; ++k) {
    still.time = system.duration * k / instants;
    for (const SpatialCable& cable : system.cables) {
      fastest = std::max(fastest, std::abs(gap_rate(cable, still)));
    }
  }
  return fastest;
}

std::size_t step_count(double duration, double step) {
  constexpr double same = 1e-9;  // [-]: 20 / 1e-3 is 20000 steps, not 20001 for a last bit
  return std::max<std::size_t>(1, static_cast<std::size_t>(std::ceil(duration / step - same)));
}

template <class TheCase>
BasicTrajectory<TheCase> record(const TheCase& the_case,
                                std::type_identity_t<BasicSimulation<TheCase>>& simulation,
                                double step, const RecordOptions& options) {
  const std::size_t steps = step_count(the_case.duration, step);
  BasicTrajectory<TheCase> run;
  run.step = step;
  run.stride = (steps + options.most_points - 1) / options.most_points;
  run.points.reserve(steps / run.stride + 2);
  StateOf<TheCase> now = state_at(simulation, 0.0);
  run.points.push_back({0.0, now});
  run.largest_energy = energy(the_case, now);
  run.stop = simulation.stopped();
  run.soft_rows = soft_rows_of(the_case, simulation);
  ImpactDetector<TheCase> detector(the_case, options.slowest);
  TensionRecorder<TheCase> tensions(the_case, simulation, run);
  ContactRecorder<TheCase> contacts(the_case, simulation, run.contacts);
  for (std::size_t index = 0; index < steps && !run.stop; ++index) {
    const double start = static_cast<double>(index) * step;
    const bool last = index + 1 == steps;
    const StateOf<TheCase> before = now;
    const double dt = last ? the_case.duration - start : step;
    const double end = last ? the_case.duration : static_cast<double>(index + 1) * step;
    simulation.step(dt);
    run.stop = simulation.stopped();
    now = state_at(simulation, run.stop ? run.stop->time : end);
    if (!reasonable(the_case, now)) {
      run.diverged = true;
      break;
    }
    detector.take(start, dt, before, now, simulation);
    tensions.take_step();
    contacts.take(start, dt, before, now);
    run.overstretch = std::max(run.overstretch, worst_overstretch(the_case, now));
    run.largest_energy = std::max(run.largest_energy, energy(the_case, now));
    if (last || run.stop || (index + 1) % run.stride == 0) {
      run.points.push_back({run.stop ? run.stop->time : end, now});
      tensions.take_point();
    }
  }
  if (run.stop && !within_run(the_case, run.stop->time)) {
    throw std::runtime_error("the engine stopped at a time that is not in the run");
  }
  detector.finish(run);
  contacts.finish();
  return run;
}

template Trajectory record(const Case&, Simulation&, double, const RecordOptions&);
template SystemTrajectory record(const SpatialSystem&, SystemSimulation&, double,
                                 const RecordOptions&);
template std::vector<SoftRow> soft_rows_of(const Case&, const Simulation&);
template std::vector<SoftRow> soft_rows_of(const SpatialSystem&, const SystemSimulation&);

}  // namespace tautline::bench
