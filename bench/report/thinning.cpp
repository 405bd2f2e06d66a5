// Of very many runs a report has fewer impacts each, and of all numbers that are drawn as many
// digits as can be seen: else no page would hold it.

#include "bench/report/thinning.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdlib>
#include <numeric>
#include <set>
#include <utility>
#include <vector>

#include "bench/measure/reference.hpp"
#include "bench/report/motion.hpp"

namespace tautline::bench {
namespace {

/// The paths of all runs may take so many bytes, and one sample of one takes this many.
constexpr std::size_t path_budget = 4'000'000;
constexpr std::size_t sample_size = 40;
constexpr std::size_t least_path_samples = 40;  // fewer do not show an arc between two impacts

/// The impacts of all runs may take so many bytes, each as a row of the columns and as a sample of
/// the path.
constexpr std::size_t impact_budget = 800'000;
constexpr std::size_t impact_size = 120;
constexpr std::size_t least_impacts = 24;

/// What a path is drawn with; its times have more, as those of impacts do [-].
constexpr int drawn_digits = 5;

using Places = std::vector<std::size_t>;

void round_all(std::vector<double>& column, int digits = 6) {
  for (double& value : column) {
    value = rounded(value, digits);
  }
}

void round_path(Path& path) {
  round_all(path.time);
  for (std::vector<double>* column : {&path.x, &path.y, &path.angle, &path.energy}) {
    round_all(*column, drawn_digits);
  }
}

/// The columns of impacts that hold numbers.
std::array<std::vector<double>*, 7> numbers(ImpactColumns& impacts) {
  return {&impacts.time, &impacts.requested,        &impacts.rate_before,  &impacts.rate_after,
          &impacts.arm,  &impacts.tangential_error, &impacts.angular_error};
}

void round_impacts(ImpactColumns& impacts) {
  for (std::vector<double>* column : numbers(impacts)) {
    round_all(*column);
  }
}

/// The places of the `most` impacts that close fastest, in rising time.
Places fastest(const ImpactColumns& impacts, std::size_t most) {
  const auto speed = [&](std::size_t place) {
    const double rate = impacts.rate_before[place];
    return std::isfinite(rate) ? -rate : 0.0;
  };
  Places places(impacts.time.size());
  std::iota(places.begin(), places.end(), std::size_t{0});
  std::stable_sort(places.begin(), places.end(),
                   [&](std::size_t a, std::size_t b) { return speed(a) > speed(b); });
  places.resize(std::min(places.size(), most));
  std::sort(places.begin(), places.end());
  return places;
}

template <class Value>
void keep(std::vector<Value>& column, const Places& places) {
  std::vector<Value> kept;
  kept.reserve(places.size());
  for (const std::size_t place : places) {
    kept.push_back(column[place]);
  }
  column = std::move(kept);
}

void keep(ImpactColumns& impacts, const Places& places) {
  for (std::vector<double>* column : numbers(impacts)) {
    keep(*column, places);
  }
  keep(impacts.cable, places);
  keep(impacts.steps, places);
}

void keep(Path& path, const Places& places) {
  for (std::vector<double>* column : {&path.time, &path.x, &path.y, &path.angle, &path.energy}) {
    keep(*column, places);
  }
}

/// The places in a path but for those at the times of `gone` that are not in `kept`.
Places places_without(const std::vector<double>& times, const std::set<double>& gone,
                      const std::set<double>& kept) {
  Places places;
  for (std::size_t place = 0; place < times.size(); ++place) {
    const bool an_end = place == 0 || place + 1 == times.size();
    if (an_end || !gone.contains(times[place]) || kept.contains(times[place])) {
      places.push_back(place);
    }
  }
  return places;
}

std::set<double> finite(const std::vector<double>& column) {
  std::set<double> result;
  std::copy_if(column.begin(), column.end(), std::inserter(result, result.end()),
               [](double value) { return std::isfinite(value); });
  return result;
}

}  // namespace

std::size_t path_samples(std::size_t runs) {
  return std::clamp(path_budget / std::max<std::size_t>(runs, 1) / sample_size, least_path_samples,
                    exact_samples);
}

std::size_t impacts_per_run(std::size_t runs) {
  return std::clamp(impact_budget / std::max<std::size_t>(runs, 1) / impact_size, least_impacts,
                    most_impacts);
}

double rounded(double value, int digits) {
  return std::isfinite(value) ? std::strtod(fmt::format("{:.{}g}", value, digits).c_str(), nullptr)
                              : value;
}

RunRow drawable(RunRow result, std::size_t impacts) {
  if (!result.path || !result.impacts) {
    return result;
  }
  round_path(*result.path);
  round_impacts(*result.impacts);
  const std::size_t all = result.impacts->time.size();
  if (all > impacts) {
    const std::set<double> before = finite(result.impacts->time);
    keep(*result.impacts, fastest(*result.impacts, impacts));
    result.impacts->left_out += all - impacts;
    keep(*result.path, places_without(result.path->time, before, finite(result.impacts->time)));
  }
  return result;
}

CaseRow drawable(CaseRow result) {
  round_path(result.path);
  round_all(result.events.time);
  for (std::optional<double>& rate : result.events.rate) {
    rate = rate ? std::optional(rounded(*rate)) : rate;
  }
  return result;
}

}  // namespace tautline::bench
