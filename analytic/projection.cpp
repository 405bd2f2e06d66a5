#include "tautline/projection.hpp"

#include "impact/least_solution.hpp"
#include "instantiate.hpp"

namespace tautline {
namespace {

/// What the velocity of `state` gains [m/s, m/s, rad/s] where the gaps of `cables` are closed and
/// the momentum along the cables is kept (Eq. 18), up to parts across them.
template <class Real>
Eigen::Matrix<Real, 3, 1> momentum_kept(const BasicCase<Real>& the_case,
                                        const BasicState<Real>& state, CableSet cables) {
  constexpr double almost_dependent = 1e-4;  // [-], pivots that would multiply rounding of the gaps
  constexpr Eigen::Index all = 3;            // independent cables leave no motion along them
  BasicCableVector<Real> gaps(static_cast<Eigen::Index>(cables.size()));
  Eigen::Index row = 0;
  for (const std::size_t index : cables) {
    gaps[row++] = gap(the_case.cables[index], state);
  }
  const auto shift =
      least_solution<Real>(delassus(the_case, state, cables), gaps, almost_dependent, all);
  Eigen::Matrix<Real, 3, 1> result = Eigen::Matrix<Real, 3, 1>::Zero();
  if (!shift) {
    return result;
  }
  row = 0;
  for (const std::size_t index : cables) {
    result += (*shift)[row++] * gap_gradient_rate(the_case.cables[index], state);
  }
  return result.cwiseProduct(inverse_mass(the_case.body));
}

}  // namespace

template <class Real>
BasicCableVector<Real> multipliers(const BasicCase<Real>& the_case, const BasicState<Real>& state,
                                   CableSet cables, const BasicCableVector<Real>& right) {
  const BasicCableMatrix<Real> g = delassus(the_case, state, cables);
  if (g.rows() == 1) {
    return right / g(0, 0);
  }
  if (g.rows() == 2) {  // by far the most frequent: in closed form unless the rows are dependent
    constexpr double dependent_rows = 1e-12;  // [-]
    const Real determinant = g(0, 0) * g(1, 1) - g(0, 1) * g(0, 1);
    if (determinant > dependent_rows * g(0, 0) * g(1, 1)) {
      BasicCableVector<Real> z(2);
      z[0] = (g(1, 1) * right[0] - g(0, 1) * right[1]) / determinant;
      z[1] = (g(0, 0) * right[1] - g(0, 1) * right[0]) / determinant;
      return z;
    }
  }
  return least_solution<Real>(g, right);
}

template <class Real>
BasicState<Real> with_zero_rates(const BasicCase<Real>& the_case, const BasicState<Real>& state,
                                 CableSet cables) {
  const BasicCableVector<Real> rates = gap_rates(the_case, state, cables);
  return with_impulses<Real>(the_case, state, cables,
                             -multipliers<Real>(the_case, state, cables, rates));
}

template <class Real>
BasicState<Real> with_zero_gaps(const BasicCase<Real>& the_case, BasicState<Real> state,
                                CableSet cables) {
  constexpr int enough = 8;  // quadratic: three reach a double's last bit, seven 100 digits
  const Real rounding = 4 * epsilon<Real>();
  for (int iteration = 0; iteration < enough; ++iteration) {
    BasicCableVector<Real> gaps(static_cast<Eigen::Index>(cables.size()));
    Eigen::Index row = 0;
    Real largest(0);
    for (const std::size_t index : cables) {
      const BasicCable<Real>& cable = the_case.cables[index];
      gaps[row] = gap(cable, state);
      largest = max(largest, Real(abs(gaps[row++]) / cable.length));
    }
    if (largest <= rounding) {
      break;
    }
    const BasicCableVector<Real> z = multipliers<Real>(the_case, state, cables, -gaps);
    BasicState<Real> step;  // the gradients at the present pose, as a change of pose
    step.position = state.position;
    step.angle = state.angle;
    step = with_impulses<Real>(the_case, step, cables, z);
    state.position += step.velocity;
    state.angle += step.spin;
  }
  return state;
}

template <class Real>
BasicState<Real> projected(const BasicCase<Real>& the_case, const BasicState<Real>& state,
                           CableSet cables) {
  const Eigen::Matrix<Real, 3, 1> change = momentum_kept(the_case, state, cables);
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
                                             CableSet);
template BasicState<Instance> projected(const BasicCase<Instance>&, const BasicState<Instance>&,
                                        CableSet);

}  // namespace tautline
