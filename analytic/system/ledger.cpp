#include "tautline/system_ledger.hpp"

#include "instantiate.hpp"
#include "system/kernel.hpp"

namespace tautline {
namespace {

/// The work along `arc` [J].
template <class Real, int D>
Real work_along(const BasicSystem<Real, D>& system, const BasicArc<BasicSystem<Real, D>>& arc) {
  constexpr Eigen::Index least_rows = 3;  // a series shorter than that is a rest
  if (arc.series.rows() < least_rows || !(arc.end > arc.start)) {
    return Real(0);
  }
  CableSet pulling;
  if (!arc.taut.empty()) {  // what redundant cables share has the same work
    const CableRows<BasicSystem<Real, D>> rows(system, arc.initial, arc.taut);
    const CableSet basis = rows.most_independent();
    std::size_t row = 0;
    for (const std::size_t index : arc.taut) {
      if (basis.contains(row++)) {
        pulling.insert(index);
      }
    }
  }
  const auto order = static_cast<std::size_t>(arc.series.rows() - 1);
  const SystemSeries<Real, D> motion(system, arc.initial, pulling, order);
  return motion.work(Real(arc.end - arc.start));
}

}  // namespace

template <class Real, int D>
BasicSystemLedger<Real> energy_ledger(const BasicSystem<Real, D>& system,
                                      const BasicSolution<BasicSystem<Real, D>>& solution) {
  const Real start = kinetic_energy(system.bodies, system.initial);
  const Real end = kinetic_energy(system.bodies, solution.at(solution.end_time()));
  BasicSystemLedger<Real> result{start, Real(0), Real(0), Real(0), end, Real(0), max(start, end)};
  for (const auto& arc : solution.arcs()) {
    result.work += work_along(system, arc);
    const Real now = kinetic_energy(system.bodies, arc.initial);
    result.range = max(result.range, max(now, Real(abs(result.work))));
  }
  for (const auto& event : solution.events()) {
    if (event.kind == EventKind::slack) {
      continue;
    }
    const Real work = work_of_impulses(system, event.before, event.cables, event.impulses);
    const Real lost = kinetic_energy(system.bodies, event.before) + work -
                      kinetic_energy(system.bodies, event.after);
    result.work += work;
    (event.kind == EventKind::impact ? result.impacts : result.completions) += lost;
  }
  result.residual = end - start - result.work + result.impacts + result.completions;
  return result;
}

template BasicSystemLedger<Instance> energy_ledger(const InstanceCase&,
                                                   const BasicSolution<InstanceCase>&);

}  // namespace tautline
