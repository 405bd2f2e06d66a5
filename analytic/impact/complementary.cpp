#include "complementary.hpp"

#include "instantiate.hpp"

namespace tautline {
namespace {

/// The rows whose bits are set.
CableSet rows_of(unsigned bits) {
  CableSet rows;
  for (std::size_t row = 0; bits >> row != 0; ++row) {
    if (((bits >> row) & 1U) != 0) {
      rows.insert(row);
    }
  }
  return rows;
}

/// The trial in which the rows of `active` are brought to zero, w_i = 0, by their z_i.
template <class TheCase, class Real = RealOf<TheCase>>
Complementary<Real> trial(const CableRows<TheCase>& cables, const BasicCableVector<Real>& q,
                          const BasicCableVector<Real>& rounding, CableSet active) {
  const RowSpace<TheCase> space = cables.space(active);
  RowOf<TheCase> change = cables.zero();  // A^T z
  RowOf<TheCase> error = cables.zero();
  std::size_t i = 0;
  for (const std::size_t row : active) {
    change -= q[static_cast<Eigen::Index>(row)] * space.dual(i);
    error += rounding[static_cast<Eigen::Index>(row)] * space.dual(i).cwiseAbs();
    ++i;
  }
  error += rounding_margin * epsilon<Real>() * change.cwiseAbs();
  const BasicCableVector<Real> zero = BasicCableVector<Real>::Zero(q.size());
  Complementary<Real> result{active, zero, zero, zero, zero};
  for (Eigen::Index row = 0; row < q.size(); ++row) {
    const RowOf<TheCase> a = cables.rows().row(row).transpose();
    const bool at_zero = active.contains(static_cast<std::size_t>(row));
    result.left[row] = at_zero ? Real(0) : Real(q[row] + a.dot(change));
    result.left_error[row] = rounding[row] + a.cwiseAbs().dot(error);
  }
  i = 0;
  for (const std::size_t row : active) {
    const auto k = static_cast<Eigen::Index>(row);
    result.multipliers[k] = space.dual(i).dot(change);
    result.multiplier_error[k] = space.dual(i).cwiseAbs().dot(error);
    ++i;
  }
  return result;
}

/// The same of one row, whose sign of q says which of its two trials is the solution.
template <class TheCase, class Real = RealOf<TheCase>>
std::optional<Complementary<Real>> of_one(const CableRows<TheCase>& cables, const Real& q,
                                          const Real& rounding) {
  if (isnan(q)) {
    return std::nullopt;
  }
  const auto one = [](const Real& number) { return BasicCableVector<Real>::Constant(1, number); };
  if (!(q < 0)) {
    return Complementary<Real>{{}, one(Real(0)), one(q), one(Real(0)), one(rounding)};
  }
  const RowOf<TheCase> a = cables.rows().row(0).transpose();
  const RowOf<TheCase> dual = a / a.squaredNorm();
  const RowOf<TheCase> change = -q * dual;
  const RowOf<TheCase> error =
      rounding * dual.cwiseAbs() + rounding_margin * epsilon<Real>() * change.cwiseAbs();
  return Complementary<Real>{CableSet::of(0), one(dual.dot(change)), one(Real(0)),
                             one(dual.cwiseAbs().dot(error)),
                             one(Real(rounding + a.cwiseAbs().dot(error)))};
}

/// By how much a trial breaks a sign [in units of w]; none where that is more than rounding.
template <class TheCase, class Real = RealOf<TheCase>>
std::optional<Real> violation(const CableRows<TheCase>& cables, const Complementary<Real>& found) {
  Real result(0);
  for (Eigen::Index row = 0; row < found.left.size(); ++row) {
    const bool is_active = found.active.contains(static_cast<std::size_t>(row));
    const Real& value = is_active ? found.multipliers[row] : found.left[row];
    const Real& error = is_active ? found.multiplier_error[row] : found.left_error[row];
    if (!(value >= -error)) {  // also where it overflowed
      return std::nullopt;
    }
    const Real unit = is_active ? Real(cables.rows().row(row).squaredNorm()) : Real(1);
    result = max(result, Real(-value * unit));
  }
  return result;
}

/// The row outside `active` that closes most and depends on none of them; none: no row closes.
template <class TheCase, class Real = RealOf<TheCase>>
std::optional<std::size_t> entering(const CableRows<TheCase>& cables,
                                    const Complementary<Real>& now, CableSet active) {
  std::optional<std::size_t> result;
  Real most(0);
  for (const std::size_t row : cables.all() - active) {
    const auto k = static_cast<Eigen::Index>(row);
    const Real size = cables.rows().row(k).norm();
    if (now.left[k] < -now.left_error[k] && now.left[k] < most * size &&
        cables.independent(active | CableSet::of(row))) {
      most = now.left[k] / size;
      result = row;
    }
  }
  return result;
}

/// A solution by active sets, after Lawson and Hanson: the row that closes most enters, and those
/// whose z would turn negative on the way leave. None where it does not end, or rounding
/// decides.
template <class TheCase, class Real = RealOf<TheCase>>
std::optional<Complementary<Real>> by_active_set(const CableRows<TheCase>& cables,
                                                 const BasicCableVector<Real>& q,
                                                 const BasicCableVector<Real>& rounding) {
  CableSet active;
  Complementary<Real> now = trial(cables, q, rounding, active);
  for (std::size_t round = 0; round < 4 * max_cables; ++round) {
    const auto next = entering(cables, now, active);
    if (!next) {
      return violation(cables, now) ? std::optional(now) : std::nullopt;
    }
    active.insert(*next);
    BasicCableVector<Real> z = now.multipliers;
    for (bool steps_back = true; steps_back;) {
      now = trial(cables, q, rounding, active);
      steps_back = false;
      Real part(1);
      std::size_t leaving = 0;
      for (const std::size_t row : active) {
        const auto k = static_cast<Eigen::Index>(row);
        if (!(now.multipliers[k] > 0) && z[k] <= part * (z[k] - now.multipliers[k])) {
          part = z[k] > 0 ? Real(z[k] / (z[k] - now.multipliers[k])) : Real(0);
          leaving = row;
          steps_back = true;
        }
      }
      if (steps_back) {
        z += part * (now.multipliers - z);
        z[static_cast<Eigen::Index>(leaving)] = Real(0);
        active.erase(leaving);
      }
    }
  }
  return std::nullopt;
}

}  // namespace

template <class TheCase, class Real>
std::optional<Complementary<Real>> complementary(const CableRows<TheCase>& cables,
                                                 const BasicCableVector<Real>& q,
                                                 const BasicCableVector<Real>& rounding) {
  if (q.size() == 1) {
    return of_one(cables, q[0], rounding[0]);
  }
  // Of independent rows A A^T is positive definite, and the solution one. Where all z are positive
  // beyond their errors it is this; `rounding` is that of q and of the products here
  if (static_cast<std::size_t>(q.size()) <= cables.freedoms() && cables.independent(cables.all())) {
    Complementary<Real> all = trial(cables, q, rounding, cables.all());
    if ((all.multipliers - all.multiplier_error).minCoeff() > 0) {
      return all;
    }
  }
  if constexpr (TheCase::has_several_bodies) {  // a planar body keeps its bits: it tries all
    constexpr Eigen::Index worth_it = 4;        // rows
    if (q.size() >= worth_it) {
      if (auto found = by_active_set(cables, q, rounding)) {
        return found;
      }
    }
  }
  // A solution with independent active rows always exists (Caratheodory), so the at most
  // 1 + 8 + 28 + 56 sets of up to three rows are all that is left to try. In exact arithmetic one
  // of them violates nothing; rounding decides between neighbours, so the smallest violation wins.
  std::optional<Complementary<Real>> best;
  Real smallest = infinity<Real>();
  for (unsigned bits = 0; bits < (1U << static_cast<unsigned>(q.size())); ++bits) {
    const CableSet active = rows_of(bits);
    if (!cables.independent(active)) {
      continue;
    }
    Complementary<Real> found = trial(cables, q, rounding, active);
    const auto broken = violation(cables, found);
    if (broken && *broken < smallest) {
      smallest = *broken;
      best = std::move(found);
      if (smallest == 0) {  // exactly: nothing is better
        break;
      }
    }
  }
  if (best) {
    best->multipliers = best->multipliers.cwiseMax(Real(0)).eval();
  }
  return best;
}

template std::optional<Complementary<Instance>> complementary(const CableRows<InstanceCase>&,
                                                              const BasicCableVector<Instance>&,
                                                              const BasicCableVector<Instance>&);

}  // namespace tautline
