// What the tests measure, from the bodies alone: nothing is asked of the cables but their impulse.

#pragma once

#include "engines/cables/scene.hpp"

#include <array>
#include <ostream>
#include <string>
#include <vector>

namespace tautline::test {

constexpr double gravity = 9.81;  // [m/s^2]

/// A cable's line between the states of its ends. An end in the world has no body.
struct Line {
  double distance;                // [m]
  Vec3 towards;                   // from the first end to the second
  std::array<Vec3, 2> moments;    // arm x towards [m]
  std::array<double, 2> inverse;  // of each end's mass as the line feels it [1/kg]
};
[[nodiscard]] Line line_of(const CableData& cable, const std::vector<BodyState>& bodies);

/// The gap's rate [m/s] along `line` with the velocities of `bodies`.
[[nodiscard]] double gap_rate(const Line& line, const CableData& cable,
                              const std::vector<BodyState>& bodies);

[[nodiscard]] std::vector<BodyState> bodies_of(const Scene& scene, int count);

/// Energy of a body [J], with the velocity at its pose: that of the engine is half a step older. By
/// events there is no lag.
enum class Velocity { lags, is_current };
[[nodiscard]] double energy(const BodyState& body, Velocity velocity);

/// A load, or a pair, about to make its cable taut.
struct Arrangement {
  std::string name;
  Vec3 attachment;    // on the load [m]
  Vec3 towards;       // the cable's direction, of any length
  double other_mass;  // [kg] of a body at the cable's other end; 0: the world
};
[[nodiscard]] const std::vector<Arrangement>& arrangements();

/// How a failing test names it.
inline void PrintTo(const Arrangement& arrangement, std::ostream* out) { *out << arrangement.name; }

constexpr double load_mass = 2.0;     // [kg]
constexpr double load_moment = 0.05;  // [kg m^2], the same about any axis: it turns evenly
constexpr double cable_length = 2.0;  // [m]

/// A scene with one cable and its ends.
struct OneCable {
  std::unique_ptr<Scene> scene;
  CableData cable;
  int count;  // bodies at its ends
};

/// Closes at `speed` [m/s] after one step and is overstretched then.
[[nodiscard]] OneCable about_to_close(const Arrangement& arrangement, double restitution,
                                      double speed);

/// A step, as the cable `index` of `scene` took it.
struct Step {
  double gap;          // before [m]
  double rate_before;  // [m/s]
  double rate_after;   // on the line before
  double impulse;      // [N s]
};
[[nodiscard]] Step take_step(OneCable& setup, int index = 0);

}  // namespace tautline::test
