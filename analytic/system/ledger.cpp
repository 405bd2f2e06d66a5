#include "tautline/system_ledger.hpp"

#include "instantiate.hpp"
#include "system/kernel.hpp"

namespace tautline {
namespace {

/// Adds what happens along `arc`.
template <class Real, int D>
void add_arc(const BasicSystem<Real, D>& system, const BasicArc<BasicSystem<Real, D>>& arc,
             BasicSystemLedger<Real>& ledger) {
  const auto motion = motion_along(system, arc);
  if (!motion) {
    return;
  }
  const Real dt = arc.end - arc.start;
  ledger.work += motion->work(dt);
  for (const CableSet cables : {arc.initial.elastic.pulling(), arc.initial.elastic.loose}) {
    for (const std::size_t index : cables) {
      ledger.dissipated += motion->dissipated(index, dt);
    }
  }
}

/// Adds what stretched elastic cables store where they are hooked up or cut.
template <class Real, int D>
void add_hooks_and_cuts(const BasicSystem<Real, D>& system,
                        const BasicSolution<BasicSystem<Real, D>>& solution,
                        BasicSystemLedger<Real>& ledger) {
  const auto stored = [&](BasicCableOfSystem<Real, D> cable, const Real& time) {
    cable.cut_at.reset();
    const auto state = solution.at(time);
    return spring_energy(*cable.elasticity, Real(-gap(cable, state)), length_at(cable, state));
  };
  for (const auto& cable : system.cables) {
    if (cable.elasticity && cable.from_time && *cable.from_time <= solution.end_time()) {
      ledger.work += stored(cable, *cable.from_time);
    }
    if (cable.elasticity && cable.cut_at && *cable.cut_at <= solution.end_time()) {
      ledger.dissipated += stored(cable, *cable.cut_at);
    }
  }
}

}  // namespace

template <class Real, int D>
BasicSystemLedger<Real> energy_ledger(const BasicSystem<Real, D>& system,
                                      const BasicSolution<BasicSystem<Real, D>>& solution) {
  const Real start = kinetic_energy(system.bodies, system.initial);
  const Real end = kinetic_energy(system.bodies, solution.at(solution.end_time()));
  BasicSystemLedger<Real> result{start, Real(0), Real(0), Real(0), end, Real(0), max(start, end)};
  for (const auto& arc : solution.arcs()) {
    add_arc(system, arc, result);
    const Real now =
        max(kinetic_energy(system.bodies, arc.initial), stored_energy(system, arc.initial));
    result.range = max(result.range, max(now, Real(abs(result.work))));
  }
  for (const auto& event : solution.events()) {
    if (event.kind != EventKind::impact && event.kind != EventKind::taut) {
      continue;
    }
    const Real work = work_of_impulses(system, event.before, event.cables, event.impulses);
    const Real lost = kinetic_energy(system.bodies, event.before) + work -
                      kinetic_energy(system.bodies, event.after) +
                      (stored_energy(system, event.before) - stored_energy(system, event.after));
    result.work += work;
    (event.kind == EventKind::impact ? result.impacts : result.completions) += lost;
  }
  add_hooks_and_cuts(system, solution, result);
  result.stored = stored_energy(system, solution.at(solution.end_time())) -
                  stored_energy(system, system.initial);
  result.residual = end - start - result.work + result.impacts + result.completions +
                    result.stored + result.dissipated;
  return result;
}

template BasicSystemLedger<Instance> energy_ledger(const InstanceCase&,
                                                   const BasicSolution<InstanceCase>&);

}  // namespace tautline
