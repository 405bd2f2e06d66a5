#pragma once

#include <cstddef>
#include <optional>
#include <span>
#include <vector>

#include "bench/run/trajectory.hpp"

namespace tautline::bench {

/// Whether an instant that an engine names is one of the run's, but for rounding.
[[nodiscard]] bool within_run(const Case& the_case, double time);

/// Turns impulses and located events into impacts, step by step.
class ImpactDetector {
 public:
  /// Impacts that close slower than `slowest` [m/s] are only counted.
  ImpactDetector(const Case& the_case, double slowest);

  /// Takes one step from `before` at `start` to `after`. Throws std::runtime_error if what the
  /// simulation says of it makes no sense.
  void take(double start, double dt, const State& before, const State& after,
            const Simulation& simulation);

  /// Puts the impacts of the whole run into `run`, in rising time.
  void finish(Trajectory& run);

 private:
  void take_located(const Event& event);
  [[nodiscard]] Eigen::Vector3d unexplained(const State& before, const State& after,
                                            std::span<const double> impulses, double dt) const;
  void extend(std::size_t index, double start, double dt, const State& before, const State& after,
              double impulse);
  void close(std::size_t index);
  void keep(const RecordedImpact& impact);

  const Case& case_;
  double slowest_;                                     // [m/s]
  std::vector<std::optional<RecordedImpact>> bursts_;  // one per cable: the impact now going on
  std::vector<bool> turned_;                           // of each burst: it closes no more
  double threshold_;                                   // [N s]
  std::vector<RecordedImpact> impacts_;
  std::size_t slow_impacts_ = 0;
};

}  // namespace tautline::bench
