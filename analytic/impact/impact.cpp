#include "tautline/impact.hpp"

#include <Eigen/Cholesky>
#include <array>
#include <bit>
#include <cassert>
#include <span>
#include <vector>

#include "complementary.hpp"
#include "instantiate.hpp"
#include "rebound.hpp"
#include "single_impact.hpp"
#include "tautline/detail/projection.hpp"
#include "tautline/geometry.hpp"

namespace tautline {
namespace {

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
    const std::type_identity_t<Real>& rounding, int rank) {
  // A solution with independent active rows always exists (Caratheodory), so in the plane the at
  // most 1 + 8 + 28 + 56 sets of up to three rows are all there is to try. In exact arithmetic one
  // of them violates nothing; rounding decides between neighbours, so the smallest violation wins.
  const auto count = static_cast<unsigned>(q.size());
  if (count == 1 && m(0, 0) > 0 && isfinite(q[0])) {
    return BasicCableVector<Real>::Constant(1, max(Real(0), Real(-q[0] / m(0, 0))));
  }
  const Real scale = q.cwiseAbs().maxCoeff();
  Real smallest = infinity<Real>();
  BasicCableVector<Real> best;
  for (unsigned bits = 0; bits < (1U << count); ++bits) {
    if (std::popcount(bits) > rank) {
      continue;
    }
    std::array<Eigen::Index, max_cables> rows{};
    const BasicCableVector<Real> z = active_set_solution<Real>(m, q, rows_of(bits, rows));
    if (z.size() != q.size()) {
      continue;
    }
    const BasicCableVector<Real> w = m * z + q;
    const BasicCableVector<Real> pull = m.diagonal().cwiseProduct(z);  // z in the units of w
    Real violation(0);
    for (Eigen::Index row = 0; row < q.size(); ++row) {
      violation = max(violation, max(Real(-w[row]), Real(-pull[row])));
    }
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

template <class TheCase>
BasicImpact<TheCase> newton_impact(const TheCase& the_case, const StateOf<TheCase>& before,
                                   CableSet cables) {
  using Real = RealOf<TheCase>;
  assert(!cables.empty() && "an impact needs a cable");
  if (cables.size() == 1) {
    auto single = single_impact(bodies_of(the_case), the_case.cables[*cables.begin()], before);
    return {BasicCableVector<Real>::Constant(1, single.impulse), std::move(single.after)};
  }
  const BasicCableVector<Real> rates = gap_rates(the_case, before, cables);
  const BasicCableVector<Real> rounding = rate_errors(the_case, before, cables);
  BasicCableVector<Real> e(rates.size());
  CableSet closing;
  Eigen::Index row = 0;
  for (const std::size_t index : cables) {
    e[row] = restitution(the_case.cables[index], rates[row]);
    if (!(rates[row] > 0)) {
      closing.insert(index);
    }
    ++row;
  }
  if (auto found = rebound(the_case, before, cables, rates, e, rounding)) {
    return *std::move(found);
  }
  // a resting cable's rate, above zero by rounding, left no solution: such cables take no part
  if (closing != cables && !closing.empty()) {
    const std::vector<Eigen::Index> part = rows_within(closing, cables);
    if (const auto found = rebound<TheCase, Real>(the_case, before, closing, rates(part), e(part),
                                                  rounding(part))) {
      BasicCableVector<Real> impulses = BasicCableVector<Real>::Zero(rates.size());
      impulses(part) = found->impulses;
      return {std::move(impulses), found->after};
    }
  }
  const BasicCableVector<Real> none =
      BasicCableVector<Real>::Constant(rates.size(), not_a_number<Real>());
  return {none, with_impulses(the_case, before, cables, none)};
}

template <class TheCase>
bool independent(const TheCase& the_case, const StateOf<TheCase>& state, CableSet cables) {
  const CableRows<TheCase> rows(the_case, state, cables);
  return rows.independent(rows.all());
}

template <class TheCase, class Real>
std::optional<BasicTensions<Real>> resting_tensions(const TheCase& the_case,
                                                    const StateOf<TheCase>& state,
                                                    CableSet cables) {
  const auto count = static_cast<Eigen::Index>(cables.size());
  BasicCableVector<Real> free(count);
  BasicCableVector<Real> rounding(count);
  Eigen::Index row = 0;
  for (const std::size_t index : cables) {
    free[row] = free_gap_acceleration(the_case, index, state);
    rounding[row++] =
        rounding_margin * rounding_of_acceleration(the_case, the_case.cables[index], state);
  }
  const CableRows<TheCase> rows(the_case, state, cables);
  auto found = complementary(rows, free, rounding);
  if (!found) {
    return std::nullopt;
  }
  return BasicTensions<Real>{std::move(found->multipliers), std::move(found->left),
                             std::move(found->multiplier_error), std::move(found->left_error)};
}

template std::optional<BasicCableVector<Instance>> solve_lcp(const BasicCableMatrix<Instance>&,
                                                             const BasicCableVector<Instance>&,
                                                             const Instance&, int);
template BasicImpact<InstanceCase> newton_impact(const InstanceCase&, const StateOf<InstanceCase>&,
                                                 CableSet);
template bool independent(const InstanceCase&, const StateOf<InstanceCase>&, CableSet);
template std::optional<BasicTensions<Instance>> resting_tensions(const InstanceCase&,
                                                                 const StateOf<InstanceCase>&,
                                                                 CableSet);

}  // namespace tautline
