#pragma once

#include <array>
#include <cstddef>
#include <optional>
#include <string>
#include <vector>

#include "bench/ensemble/output/words.hpp"

namespace tautline::bench {

/// What the exact motion does over the first two grids of an ensemble: the mean over the draws of
/// each cell, of each statistic that is shown.
struct Atlas {
  std::array<Varied, 2> axes;           // across, and up
  std::vector<std::size_t> statistics;  // of `statistics_of`
  /// By statistic, then by cell, the first axis fastest; none: no draw there has the number.
  std::vector<std::vector<std::optional<double>>> means;
  std::vector<std::size_t> draws;  // of each cell the first
  std::vector<bool> pictured;      // of each cell: it has a picture of that draw's motion
};

/// None without two grids.
[[nodiscard]] std::optional<Atlas> atlas_of(const EnsembleReport& report);

/// Of more cells than this none has a picture.
inline constexpr std::size_t most_pictures = 625;

/// Where the picture of the motion of a cell lies, from the page.
[[nodiscard]] std::string picture_name(std::size_t cell);

/// A heat map of one of the statistics; a cell leads to the picture of its motion.
[[nodiscard]] std::string atlas_svg(const Atlas& atlas, std::size_t index,
                                    const Statistic& statistic);

}  // namespace tautline::bench
