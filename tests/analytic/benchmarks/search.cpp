#include <benchmark/benchmark.h>

#include <vector>

#include "tautline/detail/first_contact.hpp"
#include "tautline/scenarios.hpp"
#include "tautline/solve.hpp"

namespace tautline {
namespace {

/// The search alone, on the flights of the standard case: two cables, the one just hit touching.
void first_contact_per_arc(benchmark::State& state) {
  const TableRow row = table_5_1().front();
  const Case the_case = breakwater(row.parameters, "standard");
  const Solution solution = solve(the_case);
  std::vector<const Event*> impacts;
  for (const Event& event : solution.events()) {
    if (event.kind == EventKind::impact) {
      impacts.push_back(&event);
    }
  }
  long steps = 0;
  std::size_t next = 0;
  for ([[maybe_unused]] const auto _ : state) {
    const Event& event = *impacts[next];
    next = (next + 1) % impacts.size();
    const auto search = first_contact(the_case, event.after, {event.cables, 0.0}, 10.0);
    steps += search.steps;
    benchmark::DoNotOptimize(search.contact);
  }
  state.counters["steps"] =
      benchmark::Counter(static_cast<double>(steps), benchmark::Counter::kAvgIterations);
}

BENCHMARK(first_contact_per_arc);

}  // namespace
}  // namespace tautline
