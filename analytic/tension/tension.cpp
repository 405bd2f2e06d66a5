#include "tension/tension.hpp"

#include <optional>
#include <vector>

#include "instantiate.hpp"
#include "tautline/detail/projection.hpp"
#include "tautline/geometry.hpp"

namespace tautline {
namespace {

/// What the cables of `set` do to the body with these tensions [N, N, N m].
template <class TheCase, class Real = RealOf<TheCase>>
RowOf<TheCase> pull(const TheCase& the_case, const StateOf<TheCase>& state, CableSet set,
                    const BasicCableVector<Real>& tensions) {
  RowOf<TheCase> result = RowOf<TheCase>::Zero(static_cast<Eigen::Index>(freedoms_of(the_case)));
  Eigen::Index row = 0;
  for (const std::size_t index : set) {
    result += tensions[row++] * gap_gradient(the_case.cables[index], state);
  }
  return result;
}

/// The tensions that take the accelerations of the gaps of `set` away, and may push.
template <class TheCase, class Real = RealOf<TheCase>>
BasicCableVector<Real> smallest_multipliers(const TheCase& the_case, const StateOf<TheCase>& state,
                                            CableSet set) {
  BasicCableVector<Real> wanted(static_cast<Eigen::Index>(set.size()));
  Eigen::Index row = 0;
  for (const std::size_t index : set) {
    wanted[row++] = -free_gap_acceleration(the_case, index, state);
  }
  return multipliers(the_case, state, set, wanted);
}

}  // namespace

template <class TheCase, class Real>
BasicCableVector<Real> holding_tensions(const TheCase& the_case, const StateOf<TheCase>& state,
                                        CableSet taut) {
  const BasicCableVector<Real> all = smallest_multipliers(the_case, state, taut);
  const Real size = all.size() > 0 ? Real(all.cwiseAbs().maxCoeff()) : Real(0);
  constexpr double rounding =
      1e-10;  // [-], of the largest: what redundant cables share loses digits
  if (taut.size() < 2 || all.minCoeff() >= -rounding * size) {
    return all.cwiseMax(Real(0));
  }
  // The smallest tensions without a push are the smallest multipliers of the cables that pull, and
  // every set of cables whose own do not push and come to the same pull is a candidate.
  const RowOf<TheCase> wanted = pull(the_case, state, taut, all);
  const std::vector<std::size_t> indices = taut.indices();
  std::optional<BasicCableVector<Real>> best;
  for (unsigned bits = 1; bits < (1U << indices.size()); ++bits) {
    CableSet part;
    std::vector<Eigen::Index> rows;
    for (std::size_t row = 0; row < indices.size(); ++row) {
      if (((bits >> row) & 1U) != 0) {
        part.insert(indices[row]);
        rows.push_back(static_cast<Eigen::Index>(row));
      }
    }
    const BasicCableVector<Real> own = smallest_multipliers(the_case, state, part);
    const Real missing = (pull(the_case, state, part, own) - wanted).norm();
    if (own.minCoeff() < -rounding * size || !(missing <= rounding * wanted.norm())) {
      continue;
    }
    if (!best || own.squaredNorm() < best->squaredNorm()) {
      best = BasicCableVector<Real>::Zero(all.size());
      (*best)(rows) = own;
    }
  }
  return best.value_or(all).cwiseMax(Real(0));
}

template BasicCableVector<Instance> holding_tensions(const InstanceCase&,
                                                     const StateOf<InstanceCase>&, CableSet);

}  // namespace tautline
