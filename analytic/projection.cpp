#include "tautline/detail/projection.hpp"

#include <array>

#include "impact/least_solution.hpp"
#include "instantiate.hpp"
#include "tautline/detail/rows.hpp"

namespace tautline {
namespace {

/// The gaps of `cables` [m].
template <class TheCase, class Real = RealOf<TheCase>>
BasicCableVector<Real> gaps(const TheCase& the_case, const StateOf<TheCase>& state,
                            CableSet cables) {
  BasicCableVector<Real> result(static_cast<Eigen::Index>(cables.size()));
  Eigen::Index row = 0;
  for (const std::size_t index : cables) {
    result[row++] = gap(the_case.cables[index], state);
  }
  return result;
}

/// True where the gaps of `cables` are as small as a step of Newton's method leaves them.
template <class TheCase>
bool are_closed(const TheCase& the_case, const StateOf<TheCase>& state, CableSet cables) {
  constexpr double last_bits = 4.0;  // [-] roundings
  for (const std::size_t index : cables) {
    const CableOf<TheCase>& cable = the_case.cables[index];
    if (!(abs(gap(cable, state)) <= last_bits * rounding_of_gap(cable, state))) {
      return false;
    }
  }
  return true;
}

/// The z with G z = right that only the rows of `basis` have, which are independent.
template <class TheCase, class Real = RealOf<TheCase>>
BasicCableVector<Real> multipliers_of(const CableRows<TheCase>& rows, CableSet basis,
                                      const BasicCableVector<Real>& right) {
  const RowSpace<TheCase> space = rows.space(basis);
  RowOf<TheCase> sum = rows.zero();
  std::size_t i = 0;
  for (const std::size_t row : basis) {
    sum += right[static_cast<Eigen::Index>(row)] * space.dual(i++);
  }
  BasicCableVector<Real> result = BasicCableVector<Real>::Zero(right.size());
  i = 0;
  for (const std::size_t row : basis) {
    result[static_cast<Eigen::Index>(row)] = space.dual(i++).dot(sum);
  }
  return result;
}

/// The z with G z = right of smallest size; a sine below `least` [-] is none.
template <class TheCase, class Real = RealOf<TheCase>>
BasicCableVector<Real> shared_multipliers(const CableRows<TheCase>& rows, CableSet basis,
                                          const BasicCableVector<Real>& right, const Real& least) {
  const BasicCableVector<Real> z = multipliers_of(rows, basis, right);
  const BasicCableMatrix<Real> shapes = rows.shapes().transpose();
  return least_solution<Real>(shapes, shapes * z, least);
}

/// What the velocity of `state` gains [m/s, m/s, rad/s] where the gaps of `cables` are closed and
/// the momentum along the cables is kept (Eq. 18), up to parts across them.
template <class TheCase>
RowOf<TheCase> momentum_kept(const TheCase& the_case, const StateOf<TheCase>& state,
                             CableSet cables) {
  using Real = RealOf<TheCase>;
  constexpr double almost_dependent = 1e-2;  // [-], a sine that would multiply rounding of the gaps
  const CableRows<TheCase> rows(the_case, state, cables);
  const CableSet basis = rows.most_independent(Real(almost_dependent));
  RowOf<TheCase> result = rows.zero();
  if (basis.size() == rows.freedoms()) {  // independent cables leave no motion along them
    return result;
  }
  const BasicCableVector<Real> open = gaps(the_case, state, cables);
  const BasicCableVector<Real> shift =
      basis == rows.all() ? multipliers_of(rows, basis, open)
                          : shared_multipliers(rows, basis, open, Real(almost_dependent));
  Eigen::Index row = 0;
  for (const std::size_t index : cables) {
    result += shift[row++] * wrench_rate(the_case.cables[index], state);
  }
  return result.cwiseProduct(inverse_mass(bodies_of(the_case)));
}

}  // namespace

template <class TheCase, class Real>
BasicCableVector<Real> multipliers(const TheCase& the_case, const StateOf<TheCase>& state,
                                   CableSet cables, const BasicCableVector<Real>& right) {
  if (cables.empty()) {
    return right;
  }
  if (cables.size() == 1) {
    return right / delassus(the_case, state, *cables.begin());
  }
  const CableRows<TheCase> rows(the_case, state, cables);
  if (rows.independent(rows.all())) {
    return multipliers_of(rows, rows.all(), right);
  }
  return shared_multipliers(rows, rows.most_independent(), right, rows.dependent());
}

template <class TheCase>
StateOf<TheCase> with_zero_rates(const TheCase& the_case, const StateOf<TheCase>& state,
                                 CableSet cables) {
  if (cables.empty()) {
    return state;
  }
  const CableRows<TheCase> rows(the_case, state, cables);
  const CableSet basis = rows.most_independent();
  const RowSpace<TheCase> space = rows.space(basis);
  return with_change(bodies_of(the_case), state,
                     RowOf<TheCase>(-gap_velocity(the_case, state, cables, basis, space)));
}

template <class TheCase, class Real>
StateOf<TheCase> with_zero_gaps(const TheCase& the_case, StateOf<TheCase> state, CableSet cables,
                                const std::type_identity_t<Real>& least_sine) {
  constexpr int enough = 8;  // quadratic: three reach a double's last bit, seven 100 digits
  const RowOf<TheCase> weight = root_of_inverse_mass(bodies_of(the_case));
  std::array<std::size_t, max_cables> indices{};  // of the rows
  std::size_t count = 0;
  for (const std::size_t index : cables) {
    indices[count++] = index;
  }
  for (int iteration = 0; iteration < enough; ++iteration) {
    if (are_closed(the_case, state, cables)) {
      break;
    }
    const CableRows<TheCase> rows(the_case, state, cables);
    const CableSet basis = rows.most_independent(least_sine);  // with them the others close
    const RowSpace<TheCase> space = rows.space(basis);
    RowOf<TheCase> step = rows.zero();  // of the pose, times the root of the mass
    CableSet chosen;
    std::size_t i = 0;
    for (const std::size_t row : basis) {
      chosen.insert(indices[row]);
      step -= gap(the_case.cables[indices[row]], state) * space.dual(i++);
    }
    if (chosen != cables && are_closed(the_case, state, chosen)) {
      break;
    }
    state = moved(state, RowOf<TheCase>(step.cwiseProduct(weight)));
  }
  return state;
}

template <class TheCase>
StateOf<TheCase> projected(const TheCase& the_case, const StateOf<TheCase>& state,
                           CableSet cables) {
  const RowOf<TheCase> change = momentum_kept(the_case, state, cables);
  const StateOf<TheCase> closed = with_zero_gaps(the_case, state, cables);
  return with_zero_rates(the_case, with_momentum(bodies_of(the_case), closed, state, change),
                         cables);
}

template BasicCableVector<Instance> multipliers(const InstanceCase&, const StateOf<InstanceCase>&,
                                                CableSet, const BasicCableVector<Instance>&);
template StateOf<InstanceCase> with_zero_rates(const InstanceCase&, const StateOf<InstanceCase>&,
                                               CableSet);
template StateOf<InstanceCase> with_zero_gaps(const InstanceCase&, StateOf<InstanceCase>, CableSet,
                                              const Instance&);
template StateOf<InstanceCase> projected(const InstanceCase&, const StateOf<InstanceCase>&,
                                         CableSet);

}  // namespace tautline
