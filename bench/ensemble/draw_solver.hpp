#pragma once

#include <cstddef>
#include <memory>
#include <string>
#include <vector>

#include "bench/ensemble/setup.hpp"
#include "bench/ensemble/spec.hpp"
#include "bench/ensemble/statistic.hpp"
#include "bench/run/registry.hpp"
#include "bench/run/worker.hpp"

namespace tautline::bench {

/// What became of one draw.
struct DrawResult {
  std::size_t draw = 0;    // its index
  std::string problem;     // why there are no values, or empty
  StatisticValues values;  // as many as `statistics_of`, or none with a problem
};

/// Draws of one setup in, the statistics of each out. One for each thread.
class DrawSolver {
 public:
  virtual ~DrawSolver() = default;

  /// The draws from `first` up to `end`, in their order; fewer if the program was interrupted.
  [[nodiscard]] virtual std::vector<DrawResult> solve(std::size_t first, std::size_t end) = 0;
};

/// What all solvers of an ensemble share. It outlives them.
struct EnsembleRequest {
  EnsembleSpec spec;
  std::vector<RegisteredEngine> engines;
  std::vector<EnsembleSetup> setups;
  WorkerLimits limits;  // of an engine's run
};

/// The solver of one setup: exact motions one after another, or runs of an engine in workers.
[[nodiscard]] std::unique_ptr<DrawSolver> draw_solver(const EnsembleRequest& request,
                                                      const EnsembleSetup& setup);

/// Draws that are solved in one go, and kept in one file: some seconds of work at most.
[[nodiscard]] std::size_t chunk_size(const EnsembleSetup& setup);

}  // namespace tautline::bench
