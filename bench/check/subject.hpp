#pragma once

#include <memory>
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

}  // namespace tautline::bench
