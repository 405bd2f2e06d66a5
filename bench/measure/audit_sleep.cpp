// A body that an engine puts to sleep stays where it is, in the air or in the middle of a swing.
// One that has lost its energy and hangs at rest is not asleep.

#include "bench/base/listed.hpp"
#include "bench/measure/audit_parts.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include "bench/base/text.hpp"
#include "tautline/geometry.hpp"

namespace tautline::bench {
namespace {

/// Parts of the shortest cable, and radians [-]: what the body moves at least in the moment before
/// a freeze, where one that comes to rest by itself hardly moves any more; and what the exact
/// motion moves at least after it.
constexpr double moved_before = 3e-4;
constexpr double moves_after = 1e-2;

/// A moment, and the shortest freeze, as parts of the run [-].
constexpr double moment = 0.01;
constexpr double least_part = 0.05;

/// A freeze lasts for this many samples at least.
constexpr std::size_t least_frozen = 4;

/// A cable with a gap up to this part of its length is taut [-]: some engines leave a slop.
constexpr double taut_gap = 1e-4;

/// A weight is carried but for this part of it [-]: of a swing, the sine of its angle. What has
/// come to rest by itself has none left; what is stopped in a swing has mostly more.
constexpr double carried = 0.01;

/// Distance of two poses in lengths of `cable` [m] and in radians, whichever is larger.
double distance(const State& a, const State& b, double cable) {
  return std::max((a.position - b.position).norm() / cable, std::abs(a.angle - b.angle));
}

bool same_pose(const State& a, const State& b) {
  return a.position == b.position && a.angle == b.angle;  // to the bit: nothing moves it
}

/// The first of the points from which on the pose is the last one's.
std::vector<Point>::const_iterator first_frozen(const std::vector<Point>& points) {
  auto first = points.end() - 1;
  while (first != points.begin() && same_pose((first - 1)->state, points.back().state)) {
    --first;
  }
  return first;
}

/// The pose that the body had `moment` of the run before `time` [s].
const State& state_before(const std::vector<Point>& points, double time) {
  const double earlier = time - moment * points.back().time;
  const auto after = std::upper_bound(points.begin(), points.end(), earlier,
                                      [](double t, const Point& point) { return t < point.time; });
  return after == points.begin() ? after->state : (after - 1)->state;
}

/// True where the exact motion moves between `from` and `until` [s].
bool exact_moves(const ReferenceCase& reference, double from, double until, double cable) {
  std::vector<State> poses;
  for (const Point& point : samples(reference)) {
    if (point.time >= from && point.time <= until) {
      poses.push_back(point.state);
    }
  }
  return std::any_of(poses.begin(), poses.end(), [&](const State& other) {
    return distance(poses.front(), other, cable) > moves_after;
  });
}

/// True where the run has an impact in the step that leads to `frozen` or begins there: a body that
/// sticks to its cable has not been put to sleep.
bool sticks(const Trajectory& run, const Point& frozen) {
  const double rounding = 1e-9 * run.points.back().time;  // [s]
  return std::any_of(run.impacts.begin(), run.impacts.end(), [&](const RecordedImpact& impact) {
    return impact.time >= frozen.time - run.step - rounding &&
           impact.time <= frozen.time + rounding;
  });
}

/// What a cable does to a body with its unit of tension, and what it has to do: a force [N], and a
/// moment [N m] over the longest arm.
using Wrench = Eigen::Vector3d;

/// The wrenches of the cables that are taut at `state`.
std::vector<Wrench> pulls(const Case& the_case, const State& state) {
  std::vector<Wrench> result;
  double longest = 0.0;  // [m]
  for (const Cable& cable : the_case.cables) {
    longest = std::max(longest, cable.attachment.norm());
    if (gap(cable, state) <= taut_gap * cable.length) {
      result.emplace_back(gap_gradient(cable, state));
    }
  }
  for (Wrench& pull : result) {
    pull[2] = longest > 0.0 ? pull[2] / longest : 0.0;
  }
  return result;
}

/// True where taut cables carry the weight of a body at `state`: there it may hang at rest for
/// good. The least squares of what is left of the weight, over tensions that are not negative, by
/// one tension after the other.
bool hangs(const Case& the_case, const State& state) {
  constexpr int sweeps = 1000;     // cables a few degrees apart have converged
  Wrench weight = Wrench::Zero();  // of a mass of 1
  weight.head<2>() = the_case.gravity;
  const std::vector<Wrench> cables = pulls(the_case, state);
  std::vector<double> tensions(cables.size(), 0.0);
  Wrench left = weight;
  for (int sweep = 0; sweep < sweeps; ++sweep) {
    for (std::size_t i = 0; i < cables.size(); ++i) {
      const double more = std::max(-tensions[i], -cables[i].dot(left) / cables[i].squaredNorm());
      tensions[i] += more;
      left += more * cables[i];
    }
  }
  return weight.norm() > 0.0 && left.norm() <= carried * weight.norm();
}

}  // namespace

std::optional<Freeze> freeze_of(const ReferenceCase& reference, const Trajectory& run) {
  const std::vector<Point>& points = run.points;
  if (run.diverged || points.size() < 2 * least_frozen) {
    return std::nullopt;
  }
  const auto frozen = first_frozen(points);
  const double end = points.back().time;
  if (frozen == points.begin() || static_cast<std::size_t>(points.end() - frozen) < least_frozen ||
      end - frozen->time < least_part * end) {
    return std::nullopt;
  }
  const Case& the_case = reference.the_case;
  const double cable = shortest_cable(the_case);
  const State& before = state_before(points, frozen->time);
  if (distance(before, frozen->state, cable) < moved_before || sticks(run, *frozen) ||
      !exact_moves(reference, frozen->time, end, cable) || hangs(the_case, frozen->state)) {
    return std::nullopt;
  }
  const Point& moving = *(frozen - 1);
  return Freeze{moving.time, frozen->time,
                energy(the_case, moving.state) - energy(the_case, points.back().state)};
}

std::vector<Finding> sleep_findings(const AuditedModel& model) {
  if (model.freezes.empty()) {
    return {};
  }
  const auto earliest =
      std::min_element(model.freezes.begin(), model.freezes.end(),
                       [](const auto& a, const auto& b) { return a.freeze.time < b.freeze.time; });
  const auto costliest =
      std::max_element(model.freezes.begin(), model.freezes.end(),
                       [](const auto& a, const auto& b) { return a.freeze.lost < b.freeze.lost; });
  Finding finding = finding_of(model, "sleeping");
  finding.sentence = fmt::format(
      "the body is put to sleep: in {} of {} runs it stands still to the end while the exact "
      "motion "
      "goes on. The earliest is at t = {:.3g} s in {}; the most energy lost at once is {:.2g} J, "
      "in "
      "{}",
      model.freezes.size(), model.runs, earliest->freeze.time, printable(earliest->run.the_case),
      costliest->freeze.lost, printable(costliest->run.the_case));
  finding.value = earliest->freeze.time;
  finding.unit = std::string("s");
  finding.runs = model.freezes.size();
  finding.impacts = 0;
  finding.shown_in = listed(model.freezes, &RunFreeze::run);
  return {finding};
}

}  // namespace tautline::bench
