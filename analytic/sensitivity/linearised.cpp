#include "linearised.hpp"

#include "dual.hpp"
#include "instantiate.hpp"
#include "tautline/detail/projection.hpp"
#include "tautline/detail/series_impl.hpp"
#include "tautline/geometry.hpp"

namespace tautline {
namespace {

/// Two cables whose delays differ by less than this fraction close at the same instant near the
/// state too: ropes side by side, for which the difference is rounding [-].
constexpr double same_delay = 1e-9;

template <class Real>
BasicStateMatrix<Real> slopes(const BasicState<Dual<Real>>& state) {
  BasicStateMatrix<Real> result;
  result << state.position.x().slopes.transpose(), state.position.y().slopes.transpose(),
      state.angle.slopes.transpose(), state.velocity.x().slopes.transpose(),
      state.velocity.y().slopes.transpose(), state.spin.slopes.transpose();
  return result;
}

/// The inverse of a Delassus matrix of independent cables: positive definite, so Gauss and Jordan
/// need no pivots. Eigen's own takes large matrices apart in blocks, 40 kB of code for dual
/// numbers.
template <class Number>
BasicCableMatrix<Number> inverse_of(BasicCableMatrix<Number> matrix) {
  const Eigen::Index size = matrix.rows();
  for (Eigen::Index k = 0; k < size; ++k) {
    const Number pivot = matrix(k, k);
    matrix(k, k) = Number(1);
    for (Eigen::Index column = 0; column < size; ++column) {
      matrix(k, column) /= pivot;
    }
    for (Eigen::Index row = 0; row < size; ++row) {
      if (row == k) {
        continue;
      }
      const Number factor = matrix(row, k);
      matrix(row, k) = Number(0);
      for (Eigen::Index column = 0; column < size; ++column) {
        matrix(row, column) -= factor * matrix(k, column);
      }
    }
  }
  return matrix;
}

/// The impulses that turn the rates of `cables`, as Newton's law says, and the state after them.
template <class Real>
BasicImpact<BasicCase<Real>> rebound(const BasicCase<Real>& the_case, const BasicState<Real>& state,
                                     CableSet cables) {
  BasicCableVector<Real> q = gap_rates(the_case, state, cables);
  Eigen::Index row = 0;
  for (const std::size_t index : cables) {
    q[row] *= 1 + restitution(the_case.cables[index], q[row]);
    ++row;
  }
  const BasicCableMatrix<Real> inverse = inverse_of(delassus(the_case, state, cables));
  BasicCableVector<Real> impulses = -inverse.lazyProduct(q);
  BasicState<Real> after = with_impulses<Real>(the_case, state, cables, impulses);
  return {std::move(impulses), std::move(after)};
}

template <class Real>
Eigen::Matrix<Real, 6, 1> numbers(const BasicState<Real>& state) {
  Eigen::Matrix<Real, 6, 1> result;
  result << state.position, state.angle, state.velocity, state.spin;
  return result;
}

/// `state` with one of its six numbers changed.
template <class Real>
BasicState<Real> changed(BasicState<Real> state, int axis, const Real& by) {
  Real* const number[] = {&state.position.x(), &state.position.y(), &state.angle,
                          &state.velocity.x(), &state.velocity.y(), &state.spin};
  *number[axis] += by;
  return state;
}

/// A step of central differences [-] for which rounding and curvature balance, unless it would
/// change the rate of a cable of `hit` by more than a thousandth: all laws are linear nearby.
template <class Real>
Real difference_step(const BasicCase<Real>& the_case, const BasicState<Real>& state, CableSet hit) {
  Real slowest = speed_scale(the_case, state);
  const Real fastest = max(Real(1), slowest);
  for (const std::size_t index : hit) {
    slowest = min(slowest, Real(abs(gap_rate(the_case.cables[index], state))));
  }
  return min(root(epsilon<Real>(), 3), Real(slowest / fastest / 1000));
}

/// The derivative of any law's resolved impact, by central differences. Their steps keep the rates
/// of `held` zero.
template <class Real>
BasicReboundSlopes<Real> difference_quotients(const BasicCase<Real>& the_case, ImpactLaw law,
                                              const BasicEvent<BasicCase<Real>>& impact,
                                              CableSet held) {
  const Real step = difference_step(the_case, impact.before, impact.cables - held);
  const auto resolved = [&](int axis, const Real& by) {
    const BasicState<Real> state = changed(impact.before, axis, by);
    const BasicState<Real> start = held.empty() ? state : with_zero_rates(the_case, state, held);
    return resolve_impact(law, the_case, start, impact.cables);
  };
  BasicReboundSlopes<Real> result;
  result.impulses.resize(impact.impulses.size(), 6);
  for (int axis = 0; axis < 6; ++axis) {
    const BasicImpact<BasicCase<Real>> above = resolved(axis, step);
    const BasicImpact<BasicCase<Real>> below = resolved(axis, -step);
    result.after.col(axis) = (numbers(above.after) - numbers(below.after)) / (2 * step);
    result.impulses.col(axis) = (above.impulses - below.impulses) / (2 * step);
  }
  return result;
}

}  // namespace

template <class Real>
CableSet basis(const BasicCase<Real>& the_case, const BasicState<Real>& state, CableSet cables) {
  CableSet result;
  for (const std::size_t index : cables) {
    if (independent(the_case, state, result | CableSet::of(index))) {
      result.insert(index);
    }
  }
  return result;
}

template <class Real>
BasicReboundSlopes<Real> rebound_slopes(const BasicCase<Real>& the_case, ImpactLaw law,
                                        const BasicEvent<BasicCase<Real>>& impact, CableSet held) {
  if (law != ImpactLaw::simultaneous && impact.cables.size() > 1) {
    return difference_quotients(the_case, law, impact, held);
  }
  BasicReboundSlopes<Real> result;
  result.impulses.setZero(impact.impulses.size(), 6);
  // of redundant cables the others follow the independent ones
  const CableSet active = basis(the_case, impact.before, pulled(impact));
  if (active.empty()) {
    result.after.setIdentity();
    return result;
  }
  const auto turned = rebound(lifted<Dual<Real>>(the_case), variables(impact.before), active);
  result.after = slopes(turned.after);
  Eigen::Index row = 0;
  Eigen::Index of_active = 0;
  for (const std::size_t index : impact.cables) {
    if (active.contains(index)) {
      result.impulses.row(row) = turned.impulses[of_active++].slopes.transpose();
    }
    ++row;
  }
  return result;
}

template <class Real>
BasicStateMatrix<Real> rebound_derivative(const BasicCase<Real>& the_case, ImpactLaw law,
                                          const BasicEvent<BasicCase<Real>>& impact,
                                          CableSet held) {
  return rebound_slopes(the_case, law, impact, held).after;
}

template <class Real>
BasicStateMatrix<Real> projection_derivative(const BasicCase<Real>& the_case,
                                             const BasicState<Real>& state, CableSet cables) {
  using Number = Dual<Real>;
  constexpr int enough = 8;  // as in with_zero_gaps, and none is left out: slopes converge last
  const BasicCase<Number> dual_case = lifted<Number>(the_case);
  const CableSet rows = basis(the_case, state, cables);
  BasicState<Number> now = variables(state);
  for (int iteration = 0; iteration < enough; ++iteration) {
    BasicCableVector<Number> gaps(static_cast<Eigen::Index>(rows.size()));
    Eigen::Index row = 0;
    for (const std::size_t index : rows) {
      gaps[row++] = gap(dual_case.cables[index], now);
    }
    const BasicCableMatrix<Number> inverse = inverse_of(delassus(dual_case, now, rows));
    BasicState<Number> step;
    step.position = now.position;
    step.angle = now.angle;
    step = with_impulses<Number>(dual_case, step, rows, -inverse.lazyProduct(gaps));
    now.position += step.velocity;
    now.angle += step.spin;
  }
  const BasicCableMatrix<Number> inverse = inverse_of(delassus(dual_case, now, rows));
  const BasicCableVector<Number> impulses = -inverse.lazyProduct(gap_rates(dual_case, now, rows));
  return slopes(with_impulses<Number>(dual_case, now, rows, impulses));
}

template <class Real>
std::vector<Eigen::Matrix<Real, 3, 6>> flow_derivative(const BasicCase<Real>& the_case,
                                                       const BasicState<Real>& start,
                                                       CableSet pulling, std::size_t order) {
  using Number = Dual<Real>;
  const BasicCase<Number> dual_case = lifted<Number>(the_case);
  const TautSeries<Number> motion(dual_case, variables(start), pulling, order);
  std::vector<Eigen::Matrix<Real, 3, 6>> result(order + 1);
  for (std::size_t k = 0; k <= order; ++k) {
    result[k].row(0) = motion.position(k).x().slopes.transpose();
    result[k].row(1) = motion.position(k).y().slopes.transpose();
    result[k].row(2) = motion.angle()[k].slopes.transpose();
  }
  return result;
}

template <class Real>
std::optional<Eigen::Matrix<Real, 1, 6>> delay_derivative(const BasicCase<Real>& the_case,
                                                          const BasicState<Real>& state,
                                                          CableSet hit) {
  std::optional<Eigen::Matrix<Real, 1, 6>> result;
  for (const std::size_t index : hit) {
    const BasicCable<Real>& cable = the_case.cables[index];
    const Real rate = gap_rate(cable, state);
    if (!(rate < 0)) {
      return std::nullopt;
    }
    Eigen::Matrix<Real, 1, 6> row = Eigen::Matrix<Real, 1, 6>::Zero();
    row.template head<3>() = -gap_gradient(cable, state).transpose() / rate;
    if (result && (row - *result).norm() > same_delay * row.norm()) {
      return std::nullopt;
    }
    result = row;
  }
  return result;
}

template CableSet basis(const InstanceCase&, const BasicState<Instance>&, CableSet);
template BasicReboundSlopes<Instance> rebound_slopes(const InstanceCase&, ImpactLaw,
                                                     const BasicEvent<InstanceCase>&, CableSet);
template BasicStateMatrix<Instance> rebound_derivative(const InstanceCase&, ImpactLaw,
                                                       const BasicEvent<InstanceCase>&, CableSet);
template BasicStateMatrix<Instance> projection_derivative(const InstanceCase&,
                                                          const BasicState<Instance>&, CableSet);
template std::vector<Eigen::Matrix<Instance, 3, 6>> flow_derivative(const InstanceCase&,
                                                                    const BasicState<Instance>&,
                                                                    CableSet, std::size_t);
template std::optional<Eigen::Matrix<Instance, 1, 6>> delay_derivative(const InstanceCase&,
                                                                       const BasicState<Instance>&,
                                                                       CableSet);

}  // namespace tautline
