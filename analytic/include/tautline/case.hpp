#pragma once

#include <Eigen/Core>
#include <algorithm>
#include <cstddef>
#include <iterator>
#include <optional>
#include <string>
#include <vector>

#include "tautline/cable_set.hpp"
#include "tautline/detail/scalar.hpp"

namespace tautline {

/// A point or a direction in the plane.
template <class Real>
using BasicVec2 = Eigen::Matrix<Real, 2, 1>;
using Vec2 = BasicVec2<double>;

/// One number per cable of a set, in rising index order; never on the heap.
template <class Real>
using BasicCableVector = Eigen::Matrix<Real, Eigen::Dynamic, 1, 0, max_cables, 1>;
using CableVector = BasicCableVector<double>;
/// One number per pair of cables of a set, in rising index order; never on the heap.
template <class Real>
using BasicCableMatrix =
    Eigen::Matrix<Real, Eigen::Dynamic, Eigen::Dynamic, 0, max_cables, max_cables>;
using CableMatrix = BasicCableMatrix<double>;

/// A planar rigid body.
template <class Real>
struct BasicBody {
  Real mass = Real(1);     // [kg], > 0
  Real inertia = Real(1);  // [kg m^2] about the centre of mass; 0 only for a point mass
};
using Body = BasicBody<double>;

/// One measurement of a cable's restitution.
template <class Real>
struct BasicRestitutionPoint {
  Real speed = Real(0);        // [m/s], >= 0, at which the cable becomes taut
  Real restitution = Real(1);  // [-], 0 to 1
};
using RestitutionPoint = BasicRestitutionPoint<double>;

/// A massless inextensible line from a point of the world to a point of the body.
template <class Real>
struct BasicCable {
  BasicVec2<Real> anchor = BasicVec2<Real>::Zero();  // [m], in the world
  BasicVec2<Real> attachment =
      BasicVec2<Real>::Zero();  // [m], in the body's frame, from its centre
  Real length = Real(1);        // [m], > 0
  Real restitution = Real(1);   // [-], Newton's coefficient, 0 to 1

  // Restitution that depends on the speed of the impact; both off by default.
  Real capture_speed = Real(0);  // [m/s], >= 0: an impact slower than this does not rebound
  /// Measured restitution over speed, in rising speed; replaces `restitution` unless empty. Linear
  /// between the points, constant beyond the first and the last.
  std::vector<BasicRestitutionPoint<Real>> restitution_table = {};
};
using Cable = BasicCable<double>;

/// True of a cable that stretches; those of a case do not.
template <class Real>
[[nodiscard]] constexpr bool is_elastic(const BasicCable<Real>& /*cable*/) {
  return false;
}

/// The index of the first elastic cable of `the_case`, or of a system; none: all are inextensible.
template <class TheCase>
[[nodiscard]] std::optional<std::size_t> first_elastic(const TheCase& the_case) {
  const auto& cables = the_case.cables;
  const auto found = std::find_if(cables.begin(), cables.end(),
                                  [](const auto& cable) { return is_elastic(cable); });
  return found == cables.end() ? std::nullopt
                               : std::optional(static_cast<std::size_t>(found - cables.begin()));
}

/// Where the body is and how it moves.
template <class Real>
struct BasicState {
  BasicVec2<Real> position = BasicVec2<Real>::Zero();  // [m], of the centre of mass
  Real angle = Real(0);                                // [rad], anticlockwise, not wrapped
  BasicVec2<Real> velocity = BasicVec2<Real>::Zero();  // [m/s], of the centre of mass
  Real spin = Real(0);                                 // [rad/s], anticlockwise
};
using State = BasicState<double>;

template <class Real>
struct BasicTouching;
template <class Real>
class TautSeries;

/// One system, its start and its duration. SI units or nondimensional: `gravity` decides.
template <class Real>
struct BasicCase {
  // The names by which the solver knows this kind of case (analytic/README.md, "Kinds of cases").
  using Scalar = Real;                   // of all its numbers
  using Vector = BasicVec2<Real>;        // a point of the world, or a direction
  using Body = BasicBody<Real>;          // that moves
  using Cable = BasicCable<Real>;        // that holds it
  using State = BasicState<Real>;        // where it is and how it moves
  using Touching = BasicTouching<Real>;  // cables at zero gap, and what rounding leaves of rates
  using Series = TautSeries<Real>;       // of the motion on taut cables
  using Gravity = BasicVec2<Real>;       // constant
  static constexpr std::size_t freedoms = 3;          // of the body
  static constexpr std::size_t most_freedoms = 3;     // the same for all cases
  static constexpr int most_pose_numbers = 3;         // the columns of an arc
  static constexpr bool flies_in_closed_form = true;  // with no cable taut
  static constexpr bool has_several_bodies = false;   // it has one

