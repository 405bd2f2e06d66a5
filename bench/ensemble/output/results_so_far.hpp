#pragma once

#include <functional>

#include "bench/ensemble/ensemble.hpp"

namespace tautline::bench {

/// Has the results so far written while draws go on, seldom enough to cost little.
class ResultsSoFar {
 public:
  using Write = std::function<void(const EnsembleResult&)>;

  /// `clock` [s], never back.
  ResultsSoFar(Write write, std::function<double()> clock);

  /// Has `so_far` written where that is due: first after `pause`, and then after a pause of at
  /// least that, of which writing takes no more than `part`. By one thread at a time.
  void offer(const EnsembleResult& so_far);

  static constexpr double pause = 10.0;  // [s]
  static constexpr double part = 0.05;   // [-]

 private:
  Write write_;
  std::function<double()> clock_;
  double due_;  // [s], by the clock
};

}  // namespace tautline::bench
