#include <algorithm>

#include "energetic_impact.hpp"
#include "instantiate.hpp"
#include "tautline/geometry.hpp"
#include "tautline/impact.hpp"
#include "tautline/projection.hpp"

namespace tautline {
namespace {

template <class Real>
BasicCableVector<Real> unknown(Eigen::Index count) {
  return BasicCableVector<Real>::Constant(count, not_a_number<Real>());
}

/// The impulses that bring every closing rate to zero and lose the least: `rates` are those of a
/// motion, so that its projection onto the motions that close nothing exists.
template <class Real>
BasicCableVector<Real> stopping(const BasicCableMatrix<Real>& g,
                                const BasicCableVector<Real>& rates, const Real& rounding) {
  return solve_lcp(g, rates, rounding).value_or(unknown<Real>(rates.size()));
}

/// Poisson's two phases: compression brings every closing rate to zero; expansion gives back
/// restitution times each impulse, and more where that leaves a cable closing.
///
/// The end is the projection onto the motions that close nothing. Its speed, in the metric of M, is
/// the largest product of such a motion k of speed one with what is projected, v + J^T E P. As
/// (J k)_i >= 0 and P_i >= 0 that product is largest where all e_i = 1, and then no more than the
/// speed of v + J^T P, which is that before the impact: no restitutions gain energy.
template <class Real>
BasicCableVector<Real> poisson_impulses(const BasicCase<Real>& the_case,
                                        const BasicState<Real>& before, CableSet cables) {
  const BasicCableMatrix<Real> g = delassus(the_case, before, cables);
  const BasicCableVector<Real> rates = gap_rates(the_case, before, cables);
  const Real rounding = impact_rounding(the_case, before);
  const BasicCableVector<Real> compression = stopping(g, rates, rounding);
  BasicCableVector<Real> impulses = compression;
  Eigen::Index row = 0;
  for (const std::size_t index : cables) {
    impulses[row] += restitution(the_case.cables[index], rates[row]) * compression[row];
    ++row;
  }
  return impulses + stopping<Real>(g, rates + g * impulses, rounding);
}

/// One cable after the other.
template <class Real>
BasicCableVector<Real> sequential_impulses(const BasicCase<Real>& the_case,
                                           const BasicState<Real>& before, CableSet cables) {
  const auto count = static_cast<Eigen::Index>(cables.size());
  BasicCableVector<Real> impulses = BasicCableVector<Real>::Zero(count);
  BasicState<Real> state = before;
  const Real rounding = 8 * epsilon<Real>() * speed_scale(the_case, before);
  const std::vector<std::size_t> indices = cables.indices();
  constexpr int most = 10'000;  // hits; those that go on forever shrink to rounding in fewer
  for (int hit = 0; hit < most; ++hit) {
    const BasicCableVector<Real> rates = gap_rates(the_case, state, cables);
    Eigen::Index fastest = 0;
    const Real least = rates.minCoeff();
    if (!(least < -rounding)) {
      break;
    }
    while (rates[fastest] > least + rounding) {  // of those as fast, the first
      ++fastest;
    }
    const CableSet one = CableSet::of(indices[static_cast<std::size_t>(fastest)]);
    BasicImpact<Real> step = newton_impact(the_case, state, one);
    impulses[fastest] += step.impulses[0];
    state = std::move(step.after);
  }
  return impulses;
}

/// `impulses`, and those that stop what they leave closing.
template <class Real>
BasicImpact<Real> completed(const BasicCase<Real>& the_case, const BasicState<Real>& before,
                            CableSet cables, BasicCableVector<Real> impulses) {
  BasicState<Real> after = with_impulses(the_case, before, cables, impulses);
  const BasicCableVector<Real> rates = gap_rates(the_case, after, cables);
  const Real rounding = 32 * epsilon<Real>() * speed_scale(the_case, before);
  if (rates.minCoeff() < -rounding) {
    impulses +=
        stopping(delassus(the_case, before, cables), rates, impact_rounding(the_case, before));
    after = with_impulses(the_case, before, cables, impulses);
  }
  return {std::move(impulses), std::move(after)};
}

}  // namespace

template <class Real>
BasicImpact<Real> resolve_impact(ImpactLaw law, const BasicCase<Real>& the_case,
                                 const BasicState<Real>& before, CableSet cables) {
  if (cables.size() > 1 && delassus(the_case, before, cables).allFinite() &&
      gap_rates(the_case, before, cables).allFinite()) {
    switch (law) {
      case ImpactLaw::poisson:
        return completed(the_case, before, cables, poisson_impulses(the_case, before, cables));
      case ImpactLaw::sequential:
        return completed(the_case, before, cables, sequential_impulses(the_case, before, cables));
      case ImpactLaw::energetic:
        return completed(the_case, before, cables, energetic_impulses(the_case, before, cables));
      case ImpactLaw::simultaneous:
        break;
    }
  }
  return newton_impact(the_case, before, cables);
}

template BasicImpact<Instance> resolve_impact(ImpactLaw, const BasicCase<Instance>&,
                                              const BasicState<Instance>&, CableSet);

#ifndef TAUTLINE_MULTIPRECISION
std::string_view to_string(ImpactLaw law) {
  switch (law) {
    case ImpactLaw::simultaneous:
      return "simultaneous";
    case ImpactLaw::poisson:
      return "poisson";
    case ImpactLaw::sequential:
      return "sequential";
    case ImpactLaw::energetic:
      return "energetic";
  }
  return "unknown";
}
#endif

}  // namespace tautline
