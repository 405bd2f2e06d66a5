#pragma once

#include <array>
#include <cstddef>
#include <string>

#include "bench/report/report.hpp"

namespace tautline::bench {

/// The end of a cable on the body at a sample of a path [m].
[[nodiscard]] Vec2 end_of(const CableRow& cable, const Path& path, std::size_t sample);

/// One still of `samples`: the body at it, the way it came from the first, and its cables, of which
/// `struck` stands out. All stills of a motion have one scale.
[[nodiscard]] std::string still_svg(const CaseRow& the_case, const Path& path,
                                    const std::array<std::size_t, 4>& samples, std::size_t still,
                                    std::size_t struck);

}  // namespace tautline::bench
