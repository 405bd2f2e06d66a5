#pragma once

#include <fmt/format.h>

#include <chrono>
#include <cstdio>

namespace tautline::bench {

/// Says on standard error with how many digits the motion is solved next, where it takes long.
class PatienceNote {
 public:
  void operator()(int digits) const {
    constexpr std::chrono::seconds long_enough{1};
    if (std::chrono::steady_clock::now() - begin_ >= long_enough) {
      fmt::print(stderr, "tautline: going on with numbers of {} digits\n", digits);
    }
  }

 private:
  std::chrono::steady_clock::time_point begin_ = std::chrono::steady_clock::now();
};

}  // namespace tautline::bench
