#pragma once

#include <memory>
#include <string>
#include <vector>

#include "tautline/cable_row.hpp"
#include "tautline/case.hpp"
#include "tautline/engine.hpp"

namespace tautline::dart_engine {

/// A DART world with the body of a case on a planar joint, and one constraint per cable, none of
/// which acts unless told to. DART's headers, which take seconds to compile, stay in its source.
class World {
 public:
  explicit World(const Case& the_case);
  World(const World&) = delete;
  World& operator=(const World&) = delete;
  ~World();

  [[nodiscard]] State state() const;

  /// Puts the body there.
  void place(const State& state);

  /// Adds `change` to the body's velocity [m/s].
  void kick(const Vec2& change);

  /// From now on the cable acts as `row`: its gap opens with at least `rate` [m/s] after a solve.
  void pull(std::size_t cable, const CableRow& row, double rate);
  void let_go(std::size_t cable);

  /// One `World::step` of `dt` [s], semi-implicit Euler.
  void advance(double dt);

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

 private:
  struct Parts;
  std::unique_ptr<Parts> parts_;
};

/// The version of the library's headers: the library itself does not tell it.
[[nodiscard]] std::string version();

}  // namespace tautline::dart_engine
