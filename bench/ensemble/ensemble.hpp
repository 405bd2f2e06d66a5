#pragma once

#include <cstddef>
#include <cstdint>
#include <filesystem>
#include <functional>
#include <vector>

#include "bench/ensemble/draw_table.hpp"
#include "bench/ensemble/team.hpp"

namespace tautline::bench {

struct EnsembleResult {
  std::vector<DrawTable> draws;  // of each setup
  bool interrupted = false;
  bool goes_on = false;  // these are the draws so far
};

/// How an ensemble is solved. None of it has a part in the results.
struct EnsembleOptions {
  std::filesystem::path out;            // the folder that keeps the draws; empty: none does
  unsigned jobs = 1;                    // threads
  bool resume = false;                  // keep the draws that `out` already has
  std::vector<std::uint64_t> programs;  // of each setup, a hash of the programs it depends on
  Team* team = nullptr;  // that shares the draws: each of its processes puts its own into `out`
                         // alone, and has none of them in its result
  /// Shown what is there after each chunk, by one thread at a time. Not with a team.
  std::function<void(const EnsembleResult&)> so_far = [](const EnsembleResult&) {};
};

/// Told of so many draws that ended, from one thread at a time; `kept` if they had been done
/// before. Of a team's draws it is told when one of its processes begins what comes after them:
/// some of them may go on, and `kept` is never said.
using DrawProgress = std::function<void(const EnsembleSetup& setup, std::size_t draws, bool kept)>;

/// Solves every draw for every setup, the setups side by side: what is there after an interruption
/// can be compared. Throws FileError if a result cannot be written.
[[nodiscard]] EnsembleResult solve_ensemble(const EnsembleRequest& request,
                                            const EnsembleOptions& options,
                                            const DrawProgress& progress);

}  // namespace tautline::bench
