#pragma once

#include <Eigen/Core>
#include <memory>
#include <optional>
#include <type_traits>

#include "tautline/case.hpp"
#include "tautline/impact.hpp"
#include "tautline/solution.hpp"
#include "tautline/system.hpp"

namespace tautline::bench {

// The exact motion of a case or of a system, restarted from a state of a run.

/// The freedoms of all bodies: x, y [m] and the angle [rad], or in space the position and the turn
/// about the body's axes; then their rates.
template <class TheCase>
using StateDifference =
    std::conditional_t<std::is_same_v<TheCase, Case>, Eigen::Matrix<double, 6, 1>, Eigen::VectorXd>;

/// Leads from `b` to `a`.
[[nodiscard]] StateDifference<Case> difference(const State& a, const State& b);
[[nodiscard]] StateDifference<SpatialSystem> difference(const SpatialSystemState& a,
                                                        const SpatialSystemState& b);

/// `state` after a free flight of `time` [s], as if there were no cables. A flight of a system does
/// not go back in time.
[[nodiscard]] State flown(const Case& the_case, const State& state, double time);
[[nodiscard]] SpatialSystemState flown(const SpatialSystem& system, const SpatialSystemState& state,
                                       double time);

/// `the_case` from `state` at `time` [s] on, for `duration` [s], without the limits of its
/// validity: a neighbour may reach them sooner.
[[nodiscard]] Case restarted(const Case& the_case, const State& state, double time,
                             double duration);
/// All that is given over time begins then, too. A cable that is cut already keeps its number, and
/// acts no more.
[[nodiscard]] SpatialSystem restarted(const SpatialSystem& system, const SpatialSystemState& state,
                                      double time, double duration);

/// A state carried to one instant T by the exact motion.
template <class TheCase>
class Carried {
 public:
  /// A state at T.
  explicit Carried(const StateOf<TheCase>& state) : end_(state) {}

  /// The motion of `restarted`, which lasts to T. None if it has problems, or ends before.
  [[nodiscard]] static std::optional<Carried> by(TheCase restarted, ImpactLaw law);

  /// The place and the motion at T.
  [[nodiscard]] const StateOf<TheCase>& end() const { return end_; }

  /// The motion restarted. Only of a state before T.
  [[nodiscard]] const BasicSolution<TheCase>& solution() const { return *solution_; }

  /// Where a neighbour at `difference` from the state is at T, from `end`, to first order: by a
  /// motion from a near neighbour, as a whole derivative costs eight motions; in the plane by the
  /// derivative where neither side can start. Infinite where no derivative exists.
  [[nodiscard]] StateDifference<TheCase> to_first_order(
      const StateDifference<TheCase>& difference) const;

  /// The state had been flown freely for `wait` [s]: differences count from before that.
  void was_flown(double wait) { wait_ = wait; }

 private:
  StateOf<TheCase> end_;
  TheCase case_;
  ImpactLaw law_ = ImpactLaw::simultaneous;
  double wait_ = 0.0;                                       // [s]
  std::shared_ptr<const BasicSolution<TheCase>> solution_;  // none at T
};

/// Carries the exact motion of one case to one instant.
template <class TheCase>
class Carrier {
 public:
  /// `the_case` outlives this; T is `until` [s].
  Carrier(const TheCase& the_case, ImpactLaw law, double until)
      : case_(the_case), law_(law), until_(until) {}

  /// From `state` at `time` [s], before T; none where the exact motion cannot start or ends early.
  [[nodiscard]] std::optional<Carried<TheCase>> carry(const StateOf<TheCase>& state,
                                                      double time) const;

  /// The same from a state that may be overstretched, with its impact behind it: it flies out of
  /// that within `patience` [s], and is put onto the cables if it does not.
  [[nodiscard]] std::optional<Carried<TheCase>> carry_out(const StateOf<TheCase>& state,
                                                          double time, double patience) const;

 private:
  const TheCase& case_;
  ImpactLaw law_;
  double until_;
};

}  // namespace tautline::bench
