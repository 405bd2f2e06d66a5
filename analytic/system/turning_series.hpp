#pragma once

#include <algorithm>
#include <array>
#include <span>
#include <utility>
#include <vector>

#include "tautline/detail/series_impl.hpp"
#include "tautline/system.hpp"

// How one body turns, as Taylor series: what differs between the plane and space in the recurrence
// of series.cpp. A turn of order k is what changes the pose: in the plane coefficient k of the
// angle, in space coefficient k - 1 of the spin over k.

namespace tautline {
namespace series {

/// A polynomial of time, its coefficients in rising order.
template <class Real>
using Coefficients = std::vector<Real>;

/// Adds the product of two polynomials with all its terms: the power of waves has twice their
/// frequency, and its series would end too soon.
template <class Real>
void add_product(Coefficients<Real>& result, const Coefficients<Real>& a,
                 const Coefficients<Real>& b) {
  if (a.empty() || b.empty()) {
    return;
  }
  result.resize(std::max(result.size(), a.size() + b.size() - 1), Real(0));
  for (std::size_t i = 0; i < a.size(); ++i) {
    for (std::size_t j = 0; j < b.size(); ++j) {
      result[i + j] += a[i] * b[j];
    }
  }
}

/// The polynomial whose coefficient k is `coefficient(k)`, for k below `count`.
template <class Real, class Coefficient>
Coefficients<Real> polynomial(std::size_t count, const Coefficient& coefficient) {
  Coefficients<Real> result;
  result.reserve(count);
  for (std::size_t k = 0; k < count; ++k) {
    result.push_back(coefficient(k));
  }
  return result;
}

/// The rate of that polynomial.
template <class Real, class Coefficient>
Coefficients<Real> rate_of(std::size_t count, const Coefficient& coefficient) {
  return polynomial<Real>(count - 1,
                          [&](std::size_t k) { return Real(number(k + 1) * coefficient(k + 1)); });
}

/// The integral of that polynomial from 0 to `end`.
template <class Real>
[[nodiscard]] Real integral(std::span<const Real> coefficients, const Real& end) {
  Real result(0);
  for (std::size_t k = coefficients.size(); k-- > 0;) {
    result = result * end + coefficients[k] / number(k + 1);
  }
  return result * end;
}

/// A unit of time in which series up to `end` [s] are multiplied: coefficients per second^k of a
/// short arc are so large that a product of two overflows. It is a power of two, so that nothing is
/// rounded.
template <class Real>
class TimeUnit {
 public:
  explicit TimeUnit(const Real& end) : end_(end) {
    using std::frexp;
    (void)frexp(end, &doublings_);
  }

  /// Coefficient k in this unit, from that per second^k.
  [[nodiscard]] Real of(const Real& coefficient, std::size_t k) const {
    return scaled(coefficient, static_cast<int>(k));
  }

  /// The rate per second, in this unit, of the polynomial whose coefficient k is `coefficient(k)`
  /// per second^k, for k below `count`.
  template <class Coefficient>
  [[nodiscard]] Coefficients<Real> rate_of(std::size_t count,
                                           const Coefficient& coefficient) const {
    return polynomial<Real>(
        count - 1, [&](std::size_t k) { return Real(number(k + 1) * of(coefficient(k + 1), k)); });
  }

  /// The integral over seconds, from 0 to the end, of a polynomial in this unit.
  [[nodiscard]] Real integral(std::span<const Real> coefficients) const {
    return scaled(series::integral<Real>(coefficients, scaled(end_, -1)), 1);
  }

 private:
  [[nodiscard]] Real scaled(const Real& value, int units) const {
    using std::ldexp;
    return Real(ldexp(value, units * doublings_));
  }

  Real end_;
  int doublings_ = 0;  // of a second: more than the end, at most twice of it
};

}  // namespace series

template <class Real, int D>
class TurningSeries;

/// In the plane: the angle, and the heading, the direction of the body's first axis.
template <class Real>
class TurningSeries<Real, 2> {
 public:
  using Vector = BasicVector<Real, 2>;       // of the world
  using Turn = BasicTurn<Real, 2>;           // one number
  using Body = BasicBodyOfSystem<Real, 2>;   // that turns
  static constexpr std::size_t numbers = 7;  // for each order

  /// Takes `numbers` zeros for each of `terms` orders from `next` on.
  void make(Real*& next, std::size_t terms) {
    for (Points<Real>* points : {&heading_, &turn_, &moment_}) {
      *points = Points<Real>(next);
      next += 2 * terms;
    }
    angle_ = next;
    next += terms;
  }

