#pragma once

#include <string>

#include "bench/gate/changes.hpp"

namespace tautline::bench {

/// What changed, for a terminal: what is broken first.
[[nodiscard]] std::string changes_text(const Changes& changes);

}  // namespace tautline::bench
