#include "bench/ensemble/output/comparison.hpp"

#include <algorithm>
#include <atomic>
#include <cmath>
#include <numeric>
#include <thread>

#include "bench/base/listed.hpp"
#include "bench/ensemble/output/energy_distance.hpp"
#include "bench/ensemble/output/kolmogorov.hpp"

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

/// How many values of a statistic are held.
struct Held {
  std::size_t count;
  std::size_t without;
};

bool can_be_tested(const Held& first, const Held& second) {
  return std::min(first.count + first.without, second.count + second.without) >= least_sample &&
         std::max(first.count, second.count) >= least_sample;
}

bool has_energy(const Held& first, const Held& second) {
  return std::min(first.count, second.count) >= least_sample;
}

std::optional<double> median_change(const Summary& first, const Summary& second) {
  const auto one = first.quantiles[median_place].value;
  const auto other = second.quantiles[median_place].value;
  return one && other ? std::optional(*other - *one) : std::nullopt;
}

/// Both samples are made again for each test: together they would take as much as all draws.
void test(Comparison& found, const EnsembleResult& result, std::uint64_t seed, std::size_t tests) {
  const EnsembleSample first = sample_of(result.draws.front(), found.statistic);
  const EnsembleSample second = sample_of(result.draws[found.setup], found.statistic);
  found.kolmogorov.effect = kolmogorov_distance(first.with_none_last(), second.with_none_last());
  found.kolmogorov.probability =
      kolmogorov_probability(found.kolmogorov.effect, first.size(), second.size());
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

/// Holm over the tests of all comparisons.
void adjust(std::vector<Comparison>& comparisons) {
  std::vector<Test*> tests;
  for (Comparison& one : comparisons) {
    tests.push_back(&one.kolmogorov);
    if (one.energy) {
      tests.push_back(&*one.energy);
    }
  }
  const std::vector<double> probabilities =
      listed(tests, [](const Test* one) { return one->probability; });
  const std::vector<double> adjusted = holm(probabilities);
  for (std::size_t place = 0; place < tests.size(); ++place) {
    tests[place]->adjusted = adjusted[place];
  }
}

/// What is to be compared, not yet tested. `held`: by setup, by statistic.
std::vector<Comparison> planned_comparisons(const std::vector<EnsembleSetup>& setups,
                                            const Findings& findings,
                                            const std::vector<std::vector<Held>>& held) {
  std::vector<Comparison> comparisons;
  for (std::size_t setup = 1; setup < held.size(); ++setup) {
    for (std::size_t place = 0; place < findings.statistics.size(); ++place) {
      const Statistic& statistic = findings.statistics[place];
      const Held& first = held.front()[place];
      const Held& second = held[setup][place];
      const bool known = !setups[setup].engine || statistic.of_engines == OfEngines::all;
      if (!known || !statistic.compared || !can_be_tested(first, second)) {
        continue;
      }
      Comparison& one = comparisons.emplace_back();
      one.setup = setup;
      one.statistic = place;
      one.draws = second.count + second.without;
      one.median_change =
          median_change(findings.summaries.front()[place], findings.summaries[setup][place]);
      if (has_energy(first, second)) {
        one.energy = Test();
      }
    }
  }
  return comparisons;
}

/// Makes all comparisons, `jobs` at a time.
void test_all(Findings& findings, const EnsembleResult& result, std::uint64_t seed, unsigned jobs) {
  const std::size_t tests = findings.tests();
  std::vector<Comparison>& all = findings.comparisons;
  std::atomic<std::size_t> next{0};
  std::vector<std::jthread> workers;
  for (unsigned job = 0; job < jobs; ++job) {
    workers.emplace_back([&] {
      for (std::size_t index = next++; index < all.size(); index = next++) {
        test(all[index], result, seed + index, tests);
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

bool tells(const EnsembleSetup& setup, const Statistic& statistic, const Summary& summary) {
  if (!setup.engine) {
    return statistic.of_exact;
  }
  return statistic.of_engines == OfEngines::all ||
         (statistic.of_engines == OfEngines::some && summary.count > 0);
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
  std::vector<std::vector<Held>> held;
  for (const DrawTable& draws : result.draws) {
    std::vector<Summary>& summaries = findings.summaries.emplace_back();
    std::vector<Held>& counts = held.emplace_back();
    for (std::size_t place = 0; place < findings.statistics.size(); ++place) {
      const EnsembleSample sample = sample_of(draws, place);
      counts.push_back({sample.values.size(), sample.without});
      summaries.push_back(draws.holds_all() ? summary_of(sample) : summary_of(draws.counts(place)));
    }
    findings.problems.push_back(draws.problems());
    findings.first_problems.push_back(draws.first_problem());
  }
  findings.comparisons = planned_comparisons(request.setups, findings, held);
  test_all(findings, result, request.spec.seed, jobs);
  adjust(findings.comparisons);
  return findings;
}

}  // namespace tautline::bench
