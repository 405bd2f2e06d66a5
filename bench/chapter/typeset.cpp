#include "bench/chapter/typeset.hpp"

#include <string_view>

namespace tautline::bench {

std::string typeset(std::string text) {
  struct Sign {
    std::string_view spelt;
    std::string_view set;
  };
  constexpr Sign signs[] = {{"<=", "≤"}, {">=", "≥"}, {"^2", "²"}, {"sqrt(", "√("}};
  for (const auto& [spelt, set] : signs) {
    for (std::size_t at = text.find(spelt); at != std::string::npos; at = text.find(spelt, at)) {
      text.replace(at, spelt.size(), set);
    }
  }
  return text;
}

}  // namespace tautline::bench
