#include "bench/run/record.hpp"

#include <algorithm>
#include <cmath>
#include <limits>
#include <stdexcept>
#include <string>
#include <utility>
#include <vector>

#include "tautline/geometry.hpp"

namespace tautline::bench {
namespace {

/// An impulse below this fraction of mass times speed is a solver's rounding, not a pull [-].
constexpr double least_impulse = 1e-12;

/// The largest speed that the case makes likely [m/s].
double speed(const Case& the_case) {
  double longest = 0.0;
  for (const Cable& cable : the_case.cables) {
    longest = std::max(longest, cable.length);
  }
  return speed_scale(the_case, the_case.initial) + std::sqrt(the_case.gravity.norm() * longest);
}

/// Turns impulses and located events into impacts, step by step.
class ImpactDetector {
 public:
  /// Impacts that close slower than `slowest` [m/s] are only counted.
  ImpactDetector(const Case& the_case, double slowest);

  /// Takes one step from `before` at `start` to `after`. Throws std::runtime_error if what the
  /// simulation says of it makes no sense.
  void take(double start, double dt, const State& before, const State& after,
            const Simulation& simulation);

  /// Puts the impacts of the whole run into `run`, in rising time.
  void finish(Trajectory& run);

 private:
  void take_located(const Event& event);
  [[nodiscard]] Eigen::Vector3d unexplained(const State& before, const State& after,
                                            std::span<const double> impulses, double dt) const;
  void extend(std::size_t index, double start, double dt, const State& before, const State& after,
              double impulse);
  void close(std::size_t index);
  void keep(const RecordedImpact& impact);

