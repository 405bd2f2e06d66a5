// Energy of a world's loads against the work that its hooks do on them.

#pragma once

#include <vector>

#include "engines/cables/worlds/world.hpp"

namespace tautline::test {

/// How the world is stepped.
enum class Stepping { fixed, by_events };

/// The bodies of a scene between two steps, and the cables' impulses of the step that led there.
struct Moment {
  std::vector<BodyState> bodies;
  std::vector<double> impulses;  // [N s]
};

/// The energy of loads at a pose, from the velocities before and after the step that begins there.
///
/// Fixed steps are semi-implicit Euler, v' = v + h a and x' = x + h v': the velocity at the pose x
/// is the mean of v and v'. With it, free flight keeps its energy to rounding, and a cable's
/// impulse P adds P (rate before + rate after) / 2, as any impulse does. By events v is at the pose
/// in flight, and half a step older while a cable is taut; which of the two holds is not to be seen
/// from outside, and each load is counted with the lower energy. In flight that is the true one
/// while the load falls, so that a gain does not hide for longer than a flight. `downwards` is
/// gravity [m/s^2].
struct Energy {
  double kinetic;    // [J]
  double potential;  // [J]
};
[[nodiscard]] Energy energy_between(const std::vector<BodyState>& at,
                                    const std::vector<BodyState>& next, int loads,
                                    Stepping stepping, double downwards);

/// The energy with which a world begins: in fixed steps, the velocities given are those of half a
/// step before the first pose.
[[nodiscard]] Energy energy_at_start(const std::vector<BodyState>& bodies, int loads,
                                     Stepping stepping, double dt, double downwards);

/// What goes in and what is there, step by step.
class Ledger {
 public:
  Ledger(const World& world, Stepping stepping, double dt);

  /// A step from `before` to `after`. The energy is that of `before`.
  void add(const Moment& before, const Moment& after);

  /// By how much the energy is above that of the start and the hooks' work, rounding aside [J].
  [[nodiscard]] double gain() const { return gain_; }
  /// Highest kinetic energy and the range of the potential energy so far [J]: what is exchanged in
  /// this world. (The range of their sum would be nothing in a world that keeps it.)
  [[nodiscard]] double range() const { return highest_kinetic_ + highest_ - lowest_; }

 private:
  void start(const Moment& before, const Moment& after);
  void add_work(const Moment& before, const Moment& after);

  World world_;
  Stepping stepping_;
  double dt_;           // [s]
  double start_ = 0.0;  // [J]
  // Of the hooks [J]. Half of a step's impulse acts before its pose and half after it. A taut cable
  // takes its load from the hook's velocity before to that in the step; an impact is solved with
  // the hook's velocity in the step. Both pull on the line that there is when the step begins.
  double work_ = 0.0;
  double work_to_come_ = 0.0;
  double gain_ = 0.0;
  double highest_kinetic_ = 0.0;
  double highest_ = 0.0;
  double lowest_ = 0.0;
  std::vector<BodyState> previous_;  // of the step before; empty: none yet
};

}  // namespace tautline::test
