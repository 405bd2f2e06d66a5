#pragma once

#include <Eigen/Core>
#include <vector>

#include "tautline/case.hpp"
#include "tautline/detail/state_matrix.hpp"
#include "tautline/impact.hpp"
#include "tautline/solution.hpp"

namespace tautline {

/// The cables that pull in `impact`.
template <class Real>
[[nodiscard]] CableSet pulled(const BasicEvent<BasicCase<Real>>& impact) {
  CableSet result;
  Eigen::Index row = 0;
  for (const std::size_t index : impact.cables) {
    if (impact.impulses[row++] > 0) {
      result.insert(index);
    }
  }
  return result;
}

// Derivatives of the maps that a motion is made of. Equation numbers are those of
// analytic/README.md.

/// True for the arc of a body at rest, whose series are a place and a spin.
template <class Real>
[[nodiscard]] bool is_rest(const BasicArc<BasicCase<Real>>& arc) {
  return arc.series.rows() == 2;
}

/// A largest independent subset of `cables`: the others follow these.
template <class Real>
[[nodiscard]] CableSet basis(const BasicCase<Real>& the_case, const BasicState<Real>& state,
                             CableSet cables);

/// The tensions [N] that hold the independent cables `pulling`, in rising index order.
template <class Real>
[[nodiscard]] BasicCableVector<Real> tensions(const BasicCase<Real>& the_case,
                                              const BasicState<Real>& state, CableSet pulling);

/// The square of the largest sine between the rows of two of `cables` [-]: 0 where all of them hold
/// the body in one way only, as at a dead point.
template <class Real>
[[nodiscard]] Real independence(const BasicCase<Real>& the_case, const BasicState<Real>& state,
                                CableSet cables);

/// What an impact's results gain per unit of the state before.
template <class Real>
struct BasicReboundSlopes {
  BasicStateMatrix<Real> after;                                       // the state after
  Eigen::Matrix<Real, Eigen::Dynamic, 6, 0, max_cables, 6> impulses;  // one row per cable
};

/// Of an impact that happens at a given instant (Eq. 43). `held` are those of its cables that were
/// taut before: the differences keep them so.
template <class Real>
[[nodiscard]] BasicReboundSlopes<Real> rebound_slopes(const BasicCase<Real>& the_case,
                                                      ImpactLaw law,
                                                      const BasicEvent<BasicCase<Real>>& impact,
                                                      CableSet held);

/// d state after / d state before of an impact that happens at a given instant (Eq. 43).
/// `held` are those of its cables that were taut before: the differences keep them so.
template <class Real>
[[nodiscard]] BasicStateMatrix<Real> rebound_derivative(const BasicCase<Real>& the_case,
                                                        ImpactLaw law,
                                                        const BasicEvent<BasicCase<Real>>& impact,
                                                        CableSet held);

/// d projected(state) / d state, onto taut `cables` (Eq. 44), without the momentum term of Eq. 18:
/// its derivative is of the size of the gaps, 1e-12 m and less.
template <class Real>
[[nodiscard]] BasicStateMatrix<Real> projection_derivative(const BasicCase<Real>& the_case,
                                                           const BasicState<Real>& state,
                                                           CableSet cables);

/// Taylor coefficients 0 to `order` of d pose / d start, in the time since then, for the motion
/// with the independent cables `pulling` taut.
template <class Real>
[[nodiscard]] std::vector<Eigen::Matrix<Real, 3, 6>> flow_derivative(
    const BasicCase<Real>& the_case, const BasicState<Real>& start, CableSet pulling,
    std::size_t order);

/// The row d dt / d state [s per unit], where dt is the delay of the instant at which `hit`, at
/// zero gap and closing, become taut: -grad g / rate. None where the delay has no derivative: a
/// cable that grazes, or several that close together at `state` but not near it.
template <class Real>
[[nodiscard]] std::optional<Eigen::Matrix<Real, 1, 6>> delay_derivative(
    const BasicCase<Real>& the_case, const BasicState<Real>& state, CableSet hit);

}  // namespace tautline
