#pragma once

#include <optional>
#include <string>
#include <vector>

#include "planar_body.hpp"
#include "tautline/cable_set.hpp"
#include "tautline/solution.hpp"

namespace tautline::simbody {

/// The cables of a body as events of an integration. A slack cable is nothing but a length to
/// watch; a taut one is a rod that is switched on. What happens when a length or a tension passes
/// zero is done to the integrator's state: impacts by Newton's law, with Simbody's Jacobians and
/// masses, and then the choice of the cables that stay taut.
class CableEvents {
 public:
  /// Adds the rods to the body's system, all of them switched off.
  explicit CableEvents(PlanarBody& body);

  /// By how much a cable is longer than when an event last left it [m]; negative for a taut cable,
  /// whose rod keeps its length, and never zero.
  [[nodiscard]] double overstretch(const SimTK::State& state, std::size_t cable) const;

  /// [N]; positive for a slack cable, and never zero. `state` is realized to accelerations.
  [[nodiscard]] double tension(const SimTK::State& state, std::size_t cable) const;

  /// Strikes the cables that are at their length and closing, and finds out which of them are taut
  /// from now on.
  void react(SimTK::State& state);

  /// Forgets the impacts of the latest step.
  void start_step();

  /// Since `start_step`.
  [[nodiscard]] const std::vector<Event>& events() const { return events_; }
  [[nodiscard]] const std::vector<double>& impulses() const { return impulses_; }

  /// Why the integration cannot go on.
  [[nodiscard]] const std::optional<std::string>& trouble() const { return trouble_; }

  /// Sees to it that no cable is overstretched beyond rounding.
  void check(const SimTK::State& state);

 private:
  [[nodiscard]] CableSet touching(const SimTK::State& state) const;
  [[nodiscard]] bool is_taut(const SimTK::State& state, std::size_t cable) const;
  void strike(SimTK::State& state, CableSet cables);
  void solve(SimTK::State& state, CableSet cables, const CableVector& rates, CableVector& impulses);
  void hold(SimTK::State& state, CableSet resting);
  [[nodiscard]] double gap_acceleration(const SimTK::State& state, std::size_t cable) const;

  PlanarBody& body_;
  std::vector<SimTK::Constraint::Rod> rods_;
  std::vector<double> levels_;  // [m], overstretch that is none
  std::vector<Event> events_;
  std::vector<double> impulses_;
  std::size_t reactions_ = 0;
  std::optional<std::string> trouble_;
};

}  // namespace tautline::simbody
