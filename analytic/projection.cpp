#include "tautline/projection.hpp"

#include <array>

#include "impact/least_solution.hpp"
#include "instantiate.hpp"
#include "tautline/rows.hpp"

namespace tautline {
namespace {

/// The gaps of `cables` [m].
template <class Real>
BasicCableVector<Real> gaps(const BasicCase<Real>& the_case, const BasicState<Real>& state,
                            CableSet cables) {
  BasicCableVector<Real> result(static_cast<Eigen::Index>(cables.size()));
  Eigen::Index row = 0;
  for (const std::size_t index : cables) {
    result[row++] = gap(the_case.cables[index], state);
  }
  return result;
}

/// True where the gaps of `cables` are as small as a step of Newton's method leaves them.
template <class Real>
bool are_closed(const BasicCase<Real>& the_case, const BasicState<Real>& state, CableSet cables) {
  constexpr double last_bits = 4.0;  // [-] roundings
  for (const std::size_t index : cables) {
    const BasicCable<Real>& cable = the_case.cables[index];
    if (!(abs(gap(cable, state)) <= last_bits * rounding_of_gap(cable, state))) {
      return false;
    }
  }
  return true;
}

/// The z with G z = right that only the rows of `basis` have, which are independent.
template <class Real>
BasicCableVector<Real> multipliers_of(const CableRows<Real>& rows, CableSet basis,
                                      const BasicCableVector<Real>& right) {
  const RowSpace<Real> space = rows.space(basis);
  Vector3<Real> sum = Vector3<Real>::Zero();
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
template <class Real>
BasicCableVector<Real> shared_multipliers(const CableRows<Real>& rows, CableSet basis,
                                          const BasicCableVector<Real>& right, const Real& least) {
  const BasicCableVector<Real> z = multipliers_of(rows, basis, right);
  const BasicCableMatrix<Real> shapes = rows.shapes().transpose();
  return least_solution<Real>(shapes, shapes * z, least);
}

/// What the velocity of `state` gains [m/s, m/s, rad/s] where the gaps of `cables` are closed and
/// the momentum along the cables is kept (Eq. 18), up to parts across them.
template <class Real>
Vector3<Real> momentum_kept(const BasicCase<Real>& the_case, const BasicState<Real>& state,
                            CableSet cables) {
  constexpr double almost_dependent = 1e-2;  // [-], a sine that would multiply rounding of the gaps
  const CableRows<Real> rows(the_case, state, cables);
  const CableSet basis = rows.most_independent(Real(almost_dependent));
  Vector3<Real> result = Vector3<Real>::Zero();
  if (basis.size() == 3) {  // independent cables leave no motion along them
    return result;
  }
  const BasicCableVector<Real> open = gaps(the_case, state, cables);
  const BasicCableVector<Real> shift =
      basis == rows.all() ? multipliers_of(rows, basis, open)
                          : shared_multipliers(rows, basis, open, Real(almost_dependent));
  Eigen::Index row = 0;
  for (const std::size_t index : cables) {
    result += shift[row++] * gap_gradient_rate(the_case.cables[index], state);
  }
  return result.cwiseProduct(inverse_mass(the_case.body));
}

}  // namespace

template <class Real>
BasicCableVector<Real> multipliers(const BasicCase<Real>& the_case, const BasicState<Real>& state,
                                   CableSet cables, const BasicCableVector<Real>& right) {
  if (cables.empty()) {
    return right;
  }
  if (cables.size() == 1) {
    return right / delassus(the_case, state, *cables.begin());
  }
  const CableRows<Real> rows(the_case, state, cables);
  if (rows.independent(rows.all())) {
    return multipliers_of(rows, rows.all(), right);
  }
  return shared_multipliers(rows, rows.most_independent(), right, rows.dependent());
}

template <class Real>
BasicState<Real> with_zero_rates(const BasicCase<Real>& the_case, const BasicState<Real>& state,
                                 CableSet cables) {
  if (cables.empty()) {
    return state;
  }
  const CableRows<Real> rows(the_case, state, cables);
  const RowSpace<Real> space = rows.space(rows.most_independent());
  return with_change<Real>(the_case.body, state, -space.part(mass_velocity(the_case.body, state)));
}

template <class Real>
BasicState<Real> with_zero_gaps(const BasicCase<Real>& the_case, BasicState<Real> state,
                                CableSet cables, const std::type_identity_t<Real>& least_sine) {
  constexpr int enough = 8;  // quadratic: three reach a double's last bit, seven 100 digits
  const Vector3<Real> weight = root_of_inverse_mass(the_case.body);
  std::array<std::size_t, max_cables> indices{};  // of the rows
  std::size_t count = 0;
  for (const std::size_t index : cables) {
    indices[count++] = index;
  }
  for (int iteration = 0; iteration < enough; ++iteration) {
    if (are_closed(the_case, state, cables)) {
      break;
    }
    const CableRows<Real> rows(the_case, state, cables);
    const CableSet basis = rows.most_independent(least_sine);  // with them the others close
    const RowSpace<Real> space = rows.space(basis);
    Vector3<Real> step = Vector3<Real>::Zero();  // of the pose, times the root of the mass
    CableSet chosen;
    std::size_t i = 0;
    for (const std::size_t row : basis) {
      chosen.insert(indices[row]);
      step -= gap(the_case.cables[indices[row]], state) * space.dual(i++);
    }
    if (chosen != cables && are_closed(the_case, state, chosen)) {
      break;
    }
    state.position += step.cwiseProduct(weight).template head<2>();
    state.angle += step[2] * weight[2];
  }
  return state;
}

template <class Real>
BasicState<Real> projected(const BasicCase<Real>& the_case, const BasicState<Real>& state,
                           CableSet cables) {
  const Vector3<Real> change = momentum_kept(the_case, state, cables);
  BasicState<Real> result = with_zero_gaps(the_case, state, cables);
  result.velocity += change.template head<2>();
  result.spin += change[2];
  return with_zero_rates(the_case, result, cables);
}

template BasicCableVector<Instance> multipliers(const BasicCase<Instance>&,
                                                const BasicState<Instance>&, CableSet,
                                                const BasicCableVector<Instance>&);
template BasicState<Instance> with_zero_rates(const BasicCase<Instance>&,
                                              const BasicState<Instance>&, CableSet);
template BasicState<Instance> with_zero_gaps(const BasicCase<Instance>&, BasicState<Instance>,
                                             CableSet, const Instance&);
template BasicState<Instance> projected(const BasicCase<Instance>&, const BasicState<Instance>&,
                                        CableSet);

}  // namespace tautline
