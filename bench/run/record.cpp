#include "bench/run/record.hpp"

#include <algorithm>
#include <cmath>
#include <limits>
#include <stdexcept>
#include <string>
#include <vector>

#include "bench/run/impact_detector.hpp"
#include "tautline/geometry.hpp"

namespace tautline::bench {
namespace {

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
