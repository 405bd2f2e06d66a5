#include "bench/ensemble/compare/summary.hpp"

#include <algorithm>
#include <boost/math/distributions/binomial.hpp>
#include <boost/math/statistics/univariate_statistics.hpp>
#include <cmath>
#include <limits>

namespace tautline::bench {
namespace {

/// The value of rank `rank`, from 1, if there is one.
std::optional<double> ranked(const EnsembleSample& sample, double rank) {
  if (!(rank >= 1.0 && rank <= static_cast<double>(sample.values.size()))) {
    return std::nullopt;
  }
  return sample.values[static_cast<std::size_t>(rank) - 1];
}

/// The quantile of the distribution is above the value of rank r unless fewer than r of the values
/// are below it, whose number is binomial.
Quantile quantile_of(const EnsembleSample& sample, double part) {
  const auto size = static_cast<double>(sample.size());
  const double outside = 0.5 * (1.0 - confidence);
  const boost::math::binomial below(size, part);
  Quantile result{ranked(sample, std::max(1.0, std::ceil(part * size))), {}, {}};
  const double low = boost::math::quantile(below, outside);  // rounded down
  if (boost::math::cdf(below, low) <= outside) {
    result.low = ranked(sample, low + 1.0);
  }
  const double high = boost::math::quantile(boost::math::complement(below, outside));  // up
  result.high = ranked(sample, high + 1.0);
  return result;
}

}  // namespace

std::vector<double> EnsembleSample::with_none_last() const {
  std::vector<double> all = values;
  all.insert(all.end(), without, std::numeric_limits<double>::infinity());
  return all;
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
  Summary result;
  result.count = sample.values.size();
  result.without = sample.without;
  if (sample.values.empty()) {
    return result;
  }
  result.mean = boost::math::statistics::mean(sample.values);
  if (sample.values.size() > 1) {
    result.deviation = std::sqrt(boost::math::statistics::sample_variance(sample.values));
  }
  for (std::size_t place = 0; place < quantile_parts.size(); ++place) {
    result.quantiles[place] = quantile_of(sample, quantile_parts[place]);
  }
  return result;
}

}  // namespace tautline::bench
