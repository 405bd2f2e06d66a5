// What a motion costs in solve_batch, for languages/python/measure.py: prints seconds of processor
// time, the best of three runs over as many starts of the standard case as its argument says.
#include "tautline/solve_batch.hpp"

#include <algorithm>
#include <cstdlib>
#include <ctime>
#include <iostream>
#include <limits>
#include <vector>

#include "tautline/scenarios.hpp"

int main(int count_of_words, char** words) {
  const int count = count_of_words == 2 ? std::atoi(words[1]) : 1000;
  std::vector<tautline::Case> cases;
  for (int index = 0; index < count; ++index) {
    cases.push_back(tautline::shipped_cases().front());
    cases.back().initial.position.x() = 0.1 + 1e-3 * (2.0 * index / count - 1.0);
  }
  double best = std::numeric_limits<double>::infinity();
  double sum = 0.0;  // of something, so that nothing is left out
  for (int run = 0; run < 3; ++run) {
    const std::clock_t start = std::clock();
    tautline::solve_batch(cases, {}, [&](std::size_t, const tautline::Solution& solution) {
      sum += solution.end_time();
    });
    best = std::min(best, static_cast<double>(std::clock() - start) / CLOCKS_PER_SEC / count);
  }
  std::cout << best << "\n";
  return sum > 0.0 ? 0 : 1;
}
