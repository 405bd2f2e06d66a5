#include "tautline/impact.hpp"

#include <Eigen/Cholesky>
#include <array>
#include <bit>
#include <cassert>
#include <span>
#include <vector>

#include "instantiate.hpp"
#include "tautline/geometry.hpp"

namespace tautline {
namespace {

/// A planar body has three degrees of freedom: no more than three rows are independent.
constexpr int degrees_of_freedom = 3;

/// A pivot below this fraction of the diagonal means the rows are dependent [-].
constexpr double dependent_rows = 1e-12;

/// The trial z that makes m z + q zero on the rows of `active` and z zero elsewhere;
/// empty if those rows are dependent.
template <class Real>
BasicCableVector<Real> active_set_solution(const BasicCableMatrix<Real>& m,
                                           const BasicCableVector<Real>& q,
                                           std::span<const Eigen::Index> active) {
  BasicCableVector<Real> z = BasicCableVector<Real>::Zero(q.size());
  if (active.empty()) {
    return z;
  }
  if (active.size() == 1) {
    const Eigen::Index row = active.front();
    if (!(m(row, row) > 0)) {
      return {};
    }
    z[row] = -q[row] / m(row, row);
    return z;
  }
  const BasicCableMatrix<Real> block = m(active, active);
  const BasicCableVector<Real> right = -q(active);
  const Eigen::LDLT<BasicCableMatrix<Real>> factors(block);
  if (factors.vectorD().minCoeff() <= dependent_rows * block.diagonal().maxCoeff()) {
    return {};
  }
  z(active) = BasicCableVector<Real>(factors.solve(right));
  return z;
}

/// The rows set in `bits`; the first entries of `rows` hold them.
std::span<const Eigen::Index> rows_of(unsigned bits, std::array<Eigen::Index, max_cables>& rows) {
  std::size_t count = 0;
  for (; bits != 0; bits &= bits - 1U) {
    rows[count++] = std::countr_zero(bits);
  }
  return {rows.data(), count};
}

}  // namespace

template <class Real>
std::optional<BasicCableVector<Real>> solve_lcp(
    const BasicCableMatrix<Real>& m, const std::type_identity_t<BasicCableVector<Real>>& q,
    const std::type_identity_t<Real>& rounding) {
  // A solution with independent active rows always exists (Caratheodory), so the at most
  // 1 + 8 + 28 + 56 sets of up to three rows are all there is to try. In exact arithmetic one of
  // them violates nothing; rounding decides between neighbours, so the smallest violation wins.
  const auto count = static_cast<unsigned>(q.size());
  if (count == 1 && m(0, 0) > 0 && isfinite(q[0])) {
    return BasicCableVector<Real>::Constant(1, max(Real(0), Real(-q[0] / m(0, 0))));
  }
  const Real scale = q.cwiseAbs().maxCoeff();
  Real smallest = infinity<Real>();
  BasicCableVector<Real> best;
  for (unsigned bits = 0; bits < (1U << count); ++bits) {
    if (std::popcount(bits) > degrees_of_freedom) {
      continue;
    }
    std::array<Eigen::Index, max_cables> rows{};
    const BasicCableVector<Real> z = active_set_solution<Real>(m, q, rows_of(bits, rows));
    if (z.size() != q.size()) {
      continue;
    }
    const BasicCableVector<Real> w = m * z + q;
    const BasicCableVector<Real> pull = m.diagonal().cwiseProduct(z);  // z in the units of w
    const Real violation = max(Real(0), max(Real(-w.minCoeff()), Real(-pull.minCoeff())));
    if (violation < smallest) {
      smallest = violation;
      best = z.cwiseMax(Real(0));
    }
  }
  constexpr double acceptable = 1e-9;  // [-] of |q|: rounding is near 1e-15, infeasibility near 1
  if (best.size() != q.size() ||
      smallest > max(Real(acceptable * scale), rounding)) {  // no size: all overflowed
    return std::nullopt;
  }
  return best;
}

/// One cable closes: Newton's law in closed form (Eq. 14).
template <class Real>
static BasicImpact<Real> single_impact(const BasicBody<Real>& body, const BasicCable<Real>& cable,
                                       const BasicState<Real>& before) {
  const Eigen::Matrix<Real, 3, 1> row = gap_gradient(cable, before);
  const Eigen::Matrix<Real, 3, 1> response = row.cwiseProduct(inverse_mass(body));
  const Real rate =
      row[0] * before.velocity.x() + row[1] * before.velocity.y() + row[2] * before.spin;
  const Real impulse = -(1 + restitution(cable, rate)) * rate / row.dot(response);
  BasicImpact<Real> impact{BasicCableVector<Real>::Constant(1, impulse), before};
  if (!(impulse > 0)) {  // it opens
    impact.impulses[0] = isfinite(impulse) ? Real(0) : impulse;
  }
  impact.after.velocity += impact.impulses[0] * response.template head<2>();
  impact.after.spin += impact.impulses[0] * response[2];
  return impact;
}

template <class Real>
BasicImpact<Real> newton_impact(const BasicCase<Real>& the_case, const BasicState<Real>& before,
                                CableSet cables) {
  assert(!cables.empty() && "an impact needs a cable");
  if (cables.size() == 1) {
    return single_impact(the_case.body, the_case.cables[*cables.begin()], before);
  }
  const BasicCableMatrix<Real> g = delassus(the_case, before, cables);
  BasicCableVector<Real> q(g.rows());  // (1 + restitution) times the rate before
  std::vector<Eigen::Index> rows;
  for (const std::size_t index : cables) {
    const BasicCable<Real>& cable = the_case.cables[index];
    const Real rate = gap_rate(cable, before);
    rows.push_back(static_cast<Eigen::Index>(rows.size()));
    q[rows.back()] = (1 + restitution(cable, rate)) * rate;
  }
  BasicImpact<Real> impact;
  if (!g.allFinite() || !q.allFinite()) {
    impact.impulses = BasicCableVector<Real>::Constant(q.size(), not_a_number<Real>());
  } else if (const auto impulses = solve_lcp(g, q, impact_rounding(the_case, before))) {
    impact.impulses = *impulses;
  } else {
    // a resting cable's rate, above zero by rounding, left no solution: such cables take no part
    std::erase_if(rows, [&](Eigen::Index row) { return q[row] > 0; });
    impact.impulses = BasicCableVector<Real>::Zero(q.size());
    // solvable: z >= 0 with J^T z = 0 and closing or resting rates only forces z . q = 0
    const BasicCableVector<Real> none = BasicCableVector<Real>::Constant(
        static_cast<Eigen::Index>(rows.size()), not_a_number<Real>());
    const BasicCableMatrix<Real> part = g(rows, rows);
    const BasicCableVector<Real> rates = q(rows);
    impact.impulses(rows) =
        solve_lcp(part, rates, impact_rounding(the_case, before)).value_or(none);
  }
  impact.after = with_impulses(the_case, before, cables, impact.impulses);
  return impact;
}

template <class Real>
bool independent(const BasicCase<Real>& the_case, const BasicState<Real>& state, CableSet cables) {
  if (cables.size() > degrees_of_freedom) {
    return false;
  }
  const BasicCableMatrix<Real> g = delassus(the_case, state, cables);
  const Eigen::LDLT<BasicCableMatrix<Real>> factors(g);
  return cables.empty() || factors.vectorD().minCoeff() > dependent_rows * g.diagonal().maxCoeff();
}

template <class Real>
std::optional<BasicTensions<Real>> resting_tensions(const BasicCase<Real>& the_case,
                                                    const BasicState<Real>& state,
                                                    CableSet cables) {
  const BasicCableMatrix<Real> g = delassus(the_case, state, cables);
  BasicCableVector<Real> free(g.rows());
  Eigen::Index row = 0;
  for (const std::size_t index : cables) {
    free[row++] = free_gap_acceleration(the_case, index, state);
  }
  const auto tension = solve_lcp(g, free);
  if (!tension) {
    return std::nullopt;
  }
  return BasicTensions<Real>{*tension, g * *tension + free};
}

template std::optional<BasicCableVector<Instance>> solve_lcp(const BasicCableMatrix<Instance>&,
                                                             const BasicCableVector<Instance>&,
                                                             const Instance&);
template BasicImpact<Instance> newton_impact(const BasicCase<Instance>&,
                                             const BasicState<Instance>&, CableSet);
template bool independent(const BasicCase<Instance>&, const BasicState<Instance>&, CableSet);
template std::optional<BasicTensions<Instance>> resting_tensions(const BasicCase<Instance>&,
                                                                 const BasicState<Instance>&,
                                                                 CableSet);

}  // namespace tautline
