#pragma once

#include <functional>
#include <memory>
#include <optional>
#include <stdexcept>
#include <string>
#include <string_view>

#include "tautline/case.hpp"
#include "tautline/engine.hpp"

namespace tautline::bench {

/// The motion of a slack step: the parabola, or semi-implicit Euler in one of its two orders.
enum class Flight { parabola, velocity_first, position_first };
inline constexpr Flight flights[] = {Flight::parabola, Flight::velocity_first,
                                     Flight::position_first};

/// "the exact parabola", "semi-implicit Euler, velocity first", ...
[[nodiscard]] std::string_view to_string(Flight flight);

/// The state after a slack step of `dt` [s].
[[nodiscard]] State slack_step(State state, const Vec2& gravity, double dt, Flight flight);

/// The velocity before a step of `dt` [s] at the pose at which the step solves its constraints.
[[nodiscard]] State at_the_solve(State before, double dt, Flight flight);

/// One model of one engine, to be measured.
class Subject {
 public:
  /// The engine must outlive it. Throws what the engine throws when it is started.
  Subject(const Engine& engine, std::string model);

  /// A run of `the_case`. It throws std::runtime_error where the engine reports what makes no
  /// sense: too few impulses, an event of a cable that is not there.
  [[nodiscard]] std::unique_ptr<Simulation> start(const Case& the_case, double step) const;
  [[nodiscard]] bool in_double() const { return in_double_; }

  /// What the engine's numbers leave of a number near 1 after a few operations [-].
  [[nodiscard]] double rounding() const { return in_double_ ? 1e-15 : 1e-6; }

  /// How it seems to fly, from one long step of a fall, in which the three are 0.5 m apart.
  [[nodiscard]] Flight flight() const { return flight_; }

 private:
  const Engine* engine_;
  std::string model_;
  bool in_double_;
  Flight flight_;
};

/// A time at which a simulation was looked at, and its state there.
struct Moment {
  double time;   // [s]
  State before;  // the latest step
  State after;   // it
};

/// Steps `simulation` with `step` until `end` [s] or until it stops, and shows every step to
/// `look`, the one in which it stops included.
void run(Simulation& simulation, double step, double end,
         const std::function<void(const Moment&)>& look);

/// A run that says it cannot go on, where it must.
class RunStopped : public std::runtime_error {
 public:
  using std::runtime_error::runtime_error;
};

/// The same, to the end: throws RunStopped with the reason if the simulation stops before.
void run_whole(Simulation& simulation, double step, double end,
               const std::function<void(const Moment&)>& look);

/// What the first hit on cable 0 did. A contact may take several steps.
struct Hit {
  State before;    // at the pose of its first solve
  State after;     // at the pose of its last one, with the velocity it left
  double impulse;  // [N s], all of it
  int steps;       // that it took; 0 if the simulation located it
};
[[nodiscard]] std::optional<Hit> first_hit(const Subject& subject, const Case& the_case,
                                           double step, double end);

/// The larger of two measures; infinite where the second is not a number, which std::max loses.
[[nodiscard]] double worse(double a, double b);

/// The largest difference of one of the six numbers of two states, each in its own unit; infinite
/// where one is not a number.
[[nodiscard]] double largest_difference(const State& a, const State& b);

/// The case that ships under `name`; it must exist.
[[nodiscard]] Case shipped_case(std::string_view name);

/// The first breakwater of Table 5.1, with this restitution.
[[nodiscard]] Case standard_breakwater(double restitution);

/// `the_case` in a mirror on the y axis, with the cables in reverse order.
[[nodiscard]] Case mirrored(const Case& the_case);
[[nodiscard]] State mirrored(State state);

}  // namespace tautline::bench
