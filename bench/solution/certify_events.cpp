#include "bench/solution/certify_events.hpp"

#include <algorithm>

#include "tautline/system.hpp"

namespace tautline::bench {
namespace {

/// The bounces that a completed accumulation replaces may last this many times as long as was
/// estimated when it was completed [-].
constexpr double lasting_margin = 2.0;

/// A cascade of ever slower impacts ends within this part of its time [-]: where only some digits
/// are left of it, how many impacts follow is a matter of rounding.
constexpr double one_instant = 1e-9;

template <class TheCase, class InDigits>
bool same(const BasicEvent<TheCase>& one, const BasicEvent<InDigits>& other) {
  return one.kind == other.kind && one.cables == other.cables;
}

/// Where the events of `solution` from number `first` on go on after they have come through
/// `accumulation`, of which they are still taking the impacts; none if they do something else.
template <class TheCase>
std::optional<std::size_t> after_the_same(const BasicSolution<TheCase>& solution, std::size_t first,
                                          const Accumulation& accumulation) {
  const auto& events = solution.events();
  const Multi lasting =
      lasting_margin * (accumulation.time - accumulation.start) + accumulation.uncertainty;
  const Multi start = first > 0 ? events[first - 1].time : Multi(0);
  for (std::size_t index = first; index < events.size(); ++index) {
    const BasicEvent<TheCase>& event = events[index];
    if (!(event.cables - accumulation.cables).empty() || event.time - start > lasting) {
      return std::nullopt;
    }
    if (event.kind == EventKind::taut && event.cables == accumulation.cables) {
      return index + 1;
    }
  }
  return events.size();  // the duration cuts it short
}

/// The event that makes all cables of a cascade taut, which event `first` of `solution` is still
/// part of; none: it is part of no such thing, or the cascade lasts.
template <class TheCase>
std::optional<std::size_t> end_of_cascade(const BasicSolution<TheCase>& solution,
                                          std::size_t first) {
  const auto& events = solution.events();
  const Multi most = one_instant * Multi(events[first].time);
  CableSet cables;
  for (std::size_t index = first; index < events.size(); ++index) {
    const BasicEvent<TheCase>& event = events[index];
    cables = cables | event.cables;
    if (Multi(event.time) - Multi(events[first].time) > most) {
      return std::nullopt;
    }
    if (event.kind == EventKind::taut && event.cables == cables) {
      return index;
    }
  }
  return std::nullopt;
}

template <class TheCase>
std::optional<EventMark> mark(const std::vector<BasicEvent<TheCase>>& events, std::size_t index) {
  if (index >= events.size()) {
    return std::nullopt;
  }
  const BasicEvent<TheCase>& event = events[index];
  return EventMark{static_cast<double>(event.time), event.kind, event.cables};
}

template <class TheCase>
std::size_t events_until(const std::vector<BasicEvent<TheCase>>& events,
                         const RealOf<TheCase>& time) {
  const auto next =
      std::upper_bound(events.begin(), events.end(), time,
                       [](const auto& t, const auto& event) { return t < event.time; });
  return static_cast<std::size_t>(next - events.begin());
}

}  // namespace

template <class TheCase, class InDigits>
Alignment<TheCase, InDigits>::Alignment(const BasicSolution<TheCase>& one,
                                        const BasicSolution<InDigits>& other)
    : one_(one), other_(other), places_{{0, 0}} {
  std::size_t i = 0;
  std::size_t j = 0;
  while (i < one.events().size() && j < other.events().size()) {
    const auto& event = one.events()[i];
    const Accumulation* accumulation = completed_by(one, event);
    if (same(event, other.events()[j])) {
      ++j;
    } else if (const auto next =
                   accumulation ? after_the_same(other, j, *accumulation) : std::nullopt) {
      j = *next;
    } else {
      const auto mine = end_of_cascade(one, i);
      const auto theirs = mine ? end_of_cascade(other, j) : std::nullopt;
      if (!theirs || one.events()[*mine].cables != other.events()[*theirs].cables) {
        break;
      }
      i = *mine;
      j = *theirs + 1;
    }
    ++i;
    places_.emplace_back(i, j);
    match_.until = event.time;
  }
  match_.count = i;
  match_.in_double = mark(one.events(), i);
  match_.in_digits = mark(other.events(), j);
  match_.all = !match_.in_double && !match_.in_digits;
}

template <class TheCase, class InDigits>
bool Alignment<TheCase, InDigits>::between_same_events(double time) const {
  return std::binary_search(
      places_.begin(), places_.end(),
      std::pair(events_until(one_.events(), time), events_until(other_.events(), Multi(time))));
}

template class Alignment<Case, BasicCase<Multi>>;
template class Alignment<System, BasicSystem<Multi, 2>>;
template class Alignment<SpatialSystem, BasicSystem<Multi, 3>>;

}  // namespace tautline::bench