  /// Sets what the state gives. `given` is the moment over time; empty: none.
  void start(const Body& body, const BasicState<Real>& now, std::vector<Turn> given) {
    body_ = &body;
    given_ = std::move(given);
    const auto [cosine, sine] = heading(now.angle);
    heading_[0] = Vector(cosine, sine);
    set_angle(0, now.angle);
    set_angle(1, now.spin);
    heading_[1] = turned(1);
  }

  /// False for a point mass.
  [[nodiscard]] bool turns() const { return body_->inertia > 0; }

  /// Prepares order k + 2: all but the turn of that order.
  void begin(std::size_t k) {
    if (turns()) {
      heading_[k + 2] = turned(k + 2);
    }
  }

  /// Order k + 2 where nothing gives a moment.
  void coast(std::size_t k) {
    if (turns()) {
      heading_[k + 2] =
          perpendicular<Real>(heading_[k + 1]) * Real(angle_[1] / series::number(k + 2));
    }
  }

  /// Coefficient k of the point `at` of the body, from its centre in world axes.
  [[nodiscard]] Vector arm(const Vector& at, std::size_t k) const {
    return series::in_the_world<Real>(at, heading_[k]);
  }

  /// How a small `turn` at the start moves that point.
  [[nodiscard]] Vector swept(const Vector& at, const Turn& turn) const {
    return turn[0] * perpendicular<Real>(arm(at, 0));
  }

  /// Adds the moment of coefficient k of a `force` at the point `at`.
  void add_moment(const Vector& at, const Vector& force, std::size_t k) {
    moment_[k] += series::moment<Real>(at, force);
  }

  /// Coefficient k of the moment that is known [N m]; `pulled`: by cables, too.
  [[nodiscard]] Turn torque(std::size_t k, bool pulled) const {
    Real torque(0);
    if (turns()) {
      torque = -body_->spin_drag * series::number(k + 1) * angle_[k + 1];
      torque += pulled ? Real(series::products(heading_, moment_, k, 0, k + 1).sum()) : Real(0);
      torque += given_.empty() ? Real(0) : given_[k][0];
    }
    return Turn(torque);
  }

  /// Sets the turn of order k + 2.
  void turn(std::size_t k, const Turn& turn) {
    if (turns()) {
      set_angle(k + 2, turn[0]);
      heading_[k + 2] += turn[0] * perpendicular<Real>(heading_[0]);
    }
  }

  /// The turn of order k.
  [[nodiscard]] Turn turn_of(std::size_t k) const { return Turn(angle_[k]); }

  /// The size of order k, against a radian.
  [[nodiscard]] Real size(std::size_t k) const { return abs(angle_[k]); }

  /// A number that is finite while those of order k are.
  [[nodiscard]] Real sum(std::size_t k) const { return angle_[k]; }

  /// Calls `limit` with what else must be small in order k, its scale and its order.
  template <class Limit>
  void limit_reach(std::size_t /*k*/, const Limit& /*limit*/) const {}

  /// Writes order k of what an arc has of it; `last`: the highest one.
  template <class Row>
  void write(std::size_t k, std::size_t /*last*/, Row&& row) const {
    row[0] = angle_[k];
  }

  /// Adds the power of moment and drag [W] in `unit`; `last`: the highest order.
  void add_power(std::size_t last, const series::TimeUnit<Real>& unit,
                 series::Coefficients<Real>& result) const {
    const auto spin = unit.rate_of(last + 1, [&](std::size_t k) { return angle_[k]; });
    const auto moment = series::polynomial<Real>(last, [&](std::size_t k) {
      const Real given = given_.empty() ? Real(0) : unit.of(given_[k][0], k);
      return Real(given - body_->spin_drag * spin[k]);
    });
    series::add_product(result, moment, spin);
  }

 private:
  void set_angle(std::size_t k, const Real& value) {
    angle_[k] = value;
    turn_[k].setConstant(Real(value * series::number(k)));
  }

  /// Coefficient k of the heading; for k > 1 without the term of the angle's own.
  [[nodiscard]] Vector turned(std::size_t k) const {
    const std::size_t end = k > 1 ? k : k + 1;
    return perpendicular<Real>(series::products(turn_, heading_, k, 1, end)) / series::number(k);
  }

