#pragma once

#include <vector>

#include "simbody.hpp"
#include "tautline/cable_row.hpp"
#include "tautline/engine.hpp"
#include "tautline/system_loads.hpp"

namespace tautline::simbody {

[[nodiscard]] inline SimTK::Vec3 vector(const Vec2& v) { return {v.x(), v.y(), 0.0}; }
[[nodiscard]] inline SimTK::Vec3 vector(const Eigen::Vector3d& v) { return {v.x(), v.y(), v.z()}; }

/// A point of a body or of the ground.
struct Station {
  SimTK::MobilizedBody body;
  SimTK::Vec3 at;  // [m], in its frame
};

/// A Simbody system with the body of a `Case` on a planar mobilizer, or the bodies of a
/// `SpatialSystem` on free ones, and no cables. Simbody keeps states apart from systems: `state_of`
/// goes from its states to ours.
template <class TheCase>
class Bodies {
 public:
  /// Throws std::invalid_argument where a cable is not straight, or changes over time.
  explicit Bodies(const TheCase& the_case);
  Bodies(const Bodies&) = delete;
  Bodies& operator=(const Bodies&) = delete;
  ~Bodies() = default;

  /// The state of the case's start, realized as far as velocities. To be called once all of the
  /// system's parts are there.
  [[nodiscard]] SimTK::State initial_state();

  [[nodiscard]] StateOf<TheCase> state_of(const SimTK::State& state) const;

  /// Lets these act in a system from now on, next to what is given.
  void set_pulls(const std::vector<BodyLoad>& loads) { pulls_ = loads; }

  [[nodiscard]] const TheCase& the_case() const { return case_; }
  [[nodiscard]] SimTK::MultibodySystem& system() { return system_; }
  [[nodiscard]] SimTK::SimbodyMatterSubsystem& matter() { return matter_; }

  /// The ends of a cable; the first is on a body.
  [[nodiscard]] Station from(std::size_t cable) const;
  [[nodiscard]] Station to(std::size_t cable) const;
  [[nodiscard]] double length(std::size_t cable) const;  // [m]

 private:
  TheCase case_;
  std::vector<BodyLoad> pulls_;  // empty: none
  SimTK::MultibodySystem system_;
  SimTK::SimbodyMatterSubsystem matter_{system_};
  SimTK::GeneralForceSubsystem forces_{system_};
  std::vector<SimTK::MobilizedBody> bodies_;
};

/// A speed [m/s] and an acceleration [m/s^2] of these bodies, to measure roundings by.
[[nodiscard]] double speed_of(const Case& the_case, const State& state);
[[nodiscard]] double speed_of(const SpatialSystem& system, const SpatialSystemState& state);
[[nodiscard]] double acceleration_of(const Case& the_case, const State& state);
[[nodiscard]] double acceleration_of(const SpatialSystem& system, const SpatialSystemState& state);

/// Settings of models that run systems.
[[nodiscard]] std::vector<Setting> system_settings();

}  // namespace tautline::simbody
