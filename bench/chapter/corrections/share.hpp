#pragma once

#include <cstddef>

namespace tautline::bench {

/// How often something was true.
struct Share {
  std::size_t times;
  std::size_t of;
};

}  // namespace tautline::bench