  const Body* body_ = nullptr;
  Points<Real> heading_;  // cosine and sine of the angle
  Points<Real> turn_;     // k times the angle's coefficient k, twice
  Points<Real> moment_;   // of all pulls, in the body's axes: heading . moment is the torque
  Real* angle_ = nullptr;
  std::vector<Turn> given_;  // moment [N m]; empty: none
};

/// In space: the quaternion, the spin, and the axes of the body in the world, which are quadratic
/// in the quaternion (S3).
template <class Real>
class TurningSeries<Real, 3> {
 public:
  using Vector = BasicVector<Real, 3>;      // of the world
  using Turn = BasicTurn<Real, 3>;          // in the axes of the body
  using Body = BasicBodyOfSystem<Real, 3>;  // that turns
  static constexpr std::size_t numbers = Points<Real, 4>::stride + 9 * Points<Real, 3>::stride;

  /// Takes `numbers` zeros for each of `terms` orders from `next` on.
  void make(Real*& next, std::size_t terms) {
    orientation_ = Points<Real, 4>(next);
    next += Points<Real, 4>::stride * terms;
    for (auto* points : {&spin_, &spin_next_, &spin_last_, axis_.data(), &axis_[1], &axis_[2],
                         moment_.data(), &moment_[1], &moment_[2]}) {
      *points = Points<Real, 3>(next);
      next += Points<Real, 3>::stride * terms;
    }
  }

  /// Sets what the state gives. `given` is the moment over time, in the world; empty: none.
  void start(const Body& body, const BasicSpatialState<Real>& now, std::vector<Turn> given) {
    body_ = &body;
    given_ = std::move(given);
    const Vector& inertia = body.inertia;
    turns_ = has_inertia(inertia);
    gyration_ =
        Vector(inertia.y() - inertia.z(), inertia.z() - inertia.x(), inertia.x() - inertia.y());
    orientation_[0] = now.orientation;
    set_spin(0, now.spin);
    expand_axes(0);
    if (turns_) {
      orientation_[1] = turned(1, 1);
      expand_axes(1);
    }
    steady_ = gyroscopic(0).isZero(0);
  }

  /// False for a point mass.
  [[nodiscard]] bool turns() const { return turns_; }

  /// Prepares order k + 2: all but the turn of that order.
  void begin(std::size_t k) {
    if (turns_) {
      orientation_[k + 2] = turned(k + 2, k + 1);
      expand_axes(k + 2);
    }
  }

  /// Order k + 2 where nothing gives a moment.
  void coast(std::size_t k) {
    if (!turns_) {
      return;
    }
    if (!steady_) {
      begin(k);
      return turn(k, Turn(gyroscopic(k).cwiseQuotient(body_->inertia) /
                          Real(series::number((k + 1) * (k + 2)))));
    }
    const Vector spin = spin_[0] / Real(series::number(k + 2));
    orientation_[k + 2] = half_product(orientation_[k + 1], spin);
    add_turned_axes(k + 1, spin, k + 2);
  }

  /// Coefficient k of the point `at` of the body, from its centre in world axes.
  [[nodiscard]] Vector arm(const Vector& at, std::size_t k) const {
    return at.x() * axis_[0][k] + at.y() * axis_[1][k] + at.z() * axis_[2][k];
  }

  /// How a small `turn` at the start moves that point.
  [[nodiscard]] Vector swept(const Vector& at, const Turn& turn) const {
    return arm(turn.cross(at), 0);
  }

  /// Adds the moment of coefficient k of a `force` at the point `at`.
  void add_moment(const Vector& at, const Vector& force, std::size_t k) {
    for (std::size_t i = 0; i < 3; ++i) {
      moment_[i][k] += at[static_cast<Eigen::Index>(i)] * force;
    }
  }

  /// Coefficient k of the moment that is known [N m]; `pulled`: by cables, too.
  [[nodiscard]] Turn torque(std::size_t k, bool pulled) const {
    Turn torque = Turn::Zero();
    if (!turns_) {
      return torque;
    }
    torque = gyroscopic(k) - body_->spin_drag * spin_[k];
    if (pulled) {
      torque += moment_of_pulls(k);
    }
    for (std::size_t j = 0; !given_.empty() && j <= k; ++j) {
      for (std::size_t i = 0; i < 3; ++i) {
        torque[static_cast<Eigen::Index>(i)] += axis_[i][j].dot(given_[k - j]);
      }
    }
    return torque;
  }

