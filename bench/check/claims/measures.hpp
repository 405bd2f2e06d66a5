#pragma once

#include <string>
#include <vector>

#include "bench/check/measure.hpp"
#include "bench/check/subject.hpp"

namespace tautline::bench {

// What each claim measures.

// Whether states have the precision that the engine declares: at the start, and after every step.
[[nodiscard]] Measure measure_state_echo(const Subject& subject);
[[nodiscard]] Measure measure_precision(const Subject& subject);

// What an engine does with a body that no cable pulls.
[[nodiscard]] Measure measure_flight(const Subject& subject);

// Whether a body that nothing pulls keeps its speed and its spin, however fast or slow it is.
[[nodiscard]] Measure measure_fast_flight(const Subject& subject);
[[nodiscard]] Measure measure_slow_flight(const Subject& subject);

// Whether a hit moves and turns the body that was declared.
[[nodiscard]] Measure measure_mass(const Subject& subject);
[[nodiscard]] Measure measure_inertia(const Subject& subject);
[[nodiscard]] Measure measure_arm(const Subject& subject);
[[nodiscard]] Measure measure_angular_momentum(const Subject& subject);

// Hits of a body in space: about each of its axes, and in every orientation.
[[nodiscard]] Measure measure_space_inertia(const Subject& subject);
[[nodiscard]] Measure measure_space_arm(const Subject& subject);

// Whether the impulses that a model reports are those that changed the motion.
[[nodiscard]] Measure measure_step_momentum(const Subject& subject);

// How hits rebound.
[[nodiscard]] Measure measure_central_restitution(const Subject& subject);
[[nodiscard]] Measure measure_off_centre_restitution(const Subject& subject);
[[nodiscard]] Measure measure_slow_restitution(const Subject& subject);

// Systems in space: their initial state, a free body that turns, a cable between two bodies, and an
// anchor that moves.
[[nodiscard]] Measure measure_space_echo(const Subject& subject);
[[nodiscard]] Measure measure_gyroscopic_term(const Subject& subject);
[[nodiscard]] Measure measure_pair_momentum(const Subject& subject);
[[nodiscard]] Measure measure_pair_restitution(const Subject& subject);
[[nodiscard]] Measure measure_moving_anchor(const Subject& subject);

// What a run as a whole must keep: energy, and the length of its cables.
[[nodiscard]] Measure measure_energy(const Subject& subject);
[[nodiscard]] Measure measure_overstretch(const Subject& subject);
[[nodiscard]] Measure measure_taut_growth(const Subject& subject);
[[nodiscard]] Measure measure_taut_turning(const Subject& subject);

// Whether a model does the same again, and the same in a mirror.
[[nodiscard]] Measure measure_mirror_symmetry(const Subject& subject);
[[nodiscard]] Measure measure_determinism(const Subject& subject);

/// A digest of the run of `determinism`: any two runs of a deterministic model have the same, in
/// whatever process. Throws what the engine throws.
[[nodiscard]] std::string run_digest(const Engine& engine, const std::string& model);

// Whether smaller steps bring a model to the exact motion, and how near.
[[nodiscard]] Measure measure_convergence(const Subject& subject);

/// How far a model is from the exact motion of the standard breakwater with e = 0.9 in two seconds.
struct Convergence {
  std::vector<double> steps;       // [s]
  std::vector<double> deviations;  // [m], the largest distance of the centre of mass
  double slope = 0.0;              // of log(deviation) over log(step)
  bool exact = false;              // at every step: only rounding is left, and no slope
};
[[nodiscard]] Convergence convergence(const Subject& subject);

}  // namespace tautline::bench
