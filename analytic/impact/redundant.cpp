#include "redundant.hpp"

#include <bit>

#include "instantiate.hpp"
#include "least_solution.hpp"
#include "rebound.hpp"
#include "tautline/detail/projection.hpp"
#include "tautline/detail/rows.hpp"

namespace tautline {
namespace {

/// The rows of `cables` whose impulse may be more than zero: they leave as fast as their
/// restitution says, up to rounding.
template <class TheCase>
CableSet rows_that_may_pull(const TheCase& the_case, const StateOf<TheCase>& before,
                            const StateOf<TheCase>& after, CableSet cables) {
  using Real = RealOf<TheCase>;
  const BasicCableVector<Real> rates = gap_rates(the_case, before, cables);
  const BasicCableVector<Real> rebounds = gap_rates(the_case, after, cables);
  const BasicCableVector<Real> rounding = rate_errors(the_case, before, cables);
  CableSet result;
  Eigen::Index row = 0;
  for (const std::size_t index : cables) {
    const Real e = restitution(the_case.cables[index], rates[row]);
    if (rebounds[row] + e * rates[row] <= (1 + e) * rounding[row]) {
      result.insert(static_cast<std::size_t>(row));
    }
    ++row;
  }
  return result;
}

/// True where `impulses`, on independent rows, may be one split of several: some cable that might
/// pull does not.
template <class Real>
bool may_be_shared(CableSet may_pull, const BasicCableVector<Real>& impulses,
                   std::size_t freedoms) {
  if (may_pull.size() > freedoms) {
    return true;
  }
  for (const std::size_t row : may_pull) {
    if (!(impulses[static_cast<Eigen::Index>(row)] > 0)) {
      return true;
    }
  }
  return false;
}

/// The rows that pull in some split on independent rows: the corners of all splits.
template <class TheCase>
CableSet rows_of_corners(const CableRows<TheCase>& rows, CableSet may_pull,
                         const RowOf<TheCase>& jump) {
  using Real = RealOf<TheCase>;
  const std::vector<std::size_t> choices = may_pull.indices();
  const Real rounding = rounding_margin * epsilon<Real>() * jump.norm();
  CableSet result;
  for (unsigned bits = 1; bits < (1U << choices.size()); ++bits) {
    CableSet chosen;
    for (std::size_t choice = 0; choice < choices.size(); ++choice) {
      if (((bits >> choice) & 1U) != 0) {
        chosen.insert(choices[choice]);
      }
    }
    if (!rows.independent(chosen)) {
      continue;
    }
    const RowSpace<TheCase> space = rows.space(chosen);
    CableSet pulling;
    bool pulls = (jump - space.part(jump)).norm() <= rounding;
    std::size_t i = 0;
    for (const std::size_t row : chosen) {
      const RowOf<TheCase>& dual = space.dual(i++);
      const Real impulse = dual.dot(jump);
      const Real error = rounding * dual.norm();
      pulls = pulls && impulse >= -error;
      if (impulse > error) {
        pulling.insert(row);
      }
    }
    result = pulls ? result | pulling : result;
  }
  return result;
}

/// The impulses >= 0 of smallest size on the rows of `sharing` that do what `impulses` do.
template <class TheCase, class Real = RealOf<TheCase>>
BasicCableVector<Real> least_impulses(const CableRows<TheCase>& rows, CableSet sharing,
                                      const BasicCableVector<Real>& impulses) {
  const BasicCableVector<Real> jump = rows.shapes().transpose() * impulses;
  BasicCableVector<Real> result = BasicCableVector<Real>::Zero(impulses.size());
  while (!sharing.empty()) {
    std::vector<Eigen::Index> chosen;
    for (const std::size_t row : sharing) {
      chosen.push_back(static_cast<Eigen::Index>(row));
    }
    const BasicCableMatrix<Real> columns = rows.shapes()(chosen, Eigen::all).transpose();
    const BasicCableVector<Real> found = least_solution<Real>(columns, jump, rows.dependent());
    Eigen::Index least = 0;
    const Real smallest = found.minCoeff(&least);
    if (smallest >= -rounding_margin * epsilon<Real>() * found.cwiseAbs().maxCoeff()) {
      result(chosen) = found.cwiseMax(Real(0));
      break;
    }
    sharing.erase(static_cast<std::size_t>(chosen[static_cast<std::size_t>(least)]));
  }
  return result;
}

}  // namespace

template <class TheCase, class Real>
Split<Real> split(const TheCase& the_case, const StateOf<TheCase>& before,
                  const StateOf<TheCase>& after, CableSet cables,
                  const BasicCableVector<Real>& impulses, bool of_corner) {
  if (cables.size() < 2 || !impulses.allFinite()) {
    return {};
  }
  const CableSet may_pull = rows_that_may_pull(the_case, before, after, cables);
  if (of_corner && !may_be_shared(may_pull, impulses, freedoms_of(the_case))) {
    return {};
  }
  const CableRows<TheCase> rows(the_case, before, cables);
  if (rows.independent(may_pull)) {
    return {};
  }
  const RowOf<TheCase> jump = rows.rows().transpose() * impulses;
  const CableSet sharing = rows_of_corners(rows, may_pull, jump);
  if (rows.independent(sharing)) {
    return {};
  }
  Split<Real> result{{}, least_impulses(rows, sharing, impulses)};
  std::size_t row = 0;
  for (const std::size_t index : cables) {
    if (sharing.contains(row++)) {
      result.cables.insert(index);
    }
  }
  return result;
}

template Split<Instance> split(const InstanceCase&, const StateOf<InstanceCase>&,
                               const StateOf<InstanceCase>&, CableSet,
                               const BasicCableVector<Instance>&, bool);

}  // namespace tautline
