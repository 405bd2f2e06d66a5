#pragma once

#include <string>

#include "tautline/cable_set.hpp"

namespace tautline::bench {

/// "0+1"
[[nodiscard]] std::string cable_list(CableSet cables);

/// "cable 0 is", "cables 0+1 are"
[[nodiscard]] std::string cables_are(CableSet cables);

}  // namespace tautline::bench
