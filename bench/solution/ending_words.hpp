#pragma once

#include <cstddef>
#include <string>

#include "tautline/solution.hpp"

namespace tautline::bench {

/// The meaning of an ending that is none of a case's own limits, in a sentence: `instant` is "t
/// = 1.5", of its rest or its end, `duration` that of the run.
[[nodiscard]] std::string ending_sentence(Ending ending, std::size_t bodies,
                                          const std::string& instant, const std::string& duration,
                                          std::size_t events);

}  // namespace tautline::bench
