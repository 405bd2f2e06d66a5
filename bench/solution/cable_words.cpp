#include "bench/solution/cable_words.hpp"

#include <fmt/format.h>

namespace tautline::bench {

std::string cable_list(CableSet cables) {
  std::string result;
  for (const std::size_t index : cables) {
    result += (result.empty() ? "" : "+") + std::to_string(index);
  }
  return result;
}

std::string cable_names(CableSet cables) {
  std::string result = cables.size() == 1 ? "cable " : "cables ";
  std::size_t place = 0;
  for (const std::size_t index : cables) {
    result += (place == 0                   ? ""
               : place + 1 == cables.size() ? " and "
                                            : ", ") +
              std::to_string(index);
    ++place;
  }
  return result;
}

std::string tie_sentence(EventKind kind, CableSet cables, const std::string& time) {
  if (kind == EventKind::slack) {
    const bool one = cables.size() == 1;
    return fmt::format(
        "At t = {} the tension of {} touches zero. Rounding decides whether {} (a tie).", time,
        cable_names(cables), one ? "it goes slack" : "they go slack");
  }
  if (kind == EventKind::taut) {
    return fmt::format(
        "At t = {} the taut {} are at a dead point, where the body can go on in more than one way. "
        "Rounding decides which way it takes (a tie).",
        time, cable_names(cables));
  }
  return fmt::format(
      "At t = {} {} become taut at the same instant, as far as the numbers can tell. Rounding "
      "decides which of them is hit first (a tie).",
      time, cable_names(cables));
}

std::string rest_tension_sentence(const std::string& list, bool determine) {
  return fmt::format("Tension at rest: {}{}.\n", list,
                     determine ? "" : " (indeterminate: the smallest that hold the body)");
}

std::string split_sentence(CableSet cables, const std::string& time, const std::string& impulses,
                           std::size_t more) {
  const std::string others =
      more == 0 ? ""
                : fmt::format(" The same holds for {} later impact{}.", more, more == 1 ? "" : "s");
  return fmt::format(
      "The impulses on {} at t = {} are indeterminate: {} is the split with the least squares, and "
      "every other split with the same effect on the body is as valid.{}",
      cable_names(cables), time, impulses, others);
}

}  // namespace tautline::bench
