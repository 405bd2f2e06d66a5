#include "bench/measure/metrics.hpp"

namespace tautline::bench {

std::string_view to_string(Window window) {
  constexpr std::array names = {"early", "horizon", "whole"};
  return names.at(static_cast<std::size_t>(window));
}

}  // namespace tautline::bench
