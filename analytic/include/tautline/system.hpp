#pragma once

#include <Eigen/Core>
#include <cstddef>
#include <optional>
#include <string>
#include <type_traits>
#include <vector>

#include "tautline/case.hpp"
#include "tautline/elasticity.hpp"
#include "tautline/function.hpp"
#include "tautline/system_turning.hpp"

namespace tautline {

/// A system has 1 to this many bodies.
inline constexpr std::size_t max_bodies = 8;

/// A rigid body of a system, or a point mass.
template <class Real, int D>
struct BasicBodyOfSystem {
  using Inertia = typename Turning<Real, D>::Inertia;  // its type

  std::string name = {};  // of its file; may be empty
  Real mass = Real(1);    // [kg], > 0
  /// [kg m^2], about its centre; in space its principal moments, whose axes are the body's. 0, in
  /// space three times 0: a point mass.
  Inertia inertia = Turning<Real, D>::of_point();
  Real drag = Real(0);                        // [N s/m], >= 0: force -drag velocity at the centre
  Real spin_drag = Real(0);                   // [N m s], >= 0: moment -spin_drag spin
  BasicFunction<Real, D> force = {};          // [N], in the world, at the centre of mass
  BasicFunction<Real, spins<D>> moment = {};  // [N m], in the world
};
using BodyOfSystem = BasicBodyOfSystem<double, 2>;  // in double, in the plane
using SpatialBody = BasicBodyOfSystem<double, 3>;   // in double, in space

/// An end of a cable, or a ring that it runs through without friction: a point of a body or of the
/// world.
template <class Real, int D>
struct BasicEnd {
  std::optional<std::size_t> body = std::nullopt;  // index; none: the world
  /// [m], in the body's frame from its centre; in the world the constant part.
  BasicVector<Real, D> at = BasicVector<Real, D>::Zero();
  BasicFunction<Real, D> motion = {};  // [m], in the world: added to `at`; continuous

  /// True where all of it is equal.
  bool operator==(const BasicEnd&) const = default;
};
using End = BasicEnd<double, 2>;         // in double, in the plane
using SpatialEnd = BasicEnd<double, 3>;  // in double, in space

/// A massless line between two ends, straight or through rings; inextensible, or elastic. Its gap
/// is its length minus the distances from end to end, summed; below 0 an elastic cable is
/// stretched.
template <class Real, int D>
struct BasicCableOfSystem {
  BasicEnd<Real, D> from = {};                  // its first end
  std::vector<BasicEnd<Real, D>> through = {};  // rings, in order; empty: straight
  BasicEnd<Real, D> to = {};                    // its last end
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

  /// How it pulls where it is longer than `length`, and has no impacts; none: it is inextensible.
  std::optional<BasicElasticity<Real>> elasticity = std::nullopt;

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
using CableOfSystem = BasicCableOfSystem<double, 2>;  // in double, in the plane
using SpatialCable = BasicCableOfSystem<double, 3>;   // in double, in space

/// True of a cable that stretches.
template <class Real, int D>
[[nodiscard]] bool is_elastic(const BasicCableOfSystem<Real, D>& cable) {
  return cable.elasticity.has_value();
}

/// The places of a system's bodies at a time, and their velocities.
template <class Real, int D>
struct BasicSystemState {
  using Body = typename Turning<Real, D>::BodyState;  // of one of them

  Real time = Real(0);                   // [s]
  std::vector<Body> bodies;              // one for each of the system, in order
  BasicElasticZones<Real> elastic = {};  // found by `solve` from the start on
};
using SystemState = BasicSystemState<double, 2>;         // in double, in the plane
using SpatialSystemState = BasicSystemState<double, 3>;  // in double, in space

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
  static constexpr bool flies_in_closed_form = false;  // it may be forced
  static constexpr bool has_several_bodies = true;     // up to max_bodies
  static constexpr int most_freedoms = static_cast<int>(max_bodies) * (D + spins<D>);  // of all
  /// An arc has one column for each of these numbers.
  static constexpr int most_pose_numbers =
      static_cast<int>(max_bodies) * Turning<Real, D>::pose_numbers;

