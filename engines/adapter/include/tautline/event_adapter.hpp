#pragma once

#include <algorithm>

#include "tautline/case.hpp"
#include "tautline/impact.hpp"
#include "tautline/system.hpp"

namespace tautline {

/// What the event driver needs of an engine: the body of a `Case` or the bodies of a
/// `SpatialSystem`, no cables of the engine's own.
template <class TheCase>
class BasicEventAdapter {
 public:
  BasicEventAdapter() = default;
  BasicEventAdapter(const BasicEventAdapter&) = delete;
  BasicEventAdapter& operator=(const BasicEventAdapter&) = delete;
  virtual ~BasicEventAdapter() = default;

  /// In SI units; in the plane the angle is not wrapped, of a system the time counts on.
  [[nodiscard]] virtual StateOf<TheCase> state() const = 0;

  /// Puts the bodies there.
  virtual void place(const StateOf<TheCase>& state) = 0;

  /// The engine's own step of `dt` [s] with no cable, kicked by half of gravity's impulse before
  /// and after where the engine's scheme needs it, so that it flies the exact parabola. What is
  /// given over time acts as it is in the middle of the step.
  virtual void fly(double dt) = 0;

  /// One solve by the engine's own solver, at the pose it has and without moving: the gap of each
  /// of `cables` opens with at least its rate of `rates` [m/s], and no cable is pushed (Eq. 14).
  /// Returns the impulses [N s]. Both have one entry per cable of `cables`, in rising index order.
  [[nodiscard]] virtual CableVector solve(CableSet cables, const CableVector& rates) = 0;

  /// What the engine's numbers and its solver leave.
  struct Rounding {
    double gap;   // [-], of a gap against `gap_scale`
    double rate;  // [-], of a gap rate against the speed of the body
  };

  /// An engine in double keeps its pose as a matrix or a quaternion and iterates for its impulses:
  /// about a hundred times the rounding of the closed form.
  [[nodiscard]] virtual Rounding rounding() const { return {1e-14, 1e-12}; }

  /// What an engine in float leaves, near cables a few metres long: two and some twenty roundings.
  static constexpr Rounding float_rounding = {3e-7, 3e-6};
};
using EventAdapter = BasicEventAdapter<Case>;                 // in the plane
using SystemEventAdapter = BasicEventAdapter<SpatialSystem>;  // in space

/// The length that a gap is rounded against [m]: the cable's length, and far from the origin the
/// body's distance from it, as the coordinates of a pose have no more digits there.
[[nodiscard]] inline double gap_scale(const Cable& cable, const State& state) {
  return std::max(cable.length, state.position.norm());
}
/// In a system the body that is farthest counts.
[[nodiscard]] inline double gap_scale(const SpatialCable& cable, const SpatialSystemState& state) {
  double result = cable.length.at(state.time)[0];
  for (const SpatialState& body : state.bodies) {
    result = std::max(result, body.position.norm());
  }
  return result;
}

}  // namespace tautline
