#include "bench/solution/cable_words.hpp"

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

}  // namespace tautline::bench
