#include "bench/gate/trend/version_trend.hpp"

#include <algorithm>
#include <limits>
#include <map>
#include <utility>

#include "bench/base/listed.hpp"

namespace tautline::bench {
namespace {

using MetricChanges = std::vector<MetricChange>;

/// One move for each model, step and metric, the largest first.
std::vector<VersionMove> moves_to(const std::string& version, const MetricChanges& changes) {
  std::map<std::pair<SetupKey, std::size_t>, VersionMove> found;
  for (const MetricChange& change : changes) {
    const auto [place, is_new] =
        found.try_emplace({setup_of(change.key), change.metric}, VersionMove{version, change, 0});
    VersionMove& move = place->second;
    ++move.runs;
    if (size_of_change(change) > size_of_change(move.most)) {
      move.most = change;
    }
  }
  std::vector<VersionMove> result = listed(found, [](const auto& one) { return one.second; });
  std::stable_sort(result.begin(), result.end(),
                   [](const VersionMove& one, const VersionMove& two) {
                     return size_of_change(one.most) > size_of_change(two.most);
                   });
  return result;
}

std::vector<VersionMove> moves_of_all(const Trend& trend, MetricChanges Changes::*kind) {
  std::vector<VersionMove> result;
  for (std::size_t index = trend.changes.size(); index > 0; --index) {
    const std::vector<VersionMove> moves =
        moves_to(trend.reports[index].name, trend.changes[index - 1].*kind);
    result.insert(result.end(), moves.begin(), moves.end());
  }
  return result;
}

}  // namespace

void find_trend(VersionTrend& versions, const Noise& noise) {
  std::vector<Report> reports;
  std::vector<std::string> names;
  for (const TrendVersion& version : versions.versions) {
    if (version.report) {
      reports.push_back(*version.report);
      names.push_back(version.version);
    }
  }
  if (!reports.empty()) {
    versions.trend = trend(reports, names, noise);
  }
}

double size_of_change(const MetricChange& change) {
  const double before = change.before.value_or(0.0);
  const double after = change.after.value_or(0.0);
  return before > 0.0 && after > 0.0 ? std::max(before / after, after / before)
                                     : std::numeric_limits<double>::infinity();
}

std::vector<VersionMove> worse_moves(const Trend& trend) {
  return moves_of_all(trend, &Changes::got_worse);
}

std::vector<VersionMove> better_moves(const Trend& trend) {
  return moves_of_all(trend, &Changes::got_better);
}

bool newest_is_worse(const VersionTrend& versions) {
  return versions.versions.empty() || !versions.versions.back().report ||
         (versions.trend && versions.trend->latest.worse());
}

}  // namespace tautline::bench