  std::string name;                                              // of its file or its maker
  BasicBody<Real> body;                                          // the one that moves
  std::vector<BasicCable<Real>> cables;                          // 1 to max_cables
  BasicVec2<Real> gravity = BasicVec2<Real>(Real(0), -Real(1));  // [m/s^2], any constant vector
  BasicState<Real> initial;         // every gap >= 0 within `gap_rounding`
  Real duration = Real(1);          // [s], > 0
  std::optional<Real> angle_limit;  // [rad], > 0: the run ends where |angle| reaches it
  std::optional<Real> ceiling;      // [m]: the run ends where an attachment rises to it
};
using Case = BasicCase<double>;

/// The same names of any kind of case.
template <class TheCase>
using RealOf = typename TheCase::Scalar;
/// A point of the world, or a direction.
template <class TheCase>
using VectorOf = typename TheCase::Vector;
/// The body that moves.
template <class TheCase>
using BodyOf = typename TheCase::Body;
/// A cable that holds it.
template <class TheCase>
using CableOf = typename TheCase::Cable;
/// Where the body is and how it moves.
template <class TheCase>
using StateOf = typename TheCase::State;
/// Cables at zero gap, and what rounding leaves of their rates.
template <class TheCase>
using TouchingOf = typename TheCase::Touching;
/// The series of the motion on taut cables.
template <class TheCase>
using SeriesOf = typename TheCase::Series;
/// Its acceleration in free flight.
template <class TheCase>
using GravityOf = typename TheCase::Gravity;
/// One number for each freedom of the body, or of all bodies; never on the heap.
template <class TheCase>
using RowOf = Eigen::Matrix<RealOf<TheCase>, TheCase::freedoms, 1, 0, TheCase::most_freedoms, 1>;
/// One row for each cable of a set, in rising index order; never on the heap.
template <class TheCase>
using RowsOf = Eigen::Matrix<RealOf<TheCase>, Eigen::Dynamic, TheCase::freedoms, 0, max_cables,
                             TheCase::most_freedoms>;
/// Taylor coefficients of a pose in time, one row each.
template <class TheCase>
using PosesOf = Eigen::Matrix<RealOf<TheCase>, Eigen::Dynamic, TheCase::freedoms>;

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

/// `the_case` rounded to double.
template <class Real>
[[nodiscard]] Case in_double(const BasicCase<Real>& the_case) {
  if constexpr (std::is_same_v<Real, double>) {
    return the_case;
  } else {
    const auto number = [](const Real& value) { return static_cast<double>(value); };
    const auto vector = [&](const BasicVec2<Real>& v) {
      return Vec2(number(v.x()), number(v.y()));
    };
    const BasicState<Real>& start = the_case.initial;
    Case result;
    result.name = the_case.name;
    result.body = {number(the_case.body.mass), number(the_case.body.inertia)};
    for (const BasicCable<Real>& cable : the_case.cables) {
      Cable rounded{vector(cable.anchor),      vector(cable.attachment),    number(cable.length),
                    number(cable.restitution), number(cable.capture_speed), {}};
      for (const auto& point : cable.restitution_table) {
        rounded.restitution_table.push_back({number(point.speed), number(point.restitution)});
      }
      result.cables.push_back(std::move(rounded));
    }
    result.gravity = vector(the_case.gravity);
    result.initial = {vector(start.position), number(start.angle), vector(start.velocity),
                      number(start.spin)};
    result.duration = number(the_case.duration);
    if (the_case.angle_limit) {
      result.angle_limit = number(*the_case.angle_limit);
    }
    if (the_case.ceiling) {
      result.ceiling = number(*the_case.ceiling);
    }
    return result;
  }
}

/// True where the restitution of `cable` is not the same at all speeds.
template <class TheCable>
[[nodiscard]] bool depends_on_speed(const TheCable& cable) {
  return cable.capture_speed > 0 || !cable.restitution_table.empty();
}

/// The restitution [-] of an impact on `cable` whose gap closes at `rate` [m/s]; its sign is
/// ignored.
template <class TheCable, class Real>
[[nodiscard]] Real restitution(const TheCable& cable, const Real& rate) {
  const Real speed = abs(rate);
  if (speed < cable.capture_speed) {
    return Real(0);
  }
  const auto& table = cable.restitution_table;
  if (table.empty()) {
    return cable.restitution;
  }
  const auto above = std::find_if(table.begin(), table.end(),
                                  [&](const auto& point) { return point.speed > speed; });
  if (above == table.begin()) {
    return table.front().restitution;
  }
  const auto below = std::prev(above);
  if (above == table.end()) {
    return below->restitution;
  }
  const Real part = (speed - below->speed) / (above->speed - below->speed);
  return below->restitution + part * (above->restitution - below->restitution);
}

/// The largest restitution [-] of impacts on `cable` no faster than `speed` [m/s].
template <class TheCable, class Real>
[[nodiscard]] Real restitution_up_to(const TheCable& cable, const Real& speed) {
  if (speed < cable.capture_speed) {
    return Real(0);
  }
  Real largest = max(restitution(cable, speed), restitution(cable, cable.capture_speed));
  for (const auto& point : cable.restitution_table) {
    if (point.speed <= speed && point.speed >= cable.capture_speed) {
      largest = max(largest, point.restitution);
    }
  }
  return largest;
}

/// True where `problems` accepts zero inertia: every attachment is the centre of mass.
template <class Real>
[[nodiscard]] bool is_point_mass(const BasicCase<Real>& the_case) {
  for (const BasicCable<Real>& cable : the_case.cables) {
    if (cable.attachment.x() != 0 || cable.attachment.y() != 0) {  // exactly
      return false;
    }
  }
  return true;
}

}  // namespace tautline
