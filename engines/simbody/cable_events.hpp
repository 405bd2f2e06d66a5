#pragma once

#include <optional>
#include <string>
#include <vector>

#include "bodies.hpp"
#include "rods.hpp"
#include "tautline/cable_set.hpp"
#include "tautline/solution.hpp"

namespace tautline::simbody {

/// The cables of bodies as events of an integration: what to watch, and what to do with the
/// integrator's state when a length or a tension passes zero.
template <class TheCase>
class CableEvents {
 public:
  using Event = BasicEvent<TheCase>;

  explicit CableEvents(Bodies<TheCase>& bodies);

  // What to watch, never zero. `state` is realized to positions, velocities, accelerations.

  /// By how much a cable is longer than its length [m]; negative for one that is taut, or that an
  /// event left at its length and that has not turned back since.
  [[nodiscard]] double overstretch(const SimTK::State& state, std::size_t cable) const;

  /// The gap rate of a cable that has not turned back [m/s], and a little; positive for the others.
  [[nodiscard]] double opening(const SimTK::State& state, std::size_t cable) const;

  /// Of a taut cable [N]; positive for a slack one.
  [[nodiscard]] double tension(const SimTK::State& state, std::size_t cable) const;

  /// Strikes the cables that are at their length and closing, and finds out which of them are taut
  /// from now on.
  void react(SimTK::State& state);

  /// Sees to it that no cable is overstretched beyond rounding.
  void check(const SimTK::State& state);

  /// Why the integration cannot go on.
  [[nodiscard]] const std::optional<std::string>& trouble() const { return trouble_; }

  /// Forgets the impacts of the latest step.
  void start_step();

  /// Since `start_step`.
  [[nodiscard]] const std::vector<Event>& events() const { return events_; }
  [[nodiscard]] const std::vector<double>& impulses() const { return impulses_; }

 private:
  [[nodiscard]] const auto& cable(std::size_t index) const {
    return bodies_.the_case().cables[index];
  }
  [[nodiscard]] double rate(const SimTK::State& state, std::size_t cable) const;
  [[nodiscard]] CableSet touching(const SimTK::State& state) const;
  void strike_closing(SimTK::State& state, CableSet cables);

  Bodies<TheCase>& bodies_;
  Rods<TheCase> rods_;
  CableSet leaving_;  // left at their length, and not turned back yet
  std::vector<Event> events_;
  std::vector<double> impulses_;
  std::size_t reactions_ = 0;
  std::optional<std::string> trouble_;
};

}  // namespace tautline::simbody
