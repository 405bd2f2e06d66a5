#include "bench/gate/trend/version_trend.hpp"

namespace tautline::bench {

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

std::vector<VersionMove> moves(const Trend& trend) {
  std::vector<VersionMove> result;
  for (std::size_t index = 1; index < trend.reports.size(); ++index) {
    for (const TrendRow& row : trend.rows) {
      const std::optional<TrendPoint>& before = row.points[index - 1];
      const std::optional<TrendPoint>& after = row.points[index];
      if (before && after && after->worse + after->better > 0) {
        result.push_back({trend.reports[index - 1].name, trend.reports[index].name, &row,
                          before->median, after->median, after->worse, after->better});
      }
    }
  }
  return result;
}

bool newest_is_worse(const VersionTrend& versions) {
  return versions.versions.empty() || !versions.versions.back().report ||
         (versions.trend && versions.trend->latest.worse());
}

}  // namespace tautline::bench
