#pragma once

#include <memory>
#include <string>
#include <vector>

#include "tautline/cable_row.hpp"
#include "tautline/case.hpp"
#include "tautline/engine.hpp"
#include "tautline/system_loads.hpp"

namespace tautline::dart_engine {

/// A DART world with one skeleton, and one constraint per cable, none of which acts unless told to.
/// DART's headers, which take seconds to compile, stay in its source.
class BareWorld {
 public:
  BareWorld(const BareWorld&) = delete;
  BareWorld& operator=(const BareWorld&) = delete;
  ~BareWorld();

  void let_go(std::size_t cable);

  /// How DART's projected Gauss-Seidel iteration ends.
  struct Iteration {
    int most;              // [-]
    double change;         // [-], of every impulse, in proportion to it
    double least_impulse;  // [N s], smaller ones may change; below the inverse of the mass
  };

  /// One solve of the constraints that act, at the present pose and without moving, by iteration.
  /// DART's own choice, Dantzig's pivoting, is what `advance` uses until then.
  void solve_here(const Iteration& iteration);

  /// Of the cable in the latest step or solve [N s], >= 0.
  [[nodiscard]] double impulse(std::size_t cable) const;

 protected:
  BareWorld();

  /// One `World::step` of `dt` [s], semi-implicit Euler.
  void step(double dt);

  struct Parts;
  [[nodiscard]] Parts& parts() { return *parts_; }
  [[nodiscard]] const Parts& parts() const { return *parts_; }

 private:
  std::unique_ptr<Parts> parts_;
};

/// The body of a case on a planar joint.
class World : public BareWorld {
 public:
  explicit World(const Case& the_case);

  [[nodiscard]] State state() const;

  /// Puts the body there.
  void place(const State& state);

  /// Adds `change` to the body's velocity [m/s].
  void kick(const Vec2& change);

  /// From now on the cable acts as `row`: its gap opens with at least `rate` [m/s] after a solve.
  void pull(std::size_t cable, const CableRow& row, double rate);

  void advance(double dt) { step(dt); }

  /// A step without cables in which the body flies the exact parabola.
  void fly(double dt);

 private:
  const Vec2 gravity_;
};

/// The bodies of a system, each on a ball joint at its centre, which a translational joint carries.
class SystemWorld : public BareWorld {
 public:
  explicit SystemWorld(const SpatialSystem& system);

  [[nodiscard]] SpatialSystemState state() const;
  void place(const SpatialSystemState& state);
  void pull(std::size_t cable, const SystemRow& row, double rate);
  void advance(double dt);                       // under what is given to act
  void add(const std::vector<BodyLoad>& loads);  // in the next step, too
  void fly(double dt);

 private:
  void load(const std::vector<BodyLoad>& loads, const Eigen::Vector3d& gravity);
  void set_orientation(std::size_t index, const Quaternion& turn);
  void step_and_follow(double dt);

  const SpatialSystem system_;
  double time_ = 0.0;  // [s]
};

/// Settings of models that run systems.
[[nodiscard]] std::vector<Setting> system_settings();

/// The version of the library's headers: the library itself does not tell it.
[[nodiscard]] std::string version();

}  // namespace tautline::dart_engine
