#include "bench/measure/metrics.hpp"

namespace tautline::bench {

std::string_view to_string(Window window) {
  switch (window) {
    case Window::early:
      return "early";
    case Window::horizon:
      return "horizon";
    case Window::whole:
      return "whole";
  }
  return "unknown";
}

}  // namespace tautline::bench
