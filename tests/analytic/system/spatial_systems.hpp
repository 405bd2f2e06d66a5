#pragma once

#include <array>
#include <cstddef>
#include <utility>

#include "tautline/case.hpp"
#include "tautline/system_geometry.hpp"

// Systems in space with a truth in closed form, in numbers of any kind.

namespace tautline::test {

/// A point of space.
template <class Real>
[[nodiscard]] BasicVector<Real, 3> point(const Real& x, const Real& y, const Real& z) {
  return {x, y, z};
}

/// So many parts of a thousand, to all digits.
template <class Real>
[[nodiscard]] Real milli(int thousandths) {
  return Real(thousandths) / 1000;
}

/// A straight cable from a body to the world.
template <class Real>
[[nodiscard]] BasicCableOfSystem<Real, 3> cable_in_space(const BasicVector<Real, 3>& attachment,
                                                         const BasicVector<Real, 3>& anchor,
                                                         const Real& length,
                                                         const Real& restitution,
                                                         std::size_t body = 0) {
  BasicCableOfSystem<Real, 3> cable;
  cable.from = {body, attachment, {}};
  cable.to = {std::nullopt, anchor, {}};
  cable.length = BasicFunction<Real, 1>::constant(length);
  cable.restitution = restitution;
  return cable;
}

/// One body in space with this inertia, under gravity 1 if no other is given.
template <class Real>
[[nodiscard]] BasicSystem<Real, 3> one_body(const BasicVector<Real, 3>& inertia,
                                            const BasicSpatialState<Real>& start,
                                            const Real& gravity = Real(1)) {
  BasicSystem<Real, 3> system;
  system.bodies.resize(1);
  system.bodies[0].inertia = inertia;
  system.gravity = BasicFunction<Real, 3>::constant(point<Real>(Real(0), Real(0), -gravity));
  system.initial.bodies = {start};
  return system;
}

/// The principal moments of a box of these sides [m].
template <class Real>
[[nodiscard]] BasicVector<Real, 3> box(const Real& mass, const BasicVector<Real, 3>& sides) {
  const BasicVector<Real, 3> square = sides.cwiseProduct(sides);
  return BasicVector<Real, 3>(square.y() + square.z(), square.x() + square.z(),
                              square.x() + square.y()) *
         Real(mass / 12);
}

/// A body on equal vertical cables around its axis, which turns about it and rises as it does.
template <class Real>
struct Filar {
  int cables;
  Real anchors;      // [m], the radius of the anchors
  Real attachments;  // [m], that of the attachments
  Real above;        // [m], the attachments above the centre
  Real yaw;          // [rad], at the start, at rest
  Real length = Real(1);
  Real inertia = Real(1) / 50;  // about the axis

