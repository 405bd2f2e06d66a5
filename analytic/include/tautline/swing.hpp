#pragma once

namespace tautline {

/// The periodic motion of a body whose taut cables leave it one degree of freedom.
template <class Real>
struct BasicSwing {
  Real energy;   // [J], above the equilibrium it swings about
  Real period;   // [s]
  Real least;    // [rad], the smaller of the angles at its two turning points
  Real largest;  // [rad], the other; between them the angle may go beyond where it is not monotone
  Real amplitude;  // [rad], half the difference
};
using Swing = BasicSwing<double>;

}  // namespace tautline
