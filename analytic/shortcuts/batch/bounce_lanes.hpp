#pragma once

#include <array>
#include <cstddef>

#include "shortcuts/bounce.hpp"

namespace tautline {

/// So many motions are taken side by side: as many doubles as the widest registers hold.
inline constexpr std::size_t lanes = 8;

/// One number of each.
struct alignas(64) LaneNumbers {
  std::array<double, lanes> of{};
};

/// What `next_bounce` is asked for each lane. Lanes that are not in use hold any numbers.
struct LaneQuestion {
  FlightWorld<LaneNumbers> world;
  Flyer<LaneNumbers> from;
  std::array<FlightCable<LaneNumbers>, max_cables>
      cables;             // of each lane in the order of its search
  LaneNumbers touches;    // 1: it has left the first of them; or 0
  LaneNumbers horizon;    // [s]
  std::size_t count = 0;  // of the cables of every lane
  CompletionLimits limits;
};

/// What it answers; of a mask 1 or 0.
using LaneAnswer = Bounce<LaneNumbers, LaneNumbers>;

/// True where `each_number` reaches all of T: one left out would be undefined in the lanes.
template <class T>
inline constexpr bool is_listed = size_listed<T>() == sizeof(T);
static_assert(is_listed<FlightWorld<LaneNumbers>> && is_listed<Flyer<LaneNumbers>> &&
              is_listed<FlightCable<LaneNumbers>> && is_listed<LaneAnswer>);

/// Answers for all lanes, each to the bit as `next_bounce` for one body.
using BounceLanes = void (*)(const LaneQuestion&, LaneAnswer&);

/// The fastest that this processor can.
[[nodiscard]] BounceLanes fastest_bounce_lanes();

void bounce_lanes_one_by_one(const LaneQuestion& question, LaneAnswer& answer);  // on any processor
void bounce_lanes_avx2(const LaneQuestion& question, LaneAnswer& answer);
void bounce_lanes_avx512(const LaneQuestion& question, LaneAnswer& answer);

}  // namespace tautline
