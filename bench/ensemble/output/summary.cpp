#include "bench/ensemble/output/summary.hpp"

#include <algorithm>
#include <boost/math/distributions/binomial.hpp>
#include <boost/math/statistics/univariate_statistics.hpp>
#include <cmath>
#include <functional>
#include <limits>

namespace tautline::bench {
namespace {

/// The value of a rank, from 1 to the number of values.
using ValueOfRank = std::function<double(std::size_t rank)>;

/// The value of a rank, if there is one.
using Ranked = std::function<std::optional<double>(double rank)>;

/// The quantile of the distribution is above the value of rank r unless fewer than r of the values
/// are below it, whose number is binomial.
Quantile quantile_of(const Ranked& ranked, double size, double part) {
  const double outside = 0.5 * (1.0 - confidence);
  const boost::math::binomial below(size, part);
  Quantile result{ranked(std::max(1.0, std::ceil(part * size))), {}, {}};
  const double low = boost::math::quantile(below, outside);  // rounded down
  if (boost::math::cdf(below, low) <= outside) {
    result.low = ranked(low + 1.0);
  }
  const double high = boost::math::quantile(boost::math::complement(below, outside));  // up
  result.high = ranked(high + 1.0);
  return result;
}

/// The numbers, and the quantiles of `count` values and of `without` larger ones.
Summary summary_of(std::size_t count, std::size_t without, double mean, double deviation,
                   const ValueOfRank& value) {
  Summary result{count, without, mean, deviation, {}};
  const auto ranked = [&](double rank) {
    return rank >= 1.0 && rank <= static_cast<double>(count)
               ? std::optional(value(static_cast<std::size_t>(rank)))
               : std::nullopt;
  };
  for (std::size_t place = 0; count > 0 && place < quantile_parts.size(); ++place) {
    result.quantiles[place] =
        quantile_of(ranked, static_cast<double>(count + without), quantile_parts[place]);
  }
  return result;
}

}  // namespace

std::vector<double> EnsembleSample::with_none_last() const {
  std::vector<double> all = values;
  all.insert(all.end(), without, std::numeric_limits<double>::infinity());
  return all;
}

double nearest_value(const std::vector<double>& values, double part) {
  const auto last = static_cast<double>(values.size() - 1);
  return values[static_cast<std::size_t>(std::lround(part * last))];
}

EnsembleSample sample_of(const DrawTable& draws, std::size_t statistic) {
  EnsembleSample sample;
  sample.values.reserve(draws.ended());
  for (std::size_t draw = 0; draw < draws.size(); ++draw) {
    if (!draws.solved(draw)) {
      continue;
    }
    if (const std::optional<double> value = draws.value(draw, statistic)) {
      sample.values.push_back(*value);
    } else {
      ++sample.without;
    }
  }
  std::sort(sample.values.begin(), sample.values.end());
  return sample;
}

Summary summary_of(const EnsembleSample& sample) {
  const std::vector<double>& values = sample.values;
  const double mean = values.empty() ? 0.0 : boost::math::statistics::mean(values);
  const double deviation =
      values.size() > 1 ? std::sqrt(boost::math::statistics::sample_variance(values)) : 0.0;
  return summary_of(values.size(), sample.without, mean, deviation,
                    [&](std::size_t rank) { return values[rank - 1]; });
}

Summary summary_of(const ValueCounts& counts) {
  const auto count = static_cast<double>(counts.count());
  double sum = 0.0;
  for (const auto& [value, times] : counts.values()) {
    sum += value * static_cast<double>(times);
  }
  const double mean = counts.count() > 0 ? sum / count : 0.0;
  double squares = 0.0;
  for (const auto& [value, times] : counts.values()) {
    squares += (value - mean) * (value - mean) * static_cast<double>(times);
  }
  const double deviation = counts.count() > 1 ? std::sqrt(squares / (count - 1.0)) : 0.0;
  return summary_of(counts.count(), counts.without(), mean, deviation, [&](std::size_t rank) {
    auto place = counts.values().begin();
    for (std::size_t up_to = place->second; up_to < rank; up_to += place->second) {
      ++place;
    }
    return place->first;
  });
}

}  // namespace tautline::bench
