#pragma once

#include <vector>

#include "bodies.hpp"
#include "tautline/cable_set.hpp"

namespace tautline::simbody {

/// The cables of bodies as Constraint::Rod: on while a cable is taut, off while it is slack.
template <class TheCase>
class Rods {
 public:
  /// Adds the rods to the system of the bodies, all of them off.
  explicit Rods(Bodies<TheCase>& bodies);

  [[nodiscard]] std::size_t size() const { return rods_.size(); }
  [[nodiscard]] bool is_on(const SimTK::State& state, std::size_t cable) const;

  /// By how much the cable is longer than its length [m]. `state` is realized to positions.
  [[nodiscard]] double overstretch(const SimTK::State& state, std::size_t cable) const;

  /// Of a rod that is on [N]. `state` is realized to accelerations.
  [[nodiscard]] double tension(const SimTK::State& state, std::size_t cable) const;

  /// Brings the cables of `resting` to rest, and leaves those rods on that pull; no other. `state`
  /// is then realized to accelerations. False if a cable without a rod would be overstretched.
  [[nodiscard]] bool hold(SimTK::State& state, CableSet resting);

 private:
  [[nodiscard]] double gap_acceleration(const SimTK::State& state, std::size_t cable) const;

  Bodies<TheCase>& bodies_;
  std::vector<SimTK::Constraint::Rod> rods_;
};

}  // namespace tautline::simbody
