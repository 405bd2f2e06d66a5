#pragma once

namespace tautline::bench {

// When a rebound counts as lost, for the audit and for the causes of deviations.

/// An impact asks for a rebound from this restitution on [-].
inline constexpr double asking = 0.2;

/// A rebound is lost that comes back with less than this part of the requested restitution [-]. A
/// correction of the overstretch may push a lost one a little: the engines' come to 0.4 of it at
/// most, and those that are not lost to 0.99 and more.
inline constexpr double lost_part = 0.5;

/// A cable still closes after a step that leaves this part of the speed [-].
inline constexpr double still_closing = 0.1;

}  // namespace tautline::bench
