#pragma once

#include <cstddef>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "bench/store/plan.hpp"

namespace tautline::bench {

/// More shards than this are refused: a shard solves every case of its suite, however few its runs.
inline constexpr std::size_t most_shards = 10'000;

/// "3/16" is the third of sixteen; none if `text` is no such thing.
[[nodiscard]] std::optional<Shard> shard_from(std::string_view text);

/// "3/16"
[[nodiscard]] std::string to_string(Shard shard);

/// What a run is expected to cost, in steps of an engine: its own, and what every run costs beside
/// them.
[[nodiscard]] double expected_cost(const SuiteOptions& options, const PlannedRun& run);

/// The number of the shard that each run of `plan(options)` falls to, if there are `shards`. It
/// follows from the plan alone. All shards are expected to cost about the same, and have about as
/// many runs of every model.
[[nodiscard]] std::vector<std::size_t> shard_numbers(const SuiteOptions& options,
                                                     std::size_t shards);

/// The places in `plan(options)` of the runs of `options.shard`, rising.
[[nodiscard]] std::vector<std::size_t> places_in_shard(const SuiteOptions& options);

}  // namespace tautline::bench