  const Case& case_;
  double slowest_;                                     // [m/s]
  std::vector<std::optional<RecordedImpact>> bursts_;  // one per cable: the impact now going on
  std::vector<bool> turned_;                           // of each burst: it closes no more
  double threshold_;                                   // [N s]
  std::vector<RecordedImpact> impacts_;
  std::size_t slow_impacts_ = 0;
};

/// True if an instant that an engine names is one of the run's, but for rounding.
bool within_run(const Case& the_case, double time) {
  constexpr double rounding = 1e-9;  // [-]
  return time >= 0.0 && time <= the_case.duration * (1.0 + rounding);
}

ImpactDetector::ImpactDetector(const Case& the_case, double slowest)
    : case_(the_case),
      slowest_(slowest),
      bursts_(the_case.cables.size()),
      turned_(the_case.cables.size()),
      threshold_(least_impulse * the_case.body.mass * speed(the_case)) {}

void ImpactDetector::take(double start, double dt, const State& before, const State& after,
                          const Simulation& simulation) {
  if (!simulation.events().empty()) {
    for (const Event& event : simulation.events()) {
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
  const bool shared = std::count_if(impulses.begin(), impulses.end(),
                                    [this](double impulse) { return impulse > threshold_; }) > 1;
  for (std::size_t index = 0; index < bursts_.size(); ++index) {
    if (impulses[index] > threshold_) {
      extend(index, start, dt, before, after, impulses[index]);
      bursts_[index]->stray += stray;
      bursts_[index]->shared = bursts_[index]->shared || shared;
    } else {
      close(index);
    }
  }
}

void ImpactDetector::finish(Trajectory& run) {
  for (std::size_t index = 0; index < bursts_.size(); ++index) {
    close(index);
  }
  std::stable_sort(impacts_.begin(), impacts_.end(),
                   [](const auto& a, const auto& b) { return a.time < b.time; });
  run.impacts = std::move(impacts_);
  run.slow_impacts = slow_impacts_;
}

void ImpactDetector::take_located(const Event& event) {
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
    const Cable& cable = case_.cables[index];
    keep({event.time, index, impulses[index], gap_rate(cable, event.before),
          gap_rate(cable, event.after), 0, event.before, event.after, stray, event.time,
          cables.size() > 1, impulses[index], gap_rate(cable, event.after)});
  }
}

/// The change of momentum from `before` to `after`, less what gravity gives in `dt` [s] and less
/// `impulses` [N s] along the cables as they are at `before`.
Eigen::Vector3d ImpactDetector::unexplained(const State& before, const State& after,
                                            std::span<const double> impulses, double dt) const {
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

/// The rates are of the engine's own velocities before and after the step, at the pose the step
/// started from: an engine bounces the velocity it stores, so this is its restitution as it means
/// it.
void ImpactDetector::extend(std::size_t index, double start, double dt, const State& before,
                            const State& after, double impulse) {
  const Cable& cable = case_.cables[index];
  std::optional<RecordedImpact>& burst = bursts_[index];
  if (!burst) {
    burst = RecordedImpact{start, index, 0.0, gap_rate(cable, before), 0.0, 0, before, before};
    burst->snap = 0.0;
  }
  burst->ended = start;
  burst->after = before;
  burst->after.velocity = after.velocity;
  burst->after.spin = after.spin;
  burst->rate_after = gap_rate(cable, burst->after);
  if (burst->steps == 0) {
    burst->rate_first = burst->rate_after;
  }
  if (burst->steps == 0 || !turned_[index]) {
    burst->snap += impulse;
    // an engine may give a part of gravity's impulse after the cable has stopped the body
    turned_[index] = burst->rate_after > -(slowest_ + dt * case_.gravity.norm());
  }
  burst->impulse += impulse;
  ++burst->steps;
}

void ImpactDetector::close(std::size_t index) {
  if (bursts_[index]) {
    if (bursts_[index]->rate_after > slowest_) {  // thrown back: all of it was the impact
      bursts_[index]->snap = bursts_[index]->impulse;
    }
    keep(*bursts_[index]);
    bursts_[index].reset();
  }
}

void ImpactDetector::keep(const RecordedImpact& impact) {
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

double worst_overstretch(const Case& the_case, const State& state) {
  double worst = 0.0;
  for (const Cable& cable : the_case.cables) {
    worst = std::max(worst, -gap(cable, state));
  }
  return worst;
}

/// The tensions of a run, from the impulses of its steps.
class TensionRecorder {
 public:
  TensionRecorder(const Case& the_case, const Simulation& simulation, Trajectory& run)
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
  Trajectory& run_;
};

}  // namespace

bool reaches(const Trajectory& run, double time) {
  constexpr double near_enough = 0.98;  // [-]
  const double end = run.stop ? run.stop->time : run.points.back().time;
  return end >= near_enough * time;
}

std::size_t step_count(double duration, double step) {
  constexpr double same = 1e-9;  // [-]: 20 / 1e-3 is 20000 steps, not 20001 for a last bit
  return std::max<std::size_t>(1, static_cast<std::size_t>(std::ceil(duration / step - same)));
}

Trajectory record(const Case& the_case, Simulation& simulation, double step,
                  const RecordOptions& options) {
  const std::size_t steps = step_count(the_case.duration, step);
  Trajectory run;
  run.step = step;
  run.stride = (steps + options.most_points - 1) / options.most_points;
  run.points.reserve(steps / run.stride + 2);
  State now = simulation.state();
  run.points.push_back({0.0, now});
  run.largest_energy = energy(the_case, now);
  run.stop = simulation.stopped();
  ImpactDetector detector(the_case, options.slowest);
  TensionRecorder tensions(the_case, simulation, run);
  for (std::size_t index = 0; index < steps && !run.stop; ++index) {
    const double start = static_cast<double>(index) * step;
    const bool last = index + 1 == steps;
    const State before = now;
    const double dt = last ? the_case.duration - start : step;
    simulation.step(dt);
    now = simulation.state();
    run.stop = simulation.stopped();
    if (!reasonable(the_case, now)) {
      run.diverged = true;
      break;
    }
    detector.take(start, dt, before, now, simulation);
    tensions.take_step();
    run.overstretch = std::max(run.overstretch, worst_overstretch(the_case, now));
    run.largest_energy = std::max(run.largest_energy, energy(the_case, now));
    if (last || run.stop || (index + 1) % run.stride == 0) {
      const double end = last ? the_case.duration : static_cast<double>(index + 1) * step;
      run.points.push_back({run.stop ? run.stop->time : end, now});
      tensions.take_point();
    }
  }
  if (run.stop && !within_run(the_case, run.stop->time)) {
    throw std::runtime_error("the engine stopped at a time that is not in the run");
  }
  detector.finish(run);
  return run;
}

}  // namespace tautline::bench
