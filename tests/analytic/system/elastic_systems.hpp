#pragma once

#include <utility>

#include "system/systems.hpp"

// Systems on elastic cables, in numbers of any kind.

namespace tautline::test {

/// A linear cable with this damping ratio.
template <class Real>
[[nodiscard]] BasicElasticity<Real> with_ratio(const Real& stiffness, const Real& ratio) {
  return {{stiffness}, Real(0), ratio};
}

/// A linear cable with this damping [N s/m].
template <class Real>
[[nodiscard]] BasicElasticity<Real> with_damping(const Real& stiffness, const Real& damping) {
  return {{stiffness}, damping, Real(0)};
}

/// The force [N] of the spring of a cable of this `length` [m] at `stretch` [m], past so many
/// corners, from corner to corner.
[[nodiscard]] inline double force_by_lines(const Elasticity& law, double stretch, double length,
                                           std::size_t past) {
  const double x = law.of_strain ? stretch / length : stretch;
  double result = 0.0;
  if (law.corners.empty()) {
    double power = x;
    for (const double k : law.stiffness) {
      result += k * power;
      power *= x;
    }
    return result;
  }
  double from = 0.0;
  double slope = law.stiffness[0];
  for (std::size_t i = 0; i < past; ++i) {
    result += slope * (law.corners[i].stretch - from);
    from = law.corners[i].stretch;
    slope = law.corners[i].stiffness;
  }
  return result + slope * (x - from);
}

/// `cable` with this law.
template <class Real, int D>
[[nodiscard]] BasicCableOfSystem<Real, D> elastic(BasicCableOfSystem<Real, D> cable,
                                                  BasicElasticity<Real> law) {
  cable.restitution = Real(1);
  cable.elasticity = std::move(law);
  return cable;
}

/// `system` with this law of all its cables.
template <class Real, int D>
[[nodiscard]] BasicSystem<Real, D> elastic(BasicSystem<Real, D> system,
                                           const BasicElasticity<Real>& law) {
  for (auto& cable : system.cables) {
    cable = elastic(std::move(cable), law);
  }
  return system;
}

/// A point mass `slack` [m] above the place below its anchor where its cable of 1 m is stretched,
/// on the way down at `speed` [m/s].
template <class Real>
[[nodiscard]] BasicSystem<Real, 2> drop(const BasicElasticity<Real>& law, const Real& gravity,
                                        const Real& speed, const Real& slack) {
  BasicSystem<Real, 2> system;
  system.bodies.push_back({});
  system.gravity = BasicFunction<Real, 2>::constant(pair_of<Real>(Real(0), Real(-gravity)));
  system.cables = {elastic(to_world<Real>(0, pair_of<Real>(Real(0), Real(0)),
                                          pair_of<Real>(Real(0), Real(0)), Real(1), Real(1)),
                           law)};
  system.initial.bodies = {{pair_of<Real>(Real(0), Real(slack - 1)), Real(0),
                            pair_of<Real>(Real(0), Real(-speed)), Real(0)}};
  system.duration = Real(1);
  return system;
}

/// Two point masses of 1 and 3 kg on one cable of 1 m, without gravity; the first runs away at
/// 2 m/s.
template <class Real>
[[nodiscard]] BasicSystem<Real, 2> pair_on_a_cable(const BasicElasticity<Real>& law) {
  const Real quarter = Real(1) / 4;
  BasicSystem<Real, 2> system;
  system.gravity = {};
  system.bodies.resize(2);
  system.bodies[1].mass = Real(3);
  BasicCableOfSystem<Real, 2> cable;
  cable.from = {0, pair_of<Real>(Real(0), Real(0)), {}};
  cable.to = {1, pair_of<Real>(Real(0), Real(0)), {}};
  system.cables = {elastic(cable, law)};
  system.initial.bodies = {
      {pair_of<Real>(Real(-1) / 2, Real(0)), Real(0), pair_of<Real>(Real(-2), quarter), Real(0)},
      {pair_of<Real>(quarter, Real(0)), Real(0), pair_of<Real>(Real(0), quarter), Real(0)}};
  system.duration = Real(1);
  return system;
}

/// A pendulum of 1 m on an inextensible cable, taut from the start, that swings into an elastic one
/// of 1.4 m from below.
template <class Real>
[[nodiscard]] BasicSystem<Real, 2> pendulum_into_a_cable(const BasicElasticity<Real>& law) {
  BasicSystem<Real, 2> system;
  system.bodies.push_back({});
  const BasicVec2<Real> centre = pair_of<Real>(Real(0), Real(0));
  system.cables = {to_world<Real>(0, centre, centre, Real(1), Real(0)),
                   elastic(to_world<Real>(0, centre, pair_of<Real>(Real(-1), Real(-2)),
                                          Real(Real(7) / 5), Real(1)),
                           law)};
  system.initial.bodies = {{pair_of<Real>(Real(Real(-3) / 5), Real(Real(-4) / 5)), Real(0),
                            pair_of<Real>(Real(Real(8) / 5), Real(Real(-6) / 5)), Real(0)}};
  return system;
}

/// A block and a ball on one elastic cable through a ring in the world.
template <class Real>
[[nodiscard]] BasicSystem<Real, 2> elastic_pulley(const BasicElasticity<Real>& law) {
  auto system = pulley<Real>();
  system.cables[0].through[0].motion = {};
  return elastic(std::move(system), law);
}

/// A box that tumbles on two elastic cables in space.
template <class Real>
[[nodiscard]] BasicSystem<Real, 3> elastic_box(const BasicElasticity<Real>& law) {
  const auto of = [](int hundredths) { return Real(Real(hundredths) / 100); };
  const auto place = [&](int x, int y, int z) { return BasicVector<Real, 3>(of(x), of(y), of(z)); };
  BasicSystem<Real, 3> system;
  system.bodies.resize(1);
  system.bodies[0].inertia = place(2, 3, 4);
  system.gravity = BasicFunction<Real, 3>::constant(place(0, 0, -100));
  for (const int side : {-1, 1}) {
    BasicCableOfSystem<Real, 3> cable;
    cable.from = {0, place(20 * side, 5, 10), {}};
    cable.to = {std::nullopt, place(100 * side, 10 * side, 100), {}};
    cable.length = BasicFunction<Real, 1>::constant(of(150));
    system.cables.push_back(elastic(cable, law));
  }
  BasicSpatialState<Real> start;
  start.position = place(10, 5, 10);
  start.velocity = place(30, 20, -10);
  start.spin = place(100, -50, 200);
  system.initial.bodies = {start};
  system.duration = Real(5);
  return system;
}

}  // namespace tautline::test
