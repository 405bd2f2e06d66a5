// A body that an engine puts to sleep stays where it is, in the air or in the middle of a swing.

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include "bench/audit_run.hpp"
#include "bench/text.hpp"

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

/// A body stands at the equilibrium if no more than this part of its first energy is left [-].
constexpr double at_equilibrium = 1e-3;

/// True where a run ends with no energy above the equilibrium of the final set of cables: what has
/// lost it all may stand still.
bool ends_at_equilibrium(const ordered_json& path, const ordered_json& the_case) {
  const ordered_json& lock = the_case.at("settling").at("lock");
  if (lock.is_null()) {
    return false;
  }
  const ordered_json& swing = lock.at("swing");
  const double lowest = the_case.at("end_energy").get<double>() -
                        (swing.is_null() ? 0.0 : swing.at("energy").get<double>());
  return path.at("energy").back().get<double>() - lowest <=
         at_equilibrium * (the_case.at("start_energy").get<double>() - lowest);
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
      ends_at_equilibrium(path, the_case)) {
    return std::nullopt;
  }
  const double lost =
      path.at("energy").at(first - 1).get<double>() - path.at("energy").at(first).get<double>();
  return Freeze{run.at("case"), time, lost};
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
       fmt::format("the body is put to sleep: it stands still to the end in {} of {} runs where "
                   "the exact motion goes on, first at t = {:.3g} s in {}; up to {:.2g} J are "
                   "lost at once (in {})",
                   model.freezes.size(), model.runs, earliest->time, printable(earliest->case_name),
                   costliest->lost, printable(costliest->case_name)),
       earliest->time, "s", model.freezes.size(), 0}};
}

}  // namespace tautline::bench
