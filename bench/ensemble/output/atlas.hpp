#pragma once

#include <array>
#include <cstddef>
#include <optional>
#include <string>
#include <vector>

#include "bench/ensemble/output/words.hpp"

namespace tautline::bench {

/// What the exact motion does over the first two grids of an ensemble, by one statistic.
struct AtlasMap {
  std::size_t statistic;  // of `statistics_of`
  /// Of each cell, the first axis fastest: the mean over its draws, or what most of them have where
  /// the numbers encode names; none: no draw there has the number.
  std::vector<std::optional<double>> cells;
  std::vector<std::string> names;  // of the numbers 0, 1, ...; empty: they are amounts
};

/// The maps, and what they have in common.
struct Atlas {
  std::array<Varied, 2> axes;  // across, and up
  std::vector<AtlasMap> maps;
  std::vector<std::size_t> draws;  // of each cell the first
  std::vector<bool> pictured;      // of each cell: it has a picture of that draw's motion
};

/// None without two grids.
[[nodiscard]] std::optional<Atlas> atlas_of(const EnsembleReport& report);

/// The most cells that have pictures.
inline constexpr std::size_t most_pictures = 625;

/// Where the picture of the motion of a cell lies, from the page.
[[nodiscard]] std::string picture_name(std::size_t cell);

/// A heat map, one of `atlas`, of this statistic; a cell leads to the picture of its motion. Its
/// colours go from the least to the largest number but for one in a hundred at each end, and by
/// their logarithm if amounts span more than a decade; shares never do.
[[nodiscard]] std::string atlas_svg(const Atlas& atlas, const AtlasMap& map,
                                    const Statistic& statistic);

/// Its numbers: a line for each cell.
[[nodiscard]] std::string atlas_csv(const Atlas& atlas, const AtlasMap& map,
                                    const Statistic& statistic);

}  // namespace tautline::bench
