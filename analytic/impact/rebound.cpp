#include "rebound.hpp"

#include "complementary.hpp"
#include "instantiate.hpp"
#include "tautline/detail/projection.hpp"

namespace tautline {

template <class TheCase, class Real>
std::optional<BasicImpact<TheCase>> rebound(const TheCase& the_case, const StateOf<TheCase>& before,
                                            CableSet cables, const BasicCableVector<Real>& rates,
                                            const BasicCableVector<Real>& e,
                                            const BasicCableVector<Real>& rounding) {
  const CableRows<TheCase> rows(the_case, before, cables);
  const BasicCableVector<Real> kept = (1 + e.array()).matrix();
  auto found =
      complementary<TheCase, Real>(rows, kept.cwiseProduct(rates), kept.cwiseProduct(rounding));
  if (!found) {
    return std::nullopt;
  }
  // What all restitutions have in common is a reflection, which rounding cannot make longer; the
  // impulses of cables almost opposed are large, and their sum would gain energy.
  const RowSpace<TheCase> space = rows.space(found->active);
  Real most(0);
  for (const std::size_t row : found->active) {
    most = max(most, e[static_cast<Eigen::Index>(row)]);
  }
  RowOf<TheCase> change =
      -(1 + most) * gap_velocity(the_case, before, cables, found->active, space);
  std::size_t i = 0;
  for (const std::size_t row : found->active) {
    const auto k = static_cast<Eigen::Index>(row);
    change += (most - e[k]) * rates[k] * space.dual(i++);
  }
  return BasicImpact<TheCase>{std::move(found->multipliers),
                              with_change(bodies_of(the_case), before, change)};
}

template std::optional<BasicImpact<InstanceCase>> rebound(const InstanceCase&,
                                                          const StateOf<InstanceCase>&, CableSet,
                                                          const BasicCableVector<Instance>&,
                                                          const BasicCableVector<Instance>&,
                                                          const BasicCableVector<Instance>&);

}  // namespace tautline
