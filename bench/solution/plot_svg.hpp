#pragma once

#include <string>

#include "tautline/case.hpp"
#include "tautline/solution.hpp"

namespace tautline::bench {

/// A picture of one motion as an SVG file of its own, legible on light and dark paper: the path of
/// the centre of mass, the body and its cables at the start and the end, the body at its fastest
/// impacts, a mark at each impact, axes and a scale bar in [m].
[[nodiscard]] std::string plot_svg(const Case& the_case, const Solution& solution);

}  // namespace tautline::bench
