// What the C interface costs: a call in which nothing happens, a million states, and a sweep
// compared with solve_batch of the same cases in one thread.

#include <benchmark/benchmark.h>

#include <vector>

#include "owned.hpp"
#include "tautline/scenarios.hpp"
#include "tautline/solve_batch.hpp"

namespace tautline::c::test {
namespace {

constexpr std::size_t samples = 200;
constexpr double duration = 20.0;  // [s]

/// The first case of Table 5.1 with other starts.
std::vector<Case> neighbours() {
  Breakwater parameters = table_5_1().front().parameters;
  parameters.duration = duration;
  const Vec2 start = parameters.initial.position;
  std::vector<Case> cases;
  for (std::size_t index = 0; index < samples; ++index) {
    parameters.initial.position = start + Vec2(0.0, 1e-6 * static_cast<double>(index));
    cases.push_back(breakwater(parameters, "neighbour"));
  }
  return cases;
}

void states(benchmark::State& state) {
  const OwnedMotion motion = solved(from_numbers(neighbours().front()));
  std::vector<double> times(static_cast<std::size_t>(state.range(0)));
  for (std::size_t index = 0; index < times.size(); ++index) {
    times[index] = duration * static_cast<double>(index) / static_cast<double>(times.size());
  }
  std::vector<double> rows(6 * times.size());
  for (auto _ : state) {
    tautline_states(motion.get(), times.data(), times.size(), rows.data(), nullptr, nullptr);
    benchmark::DoNotOptimize(rows.data());
  }
}
BENCHMARK(states)->Arg(1)->Arg(1'000'000);

void batch_in_cpp(benchmark::State& state) {
  const std::vector<Case> cases = neighbours();
  std::vector<double> ends(cases.size());
  for (auto _ : state) {
    solve_batch(cases, {}, [&](std::size_t index, const Solution& solution) {
      ends[index] = solution.at(solution.end_time()).angle;
    });
    benchmark::DoNotOptimize(ends.data());
  }
}
BENCHMARK(batch_in_cpp);

void sweep(benchmark::State& state) {
  std::vector<OwnedCase> cases;
  std::vector<const tautline_case*> pointers;
  for (const Case& the_case : neighbours()) {
    cases.push_back(from_numbers(the_case));
    pointers.push_back(cases.back().get());
  }
  const double end = duration;
  std::vector<double> states(6 * samples);
  std::vector<tautline_summary> summaries(samples, sized<tautline_summary>());
  for (auto _ : state) {
    tautline_sweep(pointers.data(), samples, nullptr, 1, &end, 1, summaries.data(), nullptr,
                   states.data(), nullptr);
    benchmark::DoNotOptimize(states.data());
  }
}
BENCHMARK(sweep);

void sweep_varied(benchmark::State& state) {
  const OwnedCase base = from_numbers(neighbours().front());
  const char* const name = "y";
  std::vector<double> values(samples);
  const double y = neighbours().front().initial.position.y();
  for (std::size_t index = 0; index < samples; ++index) {
    values[index] = y + 1e-6 * static_cast<double>(index);
  }
  const double end = duration;
  std::vector<double> states(6 * samples);
  for (auto _ : state) {
    tautline_sweep_varied(base.get(), &name, 1, values.data(), samples, nullptr, 1, &end, 1,
                          nullptr, nullptr, states.data(), nullptr);
    benchmark::DoNotOptimize(states.data());
  }
}
BENCHMARK(sweep_varied);

}  // namespace
}  // namespace tautline::c::test
