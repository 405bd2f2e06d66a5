#pragma once

#include <cstddef>
#include <cstdint>
#include <vector>

#include "bench/tools/reproduce/study.hpp"

namespace tautline::bench {

/// How often something was true.
struct Share {
  std::size_t times;
  std::size_t of;
};

/// How far above its anchor Eq. 5.4 lets an attachment rise in case `solved` [S].
[[nodiscard]] double ceiling_excess(const ChapterCase& solved);

/// The standard case in metres and seconds.
struct TimeScale {
  double spacing;       // S [m]
  double gravity;       // g [m/s^2]
  double first_impact;  // [s]
  double ratio;         // of that to the nondimensional time of the first impact [s]
};
[[nodiscard]] TimeScale time_scale(const ChapterCase& standard);

/// The change of spin in the first impact of `standard` if its mass were 2: as it is, and as Eq.
/// 5.79 has it, which cancels the mass beside velocities but not inside the inertia.
struct SpinChange {
  double exact;
  double printed;
};
[[nodiscard]] SpinChange heavy_spin_change(const ChapterCase& standard);

/// A body let go at rest with both cables taut, turned by `angle`, that loses a cable.
struct Release {
  double angle;   // [rad]
  double slack;   // [sqrt(S/g)], when a tension falls to zero
  double impact;  // [sqrt(S/g)], when that cable is taut again
  double speed;   // [sqrt(gS)], of that impact
};
[[nodiscard]] Release release(const ChapterCase& solved, double angle);

/// Among bodies of r = 1.5 and e = 0.9 in Table 5.2: pairs of which the one with the larger inertia
/// also turns further.
[[nodiscard]] Share inertia_pairs_against(const ChapterStudy& study);

/// The standard start with a body shrunk to `size`: the speed of the centre after the first impact.
struct Shrunk {
  double size;   // a [S]
  double ring;   // [sqrt(gS)], inertia a^2, as Table 5.1 has it
  double fixed;  // [sqrt(gS)], inertia 1 at any size
};
[[nodiscard]] std::vector<Shrunk> shrunk_bodies();

/// The same speed for the point mass [sqrt(gS)].
[[nodiscard]] double point_rebound();

/// Lock time and swing energy of case `solved` under the sequential impact law, in doubles.
struct OtherLaw {
  double lock;
  double energy;
};
[[nodiscard]] OtherLaw sequential_law(const ChapterCase& solved);

/// The slowest impact on the right cable, at the origin, whose rebound rises past a tolerance of
/// 1e-6 in g [sqrt(gS)].
[[nodiscard]] double slowest_resolved(const ChapterCase& solved);

/// The angle at which the two boundaries meet at the origin, at angle 0 [rad].
[[nodiscard]] double corner_angle(const Breakwater& parameters);

/// The seed of every random draw below; the same states on every machine.
inline constexpr std::uint64_t chapter_seed = 20'260'101;

/// Random poses on g1 = 0 at which Eq. 5.66, as printed, has the sign of the boundary's slope
/// wrong.
[[nodiscard]] Share slope_signs_wrong();

/// Random impacts of one cable that leave the sign of the spin as it was.
[[nodiscard]] Share spins_kept();

}  // namespace tautline::bench
