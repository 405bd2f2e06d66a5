// A body that an engine puts to sleep stays where it is, in the air or in the middle of a swing.
// One that has lost its energy and hangs at rest is not asleep.

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include "bench/base/text.hpp"
#include "bench/measure/audit/impacts.hpp"
#include "tautline/geometry.hpp"

namespace tautline::bench {
namespace {

using nlohmann::ordered_json;

/// Parts of the shortest cable, and radians [-]: what the body moves at least between the sample
/// before a freeze and the freeze, where one that comes to rest by itself hardly moves any more;
/// and what the exact motion moves at least after it.
constexpr double moved_before = 3e-4;
constexpr double moves_after = 1e-2;

/// A stretch without motion is a freeze from this many samples on, and this part of the run.
constexpr std::size_t least_samples = 4;
constexpr double least_part = 0.05;

struct Pose {
  double x;
  double y;
  double angle;
};

Pose pose(const ordered_json& path, std::size_t index) {
  return {path.at("x").at(index), path.at("y").at(index), path.at("angle").at(index)};
}

/// Distance of two poses in lengths of `cable` [m] and in radians, whichever is larger.
double distance(const Pose& a, const Pose& b, double cable) {
  return std::max(std::hypot(a.x - b.x, a.y - b.y) / cable, std::abs(a.angle - b.angle));
}

bool same(const Pose& a, const Pose& b) { return a.x == b.x && a.y == b.y && a.angle == b.angle; }

/// The first of the samples from which on no number of the pose changes.
std::size_t first_frozen(const ordered_json& path) {
  std::size_t first = path.at("time").size() - 1;
  const Pose last = pose(path, first);
  while (first > 0 && same(pose(path, first - 1), last)) {
    --first;
  }
  return first;
}

/// True where the exact motion moves between `from` and `until` [s].
bool exact_moves(const ordered_json& the_case, double from, double until, double cable) {
  const ordered_json& path = the_case.at("path");
  std::vector<Pose> poses;
  for (std::size_t i = 0; i < path.at("time").size(); ++i) {
    const double time = path.at("time").at(i);
    if (time >= from && time <= until) {
      poses.push_back(pose(path, i));
    }
  }
  return std::any_of(poses.begin(), poses.end(), [&](const Pose& other) {
    return distance(poses.front(), other, cable) > moves_after;
  });
}

/// True where the run has an impact at `time` [s], as written: a body that sticks to its cable
/// there has not been put to sleep.
bool hits_at(const ordered_json& run, const ordered_json& time) {
  const ordered_json& times = run.at("impacts").at("time");
  return std::find(times.begin(), times.end(), time) != times.end();
}

/// A cable with a gap up to this part of its length is taut [-]: a path has six digits.
constexpr double taut_gap = 1e-4;

/// A weight is carried but for this part of it [-]: of a swing, the sine of its angle. What has
/// come to rest by itself has none left; what is stopped in a swing has mostly more.
constexpr double carried = 0.01;

/// What a cable does to a body with its unit of tension, and what it has to do: a force [N], and a
/// moment [N m] over the longest arm.
using Wrench = Eigen::Vector3d;

Vec2 vector(const ordered_json& pair) {
  return {pair.at(0).get<double>(), pair.at(1).get<double>()};
}

/// The wrenches of the cables that are taut at `at`.
std::vector<Wrench> pulls(const ordered_json& the_case, const Pose& at) {
  std::vector<Wrench> result;
  double longest = 0.0;  // [m]
  for (const ordered_json& row : the_case.at("geometry")) {
    Cable cable;
    cable.anchor = vector(row.at("anchor"));
    cable.attachment = vector(row.at("attachment"));
    cable.length = row.at("length");
    longest = std::max(longest, cable.attachment.norm());
    const State state{{at.x, at.y}, at.angle, Vec2::Zero(), 0.0};
    if (gap(cable, state) <= taut_gap * cable.length) {
      result.emplace_back(gap_gradient(cable, state));
    }
  }
  for (Wrench& pull : result) {
    pull[2] = longest > 0.0 ? pull[2] / longest : 0.0;
  }
  return result;
}

/// True where taut cables carry the weight of a body at `at`: there it may hang at rest for good.
/// The least squares of what is left of the weight, over tensions that are not negative, by one
/// tension after the other.
bool hangs(const ordered_json& the_case, const Pose& at) {
  constexpr int sweeps = 1000;     // cables a few degrees apart have converged
  Wrench weight = Wrench::Zero();  // of a mass of 1
  weight.head<2>() = vector(the_case.at("gravity"));
  const std::vector<Wrench> cables = pulls(the_case, at);
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

std::optional<Freeze> freeze_of(const ordered_json& run, const ordered_json& the_case) {
  const ordered_json& path = run.at("path");
  const ordered_json& times = path.at("time");
  if (times.size() < 2 * least_samples || run.at("status") == "diverged") {
    return std::nullopt;
  }
  double cable = the_case.at("geometry").front().at("length");
  for (const ordered_json& other : the_case.at("geometry")) {
    cable = std::min(cable, other.at("length").get<double>());
  }
  const std::size_t first = first_frozen(path);
  const double time = times.at(first);
  const double end = times.back();
  const bool lasts = times.size() - first >= least_samples && end - time >= least_part * end;
  if (!lasts || first == 0) {
    return std::nullopt;
  }
  if (distance(pose(path, first - 1), pose(path, first), cable) < moved_before ||
      hits_at(run, times.at(first)) || !exact_moves(the_case, time, end, cable) ||
      hangs(the_case, pose(path, first))) {
    return std::nullopt;
  }
  const double lost =
      path.at("energy").at(first - 1).get<double>() - path.at("energy").at(first).get<double>();
  return Freeze{run.at("case"), times.at(first - 1), time, lost};
}

std::vector<AuditFinding> sleep_findings(const AuditedModel& model) {
  if (model.freezes.empty()) {
    return {};
  }
  const auto earliest =
      std::min_element(model.freezes.begin(), model.freezes.end(),
                       [](const Freeze& a, const Freeze& b) { return a.time < b.time; });
  const auto costliest =
      std::max_element(model.freezes.begin(), model.freezes.end(),
                       [](const Freeze& a, const Freeze& b) { return a.lost < b.lost; });
  return {
      {"sleeping",
       fmt::format(
           "the body is put to sleep: it stands still to the end in {} of {} runs where "
           "the exact motion goes on, first in {}, from between t = {:.3g} and {:.3g} s on; up to "
           "{:.2g} J are lost at once (in {})",
           model.freezes.size(), model.runs, printable(earliest->case_name), earliest->moving,
           earliest->time, costliest->lost, printable(costliest->case_name)),
       earliest->time, "s", model.freezes.size(), 0}};
}

}  // namespace tautline::bench
