#pragma once

#include <Eigen/Core>
#include <memory>
#include <optional>

#include "tautline/case.hpp"
#include "tautline/detail/sensitivity.hpp"
#include "tautline/impact.hpp"
#include "tautline/solution.hpp"

namespace tautline::bench {

/// x, y [m], angle [rad], their rates.
using StateDifference = Eigen::Matrix<double, 6, 1>;

/// A state carried to one instant T by the exact motion.
class Carried {
 public:
  /// A state at T.
  explicit Carried(const State& state) : position_(state.position) {}

  /// The motion of `restarted`, which lasts to T. None if it has problems, or ends before.
  [[nodiscard]] static std::optional<Carried> by(Case restarted, ImpactLaw law);

  [[nodiscard]] const Vec2& position() const { return position_; }  // [m], at T

  /// The motion restarted. Only of a state before T.
  [[nodiscard]] const Solution& solution() const { return *solution_; }

  /// Where a neighbour at `difference` from the state is at T, from `position`, to first order [m]:
  /// by a motion from a near neighbour, as a whole derivative costs eight motions; by the
  /// derivative where neither side can start. Infinite where no derivative exists.
  [[nodiscard]] Vec2 to_first_order(const StateDifference& difference) const;

  /// The state had been flown freely for `wait` [s]: differences count from before that.
  void was_flown(double wait) { flight_.topRightCorner<3, 3>().diagonal().setConstant(wait); }

 private:
  Vec2 position_;
  Case case_;
  ImpactLaw law_ = ImpactLaw::simultaneous;
  StateMatrix flight_ = StateMatrix::Identity();
  std::shared_ptr<const Solution> solution_;  // none at T
};

/// The cables that are longer than they can be at `state`.
[[nodiscard]] CableSet overstretched(const Case& the_case, const State& state);

/// Carries the exact motion of one case to one instant.
class Carrier {
 public:
  /// `the_case` outlives this; T is `until` [s].
  Carrier(const Case& the_case, ImpactLaw law, double until)
      : case_(the_case), law_(law), until_(until) {}

  /// From `state` at `time` [s], before T; none where the exact motion cannot start or ends early.
  /// The limits of the case's validity are dropped: a neighbour may reach them sooner.
  [[nodiscard]] std::optional<Carried> carry(const State& state, double time) const;

  /// The same from a state that may be overstretched, with its impact behind it: it flies out of
  /// that within `patience` [s], and is put onto the cables if it does not.
  [[nodiscard]] std::optional<Carried> carry_out(const State& state, double time,
                                                 double patience) const;

 private:
  const Case& case_;
  ImpactLaw law_;
  double until_;
};

}  // namespace tautline::bench
