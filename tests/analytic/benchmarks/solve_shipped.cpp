// Solves the shipped cases once, for a processor simulated by callgrind: `load` only makes them,
// `plain` solves them, `bounds` follows the errors of the solutions too. Prints how many impacts
// there are.

#include <cstdio>
#include <string_view>

#include "tautline/scenarios.hpp"
#include "tautline/solve.hpp"
#include "tautline/uncertainty.hpp"

int main(int argc, char** argv) {
  const std::string_view what = argc > 1 ? argv[1] : "";
  std::size_t impacts = 0;
  std::size_t sure = 0;
  for (const tautline::Case& the_case : tautline::shipped_cases()) {
    if (what == "load") {
      continue;
    }
    const tautline::Solution solution = tautline::solve(the_case);
    for (const tautline::Event& event : solution.events()) {
      impacts += event.kind == tautline::EventKind::impact ? 1U : 0U;
    }
    if (what == "bounds") {
      sure += tautline::Uncertainty(the_case, solution, {}).horizon() ? 0U : 1U;
    }
  }
  std::printf("%zu impacts, %zu solutions sure to their end\n", impacts, sure);
}
