#pragma once

#include <LCP.hpp>

#include <stdexcept>
#include <string>

namespace tautline::siconos_engine {

/// A linear complementarity problem of impulses that is solved, or throws std::runtime_error.
/// Siconos goes on with what a solver that failed has left, time-stepping after a line on the
/// standard output, `EventDriven` without a word.
class CheckedLcp final : public LCP {
 public:
  int compute(double time) override {
    const int code = LCP::compute(time);
    if (code != 0) {
      throw std::runtime_error("the solver of the impulses fails, code " + std::to_string(code));
    }
    return code;
  }
};

}  // namespace tautline::siconos_engine
