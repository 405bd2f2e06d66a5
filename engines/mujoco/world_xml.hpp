#pragma once

#include <string>
#include <vector>

#include "tautline/case.hpp"
#include "tautline/system.hpp"

namespace tautline::mujoco {

/// How MuJoCo integrates; its names for it.
enum class Integrator { euler, rk4 };

/// MuJoCo's largest impedance (mjMAXIMP), the same at every overstretch: a limit acts with this
/// part of what it should [-].
inline constexpr double limit_impedance = 0.9999;

/// A tendon's upper limit as MuJoCo models it: beyond its length it is pulled back with
/// x'' = -stiffness x - damping x', whatever the mass, and cannot push.
struct TendonLimit {
  double stiffness;  // [1/s^2]
  double damping;    // [1/s]
};

/// The MuJoCo model of `the_case`: a body that slides along x and y and turns about z, and one
/// spatial tendon per cable. `limits` has one entry per cable, or none where tendons are to be
/// measured only.
[[nodiscard]] std::string model_xml(const Case& the_case, Integrator integrator,
                                    const std::vector<TendonLimit>& limits);

/// The model of a system: bodies with free joints, and after them a mocap body for each end or ring
/// that moves, in the order of the cables. A tendon goes through the sites of its rings.
[[nodiscard]] std::string model_xml(const SpatialSystem& system, Integrator integrator,
                                    const std::vector<TendonLimit>& limits);

}  // namespace tautline::mujoco
