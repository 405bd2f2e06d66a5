// A page of very many runs has fewer impacts of each, and of all numbers that are drawn as many
// digits as can be seen: else no browser would open it. Motions are not in it: see
// suite/report_of.cpp.

#include "bench/replay/replay.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdlib>
#include <numeric>
#include <utility>
#include <vector>

namespace tautline::bench {
namespace {

/// The impacts of all runs may take so many bytes of a page, and one takes this many.
constexpr std::size_t impact_budget = 800'000;
constexpr std::size_t impact_size = 70;
constexpr std::size_t least_impacts = 3;

/// Digits of what is a rest, of which a chart shows the size [-].
constexpr int rest_digits = 3;

using Places = std::vector<std::size_t>;

/// The columns of impacts that hold numbers.
std::array<std::vector<double>*, 7> numbers(ImpactColumns& impacts) {
  return {&impacts.time, &impacts.requested,        &impacts.rate_before,  &impacts.rate_after,
          &impacts.arm,  &impacts.tangential_error, &impacts.angular_error};
}

void round_impacts(ImpactColumns& impacts) {
  for (std::vector<double>* column : {&impacts.tangential_error, &impacts.angular_error}) {
    round_all(*column, rest_digits);
  }
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

}  // namespace

std::size_t page_impacts(std::size_t runs) {
  return std::clamp(impact_budget / std::max<std::size_t>(runs, 1) / impact_size, least_impacts,
                    most_drawn);
}

void round_all(std::vector<double>& column, int digits) {
  for (double& value : column) {
    value = rounded(value, digits);
  }
}

double rounded(double value, int digits) {
  return std::isfinite(value) ? std::strtod(fmt::format("{:.{}g}", value, digits).c_str(), nullptr)
                              : value;
}

ImpactColumns drawable(ImpactColumns impacts, std::size_t most) {
  round_impacts(impacts);
  const std::size_t all = impacts.time.size();
  if (all > most) {
    keep(impacts, fastest(impacts, most));
    impacts.left_out += all - most;
  }
  return impacts;
}

Replay drawable(const Replay& replay, std::size_t cases, std::size_t runs, std::size_t most) {
  Replay result;
  for (std::size_t place = 0; place < cases; ++place) {
    CaseReplay& one =
        result.cases.emplace_back(place < replay.cases.size() ? replay.cases[place] : CaseReplay());
    round_all(one.events.time);
    for (std::optional<double>& rate : one.events.rate) {
      rate = rate ? std::optional(rounded(*rate)) : rate;
    }
  }
  for (std::size_t place = 0; place < runs; ++place) {
    const std::optional<ImpactColumns>& impacts = replay.of_run(place).impacts;
    result.runs.push_back(
        {std::nullopt, impacts ? std::optional(drawable(*impacts, most)) : std::nullopt});
  }
  return result;
}

}  // namespace tautline::bench
