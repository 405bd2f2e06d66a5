// What one run says of restitution: its impacts against what a step can do to them, its ladder of
// bounces and its scatter.

#include "bench/measure/audit_impacts.hpp"

#include <algorithm>
#include <cmath>

#include "bench/measure/impact_match.hpp"
#include "tautline/geometry.hpp"

namespace tautline::bench {
namespace {

/// An impact counts where what a step does to its rates is at most this part of them [-].
constexpr double readable = 0.1;

/// No more bounces of a ladder are told: nobody climbs them.
constexpr std::size_t longest_ladder = 300;

double kinetic_energy(const Body& body, const State& state) {
  return 0.5 * (body.mass * state.velocity.squaredNorm() + body.inertia * state.spin * state.spin);
}

/// The size of accelerations in the exact motion [m/s^2]: gravity and turning on a cable. A rate
/// that is read a step early or late is off by a step of it.
double acceleration(const ReferenceCase& reference) {
  const Case& the_case = reference.the_case;
  double largest = 0.0;  // [J], of kinetic energy
  for (const Point& point : samples(reference)) {
    largest = std::max(largest, kinetic_energy(the_case.body, point.state));
  }
  return the_case.gravity.norm() + 2.0 * largest / the_case.body.mass / shortest_cable(the_case);
}

/// By how much a step may change what is read of `impact` itself [m/s]: the rate before it is one
/// of a flight that goes on for up to a step, and the rate after it is of a velocity that has flown
/// on and of the pose before. A body that spins fast turns the cable's pull more than gravity does.
double change_in_a_step(const Case& the_case, const RecordedImpact& impact, double step) {
  const Cable& cable = the_case.cables[impact.cable];
  const double before = std::abs(free_gap_acceleration(the_case, impact.cable, impact.before));
  const Eigen::Vector3d gone(impact.after.velocity.x(), impact.after.velocity.y(),
                             impact.after.spin);
  const double turned = std::abs(gap_gradient_rate(cable, impact.before).dot(gone));
  const double fallen =
      std::abs(gap_gradient(cable, impact.before).head<2>().dot(the_case.gravity));
  return step * (restitution(cable, impact.rate_before) * before + turned + fallen);
}

/// True where no other cable pulled in the impact's steps, and no other impact of the run is at the
/// same time: those share one velocity jump.
bool alone(const std::vector<const RecordedImpact*>& impacts, std::size_t index) {
  const double time = impacts[index]->time;
  return !impacts[index]->shared && (index == 0 || impacts[index - 1]->time != time) &&
         (index + 1 == impacts.size() || impacts[index + 1]->time != time);
}

/// `momentum` less what a step explains, as a part of `impulse`.
double excess(double momentum, double explained, double impulse) {
  return std::max(0.0, std::abs(momentum) - explained) / impulse;
}

AuditedImpact audited(const Case& the_case, const RecordedImpact& impact, double floor) {
  const Cable& cable = the_case.cables[impact.cable];
  const Eigen::Vector3d pull = gap_gradient(cable, impact.before);
  AuditedImpact result;
  result.speed = -impact.rate_before;
  result.requested = restitution(cable, impact.rate_before);
  result.effective = impact.rate_after / result.speed;
  result.arm = pull[2];
  result.rate_floor = floor;
  result.steps = impact.steps;
  const auto& [mass, inertia] = the_case.body;
  const double inverse = 1.0 / mass + (inertia > 0.0 ? pull[2] * pull[2] / inertia : 0.0);
  const double impulse = result.speed * (1.0 + std::abs(result.effective)) / inverse;
  const double explained = mass * floor * std::max(1.0, static_cast<double>(impact.steps));
  const double across = perpendicular(Vec2(pull.head<2>())).dot(Vec2(impact.stray.head<2>()));
  const double gyration = std::sqrt(inertia / mass);  // [m]
  result.across = excess(across, explained, impulse);
  result.turning = gyration > 0.0 ? excess(impact.stray[2] / gyration, explained, impulse) : 0.0;
  return result;
}

/// True where the exact motion stays on one line through the only cable's anchor, and so do its
/// bounces: the body falls back as high as it rose.
bool bounces_straight(const ReferenceCase& reference) {
  constexpr double straight = 1e-6;  // [-], of the length
  const Case& the_case = reference.the_case;
  if (the_case.cables.size() != 1) {
    return false;
  }
  const Cable& cable = the_case.cables.front();
  const double allowed = straight * cable.length;
  const double weight = the_case.gravity.norm();
  if (cable.attachment.norm() > allowed || weight == 0.0) {
    return false;
  }
  const auto points = samples(reference);
  return std::all_of(points.begin(), points.end(), [&](const Point& point) {
    const Vec2 away = point.state.position - cable.anchor;
    return std::abs(perpendicular(the_case.gravity).dot(away)) <= allowed * weight;
  });
}

}  // namespace

std::vector<AuditedImpact> audited_impacts(const ReferenceCase& reference, const Trajectory& run,
                                           double count_speed) {
  const auto& lock = reference.settling.lock;
  const double end = lock ? lock->time : reference.solution.end_time();
  const double floor = acceleration(reference) * run.step;
  const auto impacts = counted(run, count_speed);
  std::vector<AuditedImpact> result;
  for (std::size_t index = 0; index < impacts.size(); ++index) {
    const RecordedImpact& recorded = *impacts[index];
    if (recorded.time > end || !alone(impacts, index)) {
      continue;
    }
    const double changed = change_in_a_step(reference.the_case, recorded, run.step);
    const AuditedImpact impact = audited(reference.the_case, recorded, std::max(floor, changed));
    if (std::isfinite(impact.effective * impact.requested) &&
        impact.rate_floor <= readable * impact.speed) {
      result.push_back(impact);
    }
  }
  return result;
}

std::optional<Ladder> ladder_of(const ReferenceCase& reference, const Trajectory& run,
                                double count_speed) {
  const auto impacts = counted(run, count_speed);
  if (impacts.empty() || !bounces_straight(reference) ||
      depends_on_speed(reference.the_case.cables.front())) {
    return std::nullopt;
  }
  const double e = reference.the_case.cables.front().restitution;
  Ladder ladder;
  ladder.exact_ratio = e * e;
  double ratio = 1.0;
  for (std::size_t index = 0; index < std::min(impacts.size(), longest_ladder); ++index) {
    const double rebound = impacts[index]->rate_after / impacts.front()->rate_before;
    if (!std::isfinite(rebound)) {
      break;
    }
    ratio *= ladder.exact_ratio;
    ladder.heights.push_back(rebound * rebound);  // v^2 = 2 g h
    ladder.exact.push_back(ratio);
  }
  return ladder;
}

std::optional<Scatter> scatter_of(const std::vector<AuditedImpact>& impacts) {
  if (impacts.empty()) {
    return std::nullopt;
  }
  Scatter result;
  result.count = impacts.size();
  result.smallest = result.largest = impacts.front().deviation();
  const auto count = static_cast<double>(impacts.size());
  double sum = 0.0;
  for (const AuditedImpact& impact : impacts) {
    sum += impact.deviation();
    result.smallest = std::min(result.smallest, impact.deviation());
    result.largest = std::max(result.largest, impact.deviation());
  }
  result.mean = sum / count;
  double squares = 0.0;
  for (const AuditedImpact& impact : impacts) {
    squares += (impact.deviation() - result.mean) * (impact.deviation() - result.mean);
  }
  result.standard_deviation = std::sqrt(squares / count);
  return result;
}

Scatter pooled(const Scatter& one, const Scatter& other) {
  const auto n = static_cast<double>(one.count);
  const auto m = static_cast<double>(other.count);
  const auto square = [](const Scatter& scatter) {
    return scatter.mean * scatter.mean + scatter.standard_deviation * scatter.standard_deviation;
  };
  Scatter result;
  result.count = one.count + other.count;
  result.mean = (n * one.mean + m * other.mean) / (n + m);
  const double variance =
      (n * square(one) + m * square(other)) / (n + m) - result.mean * result.mean;
  result.standard_deviation = std::sqrt(std::max(0.0, variance));
  result.smallest = std::min(one.smallest, other.smallest);
  result.largest = std::max(one.largest, other.largest);
  return result;
}

}  // namespace tautline::bench
