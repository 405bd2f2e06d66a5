#pragma once

#include <span>
#include <vector>

#include "tautline/clock.hpp"
#include "tautline/engine.hpp"

namespace tautline {

/// The impacts in the steps of an engine that splits a step into parts and solves impacts between
/// two of them, in no time: each is seen from outside, as the jump from the velocity with which a
/// part ended to that with which the next one begins. A cable that pulled in that part rested taut,
/// and its jump is none by itself.
template <class TheCase>  // Case or SpatialSystem
class ImpactsBetweenParts {
 public:
  using State = StateOf<TheCase>;     // of its bodies
  using Event = BasicEvent<TheCase>;  // an impact

  /// `rounding` is that of the engine's numbers [-].
  ImpactsBetweenParts(const TheCase& the_case, double rounding);

  /// Lengths and ends as the engine moves them, for the parts to come.
  void sees(const TheCase& the_case) { case_ = the_case; }

  /// To be called in this order, with the state at each: a step, its parts of `dt` [s], in which
  /// the cables `pulled` pulled, its end.
  void begin_step(const State& now);
  void begin_part(const State& now) { look(now); }  // as the engine begins a part of a step
  /// After a part of dt [s] at whose end these cables pulled.
  void end_part(double dt, const State& now, CableSet pulled);
  void end_step(double dt, const State& now);  // after the last part, with the step's dt [s]

  /// What `Simulation` tells of the latest step.
  [[nodiscard]] std::span<const Event> events() const { return events_; }
  [[nodiscard]] std::span<const double> impulses() const { return impulses_; }  // [N s], by cable

 private:
  /// Notes an impact if the velocity of `now` is not the one seen last.
  void look(const State& now);

  TheCase case_;
  double rounding_;
  Clock start_;         // of the step
  double parts_ = 0.0;  // [s], of the step, so far
  State last_;          // seen
  CableSet taut_;       // in the latest part
  std::vector<Event> events_;
  std::vector<double> impulses_;
};

}  // namespace tautline
