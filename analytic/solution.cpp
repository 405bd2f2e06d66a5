#include "tautline/solution.hpp"

#include <algorithm>
#include <stdexcept>
#include <string>
#include <utility>

#include "tautline/flight.hpp"

namespace tautline {

Solution::Solution(Vec2 gravity, std::vector<Arc> arcs, std::vector<Event> events, Ending ending,
                   std::optional<Accumulation> accumulation)
    : gravity_(std::move(gravity)),
      arcs_(std::move(arcs)),
      events_(std::move(events)),
      ending_(ending),
      accumulation_(std::move(accumulation)) {
  if (arcs_.empty()) {
    throw std::invalid_argument("a solution needs at least one arc");
  }
}

State Solution::at(double time) const {
  if (!(time >= 0.0 && time <= end_time())) {
    throw std::out_of_range("time " + std::to_string(time) +
                            " is outside the solution, which ends at " +
                            std::to_string(end_time()));
  }
  // the last arc that starts at or before `time`: after an event, not before it
  const auto next = std::upper_bound(arcs_.begin(), arcs_.end(), time,
                                     [](double t, const Arc& arc) { return t < arc.start; });
  const Arc& arc = *std::prev(next);
  return fly(arc.initial, gravity_, time - arc.start);
}

std::string_view to_string(EventKind kind) {
  switch (kind) {
    case EventKind::impact:
      return "impact";
    case EventKind::taut:
      return "taut";
    case EventKind::slack:
      return "slack";
  }
  return "unknown";
}

std::string_view to_string(Ending ending) {
  switch (ending) {
    case Ending::reached_duration:
      return "reached_duration";
    case Ending::zeno:
      return "zeno";
    case Ending::taut:
      return "taut";
    case Ending::angle_limit:
      return "angle_limit";
    case Ending::ceiling:
      return "ceiling";
    case Ending::event_limit:
      return "event_limit";
    case Ending::overflow:
      return "overflow";
  }
  return "unknown";
}

}  // namespace tautline
