#include "energetic_impact.hpp"

#include <utility>
#include <vector>

#include "instantiate.hpp"
#include "least_solution.hpp"
#include "spring_impact.hpp"
#include "tautline/geometry.hpp"

namespace tautline {
namespace {

/// A smaller restitution counts as zero where several cables are hit [-]: it would give back 1e-8
/// of its work, by a line so steep that its force swings 1e4 times during the impact.
constexpr double least_restitution = 1e-4;

}  // namespace

template <class TheCase, class Real>
SpringImpulses<Real> energetic_impulses(const TheCase& the_case, const StateOf<TheCase>& before,
                                        CableSet cables) {
  const auto count = static_cast<Eigen::Index>(cables.size());
  const RowOf<TheCase> weight = inverse_mass(bodies_of(the_case)).cwiseSqrt();
  std::vector<energetic::Spring<TheCase>> springs;
  RowsOf<TheCase> rows;
  rows.resize(count, Eigen::NoChange);
  BasicCableVector<Real> rates(count);
  for (const std::size_t index : cables) {
    const auto row = static_cast<Eigen::Index>(springs.size());
    const CableOf<TheCase>& cable = the_case.cables[index];
    rates[row] = gap_rate(cable, before);
    const Real e = restitution(cable, rates[row]);
    springs.push_back({gap_gradient(cable, before).cwiseProduct(weight),
                       e < least_restitution ? Real(0) : Real(e * e)});
    rows.row(row) = springs.back().row.transpose();
  }
  // the motion that changes no gap takes no part, and its speed would hide slow gap rates
  const RowOf<TheCase> velocity = least_solution<Real>(rows, rates);
  const Real row_scale = rows.rowwise().norm().maxCoeff();
  const Real speed_scale = velocity.norm();
  if (!(speed_scale > 0)) {
    return {BasicCableVector<Real>::Zero(count)};
  }
  for (energetic::Spring<TheCase>& spring : springs) {
    spring.row /= row_scale;
  }
  energetic::SpringImpact<TheCase> impact(std::move(springs), velocity / speed_scale);
  const int steps = impact.run();
  return {impact.impulses() * (speed_scale / row_scale), steps};
}

template SpringImpulses<Instance> energetic_impulses(const InstanceCase&,
                                                     const StateOf<InstanceCase>&, CableSet);

}  // namespace tautline
