#pragma once

#include <string>
#include <vector>

#include "bench/base/table.hpp"
#include "bench/gate/trend/version_trend.hpp"

namespace tautline::bench {

/// A table and what stands above it.
struct TitledTable {
  std::string title;
  Table table;
};

/// Which version changed which figure by how much: what got worse, then what got better, then
/// costs. What there is nothing of is left out.
[[nodiscard]] std::vector<TitledTable> change_tables(const Trend& trend);

/// How to read them.
inline constexpr const char* how_to_read_changes =
    "Since is the version that changed a figure beyond noise and tolerance; newest first, and of "
    "each what changed most. Before and after are those of the case that changed most, of so many "
    "runs.";

}  // namespace tautline::bench
