// Solves the shipped cases once, for a processor simulated by callgrind: `load` only makes them,
// `plain` solves them, `bounds` follows the errors of the solutions too. `plane` and `space` solve
// the first events of each as a system, in the plane and in a plane of space, `systems` only makes
// these. Prints how many impacts there are.

#include <cstdio>
#include <string_view>

#include "system/embedding.hpp"
#include "tautline/scenarios.hpp"
#include "tautline/solve.hpp"
#include "tautline/uncertainty.hpp"

namespace {

/// The impacts among the first events of `system`, which are the same in the plane and in space.
template <int D>
std::size_t first_impacts(const tautline::BasicSystem<double, D>& system) {
  tautline::SolveOptions options;
  options.max_events = 30;
  std::size_t impacts = 0;
  const auto solution = tautline::solve(system, options);
  for (const auto& event : solution.events()) {
    impacts += event.kind == tautline::EventKind::impact ? 1U : 0U;
  }
  return impacts;
}

/// The impacts of all shipped cases as systems, by the general kernel.
std::size_t impacts_of_systems(std::string_view what) {
  const tautline::test::Plane plane{
      Eigen::AngleAxisd(1.234, Eigen::Vector3d(1.0, 2.0, -1.0).normalized()).toRotationMatrix(),
      1,
      {0.6, 0.7}};
  std::size_t impacts = 0;
  for (const tautline::Case& the_case : tautline::shipped_cases()) {
    const tautline::System system = tautline::as_system(the_case);
    const tautline::SpatialSystem spatial = tautline::test::embedded(system, plane);
    impacts += what == "plane" ? first_impacts(system) : 0;
    impacts += what == "space" ? first_impacts(spatial) : 0;
  }
  return impacts;
}

}  // namespace

int main(int argc, char** argv) {
  const std::string_view what = argc > 1 ? argv[1] : "";
  if (what == "plane" || what == "space" || what == "systems") {
    std::printf("%zu impacts\n", impacts_of_systems(what));
    return 0;
  }
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
