#include <algorithm>

#include "energetic_impact.hpp"
#include "instantiate.hpp"
#include "rebound.hpp"
#include "redundant.hpp"
#include "tautline/detail/projection.hpp"
#include "tautline/geometry.hpp"
#include "tautline/impact.hpp"
#include "tautline/uncertainty.hpp"

namespace tautline {
namespace {

/// `impact`, and what stops the cables that it leaves closing and loses the least.
template <class TheCase>
BasicImpact<TheCase> stopped(const TheCase& the_case, const StateOf<TheCase>& before,
                             CableSet cables, BasicImpact<TheCase> impact) {
  using Real = RealOf<TheCase>;
  const auto count = static_cast<Eigen::Index>(cables.size());
  const auto stop = rebound<TheCase, Real>(
      the_case, impact.after, cables, gap_rates(the_case, impact.after, cables),
      BasicCableVector<Real>::Zero(count), rate_errors(the_case, before, cables));
  if (!stop) {
    impact.impulses.setConstant(not_a_number<Real>());
    return impact;
  }
  return {impact.impulses + stop->impulses, stop->after};
}

/// Poisson's two phases: compression brings every closing rate to zero; expansion gives back
/// restitution times each impulse, and more where that leaves a cable closing.
///
/// The end is the projection onto the motions that close nothing. Its speed, in the metric of M, is
/// the largest product of such a motion k of speed one with what is projected, v + J^T E P. As
/// (J k)_i >= 0 and P_i >= 0 that product is largest where all e_i = 1, and then no more than the
/// speed of v + J^T P, which is that before the impact: no restitutions gain energy.
template <class TheCase>
BasicImpact<TheCase> poisson_impact(const TheCase& the_case, const StateOf<TheCase>& before,
                                    CableSet cables) {
  using Real = RealOf<TheCase>;
  const BasicCableVector<Real> rates = gap_rates(the_case, before, cables);
  const BasicCableVector<Real> none = BasicCableVector<Real>::Zero(rates.size());
  const BasicImpact<TheCase> compressed = stopped(the_case, before, cables, {none, before});
  BasicCableVector<Real> e(rates.size());
  Real most(0);
  Eigen::Index row = 0;
  for (const std::size_t index : cables) {
    e[row] = restitution(the_case.cables[index], rates[row]);
    most = compressed.impulses[row] > 0 ? max(most, e[row]) : most;
    ++row;
  }
  // what all give back is the compression turned round, which rounding cannot make longer
  BasicImpact<TheCase> expanded = compressed;
  expanded.after = with_jump(compressed.after, before, compressed.after, most);
  const BasicCableVector<Real> less =
      compressed.impulses.cwiseProduct(BasicCableVector<Real>(most - e.array()));
  expanded.after = with_impulses(the_case, expanded.after, cables, BasicCableVector<Real>(-less));
  expanded.impulses += most * compressed.impulses - less;
  return stopped(the_case, before, cables, std::move(expanded));
}

/// One cable after the other.
template <class TheCase, class Real = RealOf<TheCase>>
BasicCableVector<Real> sequential_impulses(const TheCase& the_case, const StateOf<TheCase>& before,
                                           CableSet cables) {
  const auto count = static_cast<Eigen::Index>(cables.size());
  BasicCableVector<Real> impulses = BasicCableVector<Real>::Zero(count);
  StateOf<TheCase> state = before;
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
    BasicImpact<TheCase> step = newton_impact(the_case, state, one);
    impulses[fastest] += step.impulses[0];
    state = std::move(step.after);
  }
  return impulses;
}

/// `impulses`, and those that stop what they leave closing.
template <class TheCase, class Real = RealOf<TheCase>>
BasicImpact<TheCase> completed(const TheCase& the_case, const StateOf<TheCase>& before,
                               CableSet cables, BasicCableVector<Real> impulses) {
  StateOf<TheCase> after = with_impulses(the_case, before, cables, impulses);
  const BasicCableVector<Real> rates = gap_rates(the_case, after, cables);
  const Real rounding = 32 * epsilon<Real>() * speed_scale(the_case, before);
  BasicImpact<TheCase> impact{std::move(impulses), std::move(after)};
  return rates.minCoeff() < -rounding ? stopped(the_case, before, cables, std::move(impact))
                                      : impact;
}

/// `cables` without those beside which one of more restitution hangs: identical cables pull as the
/// one of them that gives back most, the first where several do.
template <class TheCase>
CableSet acting(const TheCase& the_case, const StateOf<TheCase>& before, CableSet cables) {
  using Real = RealOf<TheCase>;
  CableSet result = cables;
  for (const std::size_t a : cables) {
    for (const std::size_t b : cables) {
      if (a == b || !side_by_side(the_case.cables[a], the_case.cables[b])) {
        continue;
      }
      const Real rate = gap_rate(the_case.cables[a], before);
      const Real kept = restitution(the_case.cables[a], rate);
      const Real other = restitution(the_case.cables[b], rate);
      if (other > kept || (other == kept && b < a)) {  // exactly: the numbers given
        result.erase(a);
      }
    }
  }
  return result;
}

/// By `law` on several cables, none beside another.
template <class TheCase>
BasicImpact<TheCase> impact_on_several(ImpactLaw law, const TheCase& the_case,
                                       const StateOf<TheCase>& before, CableSet cables) {
  using Real = RealOf<TheCase>;
  switch (law) {
    case ImpactLaw::poisson:
      return poisson_impact(the_case, before, cables);
    case ImpactLaw::sequential:
      return completed(the_case, before, cables, sequential_impulses(the_case, before, cables));
    case ImpactLaw::energetic: {
      SpringImpulses<Real> springs = energetic_impulses(the_case, before, cables);
      auto impact = completed(the_case, before, cables, std::move(springs.impulses));
      impact.steps = springs.steps;
      return impact;
    }
    case ImpactLaw::simultaneous:
      break;
  }
  return newton_impact(the_case, before, cables);
}

/// The velocities of `after` without what rounding has added to their energy, where the impulses of
/// cables almost opposed are large: no law gains any, but what moves the ends of cables may.
template <class TheCase>
StateOf<TheCase> without_gain(const TheCase& the_case, const StateOf<TheCase>& before,
                              StateOf<TheCase> after) {
  using Real = RealOf<TheCase>;
  if (is_driven(the_case, before)) {
    return after;
  }
  const Real most = mass_velocity(bodies_of(the_case), before).squaredNorm();
  const Real reached = mass_velocity(bodies_of(the_case), after).squaredNorm();
  if (reached > most * (1 + few_roundings * epsilon<Real>())) {
    const Real part = sqrt(Real(most / reached));
    after = times_as_fast(after, part);
  }
  return after;
}

/// True where `law` gives what Newton's does: with one restitution Poisson's is the same. The
/// others say how an impulse is shared out.
template <class TheCase>
bool follows_newton(ImpactLaw law, const TheCase& the_case, const StateOf<TheCase>& before,
                    CableSet cables) {
  using Real = RealOf<TheCase>;
  if (law != ImpactLaw::poisson) {
    return law == ImpactLaw::simultaneous;
  }
  std::optional<Real> common;
  for (const std::size_t index : cables) {
    const CableOf<TheCase>& cable = the_case.cables[index];
    const Real e = restitution(cable, gap_rate(cable, before));
    if (common && e != *common) {  // exactly: the numbers given
      return false;
    }
    common = e;
  }
  return true;
}

/// By `law` on cables that act on each other.
template <class TheCase>
BasicImpact<TheCase> impact_on_cluster(ImpactLaw law, const TheCase& the_case,
                                       const StateOf<TheCase>& before, CableSet cables) {
  using Real = RealOf<TheCase>;
  if (cables.size() == 1 || !delassus(the_case, before, cables).allFinite() ||
      !gap_rates(the_case, before, cables).allFinite()) {
    return newton_impact(the_case, before, cables);
  }
  const CableSet several = acting(the_case, before, cables);
  BasicImpact<TheCase> impact = several.size() == 1
                                    ? newton_impact(the_case, before, several)
                                    : impact_on_several(law, the_case, before, several);
  impact.after = without_gain(the_case, before, std::move(impact.after));
  if (several != cables) {
    const auto count = static_cast<Eigen::Index>(cables.size());
    BasicCableVector<Real> impulses = BasicCableVector<Real>::Zero(count);
    impulses(rows_within(several, cables)) = impact.impulses;
    impact.impulses = std::move(impulses);
  }
  if (follows_newton(law, the_case, before, cables)) {
    auto shared = split(the_case, before, impact.after, cables, impact.impulses, true);
    if (!shared.cables.empty()) {
      impact.impulses = std::move(shared.least);
    }
  }
  return impact;
}

}  // namespace