  /// The height of the centre at an angle.
  [[nodiscard]] Real height(const Real& angle) const { return -sqrt(square(angle)) - above; }
  [[nodiscard]] Real square(const Real& angle) const {
    return length * length - anchors * anchors - attachments * attachments +
           2 * anchors * attachments * cos(angle);
  }
  /// d height / d angle.
  [[nodiscard]] Real slope(const Real& angle) const {
    return anchors * attachments * sin(angle) / sqrt(square(angle));
  }
  /// The spin on the way through the lowest place.
  [[nodiscard]] Real fastest() const {
    return sqrt(Real(2 * (height(yaw) - height(Real(0))) / inertia));
  }
  /// Four times the integral of dt over angle = yaw cos(c), c from 0 to pi/2. It is smooth and
  /// periodic in c: the midpoint rule is right to all digits.
  [[nodiscard]] Real period() const {
    constexpr int parts = 400;  // of the whole circle
    Real sum(0);
    for (int i = 0; i < parts / 4; ++i) {
      const Real c = (i + Real(1) / 2) * 2 * pi<Real>() / parts;
      const Real angle = yaw * cos(c);
      // height(yaw) - height(angle), and yaw - angle, without a difference
      const Real less = yaw * sin(Real(c / 2)) * sin(Real(c / 2));
      const Real fall = 4 * anchors * attachments * sin(Real((yaw + angle) / 2)) * sin(less) /
                        (sqrt(square(yaw)) + sqrt(square(angle)));
      const Real mass = inertia + slope(angle) * slope(angle);
      sum += yaw * sin(c) * sqrt(Real(mass / (2 * fall)));
    }
    return sum * 4 * 2 * pi<Real>() / parts;
  }
  [[nodiscard]] BasicSystem<Real, 3> system() const {
    BasicSpatialState<Real> start;
    start.position.z() = height(yaw);
    start.orientation = quaternion_of<Real>(point<Real>(Real(0), Real(0), yaw));
    auto result =
        one_body<Real>(point<Real>(Real(7 * inertia / 10), Real(inertia / 2), inertia), start);
    for (int i = 0; i < cables; ++i) {
      const Real angle = 2 * pi<Real>() * i / cables;
      const auto around = point<Real>(cos(angle), sin(angle), Real(0));
      result.cables.push_back(
          cable_in_space<Real>(attachments * around + point<Real>(Real(0), Real(0), above),
                               anchors * around, length, Real(Real(1) / 2)));
    }
    result.duration = Real(4);
    return result;
  }
};
template <class Real>
[[nodiscard]] Filar<Real> bifilar() {
  return {2, milli<Real>(250), milli<Real>(250), milli<Real>(100), milli<Real>(600)};
}
template <class Real>
[[nodiscard]] Filar<Real> trifilar() {
  return {3, milli<Real>(300), milli<Real>(200), milli<Real>(50), milli<Real>(800)};
}

/// A point that swings up on its cable, goes slack at two thirds of its energy, and is caught.
template <class Real>
[[nodiscard]] BasicSystem<Real, 3> spherical_slack() {
  BasicSpatialState<Real> start;
  start.position = point<Real>(milli<Real>(800), Real(0), milli<Real>(-600));
  start.velocity = point<Real>(milli<Real>(960), milli<Real>(300), milli<Real>(1280));
  auto result = one_body<Real>(point<Real>(Real(0), Real(0), Real(0)), start);
  result.cables = {cable_in_space<Real>(point<Real>(Real(0), Real(0), Real(0)),
                                        point<Real>(Real(0), Real(0), Real(0)), Real(1),
                                        Real(Real(1) / 2))};
  result.duration = Real(4);
  return result;
}

/// A symmetric body on one cable that goes round steadily: the cable at `cable` [rad] from the
/// vertical, the axis of the body at 0.5 rad.
template <class Real>
struct Conical {
  Real cable;
  Real precession;  // [rad/s]
  Real tension;

  static constexpr int across = 30;  // thousandths of kg m^2
  static constexpr int along = 10;

