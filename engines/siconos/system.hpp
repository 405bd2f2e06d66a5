#pragma once

#include <cstddef>
#include <exception>
#include <memory>
#include <string>
#include <vector>

#include "storage_in_cpp20.hpp"
#include "tautline/case.hpp"
#include "tautline/engine.hpp"

class LagrangianDS;
class NewtonImpactNSL;

namespace tautline::siconos_engine {

/// A case as Siconos sees it: a Lagrangian system with constant mass and force, and one interaction
/// per cable, of a `CableRelation` and Newton's impact law. Siconos ties a system to the simulation
/// it was first given to, so each simulation has its own.
class System {
 public:
  /// The body starts in `start` at time 0.
  System(const Case& the_case, const State& start);

  [[nodiscard]] State state() const;

  /// Gives every cable the restitution that it has at its gap rate of now; none to those slower
  /// than `capture_speed` [m/s].
  void set_restitutions(double capture_speed = 0.0);

  /// The cables in Siconos' index set `level`: 1 the cables that act, or that touch when events are
  /// located; 2 those that are taut.
  [[nodiscard]] CableSet index_set(unsigned int level) const;

  /// The multiplier of a cable: an impulse [N s] at level 1, a tension [N] at level 2.
  [[nodiscard]] double multiplier(std::size_t cable, unsigned int level) const;

  [[nodiscard]] SP::NonSmoothDynamicalSystem dynamics() const { return dynamics_; }

 private:
  const Case* case_;  // the simulation's, which outlives this
  std::shared_ptr<LagrangianDS> body_;
  SP::NonSmoothDynamicalSystem dynamics_;
  std::vector<std::shared_ptr<NewtonImpactNSL>> laws_;
  std::vector<SP::Interaction> interactions_;
};

/// What an exception of Siconos says, in one line.
[[nodiscard]] std::string reason(const std::exception& error);

}  // namespace tautline::siconos_engine