template <class TheCase>
BasicImpact<TheCase> resolve_impact(ImpactLaw law, const TheCase& the_case,
                                    const StateOf<TheCase>& before, CableSet cables) {
  if constexpr (!TheCase::has_several_bodies) {
    return impact_on_cluster(law, the_case, before, cables);
  } else {
    using Real = RealOf<TheCase>;
    const auto count = static_cast<Eigen::Index>(cables.size());
    BasicImpact<TheCase> result{BasicCableVector<Real>::Zero(count), before};
    for (const CableSet cluster : clusters(the_case, cables)) {
      BasicImpact<TheCase> one = impact_on_cluster(law, the_case, result.after, cluster);
      result.impulses(rows_within(cluster, cables)) = one.impulses;
      result.after = std::move(one.after);
      result.steps += one.steps;
    }
    return result;
  }
}

template <class TheCase>
CableSet indeterminate(ImpactLaw law, const TheCase& the_case, const BasicEvent<TheCase>& event) {
  return event.kind == EventKind::impact &&
                 follows_newton(law, the_case, event.before, event.cables)
             ? split(the_case, event.before, event.after, event.cables, event.impulses, false)
                   .cables
             : CableSet{};
}

template CableSet indeterminate(ImpactLaw, const InstanceCase&, const BasicEvent<InstanceCase>&);
template BasicImpact<InstanceCase> resolve_impact(ImpactLaw, const InstanceCase&,
                                                  const StateOf<InstanceCase>&, CableSet);

#ifdef TAUTLINE_FIRST
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
