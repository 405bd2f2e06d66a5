// The event driver over DART: half of gravity's impulse before and after a step makes its
// semi-implicit Euler fly the exact parabola, and one solve of its constraint solver at the pose of
// an impact gives the impulses without moving.

#include <algorithm>
#include <string>

#include "adapter/row_model.hpp"
#include "models.hpp"
#include "tautline/event_driver.hpp"
#include "tautline/parabola.hpp"
#include "world.hpp"

namespace tautline::dart_engine {
namespace {

/// One cable takes two iterations. Nearly dependent cables hit together take up to some ten
/// thousand.
constexpr int iterations = 100'000;

/// A solve ends when no impulse changes by more than this part of itself [-], but for those below
/// this part of the body's momentum.
constexpr double solve_rounding = 1e-15;

/// For a `Case`, or for a `SpatialSystem`.
template <class TheCase, class TheWorld>
class DartEventAdapter final : public BasicEventAdapter<TheCase> {
 public:
  explicit DartEventAdapter(const TheCase& the_case) : case_(the_case), world_(the_case) {}

  [[nodiscard]] StateOf<TheCase> state() const override { return world_.state(); }
  void place(const StateOf<TheCase>& state) override { world_.place(state); }
  void fly(double dt) override { world_.fly(dt); }

  [[nodiscard]] CableVector solve(CableSet cables, const CableVector& rates) override {
    const StateOf<TheCase> before = world_.state();
    return solve_rows(world_, case_, before, cables, rates, [&] {
      world_.solve_here({iterations, solve_rounding, least_impulse(before)});
    });
  }

 private:
  [[nodiscard]] double speed_of(const State& state) const { return speed_scale(case_, state); }
  [[nodiscard]] double speed_of(const SpatialSystemState& state) const { return fastest(state); }

  /// [N s]; DART also leaves out a row whose diagonal, at least 1 / mass, is not above this number.
  [[nodiscard]] double least_impulse(const StateOf<TheCase>& state) const {
    const double mass = heaviest(case_);
    return std::min(solve_rounding * mass * speed_of(state), 0.5 / mass);
  }

  const TheCase case_;
  TheWorld world_;
};

}  // namespace

std::vector<ModelEntry> event_models() {
  return {event_model<DartEventAdapter<Case, World>, DartEventAdapter<SpatialSystem, SystemWorld>>(
      "DART flies and solves, the event driver finds the instants: each impact is one solve at the "
      "exact pose.",
      {{"setBoxedLcpSolver", "PgsBoxedLcpSolver",
        "Pivoting, DART's choice, fails on three cables that are nearly dependent, and on any "
        "four."},
       {"setSecondaryBoxedLcpSolver", "nullptr", "The iteration needs none behind it."},
       {"mMaxIteration", std::to_string(iterations),
        "Nearly dependent cables hit together converge slowly; one cable takes two."},
       {"mDeltaXThreshold, mRelativeDeltaXTolerance", "0, 1e-15",
        "DART's 1e-6 and 1e-3 leave an impact as inexact as that."},
       {"mEpsilonForDivision", "1e-15 of the momentum",
        "The iteration does not wait for smaller impulses; DART's 1e-9 knows no units."},
       parabola_setting()},
      system_settings())};
}

}  // namespace tautline::dart_engine
