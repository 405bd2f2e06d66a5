#include <benchmark/benchmark.h>

#include <string>

#include "tautline/scenarios.hpp"
#include "tautline/solve.hpp"
#include "tautline/system.hpp"

namespace tautline {
namespace {

/// Solves `the_case` with all its events.
template <class TheCase>
void solve_all_of(benchmark::State& state, const TheCase& the_case) {
  std::size_t events = 0;
  for ([[maybe_unused]] const auto _ : state) {
    const auto solution = solve(the_case);
    events += solution.events().size();
    benchmark::DoNotOptimize(solution.end_time());
  }
  state.counters["events"] =
      benchmark::Counter(static_cast<double>(events), benchmark::Counter::kIsRate);
  state.counters["per event"] = benchmark::Counter(
      static_cast<double>(events), benchmark::Counter::kIsRate | benchmark::Counter::kInvert);
}

/// A case of Table 5.1 to t = 20.
Case table_case(std::size_t row) {
  const TableRow table_row = table_5_1()[row];
  return breakwater(table_row.parameters, std::string(table_row.number));
}

void solve_table_row(benchmark::State& state, std::size_t row) {
  solve_all_of(state, table_case(row));
}

/// The same by the general kernel.
void solve_as_system(benchmark::State& state, std::size_t row) {
  solve_all_of(state, as_system(table_case(row)));
}

BENCHMARK_CAPTURE(solve_table_row, standard_case_to_20, 0);
BENCHMARK_CAPTURE(solve_table_row, restitution_0_5, 8);
BENCHMARK_CAPTURE(solve_table_row, elastic, 6);
BENCHMARK_CAPTURE(solve_as_system, standard_case_to_20, 0);
BENCHMARK_CAPTURE(solve_as_system, restitution_0_5, 8);

}  // namespace
}  // namespace tautline
