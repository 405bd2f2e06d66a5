#include "bench/run/impact_detector.hpp"

#include <algorithm>
#include <cmath>
#include <stdexcept>
#include <string>
#include <utility>

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

}  // namespace

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
          cables.size() > 1, impulses[index]});
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

}  // namespace tautline::bench
