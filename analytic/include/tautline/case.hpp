#pragma once

#include <Eigen/Core>
#include <optional>
#include <string>
#include <vector>

#include "tautline/cable_set.hpp"

namespace tautline {

using Vec2 = Eigen::Vector2d;

/// One number per cable of a set, in rising index order; never on the heap.
using CableVector = Eigen::Matrix<double, Eigen::Dynamic, 1, 0, max_cables, 1>;
using CableMatrix =
    Eigen::Matrix<double, Eigen::Dynamic, Eigen::Dynamic, 0, max_cables, max_cables>;

/// A planar rigid body.
struct Body {
  double mass = 1.0;     // [kg], > 0
  double inertia = 1.0;  // [kg m^2] about the centre of mass; 0 only for a point mass
};

/// A massless inextensible line from a point of the world to a point of the body.
struct Cable {
  Vec2 anchor = Vec2::Zero();      // [m], in the world
  Vec2 attachment = Vec2::Zero();  // [m], in the body's frame, from its centre of mass
  double length = 1.0;             // [m], > 0
  double restitution = 1.0;        // [-], Newton's coefficient, 0 to 1
};

/// Where the body is and how it moves.
struct State {
  Vec2 position = Vec2::Zero();  // [m], of the centre of mass
  double angle = 0.0;            // [rad], anticlockwise, not wrapped
  Vec2 velocity = Vec2::Zero();  // [m/s], of the centre of mass
  double spin = 0.0;             // [rad/s], anticlockwise
};

/// One system, its start and its duration. SI units or nondimensional: `gravity` decides.
struct Case {
  std::string name;
  Body body;
  std::vector<Cable> cables;          // 1 to max_cables
  Vec2 gravity = Vec2(0.0, -1.0);     // [m/s^2], any constant vector, zero included
  State initial;                      // every gap >= 0 within `gap_rounding`
  double duration = 1.0;              // [s], > 0
  std::optional<double> angle_limit;  // [rad], > 0: the run ends where |angle| reaches it
  std::optional<double> ceiling;      // [m]: the run ends where an attachment rises to it
};

/// A gap this small against the cable's length is rounding in the input and counts as zero [-].
inline constexpr double gap_rounding = 1e-12;

/// No number of a case may be larger in size. The search for the first contact multiplies up to ten
/// of them (a duration cubed, times a jerk bound of seven): 1e200, which leaves room to divide.
inline constexpr double largest_number = 1e20;

/// Mass, inertia (unless zero) and length may not be smaller: the motion is divided by them, by one
/// of them at a time in the search, so that 1e200 / 1e-60 is still finite.
inline constexpr double smallest_divisor = 1e-60;

/// One sentence for each rule `the_case` breaks, naming the thing, its value and what would be
/// right. Empty means `solve` accepts it.
[[nodiscard]] std::vector<std::string> problems(const Case& the_case);

/// True where `problems` accepts zero inertia: every attachment is the centre of mass.
[[nodiscard]] bool is_point_mass(const Case& the_case);

}  // namespace tautline
