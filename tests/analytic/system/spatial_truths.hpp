#pragma once

#include <algorithm>
#include <array>
#include <string>
#include <utility>
#include <vector>

#include "system/spatial_systems.hpp"
#include "tautline/solve.hpp"

// The motions of spatial_systems.hpp in closed form, and by how much the solver differs, in numbers
// of any kind. Nothing here is of the solver.

namespace tautline::test {

/// The integral of `f` from `low` to `high`, by the double exponential rule to all digits of a
/// function that is smooth between.
template <class Real, class Function>
[[nodiscard]] Real integral(const Real& low, const Real& high, const Function& f) {
  const Real half = (high - low) / 2;
  const int steps = epsilon<Real>() > Real(1e-20) ? 8 : 32;  // for each unit
  const Real step = Real(1) / steps;
  Real sum(0);
  for (int k = -4 * steps; k <= 4 * steps; ++k) {
    const Real up = exp(Real(k * step));
    const Real grown = exp(Real(pi<Real>() / 2 * (up - 1 / up)));  // of twice the argument of tanh
    const Real place = grown / (1 + grown);                        // 0 to 1
    const Real weight = pi<Real>() / 2 * (up + 1 / up) * place / (1 + grown);
    sum += weight * f(Real(low + 2 * half * place));
  }
  return sum * 2 * half * step;
}

/// The root of `f` between `low` and `high`, where it changes its sign; to all digits.
template <class Real, class Function>
[[nodiscard]] Real root_of(Real low, Real high, const Function& f) {
  const bool falls = f(low) > 0;
  for (int k = 0; k < 400; ++k) {
    const Real middle = (low + high) / 2;
    if (!(low < middle && middle < high)) {
      break;
    }
    ((f(middle) > 0) == falls ? low : high) = middle;
  }
  return high;
}

/// What an impact on one straight cable does, Newton's law in the words of mechanics.
template <class Real>
struct Blow {
  Real speed;    // [m/s], at which it closes
  Real impulse;  // [N s]
  BasicSpatialState<Real> after;
};
template <class Real>
[[nodiscard]] Blow<Real> blow(const BasicSystem<Real, 3>& system,
                              const BasicSpatialState<Real>& before) {
  const auto& body = system.bodies[0];
  const auto& cable = system.cables[0];
  const auto u = BasicVector<Real, 3>(
      (before.position + rotated<Real>(before.orientation, cable.from.at) - cable.to.at)
          .normalized());
  const BasicVector<Real, 3> arm = cable.from.at.cross(rotated_back<Real>(before.orientation, u));
  const Real speed = u.dot(before.velocity) + arm.dot(before.spin);
  const Real response = 1 / body.mass + arm.dot(arm.cwiseQuotient(body.inertia));
  Blow<Real> result{speed, Real((1 + cable.restitution) * speed / response), before};
  result.after.velocity -= Real(result.impulse / body.mass) * u;
  result.after.spin -= result.impulse * arm.cwiseQuotient(body.inertia);
  return result;
}

/// sn, cn and dn of u, where 1 - m is `complement`.
template <class Real>
[[nodiscard]] std::array<Real, 3> jacobi(const Real& u, const Real& complement) {
  std::vector<Real> a{Real(1)};
  std::vector<Real> c{Real(sqrt(Real(1 - complement)))};
  Real b = sqrt(complement);
  double doubled = 1.0;
  while (abs(c.back()) > epsilon<Real>() && a.size() < 40) {
    const Real mean = (a.back() + b) / 2;
    c.push_back((a.back() - b) / 2);
    b = sqrt(Real(a.back() * b));
    a.push_back(mean);
    doubled *= 2.0;
  }
  Real angle = doubled * a.back() * u;
  Real last = angle;
  for (std::size_t n = a.size() - 1; n > 0; --n) {
    last = angle;
    angle = (angle + asin(Real(c[n] / a[n] * sin(angle)))) / 2;
  }
  return {sin(angle), cos(angle), Real(cos(angle) / cos(Real(last - angle)))};
}

/// A body that flies free of moments: Euler's solution, with the turn about its angular momentum
/// as an integral. `start` turns near its middle axis; axes 0, 1, 2 have rising moments.
template <class Real>
class FreeRotation {
 public:
  using Vector = BasicVector<Real, 3>;

