#pragma once

#include <vector>

#include "bench/report/motion/path.hpp"
#include "bench/report/motion/samples.hpp"

namespace tautline::bench {

/// How near a drawing is to what was recorded.
struct Nearness {
  double bound = 0.0;   // [m], centre and attachments may be off by it
  double reach = 0.0;   // [m], of the attachments from the centre
  double lever = 0.0;   // [m], >= reach: an angle may be off by bound / lever
  double energy = 0.0;  // [J], the energy may be off by it
};

/// More pieces than this are not drawn: where a run shakes by more than the bound at every step,
/// the bound is doubled until they suffice. `Path::error` says what came of it.
inline constexpr std::size_t most_pieces = 3000;

/// Draws the motion of `samples`, which are not empty, into `path`: few knots, and a cubic between
/// two that is as near to the samples as `nearness` asks.
void draw_motion(const std::vector<Sample>& samples, const Nearness& nearness, Path& path);

/// The same of its energy, with straight lines.
void draw_energy(const std::vector<Sample>& samples, const Nearness& nearness, Path& path);

}  // namespace tautline::bench
