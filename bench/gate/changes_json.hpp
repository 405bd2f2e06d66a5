#pragma once

#include <string>

#include "bench/gate/changes.hpp"

namespace tautline::bench {

/// As bench/gate/changes.schema.json describes it, indented, with a line break at its end.
[[nodiscard]] std::string changes_json(const Changes& changes);

}  // namespace tautline::bench
