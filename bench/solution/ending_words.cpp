#include "bench/solution/ending_words.hpp"

#include <fmt/format.h>

namespace tautline::bench {

std::string ending_sentence(Ending ending, std::size_t bodies, const std::string& instant,
                            const std::string& duration, std::size_t events) {
  const bool one = bodies == 1;
  switch (ending) {
    case Ending::reached_duration:
      return fmt::format("The run reached its duration, t = {}.", duration);
    case Ending::rest:
      return fmt::format("{} at rest from {} until the end, t = {}.",
                         one ? "The body is" : "The bodies are", instant, duration);
    case Ending::unstable_rest:
      return fmt::format(
          "{} still from {} until the end, t = {}, at an unstable equilibrium: the smallest push "
          "would move {}.",
          one ? "The body stands" : "The bodies stand", instant, duration, one ? "it" : "them");
    case Ending::locked:
      return fmt::format("The run ended at {}, after its swing had turned twice.", instant);
    case Ending::singular:
      return fmt::format(
          "Stopped at {}: the touching cables are so nearly in one line there that their tensions "
          "or impulses cannot be computed.",
          instant);
    case Ending::event_limit:
      return fmt::format(
          "Stopped at {}: the run reached the limit of {} events; --max-events raises it.", instant,
          events);
    case Ending::step_limit:
      return fmt::format(
          "Stopped at {}: the run reached the limit of steps of taut motion, and of springs within "
          "impacts, before t = {}; --max-steps raises it.",
          instant, duration);
    case Ending::no_progress:
      return fmt::format(
          "Stopped at {}: one event follows another there, and time does not advance.", instant);
    case Ending::overflow:
      return fmt::format("Stopped at {}: after it the motion has numbers too large for a double.",
                         instant);
    case Ending::angle_limit:
    case Ending::ceiling:
      break;
  }
  return fmt::format("The run ended at {}.", instant);
}

}  // namespace tautline::bench