  FreeRotation(const Vector& inertia, const BasicSpatialState<Real>& start)
      : inertia_(inertia), spin_(start.spin), momentum_(inertia.cwiseProduct(start.spin)) {
    const auto difference = [&](Eigen::Index i, Eigen::Index j) {
      return Real(inertia[i] - inertia[j]);
    };
    const auto excess = [&](Eigen::Index axis) {  // L^2 - 2 E times the moment of an axis
      Real sum(0);
      for (Eigen::Index i = 0; i < 3; ++i) {
        sum += inertia[i] * difference(i, axis) * spin_[i] * spin_[i];
      }
      return sum;
    };
    if (excess(1) < 0) {  // it goes round the axis of the smallest moment
      std::swap(first_, last_);
    }
    const Real of_first = excess(first_);
    const Real of_last = excess(last_);
    size_ = {Real(sqrt(Real(of_last / (inertia[first_] * difference(first_, last_))))),
             Real(sqrt(Real(of_last / (inertia[1] * difference(1, last_))))),
             Real(sqrt(Real(of_first / (inertia[last_] * difference(last_, first_)))))};
    size_[2] = copysign(size_[2], spin_[last_]);
    const int cyclic = first_ == 0 ? 1 : -1;
    size_[1] *= cyclic * difference(1, last_) * size_[2] > 0 ? -1 : 1;
    rate_ = sqrt(Real(of_first * difference(last_, 1) / (inertia[0] * inertia[1] * inertia[2])));
    complement_ = difference(last_, first_) * excess(1) / (of_first * difference(last_, 1));
    at_start_ = {Real(spin_[1] / size_[1]), Real(spin_[first_] / size_[0]),
                 Real(spin_[last_] / size_[2])};
    axes_ = world_axes(start);
  }

  /// The spin at `time`, by the addition theorem.
  [[nodiscard]] Vector spin(const Real& time) const {
    const auto [s1, c1, d1] = at_start_;
    const auto [s2, c2, d2] = jacobi<Real>(Real(rate_ * time), complement_);
    const Real m = 1 - complement_;
    const Real below = c1 * c1 + s1 * s1 * c2 * c2 + complement_ * s1 * s1 * s2 * s2;
    Vector result;
    result[1] = size_[1] * (s1 * c2 * d2 + s2 * c1 * d1) / below;
    result[first_] = size_[0] * (c1 * c2 - s1 * d1 * s2 * d2) / below;
    result[last_] = size_[2] * (d1 * d2 - m * s1 * c1 * s2 * c2) / below;
    return result;
  }

  /// The turn from the axes of the body to those of the world at `time`, as a matrix.
  [[nodiscard]] Eigen::Matrix<Real, 3, 3> orientation(const Real& time) const {
    Real angle(0);
    const int parts = 1 + static_cast<int>(4.0 * static_cast<double>(time));
    for (int k = 0; k < parts; ++k) {
      angle += integral<Real>(Real(time * k / parts), Real(time * (k + 1) / parts),
                              [&](const Real& t) { return precession(t); });
    }
    const Real cosine = cos(angle);
    const Real sine = sin(angle);
    Eigen::Matrix<Real, 3, 3> turned = axes_;
    turned.col(1) = cosine * axes_.col(1) + sine * axes_.col(2);
    turned.col(2) = cosine * axes_.col(2) - sine * axes_.col(1);
    return turned * own_axes(spin(time)).transpose();
  }

 private:
  /// The angular momentum, what is across it and the last axis, and the third, in the body's axes.
  [[nodiscard]] Eigen::Matrix<Real, 3, 3> own_axes(const Vector& spin) const {
    Eigen::Matrix<Real, 3, 3> result;
    result.col(0) = inertia_.cwiseProduct(spin).normalized();
    const Vector one = result.col(0);
    const Vector two = one.cross(Vector(Vector::Unit(last_))).normalized();
    result.col(1) = two;
    result.col(2) = one.cross(two);
    return result;
  }
  [[nodiscard]] Eigen::Matrix<Real, 3, 3> world_axes(const BasicSpatialState<Real>& start) const {
    Eigen::Matrix<Real, 3, 3> result = own_axes(start.spin);
    for (Eigen::Index i = 0; i < 3; ++i) {
      result.col(i) = rotated<Real>(start.orientation, Vector(result.col(i)));
    }
    return result;
  }
  /// The rate at which the last axis goes round the angular momentum.
  [[nodiscard]] Real precession(const Real& time) const {
    const Vector now = spin(time);
    const Vector own = inertia_.cwiseProduct(now);
    const Real across = own[1] * own[1] + own[first_] * own[first_];
    return momentum_.norm() * (now[1] * own[1] + now[first_] * own[first_]) / across;
  }

