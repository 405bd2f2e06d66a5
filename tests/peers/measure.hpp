#pragma once

#include <array>
#include <vector>

#include "problems.hpp"

namespace tautline::peers {

/// What a peer made of known motions.
struct Accuracy {
  double first;          // [s], the largest error of the first impact; infinite where one is missed
  double median;         // [s], error of the impacts that were followed
  std::size_t followed;  // impacts, from the first on, with the right cables, off by less than
                         // `other_impact`
  std::size_t of;        // impacts there are
};

[[nodiscard]] Accuracy accuracy(Peer& peer, const std::vector<KnownMotion>& motions,
                                const Effort& effort);

/// Processor time per impact found [ns], the whole call of `Peer::impacts` included.
[[nodiscard]] double cost(Peer& peer, const std::vector<KnownMotion>& motions,
                          const Effort& effort);

/// The depths [m] at which the counts of missed grazes are parted, from deep to shallow.
inline constexpr std::array depth_bands = {1e-4, 1e-6, 1e-8, 1e-10, 0.0};

/// Grazes missed, and how many there were, for depths down to those of `depth_bands`.
struct Missed {
  std::array<std::size_t, depth_bands.size()> missed{};
  std::array<std::size_t, depth_bands.size()> of{};
};

/// Of as many of `arcs` as the peer flies.
[[nodiscard]] Missed missed(Peer& peer, const std::vector<Graze>& arcs, const Effort& effort);

}  // namespace tautline::peers
