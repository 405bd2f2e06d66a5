#include "bench/ensemble/compare/comparison.hpp"

#include <algorithm>
#include <atomic>
#include <cmath>
#include <numeric>
#include <thread>

#include "bench/ensemble/compare/energy_distance.hpp"
#include "bench/ensemble/compare/kolmogorov.hpp"

namespace tautline::bench {
namespace {

/// Values that one test may permute in all: some seconds of work.
constexpr double most_permuted = 2e8;

/// Enough for a probability that is half of what Holm asks of the likeliest of `tests`, unless the
/// samples are so large that it would take minutes.
std::size_t permutations_for(std::size_t tests, std::size_t values) {
  const double wanted = 2.0 * static_cast<double>(tests) / error_rate;
  const double most = most_permuted / static_cast<double>(values);
  return static_cast<std::size_t>(std::ceil(std::max(999.0, std::min(wanted, most))));
}

/// A pair of samples to be told apart.
struct Pair {
  const Sample* first;
  const Sample* second;
  Comparison found;
};

bool can_be_tested(const Sample& first, const Sample& second) {
  return std::min(first.size(), second.size()) >= least_sample &&
         std::max(first.values.size(), second.values.size()) >= least_sample;
}

bool has_energy(const Sample& first, const Sample& second) {
  return std::min(first.values.size(), second.values.size()) >= least_sample;
}

std::optional<double> median_change(const Sample& first, const Sample& second) {
  const auto one = summary_of(first).quantiles[median_place].value;
  const auto other = summary_of(second).quantiles[median_place].value;
  return one && other ? std::optional(*other - *one) : std::nullopt;
}

void test(Pair& pair, std::uint64_t seed, std::size_t tests) {
  const Sample& first = *pair.first;
  const Sample& second = *pair.second;
  Comparison& found = pair.found;
  found.kolmogorov.effect = kolmogorov_distance(first.with_none_last(), second.with_none_last());
  found.kolmogorov.probability =
      kolmogorov_probability(found.kolmogorov.effect, first.size(), second.size());
  found.median_change = median_change(first, second);
  // Holm asks this of the first test that he refuses where he has refused none before
  found.visible =
      critical_distance(error_rate / static_cast<double>(tests), first.size(), second.size());
  if (const double shift = visible_shift(first.values, found.visible);
      shift > 0.0 && std::isfinite(shift)) {
    found.visible_shift = shift;
  }
  if (found.energy) {
    found.energy->effect = energy_coefficient(first.values, second.values);
    found.energy->probability =
        energy_probability(first.values, second.values, seed,
                           permutations_for(tests, first.values.size() + second.values.size()));
  }
}

/// Holm over the tests of all pairs.
void adjust(std::vector<Pair>& pairs) {
  std::vector<Test*> tests;
  for (Pair& pair : pairs) {
    tests.push_back(&pair.found.kolmogorov);
    if (pair.found.energy) {
      tests.push_back(&*pair.found.energy);
    }
  }
  std::vector<double> probabilities;
  probabilities.reserve(tests.size());
  for (const Test* one : tests) {
    probabilities.push_back(one->probability);
  }
  const std::vector<double> adjusted = holm(probabilities);
  for (std::size_t place = 0; place < tests.size(); ++place) {
    tests[place]->adjusted = adjusted[place];
  }
}

std::vector<Pair> pairs_of(const std::vector<Setup>& setups,
                           const std::vector<Statistic>& statistics,
                           const std::vector<std::vector<Sample>>& samples) {
  std::vector<Pair> pairs;
  for (std::size_t setup = 1; setup < samples.size(); ++setup) {
    for (std::size_t place = 0; place < statistics.size(); ++place) {
      const Sample& first = samples.front()[place];
      const Sample& second = samples[setup][place];
      const bool known = !setups[setup].engine || statistics[place].of_engines;
      if (!known || !statistics[place].compared || !can_be_tested(first, second)) {
        continue;
      }
      Pair& pair = pairs.emplace_back(Pair{&first, &second, {}});
      pair.found.setup = setup;
      pair.found.statistic = place;
      if (has_energy(first, second)) {
        pair.found.energy = Test();
      }
    }
  }
  return pairs;
}

/// Tests all pairs, `jobs` at a time.
void test_all(std::vector<Pair>& pairs, std::uint64_t seed, unsigned jobs) {
  std::size_t tests = 0;
  for (const Pair& pair : pairs) {
    tests += pair.found.energy ? 2U : 1U;
  }
  std::atomic<std::size_t> next{0};
  std::vector<std::jthread> workers;
  for (unsigned job = 0; job < jobs; ++job) {
    workers.emplace_back([&] {
      for (std::size_t index = next++; index < pairs.size(); index = next++) {
        test(pairs[index], seed + index, tests);
      }
    });
  }
}

}  // namespace

std::size_t Findings::tests() const {
  std::size_t count = 0;
  for (const Comparison& one : comparisons) {
    count += one.energy ? 2U : 1U;
  }
  return count;
}

std::vector<double> holm(const std::vector<double>& probabilities) {
  std::vector<std::size_t> order(probabilities.size());
  std::iota(order.begin(), order.end(), std::size_t{0});
  std::stable_sort(order.begin(), order.end(), [&](std::size_t one, std::size_t other) {
    return probabilities[one] < probabilities[other];
  });
  std::vector<double> adjusted(probabilities.size());
  double largest = 0.0;
  for (std::size_t rank = 0; rank < order.size(); ++rank) {
    const auto left = static_cast<double>(order.size() - rank);
    largest = std::max(largest, std::min(1.0, left * probabilities[order[rank]]));
    adjusted[order[rank]] = largest;
  }
  return adjusted;
}

Findings findings_of(const EnsembleRequest& request, const EnsembleResult& result, unsigned jobs) {
  Findings findings;
  findings.statistics = statistics_of(request.spec);
  std::vector<std::vector<Sample>> samples;
  for (const std::vector<DrawResult>& draws : result.draws) {
    std::vector<Sample>& of_setup = samples.emplace_back();
    std::vector<Summary>& summaries = findings.summaries.emplace_back();
    for (std::size_t place = 0; place < findings.statistics.size(); ++place) {
      of_setup.push_back(sample_of(draws, place));
      summaries.push_back(summary_of(of_setup.back()));
    }
    const auto bad = [](const DrawResult& draw) { return !draw.problem.empty(); };
    const auto first = std::find_if(draws.begin(), draws.end(), bad);
    findings.problems.push_back(
        static_cast<std::size_t>(std::count_if(draws.begin(), draws.end(), bad)));
    findings.first_problems.push_back(first != draws.end() ? first->problem : "");
  }
  std::vector<Pair> pairs = pairs_of(request.setups, findings.statistics, samples);
  test_all(pairs, request.spec.seed, jobs);
  adjust(pairs);
  findings.comparisons.reserve(pairs.size());
  for (const Pair& pair : pairs) {
    findings.comparisons.push_back(pair.found);
  }
  return findings;
}

}  // namespace tautline::bench
