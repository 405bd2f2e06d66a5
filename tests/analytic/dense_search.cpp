#include "dense_search.hpp"

#include <algorithm>
#include <cmath>

namespace tautline::test {
namespace {

using Real = long double;

/// Squared distance between the ends of cable 0, and its derivative, along a flight.
class SquaredDistance {
 public:
  explicit SquaredDistance(const Case& the_case)
      : state_(the_case.initial), cable_(the_case.cables.front()), gravity_(the_case.gravity) {}

  struct Value {
    Real square;
    Real rate;
  };

  [[nodiscard]] Value at(Real t) const {
    const Real angle = state_.angle + t * static_cast<Real>(state_.spin);
    return with(t, std::cos(angle), std::sin(angle));
  }

  /// For the samples, where turning by a constant angle replaces sine and cosine.
  [[nodiscard]] Value with(Real t, Real c, Real s) const {
    const Real px = cable_.attachment.x();
    const Real py = cable_.attachment.y();
    const Real gx = gravity_.x();
    const Real gy = gravity_.y();
    const Real spin = state_.spin;
    const Real ax = c * px - s * py;
    const Real ay = s * px + c * py;
    const Real dx = state_.position.x() + t * (state_.velocity.x() + t * gx / 2) + ax -
                    static_cast<Real>(cable_.anchor.x());
    const Real dy = state_.position.y() + t * (state_.velocity.y() + t * gy / 2) + ay -
                    static_cast<Real>(cable_.anchor.y());
    const Real vx = state_.velocity.x() + t * gx - spin * ay;
    const Real vy = state_.velocity.y() + t * gy + spin * ax;
    return {dx * dx + dy * dy, 2 * (dx * vx + dy * vy)};
  }

  [[nodiscard]] Real length() const { return cable_.length; }
  [[nodiscard]] const State& state() const { return state_; }

 private:
  const State& state_;
  const Cable& cable_;
  const Vec2& gravity_;
};

constexpr int bisections = 70;  // of a sample interval: to the last bit of a long double

/// The maximum of the squared distance in (low, high), where its rate goes from + to -.
Real maximum_between(const SquaredDistance& f, Real low, Real high) {
  for (int k = 0; k < bisections; ++k) {
    const Real middle = (low + high) / 2;
    (f.at(middle).rate > 0 ? low : high) = middle;
  }
  return low;
}

/// The crossing of `level` in (low, high], where the squared distance goes from below to above.
Real crossing_between(const SquaredDistance& f, Real level, Real low, Real high) {
  for (int k = 0; k < bisections; ++k) {
    const Real middle = (low + high) / 2;
    (f.at(middle).square < level ? low : high) = middle;
  }
  return high;
}

/// Calls visit(low, high, value at low, value at high) on each interval until it returns true.
template <class Visit>
void walk(const SquaredDistance& f, double horizon, int intervals, Visit visit) {
  const Real dt = static_cast<Real>(horizon) / intervals;
  const Real turn = dt * static_cast<Real>(f.state().spin);
  const Real turn_c = std::cos(turn);
  const Real turn_s = std::sin(turn);
  Real c = std::cos(static_cast<Real>(f.state().angle));
  Real s = std::sin(static_cast<Real>(f.state().angle));
  SquaredDistance::Value now = f.with(0, c, s);
  for (int k = 0; k < intervals; ++k) {
    const Real next_c = c * turn_c - s * turn_s;
    s = s * turn_c + c * turn_s;
    c = next_c;
    const SquaredDistance::Value next = f.with((k + 1) * dt, c, s);
    if (visit(k * dt, (k + 1) * dt, now, next)) {
      return;
    }
    now = next;
  }
}

}  // namespace

std::optional<DenseContact> dense_first_contact(const Case& the_case, double horizon,
                                                int intervals) {
  const SquaredDistance f(the_case);
  const Real level = f.length() * f.length();
  std::optional<DenseContact> found;
  walk(f, horizon, intervals, [&](Real low, Real high, const auto& from, const auto& to) {
    Real above = high;
    if (to.square < level) {
      if (!(from.rate > 0 && to.rate < 0)) {
        return false;
      }
      above = maximum_between(f, low, high);
      if (f.at(above).square < level) {
        return false;
      }
    }
    const Real time = crossing_between(f, level, low, above);
    const Real closing = f.at(time).rate / (2 * f.length());
    found = {static_cast<double>(time), static_cast<double>(closing)};
    return true;
  });
  return found;
}

std::optional<Farthest> first_farthest(const Case& the_case, double horizon, int intervals) {
  const SquaredDistance f(the_case);
  std::optional<Farthest> found;
  const Real start = f.at(0).square;
  walk(f, horizon, intervals, [&](Real low, Real high, const auto& from, const auto& to) {
    if (!(from.rate > 0 && to.rate < 0)) {
      return false;
    }
    const Real time = maximum_between(f, low, high);
    const Real square = f.at(time).square;
    const Real dt = 1e-6L;  // second difference of the rate: good to 1e-10, ample for a shape
    const Real bend = (f.at(time - dt).rate - f.at(time + dt).rate) / (2 * dt);
    const Real distance = std::sqrt(square);
    if (square <= start) {
      return false;
    }
    found = {static_cast<double>(time), static_cast<double>(distance),
             static_cast<double>(bend / (2 * distance))};
    return true;
  });
  return found;
}

long double precise_gap(const Case& the_case, double time) {
  const SquaredDistance f(the_case);
  return f.length() - std::sqrt(f.at(time).square);
}

}  // namespace tautline::test
