#pragma once

#include <ode/ode.h>

#include <vector>

#include "tautline/cable_row.hpp"
#include "tautline/case.hpp"
#include "tautline/engine.hpp"

namespace tautline::ode {

/// An ODE world with the body of a case in it, and one contact joint per cable that acts in the
/// next step.
class World {
 public:
  enum class Rotation { infinitesimal, finite };  // ODE's words; infinitesimal is its default

  World(const Case& the_case, Rotation rotation);
  World(const World&) = delete;
  World& operator=(const World&) = delete;
  ~World();

  [[nodiscard]] State state() const;

  [[nodiscard]] dWorldID id() const { return world_; }
  [[nodiscard]] dBodyID body() const { return body_; }

  /// Emptied after every step.
  [[nodiscard]] dJointGroupID contacts() const { return contacts_; }

  /// Puts the body there.
  void place(const State& state);

  /// Adds `change` to the body's velocity [m/s].
  void kick(const Vec2& change);

  /// Lets cable `index` act in the next step, as a contact without friction at the attachment,
  /// whose normal points to the anchor and whose depth is the overstretch.
  void pull(std::size_t index, const CableRow& row, const dSurfaceParameters& surface);

  /// One `dWorldStep` of `dt` [s], > 0; the contacts are gone afterwards.
  void advance(double dt);

  /// One solve of the contacts at this pose, without gravity and without moving.
  void solve_here();

  /// The impulse of each cable in the latest step or solve [N s], >= 0.
  [[nodiscard]] const std::vector<double>& impulses() const { return impulses_; }

 private:
  struct Pull {
    std::size_t cable;
    Vec2 towards;
  };

  void step_and_read_impulses(double dt);

  Vec2 gravity_;
  dWorldID world_;
  dBodyID body_;
  dJointGroupID contacts_;
  std::vector<Pull> pulls_;                // of the next step
  std::vector<dJointFeedback> feedbacks_;  // one per cable; ODE writes to them
  std::vector<double> impulses_;
  double angle_;  // [rad], not wrapped
};

/// The settings every model needs: those of `World`.
[[nodiscard]] std::vector<Setting> world_settings();

}  // namespace tautline::ode
