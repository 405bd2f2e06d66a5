#include <benchmark/benchmark.h>

#include "tautline/geometry.hpp"
#include "tautline/impact.hpp"

namespace tautline {
namespace {

/// A body that falls onto `count` cables at once, all from anchors above it.
Case falling_on(int count) {
  Case result;
  result.body = {1.0, 0.05};
  result.initial.velocity = Vec2(0.1, -1.0);
  for (int k = 0; k < count; ++k) {
    const double side = (k % 2 == 0) ? -1.0 : 1.0;
    Cable cable;
    cable.anchor = Vec2(side * (0.5 + 0.2 * k), 1.0 + 0.1 * k);
    cable.attachment = Vec2(0.2 * side, 0.05 * k);
    cable.length = (attachment_point(result.initial, cable) - cable.anchor).norm();
    cable.restitution = 0.8;
    result.cables.push_back(cable);
  }
  return result;
}

void impact_on_cables(benchmark::State& state) {
  const Case the_case = falling_on(static_cast<int>(state.range(0)));
  CableSet cables;
  for (std::size_t index = 0; index < the_case.cables.size(); ++index) {
    cables.insert(index);
  }
  for ([[maybe_unused]] const auto _ : state) {
    benchmark::DoNotOptimize(newton_impact(the_case, the_case.initial, cables).after);
  }
}

BENCHMARK(impact_on_cables)->Arg(1)->Arg(4);

}  // namespace
}  // namespace tautline