  Vector inertia_;
  Vector spin_;
  Vector momentum_;
  Eigen::Index first_ = 0;
  Eigen::Index last_ = 2;
  std::array<Real, 3> size_;      // of cn, sn and dn
  Real rate_;                     // of their argument
  Real complement_;               // of their parameter
  std::array<Real, 3> at_start_;  // sn, cn and dn
  Eigen::Matrix<Real, 3, 3> axes_;
};

/// By how much the solver differs from a truth.
struct Difference {
  std::string of;
  double size;
};

/// All of them.
template <class Real>
class Differences {
 public:
  [[nodiscard]] std::vector<Difference> all() {
    filar("bifilar", bifilar<Real>());
    filar("trifilar", trifilar<Real>());
    slack();
    conical();
    ball();
    turning_over();
    crane();
    robot();
    return std::move(found_);
  }

 private:
  using System = BasicSystem<Real, 3>;
  using Vector = BasicVector<Real, 3>;

  void note(const std::string& of, const Real& difference) {
    found_.push_back({of, static_cast<double>(Real(abs(difference)))});
  }

  void filar(const std::string& name, const Filar<Real>& one) {
    const System system = one.system();
    const auto solution = solve(system);
    const Real period = one.period();
    const auto quarter = solution.at(Real(period / 4)).bodies[0];
    note(name + ": spin at a quarter", quarter.spin.z() + one.fastest());
    note(name + ": yaw at a quarter", 2 * quarter.orientation[3]);
    note(name + ": height at a quarter", quarter.position.z() - one.height(Real(0)));
    const auto back = solution.at(period).bodies[0];
    const auto& start = system.initial.bodies[0];
    note(name + ": place after a period", (back.position - start.position).norm());
    note(name + ": turn after a period", angle_between<Real>(back.orientation, start.orientation));
    note(name + ": spin after a period", back.spin.norm());
  }

  void slack() {
    const System system = spherical_slack<Real>();
    const auto& start = system.initial.bodies[0];
    const Real energy = start.velocity.squaredNorm() / 2 + start.position.z();
    const Real turning = start.position.x() * start.velocity.y();
    const Real height = 2 * energy / 3;  // where gravity alone bends the way
    const auto square = [&](const Real& z) {
      return Real(2 * (energy - z) * (1 - z * z) - turning * turning);
    };
    const Real time = integral<Real>(start.position.z(), height,
                                     [&](const Real& z) { return Real(1 / sqrt(square(z))); });
    const Real rise = sqrt(square(height));
    const auto solution = solve(system);
    const auto& events = solution.events();
    note("spherical slack: events", Real(static_cast<double>(events.size()) - 4.0));
    note("spherical slack: let go", events[1].time - time);
    note("spherical slack: height", events[1].after.bodies[0].position.z() - height);
    note("spherical slack: caught", events[2].time - (time + 4 * rise));
    note("spherical slack: impulse", events[2].impulses[0] - 12 * rise * rise * rise);
  }

  void conical() {
    const auto one = Conical<Real>::find();
    const System system = one.system();
    const auto solution = solve(system);
    const auto& start = system.initial.bodies[0];
    const Real turn = 2 * pi<Real>() / one.precession;
    const auto half = solution.at(Real(turn / 2)).bodies[0];
    note(
        "conical: across",
        (half.position + start.position - 2 * Vector(Vector::Unit(2)) * start.position.z()).norm());
    const auto back = solution.at(turn).bodies[0];
    note("conical: place after a turn", (back.position - start.position).norm());
    note("conical: orientation", angle_between<Real>(back.orientation, start.orientation));
    note("conical: spin", (back.spin - start.spin).norm());
    note("conical: tension", solution.tensions(turn)[0] - one.tension);
  }

  /// The first impact of `system`, where its body was in `before`.
  void first_impact(const std::string& name, const System& system,
                    const BasicSpatialState<Real>& before) {
    const auto solution = solve(system);
    const auto& event = solution.events().front();
    const auto truth = blow<Real>(system, before);
    note(name + ": place", (event.before.bodies[0].position - before.position).norm());
    note(name + ": impulse", event.impulses[0] - truth.impulse);
    note(name + ": velocity", (event.after.bodies[0].velocity - truth.after.velocity).norm());
    note(name + ": spin", (event.after.bodies[0].spin - truth.after.spin).norm());
  }

