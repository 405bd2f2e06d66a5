#include "bench/ensemble/output/results_so_far.hpp"

#include <algorithm>
#include <utility>

namespace tautline::bench {

ResultsSoFar::ResultsSoFar(Write write, std::function<double()> clock)
    : write_(std::move(write)), clock_(std::move(clock)), due_(clock_() + pause) {}

void ResultsSoFar::offer(const EnsembleResult& so_far) {
  const double start = clock_();
  if (start < due_) {
    return;
  }
  write_(so_far);
  const double end = clock_();
  due_ = end + std::max(pause, (end - start) / part);
}

}  // namespace tautline::bench
