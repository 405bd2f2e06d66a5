// What the protocol costs beside the engine: steps of a child that computes next to nothing.
#include <benchmark/benchmark.h>

#include <string>

#include "bench/base/process.hpp"
#include "bench/run/protocol/children.hpp"
#include "tautline/scenarios.hpp"

namespace tautline::bench {
namespace {

constexpr double dt = 1e-4;  // [s]; most of the digits of a number are then needed

/// Time and processor time of one step, at `state.range(0)` steps a message.
void steps_of(benchmark::State& state, const std::vector<std::string>& command) {
  Children children({command, TAUTLINE_BENCHMARK_CHILDREN, std::size_t{2} << 30U});
  const Case the_case = breakwater(table_5_1().front().parameters, "standard");
  const auto count = static_cast<std::size_t>(state.range(0));
  try {
    const Children::Lease child(children);
    static_cast<void>(child->start(the_case, child->info().models.front(), dt));
    const double before = children.processor_time();
    std::size_t steps = 0;
    for ([[maybe_unused]] const auto _ : state) {
      benchmark::DoNotOptimize(child->step(dt, count).values.data());
      steps += count;
    }
    using benchmark::Counter;
    const auto all = static_cast<double>(steps);
    state.counters["time/step"] = Counter(all, Counter::kIsRate | Counter::kInvert);
    state.counters["child_cpu/step"] = Counter((children.processor_time() - before) / all);
  } catch (const std::exception& error) {  // no such program here
    state.SkipWithError(error.what());
  }
}

BENCHMARK_CAPTURE(steps_of, node, {"node", "trivial.mjs"})
    ->Arg(1)
    ->Arg(10)
    ->Arg(100)
    ->UseRealTime();
BENCHMARK_CAPTURE(steps_of, python, {"python3", "trivial.py"})
    ->Arg(1)
    ->Arg(10)
    ->Arg(100)
    ->UseRealTime();

}  // namespace
}  // namespace tautline::bench