  /// Sets the turn of order k + 2.
  void turn(std::size_t k, const Turn& turn) {
    if (turns_) {
      set_spin(k + 1, Real(series::number(k + 2)) * turn);
      orientation_[k + 2] += half_product(orientation_[0], turn);
      add_turned_axes(0, turn, k + 2);
    }
  }

  /// The turn of order k, at least 1.
  [[nodiscard]] Turn turn_of(std::size_t k) const { return spin_[k - 1] / Real(series::number(k)); }

  /// The size of order k, against a radian.
  [[nodiscard]] Real size(std::size_t k) const {
    Real result =
        max(Real(orientation_[k].cwiseAbs().maxCoeff()), Real(turn_of(k).cwiseAbs().maxCoeff()));
    for (const Points<Real, 3>& axis : axis_) {
      result = max(result, Real(axis[k].cwiseAbs().maxCoeff()));
    }
    return result;
  }

  /// A number that is finite while those of order k are.
  [[nodiscard]] Real sum(std::size_t k) const {
    return orientation_[k].sum() + (k > 0 ? Real(spin_[k - 1].sum()) : Real(0));
  }

  /// Calls `limit` with what else must be small in order k, its scale and its order: the spin.
  template <class Limit>
  void limit_reach(std::size_t k, const Limit& limit) const {
    const Real scale = max(Real(spin_[0].norm()), Real(sqrt(Real(spin_[1].norm()))));
    limit(Real(spin_[k - 1].cwiseAbs().maxCoeff()), scale, k - 1);
  }

  /// Writes order k of what an arc has of it; `last`: the highest one.
  template <class Row>
  void write(std::size_t k, std::size_t last, Row&& row) const {
    row.template head<4>() = orientation_[k].transpose();
    row.template tail<3>().setZero();
    if (k < last) {
      row.template tail<3>() = spin_[k].transpose();
    }
  }

  /// Adds the power of moment and drag [W] in `unit`; `last`: the highest order.
  void add_power(std::size_t last, const series::TimeUnit<Real>& unit,
                 series::Coefficients<Real>& result) const {
    using Coefficients = series::Coefficients<Real>;
    std::array<Coefficients, 3> spin;
    for (std::size_t i = 0; i < 3; ++i) {
      const auto number = static_cast<Eigen::Index>(i);
      spin[i] = series::polynomial<Real>(
          last, [&](std::size_t k) { return unit.of(spin_[k][number], k); });
      const Coefficients drag = series::polynomial<Real>(
          last, [&](std::size_t k) { return Real(-body_->spin_drag * spin[i][k]); });
      series::add_product(result, drag, spin[i]);
    }
    for (Eigen::Index row = 0; !given_.empty() && row < 3; ++row) {
      Coefficients in_world;  // the spin about an axis of the world
      for (std::size_t i = 0; i < 3; ++i) {
        const Coefficients part = series::polynomial<Real>(
            last + 1, [&](std::size_t k) { return unit.of(axis_[i][k][row], k); });
        series::add_product(in_world, part, spin[i]);
      }
      const Coefficients moment =
          series::polynomial<Real>(last, [&](std::size_t k) { return unit.of(given_[k][row], k); });
      series::add_product(result, moment, in_world);
    }
  }

 private:
  void set_spin(std::size_t k, const Vector& spin) {
    spin_[k] = spin;
    spin_next_[k] = Vector(spin.y(), spin.z(), spin.x());
    spin_last_[k] = Vector(spin.z(), spin.x(), spin.y());
  }

  /// Half of the product of q and (0, v) (S2).
  [[nodiscard]] static BasicQuaternion<Real> half_product(const BasicQuaternion<Real>& q,
                                                          const Vector& v) {
    BasicQuaternion<Real> result;
    result << -(q[1] * v[0] + q[2] * v[1] + q[3] * v[2]), q[0] * v[0] + q[2] * v[2] - q[3] * v[1],
        q[0] * v[1] + q[3] * v[0] - q[1] * v[2], q[0] * v[2] + q[1] * v[1] - q[2] * v[0];
    return result / Real(2);
  }

  /// Coefficient k of the quaternion from those before it and from spins below `end`.
  [[nodiscard]] BasicQuaternion<Real> turned(std::size_t k, std::size_t end) const {
    std::array<series::SumOfProducts<Real, 4>, 3> sums;  // of a number of the spin times q
    for (std::size_t j = 0; j < end; ++j) {
      const Real* const spin = spin_.data(j);
      const Real* const q = orientation_.data(k - 1 - j);
      sums[0].add_times(spin[0], q);
      sums[1].add_times(spin[1], q);
      sums[2].add_times(spin[2], q);
    }
    const BasicQuaternion<Real> x = sums[0].point();
    const BasicQuaternion<Real> y = sums[1].point();
    const BasicQuaternion<Real> z = sums[2].point();
    BasicQuaternion<Real> result;
    result << -(x[1] + y[2] + z[3]), x[0] + z[2] - y[3], y[0] + x[3] - z[1], z[0] + y[1] - x[2];
    return result / Real(series::number(2 * k));
  }

