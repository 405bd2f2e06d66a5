#pragma once

#include <Eigen/Core>
#include <cstddef>
#include <optional>
#include <string>
#include <vector>

#include "tautline/case.hpp"
#include "tautline/function.hpp"

namespace tautline {

/// A system has 1 to this many bodies.
inline constexpr std::size_t max_bodies = 8;

/// A point of D dimensions, or a direction.
template <class Real, int D>
using BasicVector = Eigen::Matrix<Real, D, 1>;

/// How many numbers a spin has.
template <int D>
inline constexpr int spins = D == 2 ? 1 : 3;

/// The types that differ between the plane and space.
template <class Real, int D>
struct Turning;
/// In the plane a body turns by an angle.
template <class Real>
struct Turning<Real, 2> {
  using Inertia = Real;                ///< about the centre of mass
  using BodyState = BasicState<Real>;  ///< place and velocity of one body
};

/// A rigid body of a system, or a point mass.
template <class Real, int D>
struct BasicBodyOfSystem {
  using Inertia = typename Turning<Real, D>::Inertia;

  std::string name = {};                      // of its file; may be empty
  Real mass = Real(1);                        // [kg], > 0
  Inertia inertia = Inertia(0);               // [kg m^2], about its centre; 0: a point mass
  Real drag = Real(0);                        // [N s/m], >= 0: force -drag velocity at the centre
  Real spin_drag = Real(0);                   // [N m s], >= 0: moment -spin_drag spin
  BasicFunction<Real, D> force = {};          // [N], in the world, at the centre of mass
  BasicFunction<Real, spins<D>> moment = {};  // [N m]
};
using BodyOfSystem = BasicBodyOfSystem<double, 2>;

/// An end of a cable, or a ring that it runs through without friction: a point of a body or of the
/// world.
template <class Real, int D>
struct BasicEnd {
  std::optional<std::size_t> body = std::nullopt;  // index; none: the world
  /// [m], in the body's frame from its centre; in the world the part that stands still.
  BasicVector<Real, D> at = BasicVector<Real, D>::Zero();
  BasicFunction<Real, D> motion = {};  // [m], in the world: added to `at`; continuous
};
using End = BasicEnd<double, 2>;

/// A massless inextensible line between two ends, straight or through rings. Its gap is its length
/// minus the distances from end to end, summed.
template <class Real, int D>
struct BasicCableOfSystem {
  BasicEnd<Real, D> from = {};
  std::vector<BasicEnd<Real, D>> through = {};  // rings, in order; empty: straight
  BasicEnd<Real, D> to = {};
  BasicFunction<Real, 1> length =
      BasicFunction<Real, 1>::constant(Real(1));  // [m], > 0, continuous
  Real restitution = Real(1);                     // [-], Newton's coefficient, 0 to 1

  // Restitution that depends on the speed of the impact, as in the plane; both off by default.
  Real capture_speed = Real(0);  // [m/s], >= 0: an impact slower than this does not rebound
  std::vector<BasicRestitutionPoint<Real>> restitution_table = {};  // replaces `restitution`

  // When it acts: from the start on, without end, by default.
  std::optional<Real> from_time =
      std::nullopt;                           // [s], > 0: it is hooked up then, not overstretched
  std::optional<Real> cut_at = std::nullopt;  // [s], > `from_time`: it is cut then

  /// How many straight pieces it has.
  [[nodiscard]] std::size_t segments() const { return through.size() + 1; }
  /// Its ends and rings in order, 0 to segments().
  [[nodiscard]] const BasicEnd<Real, D>& end(std::size_t i) const {
    return i == 0 ? from : i <= through.size() ? through[i - 1] : to;
  }
  /// True where it is hooked up and not cut at `time` [s] and right after it.
  [[nodiscard]] bool acts_at(const Real& time) const {
    return !(from_time && time < *from_time) && !(cut_at && time >= *cut_at);
  }
};
using CableOfSystem = BasicCableOfSystem<double, 2>;

/// The places of a system's bodies at a time, and their velocities.
template <class Real, int D>
struct BasicSystemState {
  using Body = typename Turning<Real, D>::BodyState;

  Real time = Real(0);       // [s]
  std::vector<Body> bodies;  // one for each of the system, in order
};
using SystemState = BasicSystemState<double, 2>;

template <class Real, int D>
struct SystemTouching;
template <class Real, int D>
class SystemSeries;

/// Several bodies on cables, with what is given over time; its start and its duration. The
/// general kind of case; `BasicCase` is the one of one planar body where all is constant.
template <class Real, int D>
struct BasicSystem {
  // The names by which the solver knows this kind of case (analytic/README.md, "Kinds of cases").
  using Scalar = Real;                             // of all its numbers
  using Vector = BasicVector<Real, D>;             // a point of the world, or a direction
  using Gravity = BasicFunction<Real, D>;          // over time
  using Body = BasicBodyOfSystem<Real, D>;         // that moves
  using Cable = BasicCableOfSystem<Real, D>;       // that holds it
  using State = BasicSystemState<Real, D>;         // their places and velocities
  using Touching = SystemTouching<Real, D>;        // cables at zero gap, and the rounding of rates
  using Series = SystemSeries<Real, D>;            // of the motion, in flight as on taut cables
  static constexpr int freedoms = Eigen::Dynamic;  // of all bodies
  static constexpr int most_freedoms = static_cast<int>(max_bodies) * (D + spins<D>);

  std::string name = {};                                              // of its file or its maker
  std::vector<Body> bodies;                                           // 1 to max_bodies
  std::vector<Cable> cables;                                          // 0 to max_cables
  Gravity gravity = Gravity::constant(Vector(-Vector::Unit(D - 1)));  // [m/s^2]
  State initial;            // at time 0; every gap >= 0 within `gap_rounding`
  Real duration = Real(1);  // [s], > 0
};
using System = BasicSystem<double, 2>;

/// One sentence for each rule `system` breaks, naming the thing, its value and what would be right.
/// Empty means `solve` accepts it.
[[nodiscard]] std::vector<std::string> problems(const System& system);

/// `the_case` as a system of one body: the same motion.
[[nodiscard]] System as_system(const Case& the_case);

}  // namespace tautline
