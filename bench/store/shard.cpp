#include "bench/store/shard.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <charconv>
#include <numeric>
#include <tuple>

namespace tautline::bench {
namespace {

/// What a run costs beside its steps, in steps: a process, the engine's library, and the comparison
/// with the exact motion. Measured on ten engines, where it was that of 2,000 to 20,000 steps.
constexpr double cost_beside_steps = 5'000;

/// A whole number in decimals from 1 on; 0 if `text` is none.
std::size_t counting_number(std::string_view text) {
  std::size_t value = 0;
  const auto [end, error] = std::from_chars(text.data(), text.data() + text.size(), value);
  return error == std::errc() && end == text.data() + text.size() ? value : 0;
}

}  // namespace

std::optional<Shard> shard_from(std::string_view text) {
  const std::size_t slash = text.find('/');
  if (slash == std::string_view::npos) {
    return std::nullopt;
  }
  const Shard shard = {counting_number(text.substr(0, slash)),
                       counting_number(text.substr(slash + 1))};
  const bool sound = shard.number >= 1 && shard.number <= shard.of && shard.of <= most_shards;
  return sound ? std::optional(shard) : std::nullopt;
}

std::string to_string(Shard shard) { return fmt::format("{}/{}", shard.number, shard.of); }

double expected_cost(const SuiteOptions& options, const PlannedRun& run) {
  return duration_of(options.cases[run.the_case]) / run.step + cost_beside_steps;
}

std::vector<std::size_t> shard_numbers(const SuiteOptions& options, std::size_t shards) {
  const std::vector<PlannedRun> runs = plan(options);
  std::vector<std::size_t> order(runs.size());
  std::iota(order.begin(), order.end(), std::size_t{0});
  // The dearest first, each to the shard that has least: no shard ends up with more than the
  // cheapest by over one run. Runs that cost alike come by model, so that each shard gets its share
  // of a slow engine.
  const auto place = [&](std::size_t index) {
    const PlannedRun& run = runs[index];
    return std::make_tuple(-expected_cost(options, run), run.engine, std::cref(run.model.name),
                           index);
  };
  std::sort(order.begin(), order.end(),
            [&](std::size_t one, std::size_t other) { return place(one) < place(other); });
  std::vector<double> load(shards, 0.0);
  std::vector<std::size_t> numbers(runs.size());
  for (const std::size_t index : order) {
    const auto least = std::min_element(load.begin(), load.end());
    *least += expected_cost(options, runs[index]);
    numbers[index] = static_cast<std::size_t>(least - load.begin()) + 1;
  }
  return numbers;
}

std::vector<std::size_t> places_in_shard(const SuiteOptions& options) {
  const std::vector<std::size_t> numbers = shard_numbers(options, options.shard.of);
  std::vector<std::size_t> places;
  for (std::size_t index = 0; index < numbers.size(); ++index) {
    if (numbers[index] == options.shard.number) {
      places.push_back(index);
    }
  }
  return places;
}

}  // namespace tautline::bench
