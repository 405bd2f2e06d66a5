#pragma once

#include <cstddef>
#include <exception>
#include <memory>
#include <string>
#include <vector>

#include "storage_in_cpp20.hpp"
#include "tautline/case.hpp"
#include "tautline/engine.hpp"
#include "tautline/system_loads.hpp"

class DynamicalSystem;
class LagrangianDS;
class NewtonEulerDS;
class NewtonImpactNSL;
class Relation;

namespace tautline::siconos_engine {

/// The interactions of cables, one for each, with Newton's impact law. Siconos ties a system to the
/// simulation it was first given to, so each simulation has its own.
class Interactions {
 public:
  /// The cables in Siconos' index set `level`: 1 the cables that act, or that touch when events are
  /// located; 2 those that are taut.
  [[nodiscard]] CableSet index_set(unsigned int level) const;

  /// The multiplier of a cable: an impulse [N s] at level 1, a tension [N] at level 2.
  [[nodiscard]] double multiplier(std::size_t cable, unsigned int level) const;

  [[nodiscard]] SP::NonSmoothDynamicalSystem dynamics() const { return dynamics_; }

 protected:
  Interactions();

  /// Adds the next cable, between one body and itself, or two.
  void add(double restitution, std::shared_ptr<Relation> relation,
           const std::vector<std::shared_ptr<DynamicalSystem>>& on);

  /// Gives every cable the restitution that it has at its gap rate of now; none to those slower
  /// than `capture_speed` [m/s].
  template <class TheCase>
  void set_restitutions(const TheCase& the_case, const StateOf<TheCase>& now, double capture_speed);

  SP::NonSmoothDynamicalSystem dynamics_;

 private:
  std::vector<std::shared_ptr<NewtonImpactNSL>> laws_;
  std::vector<SP::Interaction> interactions_;
};

/// A case as Siconos sees it: a Lagrangian system with constant mass and force, and a
/// `CableRelation` per cable.
class System : public Interactions {
 public:
  /// The body starts in `start` at time 0.
  System(const Case& the_case, const State& start);

  [[nodiscard]] State state() const;
  void set_restitutions(double capture_speed = 0.0) {
    Interactions::set_restitutions(*case_, state(), capture_speed);
  }

 private:
  const Case* case_;  // the simulation's, which outlives this
  std::shared_ptr<LagrangianDS> body_;
};

/// A system in space: a Newton and Euler system for each body, and a `SystemCableRelation` per
/// cable. Throws std::invalid_argument where a cable joins more than two bodies, or where its ends
/// or its length move.
class SystemInSpace : public Interactions {
 public:
  SystemInSpace(const SpatialSystem& system, const SpatialSystemState& start);

  [[nodiscard]] SpatialSystemState state() const;

  /// Lets these act from now on, next to what is given.
  void set_pulls(const std::vector<BodyLoad>& loads) { pulls_ = loads; }

  void set_restitutions(double capture_speed = 0.0) {
    Interactions::set_restitutions(*system_, state(), capture_speed);
  }

 private:
  const SpatialSystem* system_;  // the simulation's, which outlives this
  std::vector<std::shared_ptr<NewtonEulerDS>> bodies_;
  std::vector<BodyLoad> pulls_;  // empty: none
  double start_;                 // [s], of the run, where Siconos has 0
};

/// What an exception of Siconos says, in one line.
[[nodiscard]] std::string reason(const std::exception& error);

/// Settings of models that run systems.
[[nodiscard]] std::vector<Setting> system_settings();

}  // namespace tautline::siconos_engine
