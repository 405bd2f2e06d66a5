#include <benchmark/benchmark.h>

#include <string>

#include "tautline/scenarios.hpp"
#include "tautline/solve.hpp"

namespace tautline {
namespace {

/// A case of Table 5.1 to t = 20, with all its events.
void solve_table_row(benchmark::State& state, std::size_t row) {
  const TableRow table_row = table_5_1()[row];
  const Case the_case = breakwater(table_row.parameters, std::string(table_row.number));
  std::size_t events = 0;
  for ([[maybe_unused]] const auto _ : state) {
    const Solution solution = solve(the_case);
    events += solution.events().size();
    benchmark::DoNotOptimize(solution.end_time());
  }
  state.counters["events"] =
      benchmark::Counter(static_cast<double>(events), benchmark::Counter::kIsRate);
}

BENCHMARK_CAPTURE(solve_table_row, standard_case_to_20, 0);
BENCHMARK_CAPTURE(solve_table_row, restitution_0_5, 8);
BENCHMARK_CAPTURE(solve_table_row, elastic, 6);

}  // namespace
}  // namespace tautline
