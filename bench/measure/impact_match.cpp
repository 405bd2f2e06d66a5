#include "bench/measure/impact_match.hpp"

#include <algorithm>
#include <cmath>
#include <limits>
#include <optional>

namespace tautline::bench {
namespace {

/// For each of `from`, the index of the nearest of `to` on the same cable.
std::vector<std::optional<std::size_t>> nearest(const std::vector<CountedImpact>& from,
                                                const std::vector<CountedImpact>& to) {
  std::vector<std::optional<std::size_t>> result(from.size());
  for (std::size_t i = 0; i < from.size(); ++i) {
    // both lists rise in time: walk out from the first not before, to the same cable either side
    const auto later = std::lower_bound(
        to.begin(), to.end(), from[i].time,
        [](const CountedImpact& impact, double time) { return impact.time < time; });
    double best = std::numeric_limits<double>::infinity();
    const auto consider = [&](auto it) {
      const double distance = std::abs(it->time - from[i].time);
      if (distance < best) {
        best = distance;
        result[i] = static_cast<std::size_t>(it - to.begin());
      }
    };
    for (auto it = later; it != to.end(); ++it) {
      if (it->cable == from[i].cable) {
        consider(it);
        break;
      }
    }
    for (auto it = later; it != to.begin();) {
      if ((--it)->cable == from[i].cable) {
        consider(it);
        break;
      }
    }
  }
  return result;
}

}  // namespace

ImpactPairs match_impacts(const std::vector<CountedImpact>& exact,
                          const std::vector<CountedImpact>& found) {
  const auto to_found = nearest(exact, found);
  const auto to_exact = nearest(found, exact);
  ImpactPairs pairs;
  for (std::size_t i = 0; i < exact.size(); ++i) {
    if (to_found[i] && to_exact[*to_found[i]] == i) {
      pairs.emplace_back(i, *to_found[i]);
    }
  }
  return pairs;
}

ImpactMatch impacts_until(double end, const std::vector<CountedImpact>& exact,
                          const std::vector<CountedImpact>& found, const ImpactPairs& pairs) {
  const auto inside = [end](const CountedImpact& impact) { return impact.time <= end; };
  ImpactMatch result;
  result.exact = static_cast<std::size_t>(std::count_if(exact.begin(), exact.end(), inside));
  result.found = static_cast<std::size_t>(std::count_if(found.begin(), found.end(), inside));
  for (const auto& [i, j] : pairs) {
    result.found -= inside(found[j]) ? 1U : 0U;  // a pair counts by its exact impact, on both sides
    if (!inside(exact[i])) {
      continue;
    }
    ++result.found;
    const double error = std::abs(exact[i].time - found[j].time);
    ++result.matched;
    result.worst_time_error = std::max(result.worst_time_error.value_or(0.0), error);
    if (i == 0) {
      result.first_time_error = error;
    }
  }
  return result;
}

}  // namespace tautline::bench
