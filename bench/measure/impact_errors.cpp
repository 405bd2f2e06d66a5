#include "bench/measure/impact_errors.hpp"

#include <algorithm>
#include <cmath>
#include <vector>

#include "tautline/system_geometry.hpp"

namespace tautline::bench {
namespace {

/// What an impact of one cable did, on either side.
struct Effect {
  double impulse;      // [N s], of the cable
  double energy_loss;  // [J], of the whole velocity jump
  bool is_jump;        // all of it happened at one pose
  bool is_alone;       // no other cable was hit at the same instant
};

template <class TheCase>
double energy_loss(const TheCase& the_case, const StateOf<TheCase>& before,
                   const StateOf<TheCase>& after) {
  return energy(the_case, before) - energy(the_case, after);
}

/// In the order of `counted_impacts`.
template <class TheCase>
std::vector<Effect> effects(const TheCase& the_case, const BasicSolution<TheCase>& solution,
                            double count_speed) {
  std::vector<Effect> result;
  for (const BasicEvent<TheCase>& event : solution.events()) {
    const double lost = energy_loss(the_case, event.before, event.after);
    Eigen::Index row = 0;
    for (const std::size_t cable : event.cables) {
      const double impulse = event.impulses[row++];
      if (event.kind == EventKind::impact &&
          -gap_rate(the_case.cables[cable], event.before) > count_speed) {
        result.push_back({impulse, lost, true, event.cables.size() == 1});
      }
    }
  }
  return result;
}

/// The same of a run.
template <class TheCase>
std::vector<Effect> effects(const TheCase& the_case, const BasicTrajectory<TheCase>& run,
                            double count_speed) {
  std::vector<Effect> result;
  const auto& all = run.impacts;  // in rising time
  for (auto impact = all.begin(); impact != all.end(); ++impact) {
    const bool alone = (impact == all.begin() || (impact - 1)->time != impact->time) &&
                       (impact + 1 == all.end() || (impact + 1)->time != impact->time);
    if (-impact->rate_before > count_speed) {
      result.push_back({impact->impulse, energy_loss(the_case, impact->before, impact->after),
                        impact->steps <= 1, alone});
    }
  }
  return result;
}

void worsen(std::optional<double>& worst, double error) {
  worst = std::max(worst.value_or(0.0), error);
}

}  // namespace

template <class TheCase>
ImpactErrors impact_errors(const TheCase& the_case, const BasicSolution<TheCase>& solution,
                           const BasicTrajectory<TheCase>& run, double count_speed,
                           const std::vector<CountedImpact>& exact, const ImpactPairs& pairs,
                           double end) {
  const auto wanted = effects(the_case, solution, count_speed);
  const auto found = effects(the_case, run, count_speed);
  ImpactErrors errors;
  for (const auto& [i, j] : pairs) {
    if (exact[i].time > end || !wanted[i].is_alone || !found[j].is_alone) {
      continue;
    }
    worsen(errors.impulse, 100.0 * std::abs(found[j].impulse / wanted[i].impulse - 1.0));
    if (found[j].is_jump) {
      worsen(errors.energy_loss, std::abs(found[j].energy_loss - wanted[i].energy_loss));
    }
  }
  return errors;
}

template ImpactErrors impact_errors(const Case&, const Solution&, const Trajectory&, double,
                                    const std::vector<CountedImpact>&, const ImpactPairs&, double);
template ImpactErrors impact_errors(const SpatialSystem&, const BasicSolution<SpatialSystem>&,
                                    const SystemTrajectory&, double,
                                    const std::vector<CountedImpact>&, const ImpactPairs&, double);

}  // namespace tautline::bench