  std::string name = {};                                              // of its file or its maker
  std::vector<Body> bodies;                                           // 1 to max_bodies
  std::vector<Cable> cables;                                          // 0 to max_cables
  Gravity gravity = Gravity::constant(Vector(-Vector::Unit(D - 1)));  // [m/s^2]
  State initial;            // at time 0; every gap >= 0 within `gap_rounding`
  Real duration = Real(1);  // [s], > 0
};
using System = BasicSystem<double, 2>;         // in double, in the plane
using SpatialSystem = BasicSystem<double, 3>;  // in double, in space

/// Calls `visit` with each function of `system` over time, a `BasicSystem` that may be const: of
/// gravity, of the bodies, of the lengths and ends of the cables.
template <class TheSystem, class Visit>
void each_function(TheSystem& system, const Visit& visit) {
  visit(system.gravity);
  for (auto& body : system.bodies) {
    visit(body.force);
    visit(body.moment);
  }
  for (auto& cable : system.cables) {
    visit(cable.length);
    visit(cable.from.motion);
    for (auto& ring : cable.through) {
      visit(ring.motion);
    }
    visit(cable.to.motion);
  }
}

/// `function` in numbers of another type.
template <class To, class Real, int N>
[[nodiscard]] BasicFunction<To, N> converted(const BasicFunction<Real, N>& function) {
  BasicFunction<To, N> result;
  for (const auto& piece : function.pieces) {
    result.pieces.push_back({static_cast<To>(piece.from), {}});
    for (const auto& coefficient : piece.coefficients) {
      result.pieces.back().coefficients.push_back(converted<To>(coefficient));
    }
  }
  for (const auto& wave : function.waves) {
    result.waves.push_back({converted<To>(wave.amplitude), static_cast<To>(wave.frequency),
                            static_cast<To>(wave.phase)});
  }
  return result;
}

/// `cable` in numbers of another type.
template <class To, class Real, int D>
[[nodiscard]] BasicCableOfSystem<To, D> converted(const BasicCableOfSystem<Real, D>& cable) {
  const auto number = [](const Real& value) { return static_cast<To>(value); };
  const auto time = [&](const std::optional<Real>& value) {
    return value ? std::optional<To>(number(*value)) : std::nullopt;
  };
  const auto end = [](const BasicEnd<Real, D>& from) {
    return BasicEnd<To, D>{from.body, converted<To>(from.at), converted<To>(from.motion)};
  };
  BasicCableOfSystem<To, D> result;
  result.from = end(cable.from);
  result.to = end(cable.to);
  for (const auto& ring : cable.through) {
    result.through.push_back(end(ring));
  }
  result.length = converted<To>(cable.length);
  result.restitution = number(cable.restitution);
  result.capture_speed = number(cable.capture_speed);
  for (const auto& point : cable.restitution_table) {
    result.restitution_table.push_back({number(point.speed), number(point.restitution)});
  }
  result.from_time = time(cable.from_time);
  result.cut_at = time(cable.cut_at);
  if (cable.elasticity) {
    result.elasticity.emplace();
    for (const Real& one : cable.elasticity->stiffness) {
      result.elasticity->stiffness.push_back(number(one));
    }
    result.elasticity->damping = number(cable.elasticity->damping);
    result.elasticity->damping_ratio = number(cable.elasticity->damping_ratio);
    for (const auto& corner : cable.elasticity->corners) {
      result.elasticity->corners.push_back({number(corner.stretch), number(corner.stiffness)});
    }
    result.elasticity->of_strain = cable.elasticity->of_strain;
    result.elasticity->cut = cable.elasticity->cut;
  }
  return result;
}

/// `system` in numbers of another type: the numbers of doubles are exact in many digits.
template <class To, class Real, int D>
[[nodiscard]] BasicSystem<To, D> converted(const BasicSystem<Real, D>& system) {
  const auto number = [](const Real& value) { return static_cast<To>(value); };
  BasicSystem<To, D> result;
  result.name = system.name;
  for (const auto& body : system.bodies) {
    result.bodies.push_back({body.name, number(body.mass), inertia_in<To>(body.inertia),
                             number(body.drag), number(body.spin_drag), converted<To>(body.force),
                             converted<To>(body.moment)});
  }
  for (const auto& cable : system.cables) {
    result.cables.push_back(converted<To>(cable));
  }
  result.gravity = converted<To>(system.gravity);
  result.initial.time = number(system.initial.time);
  for (const auto& body : system.initial.bodies) {
    result.initial.bodies.push_back(converted<To>(body));
  }
  result.duration = number(system.duration);
  return result;
}

/// One sentence for each rule `system` breaks, naming the thing, its value and what would be right.
/// Empty means `solve` accepts it.
[[nodiscard]] std::vector<std::string> problems(const System& system);
/// In space.
[[nodiscard]] std::vector<std::string> problems(const SpatialSystem& system);

/// `system` rounded to double.
template <class Real, int D>
[[nodiscard]] BasicSystem<double, D> in_double(const BasicSystem<Real, D>& system) {
  if constexpr (std::is_same_v<Real, double>) {
    return system;
  } else {
    return converted<double>(system);
  }
}

/// `the_case` as a system of one body: the same motion.
[[nodiscard]] System as_system(const Case& the_case);

}  // namespace tautline
