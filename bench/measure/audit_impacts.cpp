// What one run says of restitution: its impacts against what a step can do to them, its ladder of
// bounces and its scatter.

#include "bench/measure/audit_impacts.hpp"

#include <algorithm>
#include <cmath>

#include "bench/measure/audit_lost.hpp"
#include "bench/measure/impact_match.hpp"
#include "tautline/case_or_system.hpp"
#include "tautline/elastic_step.hpp"

namespace tautline::bench {
namespace {

/// No more bounces of a ladder are told: nobody climbs them.
constexpr std::size_t longest_ladder = 300;

/// Steps that a body is held after the one that stopped it: a soft contact takes several steps to
/// stop it, and two phases of one impact two.
constexpr std::size_t least_held = 4;

/// True where a step stops the body and the steps that follow hold it: nothing came back, which the
/// first step says.
template <class TheCase>
bool sticks(const TheCase& the_case, const BasicRecordedImpact<TheCase>& impact) {
  const double speed = -impact.rate_before;
  const double e = restitution(the_case.cables[impact.cable], impact.rate_before);
  return e >= asking && impact.steps >= least_held && impact.rate_first > -still_closing * speed &&
         impact.rate_first < lost_part * e * speed &&
         (impact.shared || impact.rate_after < lost_part * e * speed);
}

constexpr double step_and_rounding = 1.01;  // steps

/// True where no impact of another cable begins up to `over` [s], or at the instant of this one.
template <class TheCase>
bool none_follows(const BasicTrajectory<TheCase>& run, std::size_t index, double over) {
  const auto& impacts = run.impacts;
  for (std::size_t next = index + 1; next < impacts.size() && impacts[next].time <= over; ++next) {
    if (impacts[next].cable != impacts[index].cable) {
      return false;
    }
  }
  return index == 0 || impacts[index - 1].time != impacts[index].time;
}

/// True where no other cable pulled in the impact's steps or in the step after them, and the run
/// has this step: a contact that another impact or the end of the run cuts off is not read.
template <class TheCase>
bool alone(const BasicTrajectory<TheCase>& run, std::size_t index) {
  const auto& impact = run.impacts[index];
  const double over = impact.ended + step_and_rounding * run.step;
  return !impact.shared && (impact.steps == 0 || over <= run.points.back().time) &&
         none_follows(run, index, over);
}

/// The same of the steps in which a body is stopped and held; later ones say nothing of it.
template <class TheCase>
bool stopped_alone(const BasicTrajectory<TheCase>& run, std::size_t index) {
  const auto& impact = run.impacts[index];
  const auto before = run.impacts.begin() + static_cast<std::ptrdiff_t>(index);
  return none_follows(run, index, impact.time + static_cast<double>(least_held) * run.step) &&
         std::none_of(run.impacts.begin(), before, [&](const auto& earlier) {
           return earlier.cable != impact.cable &&
                  earlier.ended + step_and_rounding * run.step >= impact.time;
         });
}

/// `momentum` less what a step explains, as a part of `impulse`.
double excess(double momentum, double explained, double impulse) {
  return std::max(0.0, std::abs(momentum) - explained) / impulse;
}

/// Adds what the impulse of one cable on one body in the plane does not explain.
void add_unexplained(const Case& the_case, const RecordedImpact& impact, double floor,
                     AuditedImpact& result) {
  const Eigen::Vector3d pull = gap_gradient(the_case.cables[impact.cable], impact.before);
  result.arm = pull[2];
  const auto& [mass, inertia] = the_case.body;
  const double inverse = 1.0 / mass + (inertia > 0.0 ? pull[2] * pull[2] / inertia : 0.0);
  const double impulse = result.speed * (1.0 + std::abs(result.effective)) / inverse;
  const double explained = mass * floor;
  const double across = perpendicular(Vec2(pull.head<2>())).dot(Vec2(impact.stray.head<2>()));
  const double gyration = std::sqrt(inertia / mass);  // [m]
  result.across = excess(across, explained, impulse);
  result.turning = gyration > 0.0 ? excess(impact.stray[2] / gyration, explained, impulse) : 0.0;
}

template <class TheCase>
AuditedImpact audited(const TheCase& the_case, const BasicRecordedImpact<TheCase>& impact,
                      double floor) {
  const auto& cable = the_case.cables[impact.cable];
  AuditedImpact result;
  result.speed = -impact.rate_before;
  result.requested = restitution(cable, impact.rate_before);
  result.effective = impact.rate_after / result.speed;
  result.rate_floor = doubt_of_rates(cable, result.speed, floor);
  result.steps = impact.steps;
  if constexpr (std::is_same_v<TheCase, Case>) {
    add_unexplained(the_case, impact, floor, result);
  }
  return result;
}

/// By how much the rate of a gap changes by what acts on bodies that stand still, and by what is
/// given over time [m/s^2], at most: an engine may take either a step earlier or later.
double falling(const Case& the_case, std::size_t index, const State& state) {
  return std::abs(gap_gradient(the_case.cables[index], state).head<2>().dot(the_case.gravity));
}
double falling(const SpatialSystem& system, std::size_t index, const SpatialSystemState& state) {
  const SpatialSystemState still = standing_still(state);
  const double by_forces =
      gap_gradient(system.cables[index], still).dot(free_accelerations(system, still));
  return std::abs(by_forces) + std::abs(free_gap_acceleration(system, index, still) - by_forces);
}

/// `state` with what elastic cables pull at, which no run tells; there are none in the plane.
const State& with_pulls(const Case& /*the_case*/, const State& state) { return state; }
SpatialSystemState with_pulls(const SpatialSystem& system, const SpatialSystemState& state) {
  return with_zones_of_step(system, state);
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

template <class TheCase>
double change_of_rates(const TheCase& the_case, std::size_t index, const StateOf<TheCase>& before,
                       const StateOf<TheCase>& after) {
  const auto& cable = the_case.cables[index];
  const StateOf<TheCase> pulled = with_pulls(the_case, before);
  const double flown =
      std::max(std::abs(free_gap_acceleration(the_case, index, pulled)),
               std::abs(free_gap_acceleration(the_case, index, with_pulls(the_case, after))));
  const double turned = std::abs(gap_gradient_rate(cable, before).dot(motion_of(after)));
  const double fallen = falling(the_case, index, pulled);
  return restitution(cable, gap_rate(cable, before)) * flown + turned + fallen;
}

template <class TheReference, class TheCase>
std::vector<AuditedImpact> audited_impacts(const TheReference& reference,
                                           const BasicTrajectory<TheCase>& run) {
  const TheCase& the_case = reference.the_case;
  const double end = reference.solution.end_time();
  std::vector<AuditedImpact> result;
  for (std::size_t index = 0; index < run.impacts.size(); ++index) {
    BasicRecordedImpact<TheCase> recorded = run.impacts[index];
    const bool stuck = sticks(the_case, recorded) && stopped_alone(run, index);
    if (recorded.time > end || !(stuck || alone(run, index))) {
      continue;
    }
    if (stuck) {  // of its first step alone
      recorded.rate_after = recorded.rate_first;
      recorded.after = recorded.before;
      recorded.stray.setZero();
    }
    const StateOf<TheCase> after = with_velocities(recorded.before, recorded.after);
    const double steps = stuck ? 1.0 : std::max(1.0, static_cast<double>(recorded.steps));
    const double floor =
        steps * run.step * change_of_rates(the_case, recorded.cable, recorded.before, after);
    const AuditedImpact impact = audited(the_case, recorded, floor);
    if (std::isfinite(impact.effective * impact.requested) &&
        impact.rate_floor <= readable_part * impact.speed) {
      result.push_back(impact);
    }
  }
  return result;
}

template std::vector<AuditedImpact> audited_impacts(const ReferenceCase&, const Trajectory&);
template std::vector<AuditedImpact> audited_impacts(const ReferenceSystem&,
                                                    const SystemTrajectory&);
template double change_of_rates(const Case&, std::size_t, const State&, const State&);
template double change_of_rates(const SpatialSystem&, std::size_t, const SpatialSystemState&,
                                const SpatialSystemState&);

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

}  // namespace tautline::bench
