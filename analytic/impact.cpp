#include "tautline/impact.hpp"

#include <Eigen/Cholesky>
#include <algorithm>
#include <bit>
#include <cassert>
#include <limits>
#include <vector>

#include "tautline/geometry.hpp"

namespace tautline {
namespace {

/// A planar body has three degrees of freedom: no more than three rows are independent.
constexpr int degrees_of_freedom = 3;

/// A pivot below this fraction of the diagonal means the rows are dependent [-].
constexpr double dependent_rows = 1e-12;

/// The trial z that makes m z + q zero on the rows of `active` and z zero elsewhere;
/// empty if those rows are dependent.
CableVector active_set_solution(const CableMatrix& m, const CableVector& q,
                                const std::vector<Eigen::Index>& active) {
  CableVector z = CableVector::Zero(q.size());
  if (active.empty()) {
    return z;
  }
  const CableMatrix block = m(active, active);
  const CableVector right = -q(active);
  const Eigen::LDLT<CableMatrix> factors(block);
  if (factors.vectorD().minCoeff() <= dependent_rows * block.diagonal().maxCoeff()) {
    return {};
  }
  z(active) = CableVector(factors.solve(right));
  return z;
}

}  // namespace

std::optional<CableVector> solve_lcp(const CableMatrix& m, const CableVector& q) {
  // A solution with independent active rows always exists (Caratheodory), so the at most
  // 1 + 8 + 28 + 56 sets of up to three rows are all there is to try. In exact arithmetic one of
  // them violates nothing; rounding decides between neighbours, so the smallest violation wins.
  const auto count = static_cast<unsigned>(q.size());
  const double scale = q.cwiseAbs().maxCoeff();
  double smallest = std::numeric_limits<double>::infinity();
  CableVector best;
  for (unsigned bits = 0; bits < (1U << count); ++bits) {
    if (std::popcount(bits) > degrees_of_freedom) {
      continue;
    }
    std::vector<Eigen::Index> active;
    for (unsigned row = 0; row < count; ++row) {
      if (((bits >> row) & 1U) != 0) {
        active.push_back(row);
      }
    }
    const CableVector z = active_set_solution(m, q, active);
    if (z.size() != q.size()) {
      continue;
    }
    const CableVector w = m * z + q;
    const CableVector pull = m.diagonal().cwiseProduct(z);  // z in the units of w
    const double violation = std::max({0.0, -w.minCoeff(), -pull.minCoeff()});
    if (violation < smallest) {
      smallest = violation;
      best = z.cwiseMax(0.0);
    }
  }
  constexpr double acceptable = 1e-9;  // [-] of |q|: rounding is near 1e-15, infeasibility near 1
  if (best.size() != q.size() || smallest > acceptable * scale) {  // no size: all overflowed
    return std::nullopt;
  }
  return best;
}

Impact newton_impact(const Case& the_case, const State& before, CableSet cables) {
  assert(!cables.empty() && "an impact needs a cable");
  const CableMatrix g = delassus(the_case, before, cables);
  CableVector q(g.rows());  // (1 + restitution) times the rate before
  std::vector<Eigen::Index> rows;
  for (const std::size_t index : cables) {
    const Cable& cable = the_case.cables[index];
    rows.push_back(static_cast<Eigen::Index>(rows.size()));
    q[rows.back()] = (1.0 + cable.restitution) * gap_rate(cable, before);
  }
  Impact impact;
  const double overflowed = std::numeric_limits<double>::quiet_NaN();
  if (!g.allFinite() || !q.allFinite()) {
    impact.impulses = CableVector::Constant(q.size(), overflowed);
  } else if (std::optional<CableVector> impulses = solve_lcp(g, q)) {
    impact.impulses = *impulses;
  } else {
    // a resting cable's rate, above zero by rounding, left no solution: such cables take no part
    std::erase_if(rows, [&](Eigen::Index row) { return q[row] > 0.0; });
    impact.impulses = CableVector::Zero(q.size());
    // solvable: z >= 0 with J^T z = 0 and closing or resting rates only forces z . q = 0
    const CableVector none =
        CableVector::Constant(static_cast<Eigen::Index>(rows.size()), overflowed);
    impact.impulses(rows) = solve_lcp(g(rows, rows), q(rows)).value_or(none);
  }
  impact.after = with_impulses(the_case, before, cables, impact.impulses);
  return impact;
}

std::optional<Tensions> resting_tensions(const Case& the_case, const State& state,
                                         CableSet cables) {
  const CableMatrix g = delassus(the_case, state, cables);
  CableVector free(g.rows());
  Eigen::Index row = 0;
  for (const std::size_t index : cables) {
    free[row++] = free_gap_acceleration(the_case, index, state);
  }
  Tensions result;
  const std::optional<CableVector> tension = solve_lcp(g, free);
  if (!tension) {
    return std::nullopt;
  }
  result.tension = *tension;
  result.acceleration = g * result.tension + free;
  return result;
}

}  // namespace tautline
