// A world of a host engine with its own settings, as a user has it: ground, boxes that lie and
// fall on it, and loads on drop-in cables. The same for each engine; scene_bullet.cpp and
// scene_ode.cpp say how, and each test program is linked with one of them.

#pragma once

#include <Eigen/Dense>

#include <cmath>
#include <functional>
#include <memory>
#include <string>
#include <vector>

namespace tautline::test {

using Vec3 = Eigen::Vector3d;
using Mat3 = Eigen::Matrix3d;

/// One end of a cable: a point of a body, in its frame, or of the world if `body` is negative [m].
struct CableEnd {
  int body;
  Vec3 point;
};

struct BodyState {
  Vec3 position;  // [m]
  Mat3 axes;      // from the body's frame to the world's
  Vec3 velocity;  // [m/s]
  Vec3 spin;      // [rad/s]
  double mass;    // [kg]; infinite for a hook
  Vec3 moments;   // [kg m^2], about the body's axes

  [[nodiscard]] bool is_hook() const { return std::isinf(mass); }

  [[nodiscard]] Mat3 inertia() const { return axes * moments.asDiagonal() * axes.transpose(); }
};

struct CableData {
  CableEnd first;
  CableEnd second;
  double length;                       // [m]
  double restitution;                  // [-]
  std::vector<double> stiffness = {};  // [N/m, N/m^2, ...]; none: inextensible
  double damping = 0.0;                // [N s/m]
  double damping_ratio = 0.0;          // [-]
};

class Scene {
 public:
  static constexpr double step_length = 1.0 / 60.0;  // [s], unless another rate is asked for

  /// Gravity acts along -y [m/s^2]; `rate` steps make a second.
  explicit Scene(double gravity, double rate = 60.0);
  Scene(const Scene&) = delete;
  Scene& operator=(const Scene&) = delete;
  ~Scene();

  /// A body that touches nothing, or a box of 0.2 m that touches all.
  int add_body(double mass, const Vec3& moments, const Vec3& position, const Vec3& velocity);
  int add_box(double mass, const Vec3& position);
  /// A body of no size that goes where it is moved to and that no force moves: the engine's
  /// kinematic body. It does not turn.
  int add_hook(const Vec3& position);
  int add_cable(const CableData& cable);
  /// The engine's own ball joint between a point of a body, in its frame, and the world or `other`.
  void add_ball_joint(int body, const Vec3& point, int other = -1);
  void add_ground();
  /// Ground, and boxes that lie and fall on it.
  void add_scenery();

  void set_velocity(int body, const Vec3& velocity, const Vec3& spin);
  /// Where a hook is after the next step [m]; it goes there evenly.
  void move_hook(int hook, const Vec3& position);
  /// Winches a cable by `rate` [m/s] from now on; negative hauls it in.
  void wind(int cable, double rate);
  void keep_awake(int body);
  void let_sleep();
  void rebound_by_energy(int cable);
  void break_at_tension(int cable, double tension);  // [N]
  void set_length_rate(int cable, double rate);      // [m/s]
  /// Steps by ODE's iterative solver from now on; false if the engine has no such choice.
  bool use_quick_step();

  /// The engine's own forces on a body, for one step or part of it: a force at its centre [N] and a
  /// torque [N m], or a force at a point of the world.
  void push(int body, const Vec3& force, const Vec3& torque);
  void push_at(int body, const Vec3& force, const Vec3& point);
  /// From now on, calls `forces` with the length [s] of each step, or part of one, as it begins:
  /// where the engine's users give forces in a step.
  void push_in_steps(std::function<void(double)> forces);

  void step();
  /// One step by events; returns its parts.
  int step_by_events();

  [[nodiscard]] double dt() const;  // [s]
  [[nodiscard]] int count() const;  // bodies that move
  [[nodiscard]] BodyState body(int index) const;
  [[nodiscard]] bool sleeps(int body) const;
  [[nodiscard]] bool touched(int body) const;  // by another body, in the last step or part of one
  [[nodiscard]] double impulse(int cable) const;         // of the last step [N s]
  [[nodiscard]] double impact_impulse(int cable) const;  // [N s]
  [[nodiscard]] double taut_tension(int cable) const;    // [N]
  [[nodiscard]] double peak_tension(int cable) const;    // of an elastic cable [N]
  [[nodiscard]] bool broken(int cable) const;
  [[nodiscard]] bool taut(int cable) const;
  [[nodiscard]] double reported_gap(int cable) const;       // [m]
  [[nodiscard]] double reported_gap_rate(int cable) const;  // [m/s]

  /// The engine, and the rounding of its numbers.
  static const std::string engine;
  static const double rounding;
  /// By what angle the engine turns a body that spins at `spin` [rad/s] in one step of `dt` [s].
  [[nodiscard]] static double turn(double spin, double dt);

 private:
  struct Engine;
  std::unique_ptr<Engine> engine_;
};

}  // namespace tautline::test
