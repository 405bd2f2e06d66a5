#pragma once

#include <cstddef>
#include <vector>

#include "bench/measure/reference.hpp"
#include "bench/replay/curve.hpp"
#include "bench/replay/path.hpp"
#include "bench/replay/replay.hpp"
#include "bench/run/record.hpp"
#include "bench/run/trajectory.hpp"
#include "tautline/case.hpp"
#include "tautline/solution.hpp"
#include "tautline/system.hpp"

namespace tautline::bench {

// What a page needs to draw a motion again, as near to it as a page can show. A whole trajectory
// has a hundred thousand samples; a report of thousands of runs cannot hold them.

/// A motion is drawn as near as this part of what the case covers [-]: a quarter of a pixel of a
/// picture that is a thousand wide.
inline constexpr double drawn_part = 2.5e-4;

/// And as near as this part of what gap, angle and energy of the exact motion cover [-]: a third of
/// the width of a line in a panel that is 120 pixels high.
inline constexpr double plotted_part = 3e-3;

/// What the anchors and the exact motion cover, the widest of width, height and depth [m].
template <class TheReference>
[[nodiscard]] double drawn_extent(const TheReference& reference);

/// How near the motions of a case are drawn.
template <class TheReference>
[[nodiscard]] Nearness nearness_of(const TheReference& reference);

/// `run` as it is drawn; without columns where nothing of it is finite.
template <class TheCase>
[[nodiscard]] Path run_path(const TheCase& the_case, const Nearness& nearness,
                            const BasicTrajectory<TheCase>& run);

/// The impacts that the report has: those that close faster than `count_speed` [m/s], the fastest
/// `most_impacts` of them. In space an impact has no arm and no errors.
template <class TheCase>
[[nodiscard]] ImpactColumns run_impacts(const TheCase& the_case,
                                        const BasicTrajectory<TheCase>& run, double count_speed);

/// The exact motion as it is drawn, and its events; of very many the fastest impacts, and all that
/// are none.
template <class TheReference>
[[nodiscard]] CaseReplay exact_replay(const TheReference& reference);

/// A run's cable is at its length where its recorded gap is below this part of the length [-]: held
/// cables are within 1e-5 of it in all engines but the softest, and a free one passes this in a
/// step.
inline constexpr double taut_part = 1e-4;

/// A run's cable is taut where it is at its length for so long [s], a frame of a screen. A shorter
/// touch is an impact.
inline constexpr double shortest_hold = 1.0 / 60.0;

/// A tension is drawn as near as this part of the largest of the exact motion [-]: the colours of
/// cables show no smaller change.
inline constexpr double coloured_part = 1e-2;

/// And by no more pieces than this: colours need few.
inline constexpr std::size_t most_tension_pieces = 300;

/// The radius of a solid box with these principal moments about its centre [m], which a page draws
/// a body as; of a point mass 0.
[[nodiscard]] double box_radius(const SpatialBody& body);

}  // namespace tautline::bench
