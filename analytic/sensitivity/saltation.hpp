#pragma once

#include <Eigen/Core>
#include <span>

#include "tautline/case.hpp"
#include "tautline/detail/state_matrix.hpp"
#include "tautline/impact.hpp"
#include "tautline/solution.hpp"

namespace tautline {

/// In place of a derivative where there is none.
template <class Real>
[[nodiscard]] BasicStateMatrix<Real> no_derivative() {
  return BasicStateMatrix<Real>::Constant(infinity<Real>());
}

/// d state / dt along `arc`, `dt` [s] after its start.
template <class Real>
[[nodiscard]] Eigen::Matrix<Real, 6, 1> state_rate(const BasicArc<BasicCase<Real>>& arc,
                                                   const Real& dt, const BasicVec2<Real>& gravity);

/// The events of one instant, between the arcs that end and start there.
template <class Real>
struct BasicInstant {
  const BasicCase<Real>& the_case;
  ImpactLaw law;
  std::span<const BasicEvent<BasicCase<Real>>> events;  // at most one of them an impact, the first
  Eigen::Matrix<Real, 6, 1> rate_before, rate_after;    // of the state
};

template <class Real>
struct BasicJump {
  BasicStateMatrix<Real> matrix;  // d state after / d state before; infinite where there is none
  CableSet taut;                  // after the events
};

/// What the events of an instant, before which `taut` were taut, do to a small difference of states
/// (Eq. 41).
template <class Real>
[[nodiscard]] BasicJump<Real> saltation(const BasicInstant<Real>& instant, CableSet taut);

}  // namespace tautline