  void ball() {
    const System system = tethered_ball<Real>();
    const auto& start = system.initial.bodies[0];
    const auto at = [&](const Real& t) {
      BasicSpatialState<Real> result = start;
      result.position += t * start.velocity + t * t / 2 * Vector(-Vector::Unit(2));
      result.velocity -= t * Vector(Vector::Unit(2));
      result.orientation = quaternion_of<Real>(Vector(t * start.spin));
      return result;
    };
    const Real contact = root_of<Real>(Real(1), milli<Real>(1400), [&](const Real& t) {
      const auto state = at(t);
      return Real(
          1 - (state.position + rotated<Real>(state.orientation, system.cables[0].from.at)).norm());
    });
    note("tethered ball: contact", solve(system).events().front().time - contact);
    first_impact("tethered ball", system, at(contact));
  }

  void turning_over() {
    const System system = dzhanibekov<Real>();
    const auto& start = system.initial.bodies[0];
    const FreeRotation<Real> rotation(system.bodies[0].inertia, start);
    const auto solution = solve(system);
    const auto& event = solution.events().front();
    const Real& time = event.time;
    const Vector gravity = system.gravity.at(Real(0));
    const Eigen::Matrix<Real, 3, 3> turned = rotation.orientation(time);
    const Vector place = start.position + time * start.velocity + time * time / 2 * gravity;
    const Vector arm = turned * system.cables[0].from.at;
    const Vector velocity = start.velocity + time * gravity;
    const Vector along = (place + arm).normalized();
    const Vector spin = rotation.spin(time);
    const Vector sweep = turned * spin.cross(system.cables[0].from.at);
    const Real rate = along.dot(velocity + sweep);
    note("dzhanibekov: contact", ((place + arm).norm() - 1) / rate);
    const auto& before = event.before.bodies[0];
    Real most(0);
    for (Eigen::Index i = 0; i < 3; ++i) {
      const Vector axis = Vector::Unit(i);
      most = max(most, Real((rotated<Real>(before.orientation, axis) - turned * axis).norm()));
    }
    note("dzhanibekov: axes", most);
    note("dzhanibekov: spin [-]", (before.spin - spin).norm() / spin.norm());
    note("dzhanibekov: impulse", event.impulses[0] - blow<Real>(system, before).impulse);
  }

  void crane() {
    const System system = crane_slings<Real>();
    const Real length = system.cables[0].length.at(Real(0))[0];
    const Real gravity = milli<Real>(9810);
    // level, until the short sling is as long as from the hook to its corner
    const Real depth = sqrt(Real(length * length - Real(5) / 4)) + milli<Real>(250);
    auto before = system.initial.bodies[0];
    const Real time = sqrt(Real(2 * (before.position.z() + depth) / gravity));
    before.position.z() = -depth;
    before.velocity.z() = -gravity * time;
    SolveOptions options;
    options.max_events = 1;
    note("crane: contact", solve(system, options).events().front().time - time);
    first_impact("crane", system, before);
  }

  /// The platform hangs on six cables: their lengths, and its balance.
  void robot() {
    if (epsilon<Real>() < Real(1e-20)) {
      return;  // thousands of events
    }
    const System system = parallel_robot<Real>();
    const auto solution = solve(system);
    note("robot: rests", Real(solution.ending() == Ending::rest ? 0 : 1));
    const auto rest = solution.at(solution.end_time());
    note("robot: height", rest.bodies[0].position.z() + Real(1.40393100408779714310));
    const CableSet taut = solution.arcs().back().taut;
    note("robot: taut cables", Real(static_cast<double>(taut.size()) - 6.0));
    const auto tensions = solution.tensions(solution.end_time());
    RowOf<System> forces = no_change(rest);
    forces[2] = -20 * milli<Real>(9810);
    for (const std::size_t index : taut) {
      note("robot: gap " + std::to_string(index), gap(system.cables[index], rest));
      forces +=
          tensions[static_cast<Eigen::Index>(index)] * gap_gradient(system.cables[index], rest);
    }
    note("robot: forces [200 N]", forces.norm() / 200);
  }

  std::vector<Difference> found_;
};

}  // namespace tautline::test
