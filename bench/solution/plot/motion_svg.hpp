#pragma once

#include <string>

#include "tautline/case.hpp"
#include "tautline/solution.hpp"

namespace tautline::bench {

/// A picture of one motion over time as an SVG file of its own, legible on light and dark paper: a
/// panel each for x, y, the angle, the gaps and the tensions, with a line at each impact. Where
/// more happens within a pixel than it can show, it shows the least and the largest value there.
[[nodiscard]] std::string plot_motion_svg(const Case& the_case, const Solution& solution);

}  // namespace tautline::bench
