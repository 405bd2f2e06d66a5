#pragma once

#include <type_traits>

#include "shortcuts/batch/bounce_lanes.hpp"
#include "shortcuts/members.hpp"

namespace tautline {

// `Pack` says how numbers of lanes are computed with: its V, so many at once, from(LaneNumbers,
// first) and to(V, LaneNumbers&, first), and Mask, from(...) > 0, to(Mask, ...).

/// What so many lanes from `first` on have of those of all.
template <class Pack, template <class> class Parts>
[[nodiscard]] Parts<typename Pack::V> part_of_lanes(const Parts<LaneNumbers>& all,
                                                    std::size_t first) {
  Parts<typename Pack::V> part;
  each_number(part, all, [first](typename Pack::V& v, const LaneNumbers& numbers) {
    v = Pack::from(numbers, first);
  });
  return part;
}

template <class Pack>
void bounce_lanes(const LaneQuestion& question, LaneAnswer& answer) {
  using V = typename Pack::V;
  using Mask = typename Pack::Mask;
  for (std::size_t first = 0; first < lanes; first += Pack::size) {
    const auto cable = [&](std::size_t place) {
      return part_of_lanes<Pack>(question.cables[place], first);
    };
    const Mask touches = Pack::from(question.touches, first) > V(0);
    const Bounce<V, Mask> bounce = next_bounce(
        part_of_lanes<Pack>(question.world, first), part_of_lanes<Pack>(question.from, first),
        cable, question.count, touches, Pack::from(question.horizon, first), question.limits);
    each_number(answer, bounce, [first]<class Of>(LaneNumbers& into, const Of& of) {
      if constexpr (std::is_same_v<Of, V>) {
        Pack::to(of, into, first);
      } else {
        Pack::to(select(of, V(1), V(0)), into, first);
      }
    });
  }
}

}  // namespace tautline
