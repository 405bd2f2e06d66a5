#include "rebound.hpp"

#include "complementary.hpp"
#include "instantiate.hpp"
#include "tautline/projection.hpp"

namespace tautline {

template <class Real>
std::optional<BasicImpact<Real>> rebound(const BasicCase<Real>& the_case,
                                         const BasicState<Real>& before, CableSet cables,
                                         const BasicCableVector<Real>& rates,
                                         const BasicCableVector<Real>& e,
                                         const BasicCableVector<Real>& rounding) {
  const CableRows<Real> rows(the_case, before, cables);
  const BasicCableVector<Real> kept = (1 + e.array()).matrix();
  auto found = complementary<Real>(rows, kept.cwiseProduct(rates), kept.cwiseProduct(rounding));
  if (!found) {
    return std::nullopt;
  }
  // What all restitutions have in common is a reflection, which rounding cannot make longer; the
  // impulses of cables almost opposed are large, and their sum would gain energy.
  const RowSpace<Real> space = rows.space(found->active);
  Real most(0);
  for (const std::size_t row : found->active) {
    most = max(most, e[static_cast<Eigen::Index>(row)]);
  }
  Vector3<Real> change = -(1 + most) * space.part(mass_velocity(the_case.body, before));
  std::size_t i = 0;
  for (const std::size_t row : found->active) {
    const auto k = static_cast<Eigen::Index>(row);
    change += (most - e[k]) * rates[k] * space.dual(i++);
  }
  return BasicImpact<Real>{std::move(found->multipliers),
                           with_change(the_case.body, before, change)};
}

template std::optional<BasicImpact<Instance>> rebound(const BasicCase<Instance>&,
                                                      const BasicState<Instance>&, CableSet,
                                                      const BasicCableVector<Instance>&,
                                                      const BasicCableVector<Instance>&,
                                                      const BasicCableVector<Instance>&);

}  // namespace tautline
