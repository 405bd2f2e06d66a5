#include "bench/solution/certify_events.hpp"

#include <algorithm>

namespace tautline::bench {
namespace {

/// The bounces that a completed accumulation replaces may last this many times as long as was
/// estimated when it was completed [-].
constexpr double lasting_margin = 2.0;

template <class Real>
bool same(const Event& one, const BasicEvent<BasicCase<Real>>& other) {
  return one.kind == other.kind && one.cables == other.cables;
}

/// The accumulation that `event` completes, or null.
const Accumulation* completed_by(const Solution& solution, const Event& event) {
  const auto& all = solution.accumulations();
  const auto found = std::find_if(all.begin(), all.end(), [&](const Accumulation& accumulation) {
    return accumulation.start == event.time && accumulation.cables == event.cables;
  });
  return event.kind == EventKind::taut && found != all.end() ? &*found : nullptr;
}

/// Where the events of `solution` from number `first` on go on after they have come through
/// `accumulation`, of which they are still taking the impacts; none if they do something else.
std::optional<std::size_t> after_the_same(const BasicSolution<BasicCase<Multi>>& solution,
                                          std::size_t first, const Accumulation& accumulation) {
  const auto& events = solution.events();
  const Multi lasting =
      lasting_margin * (accumulation.time - accumulation.start) + accumulation.uncertainty;
  const Multi start = first > 0 ? events[first - 1].time : Multi(0);
  for (std::size_t index = first; index < events.size(); ++index) {
    const BasicEvent<BasicCase<Multi>>& event = events[index];
    if (!(event.cables - accumulation.cables).empty() || event.time - start > lasting) {
      return std::nullopt;
    }
    if (event.kind == EventKind::taut && event.cables == accumulation.cables) {
      return index + 1;
    }
  }
  return events.size();  // the duration cuts it short
}

template <class Real>
std::optional<EventMark> mark(const std::vector<BasicEvent<BasicCase<Real>>>& events,
                              std::size_t index) {
  if (index >= events.size()) {
    return std::nullopt;
  }
  const BasicEvent<BasicCase<Real>>& event = events[index];
  return EventMark{static_cast<double>(event.time), event.kind, event.cables};
}

template <class Real>
std::size_t events_until(const std::vector<BasicEvent<BasicCase<Real>>>& events, const Real& time) {
  const auto next = std::upper_bound(
      events.begin(), events.end(), time,
      [](const Real& t, const BasicEvent<BasicCase<Real>>& event) { return t < event.time; });
  return static_cast<std::size_t>(next - events.begin());
}

}  // namespace

Alignment::Alignment(const Solution& one, const BasicSolution<BasicCase<Multi>>& other)
    : one_(one), other_(other), places_{{0, 0}} {
  std::size_t i = 0;
  std::size_t j = 0;
  while (i < one.events().size() && j < other.events().size()) {
    const Event& event = one.events()[i];
    const Accumulation* accumulation = completed_by(one, event);
    if (same(event, other.events()[j])) {
      ++j;
    } else if (const auto next =
                   accumulation ? after_the_same(other, j, *accumulation) : std::nullopt) {
      j = *next;
    } else {
      break;
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

bool Alignment::between_same_events(double time) const {
  return std::binary_search(
      places_.begin(), places_.end(),
      std::pair(events_until(one_.events(), time), events_until(other_.events(), Multi(time))));
}

}  // namespace tautline::bench
