#pragma once

#include <optional>

namespace tautline {

/// Whose angle the turning points of a swing are told by.
enum class SwingAngle {
  body,   // the body's own
  cable,  // of a body that does not turn with its cables: that of the first cable which pulls, from
          // gravity's direction, anticlockwise
};

/// The periodic motion of a body whose taut cables leave it one degree of freedom: it swings from
/// one turning point to the other and back, or goes round and round.
template <class Real>
struct BasicSwing {
  Real energy;   // [J], its largest kinetic energy: that above the equilibrium it swings about
  Real period;   // [s]
  Real least;    // [rad], the smaller of the angles at its two turning points
  Real largest;  // [rad], the other; between them the angle may go beyond where it is not monotone
  Real amplitude;                       // [rad], half the difference
  SwingAngle angle = SwingAngle::body;  // which angle these are of
  bool goes_round = false;              // it has no turning points: the three are 0
  /// [N], of one cable, of a swing told ahead (SolveOptions::swing_ahead). None: the arcs of the
  /// solution have the whole way, and `tensions` tells those along them.
  std::optional<Real> largest_tension = std::nullopt;
};
using Swing = BasicSwing<double>;

}  // namespace tautline
