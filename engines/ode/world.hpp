#pragma once

#include <ode/ode.h>

#include <cstddef>
#include <vector>

#include "tautline/cable_row.hpp"
#include "tautline/case.hpp"
#include "tautline/engine.hpp"
#include "tautline/system_loads.hpp"

namespace tautline::ode {

enum class Rotation { infinitesimal, finite };  // ODE's words; infinitesimal is its default

/// A contact without friction that a cable acts as in the next step.
struct CableContact {
  std::size_t cable;
  Eigen::Vector3d point;    // [m], where it pulls at its first body
  Eigen::Vector3d towards;  // [-], in which direction
  double gap;               // [m]; the depth of the contact is the overstretch
  dBodyID other = nullptr;  // that it pulls at in the other direction; null: none
};

/// An ODE world with bodies to be added, and one contact joint per cable that acts in the next
/// step.
class BareWorld {
 public:
  enum class Turning { in_the_plane, in_space };

  BareWorld(std::size_t cables, Rotation rotation, Turning turning = Turning::in_the_plane);
  BareWorld(const BareWorld&) = delete;
  BareWorld& operator=(const BareWorld&) = delete;
  ~BareWorld();

  [[nodiscard]] dWorldID id() const { return world_; }

  /// Emptied after every step.
  [[nodiscard]] dJointGroupID contacts() const { return contacts_; }

  /// The impulse of each cable in the latest step or solve [N s], >= 0.
  [[nodiscard]] const std::vector<double>& impulses() const { return impulses_; }

  /// One solve of the contacts at these poses, without gravity and without moving.
  void solve_here();

 protected:
  dBodyID add_body(double mass, const Eigen::Vector3d& moments);
  void set_gravity(const Eigen::Vector3d& gravity);

  /// Lets a cable act in the next step at `body`, with a surface of these settings.
  void pull(dBodyID body, const CableContact& contact, const dSurfaceParameters& surface);

  /// One `dWorldStep` of `dt` [s], > 0; the contacts are gone afterwards.
  void step_and_read_impulses(double dt);

 private:
  struct Pull {
    std::size_t cable;
    Eigen::Vector3d towards;
  };

  dWorldID world_;
  Rotation rotation_;
  Turning turning_;
  dJointGroupID contacts_;
  std::vector<dBodyID> bodies_;
  std::vector<Pull> pulls_;                // of the next step
  std::vector<dJointFeedback> feedbacks_;  // one per cable; ODE writes to them
  std::vector<double> impulses_;
};

/// An ODE world with the body of a case in it.
class World : public BareWorld {
 public:
  World(const Case& the_case, Rotation rotation);

  [[nodiscard]] State state() const;

  [[nodiscard]] dBodyID body() const { return body_; }

  /// Puts the body there.
  void place(const State& state);

  /// Adds `change` to the body's velocity [m/s].
  void kick(const Vec2& change);

  /// Lets cable `index` act in the next step, as a contact at the attachment whose normal points to
  /// the anchor.
  void pull(std::size_t index, const CableRow& row, const dSurfaceParameters& surface);

  /// One `dWorldStep` of `dt` [s], > 0; the contacts are gone afterwards.
  void advance(double dt);
  void step_loaded(double dt) { advance(dt); }

  /// A step without contacts in which the body flies the exact parabola.
  void fly(double dt);

 private:
  Vec2 gravity_;
  dBodyID body_;
  double angle_;  // [rad], not wrapped
};

/// An ODE world with the bodies of a system in space in it.
class SystemWorld : public BareWorld {
 public:
  SystemWorld(const SpatialSystem& system, Rotation rotation);

  [[nodiscard]] SpatialSystemState state() const;

  [[nodiscard]] dBodyID body(std::size_t index) const { return moving_[index]; }

  void place(const SpatialSystemState& state);
  void pull(std::size_t index, const SystemRow& row, const dSurfaceParameters& surface);
  void advance(double dt);                       // under what is given to act
  void add(const std::vector<BodyLoad>& loads);  // in the next step, too
  void fly(double dt);

  /// The two parts of `advance`, where its step may be split: before it all, and once or more.
  void load(double dt);
  void step_loaded(double dt);

  [[nodiscard]] double time() const { return time_; }  // [s]
  void set_time(double time) { time_ = time; }

  /// Adds a kinematic body, and lets it go to `there` [m] in a step of `dt` [s].
  dBodyID add_hook(const Eigen::Vector3d& position);
  static void move_hook(dBodyID hook, const Eigen::Vector3d& there, double dt);

 private:
  void load(const std::vector<BodyLoad>& loads, const Eigen::Vector3d& gravity);

  const SpatialSystem system_;
  std::vector<dBodyID> moving_;
  double time_ = 0.0;  // [s]
};

/// Throws std::invalid_argument where a cable does not pull along one line: a contact does.
void check_contacts(const SpatialSystem& system);
inline void check_contacts(const Case& /*the_case*/) {}

/// The settings every model needs: those of `World`.
[[nodiscard]] std::vector<Setting> world_settings();

/// Settings of models that run systems.
[[nodiscard]] std::vector<Setting> system_settings();

}  // namespace tautline::ode
