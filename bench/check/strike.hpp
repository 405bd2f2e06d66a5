#pragma once

#include <vector>

#include "bench/check/subject.hpp"
#include "tautline/case.hpp"

namespace tautline::bench {

/// One body of 1 kg that closes one cable straight on, without gravity.
struct Strike {
  double speed = 1.0;    // [m/s], with which the cable closes
  double arm = 0.0;      // [m], from the centre of mass to the line of the cable
  double inertia = 0.0;  // [kg m^2]
  /// The part of the speed that the body's spin brings [-], its centre the rest; 0 without an arm.
  double spin_part = 0.0;
};

/// The case of a strike that wants this `restitution`. The cable goes taut after some whole steps
/// and the part `phase` [-] of one.
[[nodiscard]] Case struck_case(const Strike& strike, double restitution, double step, double phase);

/// What each strike rebounds with [-], at phases that differ from one to the next, on cables that
/// want `wanted`; no number where the cable is not struck or the engine loses the body.
[[nodiscard]] std::vector<double> restitutions_of(const Subject& subject,
                                                  const std::vector<Strike>& strikes, double step,
                                                  double wanted);

}  // namespace tautline::bench
