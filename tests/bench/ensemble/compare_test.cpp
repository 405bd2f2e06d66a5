// What tells two distributions apart, against tables and second routes.

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <vector>

#include "bench/ensemble/output/comparison.hpp"
#include "bench/ensemble/output/energy_distance.hpp"
#include "bench/ensemble/output/kolmogorov.hpp"
#include "bench/ensemble/output/summary.hpp"
#include "bench/ensemble/random.hpp"

namespace tautline::bench {
namespace {

/// Uniform random numbers from `low` to `low` + 1, in rising order.
std::vector<double> uniform(std::uint64_t seed, std::size_t count, double low = 0.0) {
  std::vector<double> values;
  for (std::size_t index = 0; index < count; ++index) {
    values.push_back(low + random_part(seed, Purpose::draw, index, 0));
  }
  std::sort(values.begin(), values.end());
  return values;
}

// critical values of Kolmogorov's limit (Smirnov 1948): 1.2238, 1.3581, 1.6276, 1.9495
TEST(Kolmogorov, HasTheCriticalValuesOfTheTables) {
  const std::size_t many = 1000;  // the limit knows no size
  const double root = std::sqrt(static_cast<double>(many) / 2.0);
  const std::vector<std::pair<double, double>> table = {
      {0.10, 1.22385}, {0.05, 1.35810}, {0.01, 1.62762}, {0.001, 1.94947}};
  for (const auto& [probability, critical] : table) {
    EXPECT_NEAR(critical_distance(probability, many, many) * root, critical, 5e-5);
    EXPECT_NEAR(kolmogorov_probability(critical / root, many, many), probability,
                1e-3 * probability);
  }
}

/// The exact probability that two samples of `n` are `k` / n apart or more: the share of the orders
/// of their values, paths over an n by n lattice, that come so far from the diagonal.
double share_of_paths(int n, int k) {
  const auto count = [n](int most) {  // paths with |i - j| at most `most`
    const auto size = static_cast<std::size_t>(n) + 1;
    std::vector<double> paths(size * size);
    for (std::size_t i = 0; i < size; ++i) {
      for (std::size_t j = 0; j < size; ++j) {
        const double left = j > 0 ? paths[i * size + j - 1] : 0.0;
        const double below = i > 0 ? paths[(i - 1) * size + j] : 0.0;
        const int apart = std::abs(static_cast<int>(i) - static_cast<int>(j));
        paths[i * size + j] = apart > most ? 0.0 : i + j == 0 ? 1.0 : left + below;
      }
    }
    return paths.back();
  };
  return 1.0 - count(k - 1) / count(n);
}

TEST(Kolmogorov, IsNearTheExactValuesOfSmallSamples) {
  EXPECT_NEAR(share_of_paths(20, 9), 0.0335, 5e-5) << "as in Massey's table (1951)";
  for (const int n : {10, 20, 100}) {
    for (const double x : {1.0, 1.3, 1.6}) {
      const int k = static_cast<int>(std::ceil(x * std::sqrt(2.0 * n)));
      const auto size = static_cast<std::size_t>(n);
      const double exact = share_of_paths(n, k);
      const double limit = kolmogorov_probability(static_cast<double>(k) / n, size, size);
      EXPECT_NEAR(limit, exact, 0.004) << n << ", " << k;
      EXPECT_GE(limit, exact < 0.1 ? exact : 0.0) << n << ", " << k << ": the safe side";
    }
  }
}

TEST(Kolmogorov, DistanceIsThatOfTheDistributionFunctions) {
  EXPECT_EQ(kolmogorov_distance({1, 2, 3}, {1, 2, 3}), 0.0);
  EXPECT_EQ(kolmogorov_distance({1, 2}, {3, 4, 5}), 1.0);
  EXPECT_DOUBLE_EQ(kolmogorov_distance({1, 2, 3, 4}, {3, 4, 5, 6}), 0.5);
  EXPECT_DOUBLE_EQ(kolmogorov_distance({1, 1, 1, 2}, {1, 2, 2, 2}), 0.5) << "equal values";
  EXPECT_EQ(kolmogorov_probability(0.0, 50, 50), 1.0);
}

TEST(Kolmogorov, RefusesAsOftenAsItSays) {
  int refused = 0;
  const int tries = 400;
  for (std::uint64_t seed = 1; seed <= tries; ++seed) {
    const auto one = uniform(2 * seed, 100);
    const auto other = uniform(2 * seed + 1, 100);
    refused += kolmogorov_probability(kolmogorov_distance(one, other), 100, 100) <= 0.05 ? 1 : 0;
  }
  // 20 are expected, at most: distances come in steps; 20 +- 4 standard deviations of 4.4
  EXPECT_LE(refused, 38);
  EXPECT_GE(refused, 3);
}

TEST(Kolmogorov, AShiftByTheVisibleOneIsSeen) {
  const auto sample = uniform(5, 1000);
  const double critical = critical_distance(0.001, 1000, 1000);
  const double shift = visible_shift(sample, critical);
  std::vector<double> moved = sample;
  for (double& value : moved) {
    value += shift;
  }
  EXPECT_NEAR(kolmogorov_distance(sample, moved), critical, 2e-3) << "a rank is 1e-3";
}

TEST(EnergyDistance, IsThatOfAllPairs) {
  const auto one = uniform(1, 60);
  const auto other = uniform(2, 40, 0.2);
  const auto mean = [](const std::vector<double>& a, const std::vector<double>& b) {
    double sum = 0.0;
    for (const double x : a) {
      for (const double y : b) {
        sum += std::abs(x - y);
      }
    }
    return sum / static_cast<double>(a.size() * b.size());
  };
  const double between = 2.0 * mean(one, other);
  const double expected = (between - mean(one, one) - mean(other, other)) / between;
  EXPECT_NEAR(energy_coefficient(one, other), expected, 1e-13);
  EXPECT_DOUBLE_EQ(energy_coefficient({1.0}, {2.0}), 1.0) << "two points apart";
  EXPECT_EQ(energy_coefficient({1.0, 1.0}, {1.0}), 0.0) << "one point";
}

TEST(EnergyDistance, RefusesAsOftenAsItSays) {
  int refused = 0;
  for (std::uint64_t seed = 1; seed <= 200; ++seed) {
    const auto one = uniform(2 * seed, 50);
    const auto other = uniform(2 * seed + 1, 50);
    refused += energy_probability(one, other, seed, 199) <= 0.05 ? 1 : 0;
  }
  EXPECT_LE(refused, 22) << "10 are expected, with a standard deviation of 3";
  EXPECT_GE(refused, 1);
  EXPECT_DOUBLE_EQ(energy_probability(uniform(1, 50), uniform(2, 50, 0.5), 1, 999), 1e-3);
}

// Holm (1979): 0.01, 0.02, 0.03 of four tests become 0.04, 0.06, 0.06
TEST(Holm, AsksTheMostOfTheLikeliest) {
  const std::vector<double> adjusted = holm({0.03, 0.01, 0.5, 0.02});
  EXPECT_DOUBLE_EQ(adjusted[1], 0.04);
  EXPECT_DOUBLE_EQ(adjusted[3], 0.06);
  EXPECT_DOUBLE_EQ(adjusted[0], 0.06);
  EXPECT_DOUBLE_EQ(adjusted[2], 0.5);
}

// the median of 100 values lies between those of rank 40 and 61, in any table of order statistics
TEST(Quantiles, HaveTheIntervalsOfTheTables) {
  EnsembleSample sample;
  for (int rank = 1; rank <= 100; ++rank) {
    sample.values.push_back(rank);
  }
  const Summary summary = summary_of(sample);
  const Quantile& median = summary.quantiles[median_place];
  EXPECT_EQ(median.value, 50.0);
  EXPECT_EQ(median.low, 40.0);
  EXPECT_EQ(median.high, 61.0);
  EXPECT_DOUBLE_EQ(summary.mean, 50.5);
  EXPECT_NEAR(summary.deviation, std::sqrt(100.0 * 101.0 / 12.0), 1e-12);
}

TEST(Quantiles, CountDrawsWithoutAValueAsTheLargest) {
  EnsembleSample sample;
  sample.values = {1, 2, 3, 4};
  sample.without = 6;
  EXPECT_FALSE(summary_of(sample).quantiles[median_place].value);
  EXPECT_EQ(summary_of(sample).quantiles[1].value, 3.0);
  EXPECT_FALSE(summary_of(sample).quantiles[1].high);
}

}  // namespace
}  // namespace tautline::bench