  /// Coefficient k of the axes from quaternions up to k.
  void expand_axes(std::size_t k) {
    std::array<series::SumOfProducts<Real, 4>, 4> sums;  // of a number of q times q: half of it
    for (std::size_t j = 0; 2 * j < k; ++j) {
      const Real* const one = orientation_.data(j);
      const Real* const other = orientation_.data(k - j);
      for (std::size_t i = 0; i < 4; ++i) {
        sums[i].add_times(one[i], other);
      }
    }
    Eigen::Matrix<Real, 4, 4> half;
    for (Eigen::Index i = 0; i < 4; ++i) {
      half.col(i) = sums[static_cast<std::size_t>(i)].point();
    }
    Eigen::Matrix<Real, 4, 4> s = half + half.transpose();
    if (k % 2 == 0) {
      const BasicQuaternion<Real> middle = orientation_[k / 2];
      s += middle * middle.transpose();
    }
    const Real less = s(0, 0) - s(1, 1);
    axis_[0][k] = Vector(s(0, 0) + s(1, 1) - s(2, 2) - s(3, 3), 2 * (s(1, 2) + s(0, 3)),
                         2 * (s(1, 3) - s(0, 2)));
    axis_[1][k] =
        Vector(2 * (s(1, 2) - s(0, 3)), less + s(2, 2) - s(3, 3), 2 * (s(2, 3) + s(0, 1)));
    axis_[2][k] =
        Vector(2 * (s(1, 3) + s(0, 2)), 2 * (s(2, 3) - s(0, 1)), less - s(2, 2) + s(3, 3));
  }

  /// Adds order `from` of the axes, turned by `turn`, to order k.
  void add_turned_axes(std::size_t from, const Turn& turn, std::size_t k) {
    axis_[0][k] += axis_[1][from] * turn.z() - axis_[2][from] * turn.y();
    axis_[1][k] += axis_[2][from] * turn.x() - axis_[0][from] * turn.z();
    axis_[2][k] += axis_[0][from] * turn.y() - axis_[1][from] * turn.x();
  }

  /// Coefficient k of (I spin) x spin.
  [[nodiscard]] Vector gyroscopic(std::size_t k) const {
    if (gyration_.isZero(0)) {
      return Vector::Zero();
    }
    return gyration_.cwiseProduct(series::products(spin_next_, spin_last_, k, 0, k + 1));
  }

  /// Coefficient k of the moment of all pulls, in the axes of the body.
  [[nodiscard]] Vector moment_of_pulls(std::size_t k) const {
    std::array<series::SumOfProducts<Real, 3>, 3> sums;
    for (std::size_t j = 0; j <= k; ++j) {
      const Real* const x = axis_[0].data(k - j);
      const Real* const y = axis_[1].data(k - j);
      const Real* const z = axis_[2].data(k - j);
      sums[0].add(moment_[1].data(j), z);
      sums[0].subtract(moment_[2].data(j), y);
      sums[1].add(moment_[2].data(j), x);
      sums[1].subtract(moment_[0].data(j), z);
      sums[2].add(moment_[0].data(j), y);
      sums[2].subtract(moment_[1].data(j), x);
    }
    return {sums[0].point().sum(), sums[1].point().sum(), sums[2].point().sum()};
  }

  const Body* body_ = nullptr;
  bool turns_ = false;
  bool steady_ = true;  // its spin stays where nothing gives a moment
  Vector gyration_;     // differences of the moments of inertia [kg m^2]
  Points<Real, 4> orientation_;
  Points<Real, 3> spin_;
  Points<Real, 3> spin_next_;              // its numbers as y, z, x
  Points<Real, 3> spin_last_;              // and as z, x, y
  std::array<Points<Real, 3>, 3> axis_;    // of the body, in the world
  std::array<Points<Real, 3>, 3> moment_;  // all pulls, times each coordinate of where they act
  std::vector<Turn> given_;                // moment in the world [N m]; empty: none
};

}  // namespace tautline
