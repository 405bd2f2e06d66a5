#pragma once

#include "simbody.hpp"
#include "tautline/case.hpp"

namespace tautline::simbody {

[[nodiscard]] inline SimTK::Vec3 vector(const Vec2& v) { return {v.x(), v.y(), 0.0}; }

/// A Simbody system with the body of a case on a planar mobilizer, and no cables. Simbody keeps
/// states apart from systems: `state_of` and `place` go between its states and ours.
class PlanarBody {
 public:
  explicit PlanarBody(const Case& the_case);
  PlanarBody(const PlanarBody&) = delete;
  PlanarBody& operator=(const PlanarBody&) = delete;
  ~PlanarBody() = default;

  /// The state of the case's start, realized as far as velocities. To be called once all of the
  /// system's parts are there.
  [[nodiscard]] SimTK::State initial_state();

  [[nodiscard]] State state_of(const SimTK::State& state) const;

  [[nodiscard]] const Case& the_case() const { return case_; }
  [[nodiscard]] SimTK::MultibodySystem& system() { return system_; }
  [[nodiscard]] SimTK::SimbodyMatterSubsystem& matter() { return matter_; }
  [[nodiscard]] SimTK::MobilizedBody& mobilized() { return body_; }
  [[nodiscard]] SimTK::MobilizedBody& ground() { return matter_.updGround(); }

 private:
  const Case case_;
  SimTK::MultibodySystem system_;
  SimTK::SimbodyMatterSubsystem matter_{system_};
  SimTK::GeneralForceSubsystem forces_{system_};
  SimTK::MobilizedBody::Planar body_;
};

}  // namespace tautline::simbody
