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

std::string cables_are(CableSet cables) {
  return cables.size() == 1 ? "cable " + cable_list(cables) + " is"
                            : "cables " + cable_list(cables) + " are";
}

std::string tie_sentence(EventKind kind, CableSet cables, const std::string& time) {
  if (kind == EventKind::slack) {
    const bool one = cables.size() == 1;
    return fmt::format(
        "At t = {} the tension of cable{} {} touches zero: whether {} there is a tie that rounding "
        "decides.",
        time, one ? "" : "s", cable_list(cables), one ? "it lets go" : "they let go");
  }
  if (kind == EventKind::taut) {
    return fmt::format(
        "At t = {} the taut cables {} are at a dead point, where the body can go on in more than "
        "one way: which one it takes is a tie that rounding decides.",
        time, cable_list(cables));
  }
  return fmt::format(
      "At t = {} cables {} become taut at one instant, as far as numbers tell: which of them is "
      "first is a tie that rounding decides.",
      time, cable_list(cables));
}

std::string rest_tension_sentence(const std::string& list, bool determine) {
  return fmt::format("Tension at rest: {}{}.\n", list,
                     determine ? "" : " (indeterminate: the smallest that hold the body)");
}

std::string split_sentence(CableSet cables, const std::string& time, const std::string& impulses,
                           std::size_t more) {
  const std::string others =
      more == 0 ? ""
                : fmt::format(" So are those of {} later impact{}.", more, more == 1 ? "" : "s");
  return fmt::format(
      "The impulses on cables {} at t = {} are indeterminate: {} is the split of least squares, "
      "and "
      "every other one that does the same to the body is as right.{}",
      cable_list(cables), time, impulses, others);
}

}  // namespace tautline::bench
