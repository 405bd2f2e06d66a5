#pragma once

// Numbers that carry their derivatives along, with respect to the six numbers of a state: what is
// computed from them has its exact derivative. Only what geometry.hpp and series.hpp need.

#include <Eigen/Core>
#include <concepts>

#include "tautline/case.hpp"
#include "tautline/detail/scalar.hpp"

namespace tautline {

/// A number and its derivatives with respect to x, y, angle, x velocity, y velocity and spin.
template <class Real>
struct Dual {
  using Slopes = Eigen::Matrix<Real, 6, 1>;

  Dual() : value(0), slopes(Slopes::Zero()) {}
  template <class Number>
  requires std::convertible_to<Number, Real> Dual(const Number& constant)
      : value(constant), slopes(Slopes::Zero()) {}  // implicit, as numbers
  Dual(Real the_value, Slopes the_slopes)
      : value(std::move(the_value)), slopes(std::move(the_slopes)) {}

  Real value;
  Slopes slopes;

  Dual& operator+=(const Dual& b) {
    value += b.value;
    slopes += b.slopes;
    return *this;
  }
  Dual& operator-=(const Dual& b) {
    value -= b.value;
    slopes -= b.slopes;
    return *this;
  }
  Dual& operator*=(const Dual& b) {
    slopes = slopes * b.value + value * b.slopes;
    value *= b.value;
    return *this;
  }
  Dual& operator/=(const Dual& b) {
    value /= b.value;
    slopes = (slopes - value * b.slopes) / b.value;
    return *this;
  }
  friend Dual operator+(Dual a, const Dual& b) { return a += b; }
  friend Dual operator-(Dual a, const Dual& b) { return a -= b; }
  friend Dual operator*(Dual a, const Dual& b) { return a *= b; }
  friend Dual operator/(Dual a, const Dual& b) { return a /= b; }
  friend Dual operator-(const Dual& a) { return {-a.value, -a.slopes}; }

  friend bool operator<(const Dual& a, const Dual& b) { return a.value < b.value; }
  friend bool operator>(const Dual& a, const Dual& b) { return a.value > b.value; }
  friend bool operator<=(const Dual& a, const Dual& b) { return a.value <= b.value; }
  friend bool operator>=(const Dual& a, const Dual& b) { return a.value >= b.value; }
  friend bool operator==(const Dual& a, const Dual& b) { return a.value == b.value; }
  friend bool operator!=(const Dual& a, const Dual& b) { return a.value != b.value; }

  friend Dual abs(const Dual& a) { return a.value < 0 ? -a : a; }
  friend Dual sqrt(const Dual& a) {
    const Real root = sqrt(a.value);
    return {root, a.slopes / (2 * root)};
  }
  friend Dual sin(const Dual& a) { return {sin(a.value), a.slopes * cos(a.value)}; }
  friend Dual cos(const Dual& a) { return {cos(a.value), -a.slopes * sin(a.value)}; }
};

/// `cable` for calculations with duals; its numbers are constants.
template <class Number, class Real>
[[nodiscard]] BasicCable<Number> lifted(const BasicCable<Real>& cable) {
  BasicCable<Number> result{cable.anchor.template cast<Number>(),
                            cable.attachment.template cast<Number>(),
                            Number(cable.length),
                            Number(cable.restitution),
                            Number(cable.capture_speed),
                            {}};
  for (const BasicRestitutionPoint<Real>& point : cable.restitution_table) {
    result.restitution_table.push_back({Number(point.speed), Number(point.restitution)});
  }
  return result;
}

/// `the_case` for calculations with duals, with `cables` alone.
template <class Number, class Real>
[[nodiscard]] BasicCase<Number> lifted(const BasicCase<Real>& the_case, CableSet cables) {
  BasicCase<Number> result;
  result.body = {Number(the_case.body.mass), Number(the_case.body.inertia)};
  result.cables.reserve(cables.size());
  for (const std::size_t index : cables) {
    result.cables.push_back(lifted<Number>(the_case.cables[index]));
  }
  result.gravity = the_case.gravity.template cast<Number>();
  return result;
}

/// The same with all cables.
template <class Number, class Real>
[[nodiscard]] BasicCase<Number> lifted(const BasicCase<Real>& the_case) {
  CableSet all;
  for (std::size_t index = 0; index < the_case.cables.size(); ++index) {
    all.insert(index);
  }
  return lifted<Number>(the_case, all);
}

/// `state` as the point at which to differentiate: its six numbers are the variables.
template <class Real>
[[nodiscard]] BasicState<Dual<Real>> variables(const BasicState<Real>& state) {
  using Number = Dual<Real>;
  const auto variable = [](const Real& value, Eigen::Index axis) {
    return Number(value, Number::Slopes::Unit(axis));
  };
  return {{variable(state.position.x(), 0), variable(state.position.y(), 1)},
          variable(state.angle, 2),
          {variable(state.velocity.x(), 3), variable(state.velocity.y(), 4)},
          variable(state.spin, 5)};
}

}  // namespace tautline

namespace Eigen {

template <class Real>
struct NumTraits<tautline::Dual<Real>> : GenericNumTraits<tautline::Dual<Real>> {
  enum {
    RequireInitialization = 1,
    ReadCost = 7 * static_cast<int>(NumTraits<Real>::ReadCost),
    AddCost = 7 * static_cast<int>(NumTraits<Real>::AddCost),
    MulCost = 13 * static_cast<int>(NumTraits<Real>::MulCost),
  };
};

}  // namespace Eigen
