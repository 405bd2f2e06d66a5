#include "bench/report/motion/samples.hpp"

#include <algorithm>
#include <cmath>

#include "tautline/geometry.hpp"

namespace tautline::bench {
namespace {

/// Two instants nearer than this part of the duration are one [-]: rounding.
constexpr double one_instant = 1e-12;

Eigen::Vector3d pose_of(const State& state) {
  return {state.position.x(), state.position.y(), state.angle};
}

Eigen::Vector3d velocity_of(const State& state) {
  return {state.velocity.x(), state.velocity.y(), state.spin};
}

Sample sample(const Case& the_case, double time, const State& before, const State& after) {
  return {time,
          pose_of(before),
          velocity_of(before),
          velocity_of(after),
          energy(the_case, before),
          energy(the_case, after)};
}

bool is_finite(const Sample& sample) {
  return sample.pose.allFinite() && sample.arriving.allFinite() && sample.leaving.allFinite() &&
         std::isfinite(sample.energy_before) && std::isfinite(sample.energy_after);
}

/// Samples of one instant become one: it is come to as the first is, and left as the last is.
std::vector<Sample> merged(const Case& the_case, const std::vector<Sample>& samples) {
  std::vector<Sample> result;
  for (const Sample& one : samples) {
    if (!is_finite(one)) {
      break;  // the last of a run that diverged
    }
    if (!result.empty() && one.time - result.back().time <= one_instant * the_case.duration) {
      result.back().leaving = one.leaving;
      result.back().energy_after = one.energy_after;
    } else {
      result.push_back(one);
    }
  }
  return result;
}

/// Gives every sample the velocities of the straight ways to its neighbours.
void take_differences(std::vector<Sample>& samples) {
  for (std::size_t next = 1; next < samples.size(); ++next) {
    Sample& from = samples[next - 1];
    Sample& to = samples[next];
    from.leaving = to.arriving = (to.pose - from.pose) / (to.time - from.time);
  }
}

}  // namespace

std::vector<Sample> samples_of(const Case& the_case, const Trajectory& run) {
  const auto& impacts = run.impacts;
  const bool located = !impacts.empty() && std::all_of(impacts.begin(), impacts.end(),
                                                       [](const auto& i) { return i.steps == 0; });
  std::vector<Sample> samples;
  samples.reserve(run.points.size() + impacts.size());
  for (const RecordedImpact& impact : impacts) {
    // a push over whole steps starts from a pose of the run; where it leads is another one
    samples.push_back(sample(the_case, impact.time, impact.before,
                             impact.steps == 0 ? impact.after : impact.before));
  }
  for (const Point& point : run.points) {
    samples.push_back(sample(the_case, point.time, point.state, point.state));
  }
  // of one instant, the impact stands before the point, which is after it
  std::inplace_merge(samples.begin(), samples.begin() + static_cast<std::ptrdiff_t>(impacts.size()),
                     samples.end(), [](const auto& a, const auto& b) { return a.time < b.time; });
  samples = merged(the_case, samples);
  if (!located) {
    take_differences(samples);
  }
  return samples;
}

std::vector<Sample> samples_of(const Case& the_case, const Solution& solution) {
  constexpr double fine = 20000.0;   // parts of the whole motion: a millisecond of 20 s
  constexpr std::size_t least = 24;  // parts of an arc: a cubic may cut the corner at its end
  // an accumulation that is completed moves the body at once: so soon it is where it then goes on
  const double soon = 4e-6 * solution.end_time();  // [s], wide enough for two knots
  std::vector<Sample> samples;
  const auto add = [&](const Arc& arc, double dt) {
    const State state = arc.after(dt, solution.gravity());
    samples.push_back(sample(the_case, arc.start + dt, state, state));
  };
  for (const Arc& arc : solution.arcs_until(solution.end_time())) {
    const double length = arc.end - arc.start;
    add(arc, 0.0);
    if (static_cast<double>(least) * soon < length) {
      add(arc, soon);
    }
    const std::size_t parts =
        std::max(least, static_cast<std::size_t>(fine * length / solution.end_time()));
    for (std::size_t part = 1; part <= parts; ++part) {
      add(arc, length * static_cast<double>(part) / static_cast<double>(parts));
    }
  }
  return merged(the_case, samples);
}

}  // namespace tautline::bench
