#pragma once

#include <string_view>

#include "tautline/case.hpp"
#include "tautline/system.hpp"

namespace tautline::bench {

// The cases that several claims are measured on.

/// The case that ships under `name`; it must exist.
[[nodiscard]] Case shipped_case(std::string_view name);

/// The first breakwater of Table 5.1, with this restitution.
[[nodiscard]] Case standard_breakwater(double restitution);

/// One cable through an attachment of a spinning body, slack for the first `slack` metres.
[[nodiscard]] Case spinning_on_one_cable(double slack);

/// `the_case` in a mirror on the y axis, with the cables in reverse order.
[[nodiscard]] Case mirrored(const Case& the_case);
[[nodiscard]] State mirrored(State state);

/// One body of 1 kg at rest in the origin of space, with these principal `moments` [kg m^2] and
/// without gravity, on a slack cable from its centre to the world.
[[nodiscard]] SpatialSystem body_in_space(const Eigen::Vector3d& moments);

/// The direction in which cables in space are struck: a unit vector, and no special one.
[[nodiscard]] Eigen::Vector3d struck_direction();

/// How far a struck cable in space is from its length at the start [m]: at 1 m/s it goes taut in
/// the 21st step of 1e-3 s.
inline constexpr double way_to_strike = 0.0203;

/// Two bodies of 1 and 3 kg in space that go apart with 1 m/s, on an off-centre cable between them.
/// Each has three equal moments, and so turns alike with and without the gyroscopic term. Their
/// momentum is zero, so that damping does not change it.
[[nodiscard]] SpatialSystem pair_on_a_cable(double restitution);

}  // namespace tautline::bench
