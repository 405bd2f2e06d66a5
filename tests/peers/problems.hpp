#pragma once

#include <cstddef>
#include <cstdint>
#include <vector>

#include "peer.hpp"

namespace tautline::peers {

/// Impacts off by more are others [s].
inline constexpr double other_impact = 1e-3;

/// A case whose first impacts are known.
struct KnownMotion {
  Case the_case;
  Stop stop;  // after the last of them; before what comes next, if that is not the same instant
  std::vector<Located> impacts;  // of the exact motion of its doubles, in 40 digits
};

/// Of every shipped case on one or two cables, rigid or not, without limits of its own, the first
/// impacts from slack cables, `most` at most, as far as no cable becomes taut in between and
/// flights are longer than two `other_impact`.
[[nodiscard]] std::vector<KnownMotion> known_motions(std::size_t most);

/// A flight whose cable is overrun by less than 1 % of its length, once, and opens again.
struct Graze {
  Case the_case;   // one cable
  double deepest;  // [s], the instant of the smallest gap
  double depth;    // [m], > 0; the gap is minus this there
  double width;    // [s], half the time that the gap would be below zero, to leading order
};

/// `count` of them. The state at `deepest` is drawn: cable's direction, attachment, spin and speed
/// across the cable uniform, the depth uniform in its logarithm from 1e-12 to 1e-2; and flown back
/// to a start with a positive gap. So each has an impact: its gap is positive first, and at
/// `deepest` negative in numbers of 64 bits of mantissa.
[[nodiscard]] std::vector<Graze> grazes(std::size_t count, std::uint64_t seed);

/// True where `found` has the impact of `graze`: one within twice its width.
[[nodiscard]] bool has_graze(const Graze& graze, const std::vector<Located>& found);

/// The run that looks for it: to some time after it, one impact.
[[nodiscard]] Stop stop_of(const Graze& graze);

}  // namespace tautline::peers
