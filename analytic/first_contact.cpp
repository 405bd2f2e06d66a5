#include "tautline/first_contact.hpp"

#include <algorithm>
#include <array>
#include <cmath>

#include "tautline/flight.hpp"
#include "tautline/geometry.hpp"
#include "tautline/root_search.hpp"

namespace tautline {
namespace {

/// f = (length^2 - distance^2) / (2 length) of one cable along a flight: smooth everywhere, zero
/// with the gap, and with the gap's rate there (Eq. 11).
///
/// Computed from the way d(s) the attachment has gone, f(s) = f(0) - (D(0) + d / 2) . d / length:
/// a short flight then has a small rounding error. Taking squared distances instead leaves 1e-16
/// however short it is, which moves the return of a bounce of speed v by 1e-16 / v.
class GapAlongFlight {
 public:
  /// `at_zero`: f(0) is zero, and f'(0) too where it is within `rate_rounding` below.
  GapAlongFlight(const Case& the_case, const Cable& cable, const State& start, bool at_zero,
                 double rate_rounding)
      : gravity_(the_case.gravity),
        cable_(cable),
        start_(start),
        arm_(attachment_arm(start, cable)),
        from_anchor_(start.position + arm_ - cable.anchor),
        value_(at_zero ? 0.0
                       : (cable.length * cable.length - from_anchor_.squaredNorm()) /
                             (2.0 * cable.length)),
        radius_(cable.attachment.norm()),
        turning_(start.spin * start.spin * radius_) {
    const double rate =
        -from_anchor_.dot(start.velocity + start.spin * perpendicular(arm_)) / cable.length;
    drift_ = at_zero && rate < 0.0 && rate >= -rate_rounding ? -rate : 0.0;
  }

  [[nodiscard]] Sample at(double s) const {
    // the turn by 2 h takes the arm a to a + 2 sin h (cos h a' - sin h a), a' perpendicular to a
    const double sine = std::sin(0.5 * s * start_.spin);
    const double cosine = std::cos(0.5 * s * start_.spin);
    const Vec2 turned = 2.0 * sine * (cosine * perpendicular(arm_) - sine * arm_);
    const Vec2 way = s * start_.velocity + (0.5 * s * s) * gravity_ + turned;
    const Vec2 arm = arm_ + turned;
    const Vec2 from_anchor = from_anchor_ + way;
    const Vec2 velocity = start_.velocity + s * gravity_ + start_.spin * perpendicular(arm);
    const Vec2 acceleration = gravity_ - start_.spin * start_.spin * arm;
    const double length = cable_.length;
    return {value_ + s * drift_ - (from_anchor_ + 0.5 * way).dot(way) / length,
            drift_ - from_anchor.dot(velocity) / length,
            -(velocity.squaredNorm() + from_anchor.dot(acceleration)) / length};
  }

  /// |f'''| <= (3 V A + D J) / length (Eq. 12): V, A, J bound the attachment's speed, acceleration
  /// and jerk over the window, and D the distance, which is at most the length until the first root
  /// and at most V w beyond it after.
  [[nodiscard]] double jerk_bound(double s, double window) const {
    const double speed = (start_.velocity + s * gravity_).norm() + window * gravity_.norm() +
                         std::abs(start_.spin) * radius_;
    const double acceleration = gravity_.norm() + turning_;
    const double distance = cable_.length + speed * window;
    const double jerk = std::abs(start_.spin) * turning_;
    return (3.0 * speed * acceleration + distance * jerk) / cable_.length;
  }

 private:
  Vec2 gravity_;
  const Cable& cable_;
  const State& start_;
  Vec2 arm_;          // [m], centre of mass to attachment at the start
  Vec2 from_anchor_;  // [m], anchor to attachment at the start
  double value_;      // [m], f at the start
  double drift_;      // [m/s], takes away a closing rate that is rounding
  double radius_;     // [m], attachment to centre of mass
  double turning_;    // [m/s^2], centripetal acceleration of the attachment
};

/// How far one attachment is below the ceiling along a flight.
class RoomAlongFlight {
 public:
  RoomAlongFlight(const Case& the_case, const Cable& cable, const State& start)
      : the_case_(the_case), cable_(cable), start_(start) {}

  [[nodiscard]] Sample at(double s) const {
    const State state = fly(start_, the_case_.gravity, s);
    const Vec2 point = attachment_point(state, cable_);
    const double height_above_centre = point.y() - state.position.y();
    return {*the_case_.ceiling - point.y(), -attachment_velocity(state, cable_).y(),
            -(the_case_.gravity.y() - state.spin * state.spin * height_above_centre)};
  }

  [[nodiscard]] double jerk_bound(double /*s*/, double /*window*/) const {
    return std::abs(start_.spin * start_.spin * start_.spin) * cable_.attachment.norm();
  }

 private:
  const Case& the_case_;
  const Cable& cable_;
  const State& start_;
};

}  // namespace

FirstContactSearch first_contact(const Case& the_case, const State& state, const Touching& touching,
                                 double horizon) {
  FirstContactSearch result;
  std::array<std::optional<double>, max_cables> roots;
  std::optional<double> earliest;
  for (std::size_t index = 0; index < the_case.cables.size(); ++index) {
    // nothing after the earliest contact so far matters, except what is simultaneous with it
    const double until = earliest ? std::min(horizon, *earliest * (1.0 + simultaneous)) : horizon;
    const bool at_zero = touching.cables.contains(index);
    const GapAlongFlight f(the_case, the_case.cables[index], state, at_zero,
                           touching.rate_rounding);
    const RootSearch search = first_root(f, until, {at_zero});
    result.steps += search.steps;
    if (search.root && std::isnan(*search.root)) {
      result.contact = FirstContact{*search.root, {}};
      return result;
    }
    roots[index] = search.root;
    if (search.root && (!earliest || *search.root < *earliest)) {
      earliest = search.root;
    }
  }
  if (!earliest) {
    return result;
  }
  result.contact = FirstContact{*earliest, {}};
  for (std::size_t index = 0; index < the_case.cables.size(); ++index) {
    if (roots[index] && *roots[index] <= *earliest * (1.0 + simultaneous)) {
      result.contact->cables.insert(index);
    }
  }
  return result;
}

std::optional<double> time_to_ceiling(const Case& the_case, const State& state, double horizon) {
  std::optional<double> earliest;
  if (!the_case.ceiling) {
    return earliest;
  }
  for (const Cable& cable : the_case.cables) {
    const RoomAlongFlight room(the_case, cable, state);
    const RootSearch search = first_root(room, earliest.value_or(horizon));
    earliest = search.root ? search.root : earliest;
    if (earliest && std::isnan(*earliest)) {
      return earliest;
    }
  }
  return earliest;
}

std::optional<double> time_to_angle_limit(const Case& the_case, const State& state,
                                          double horizon) {
  if (!the_case.angle_limit || state.spin == 0.0) {  // exactly zero: the body does not turn
    return std::nullopt;
  }
  const double limit = std::copysign(*the_case.angle_limit, state.spin);
  const double dt = std::max(0.0, (limit - state.angle) / state.spin);
  return dt <= horizon ? std::optional(dt) : std::nullopt;
}

}  // namespace tautline