  /// By Newton's method from balance: across the axis the centre, and the moment about it.
  [[nodiscard]] static Conical find() {
    const Real b = milli<Real>(500);
    const Real h = milli<Real>(300);
    const Real part = milli<Real>(across - along) * sin(b) * cos(b);
    const auto square = [&](const Real& a) { return Real(tan(a) / (sin(a) + h * sin(b))); };
    const auto balance = [&](const Real& a) {
      return Real(h * sin(Real(b - a)) / cos(a) - part * square(a));
    };
    Real one = milli<Real>(478);
    Real two = milli<Real>(479);
    for (int k = 0; k < 12 && one != two && balance(one) != balance(two); ++k) {
      const Real next = two - balance(two) * (two - one) / (balance(two) - balance(one));
      one = std::exchange(two, next);
    }
    return {two, sqrt(square(two)), Real(1 / cos(two))};
  }
  [[nodiscard]] BasicSystem<Real, 3> system() const {
    const Real b = milli<Real>(500);
    const Real h = milli<Real>(300);
    BasicSpatialState<Real> start;
    const Real x = sin(cable) + h * sin(b);
    start.position = point<Real>(x, Real(0), -cos(cable) - h * cos(b));
    start.orientation = quaternion_of<Real>(point<Real>(Real(0), -b, Real(0)));
    start.velocity = point<Real>(Real(0), precession * x, Real(0));
    start.spin = rotated_back<Real>(start.orientation, point<Real>(Real(0), Real(0), precession));
    auto result = one_body<Real>(
        point<Real>(milli<Real>(across), milli<Real>(across), milli<Real>(along)), start);
    result.cables = {cable_in_space<Real>(point<Real>(Real(0), Real(0), h),
                                          point<Real>(Real(0), Real(0), Real(0)), Real(1),
                                          Real(Real(1) / 2))};
    result.duration = Real(7);
    return result;
  }
};

/// A spinning ball on a tether at its surface, thrown.
template <class Real>
[[nodiscard]] BasicSystem<Real, 3> tethered_ball() {
  BasicSpatialState<Real> start;
  start.position = point<Real>(milli<Real>(200), Real(0), milli<Real>(-300));
  start.velocity = point<Real>(milli<Real>(500), milli<Real>(400), milli<Real>(600));
  start.spin = point<Real>(Real(3), Real(-4), Real(12));
  auto result = one_body<Real>(point<Real>(milli<Real>(4), milli<Real>(4), milli<Real>(4)), start);
  result.cables = {cable_in_space<Real>(point<Real>(milli<Real>(100), Real(0), Real(0)),
                                        point<Real>(Real(0), Real(0), Real(0)), Real(1),
                                        milli<Real>(700))};
  result.duration = Real(6);
  return result;
}

/// A box that spins about its middle axis, in little gravity: it turns over in flight, again and
/// again, until its tether is taut.
template <class Real>
[[nodiscard]] BasicSystem<Real, 3> dzhanibekov() {
  BasicSpatialState<Real> start;
  start.position = point<Real>(Real(0), Real(0), milli<Real>(-400));
  start.velocity = point<Real>(milli<Real>(30), milli<Real>(10), milli<Real>(20));
  start.spin = point<Real>(milli<Real>(20), Real(6), milli<Real>(10));
  auto result = one_body<Real>(
      box<Real>(Real(1), point<Real>(milli<Real>(300), milli<Real>(200), milli<Real>(80))), start,
      milli<Real>(10));
  result.cables = {
      cable_in_space<Real>(point<Real>(milli<Real>(150), milli<Real>(100), milli<Real>(40)),
                           point<Real>(Real(0), Real(0), Real(0)), Real(1), milli<Real>(800))};
  result.duration = Real(40);
  return result;
}

/// A box of 1000 kg on four slings of a hook, the first one 5 cm short, let go level.
template <class Real>
[[nodiscard]] BasicSystem<Real, 3> crane_slings() {
  BasicSpatialState<Real> start;
  start.position.z() = milli<Real>(-1550);
  const auto sides = point<Real>(Real(2), Real(1), milli<Real>(500));
  auto result = one_body<Real>(box<Real>(Real(1000), sides), start, milli<Real>(9810));
  result.bodies[0].mass = Real(1000);
  const Real full = sqrt(milli<Real>(3500));
  for (const auto& [x, y] : {std::pair{1, 1}, {-1, 1}, {-1, -1}, {1, -1}}) {
    const Real length = result.cables.empty() ? Real(full - milli<Real>(50)) : full;
    result.cables.push_back(
        cable_in_space<Real>(point<Real>(Real(x), milli<Real>(500 * y), milli<Real>(250)),
                             point<Real>(Real(0), Real(0), Real(0)), length, milli<Real>(200)));
  }
  result.duration = Real(10);
  return result;
}

/// A platform of 20 kg on eight crossed cables of slightly unequal lengths, let go 2 cm above.
template <class Real>
[[nodiscard]] BasicSystem<Real, 3> parallel_robot() {
  BasicSpatialState<Real> start;
  start.position = point<Real>(milli<Real>(3), milli<Real>(-2), milli<Real>(-1380));
  start.orientation = quaternion_of<Real>(point<Real>(milli<Real>(12), milli<Real>(16), Real(0)));
  const auto sides = point<Real>(milli<Real>(500), milli<Real>(400), milli<Real>(300));
  auto result = one_body<Real>(box<Real>(Real(20), sides), start, milli<Real>(9810));
  result.bodies[0].mass = Real(20);
  const std::array<int, 8> longer{0, 40, 10, 60, 30, 20, 50, 15};  // [0.1 mm]
  for (const auto& [x, y] : {std::pair{1, 1}, {1, -1}, {-1, 1}, {-1, -1}}) {
    for (const int lower : {0, 1}) {
      const int sign = lower == 0 ? 1 : -1;
      const auto attachment = point<Real>(milli<Real>(250 * x * sign), milli<Real>(-200 * y * sign),
                                          milli<Real>(150 * sign));
      const auto anchor =
          point<Real>(Real(2 * x), milli<Real>(1500 * y), milli<Real>(-100 * lower));
      const BasicVector<Real, 3> along =
          point<Real>(Real(0), Real(0), milli<Real>(-1400)) + attachment - anchor;
      const Real length = along.norm() + Real(longer[result.cables.size()]) / 10000;
      result.cables.push_back(cable_in_space<Real>(attachment, anchor, length, milli<Real>(300)));
    }
  }
  result.duration = Real(5);
  return result;
}

}  // namespace tautline::test
