#pragma once

namespace tautline {

/// The periodic motion of a body whose taut cables leave it one degree of freedom.
template <class Real>
struct BasicSwing {
  Real energy;     // [J], above the equilibrium it swings about
  Real period;     // [s]
  Real least;      // [rad], smallest angle
  Real largest;    // [rad]
  Real amplitude;  // [rad], half the difference
};
using Swing = BasicSwing<double>;

}  // namespace tautline
