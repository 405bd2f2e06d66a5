#pragma once

#include "tautline/system.hpp"

// Systems with what is given over time and with several bodies, in numbers of any kind.

namespace tautline::test {

/// A pair of numbers.
template <class Real>
[[nodiscard]] BasicVec2<Real> pair_of(const Real& x, const Real& y) {
  return {x, y};
}

/// A straight cable from a body to the world.
template <class Real>
[[nodiscard]] BasicCableOfSystem<Real, 2> to_world(std::size_t body,
                                                   const BasicVec2<Real>& attachment,
                                                   const BasicVec2<Real>& anchor,
                                                   const Real& length, const Real& restitution) {
  BasicCableOfSystem<Real, 2> cable;
  cable.from = {body, attachment, {}};
  cable.to = {std::nullopt, anchor, {}};
  cable.length = BasicFunction<Real, 1>::constant(length);
  cable.restitution = restitution;
  return cable;
}

/// amplitude sin(frequency t).
template <class Real, int N>
[[nodiscard]] BasicFunction<Real, N> sine(const Eigen::Matrix<Real, N, 1>& amplitude,
                                          const Real& frequency) {
  return {{}, {{amplitude, frequency, Real(-pi<Real>() / 2)}}};
}

/// The breakwater 1910121100 with restitution `e`.
template <class Real>
[[nodiscard]] BasicSystem<Real, 2> breakwater_system(const Real& e) {
  const Real a = Real(1) / 10;
  const Real r = Real(3) / 2;
  const Real h = sqrt(Real(r * r - (1 - a) * (1 - a)));
  BasicSystem<Real, 2> system;
  system.bodies.push_back({});
  system.bodies[0].inertia = a * a;
  system.cables = {to_world<Real>(0, {-a, Real(0)}, {Real(-1), h}, r, e),
                   to_world<Real>(0, {a, Real(0)}, {Real(1), h}, r, e)};
  system.initial.bodies = {{{Real(1) / 10, Real(1) / 10}, Real(0), {Real(1) / 5, -a}, Real(0)}};
  system.duration = Real(12);
  return system;
}

/// Its anchors move sideways, 0.1 sin(2 t).
template <class Real>
[[nodiscard]] BasicSystem<Real, 2> shaken(const Real& e = Real(9) / 10) {
  auto system = breakwater_system<Real>(e);
  for (auto& cable : system.cables) {
    cable.to.motion = sine<Real, 2>(pair_of<Real>(Real(1) / 10, Real(0)), Real(2));
  }
  return system;
}

/// That without rebounds, and cable 0 drawn in and out: 1.5 + 0.05 sin(1.3 t).
template <class Real>
[[nodiscard]] BasicSystem<Real, 2> plastic() {
  auto system = shaken<Real>(Real(0));
  system.cables[0].length.waves =
      sine<Real, 1>(Eigen::Matrix<Real, 1, 1>(Real(1) / 20), Real(13) / 10).waves;
  system.duration = Real(6);
  return system;
}

/// A hanging point under an anchor a sin(pi t + phase), on the orbit that repeats every period of
/// 2 s: it rises with U = 1 after each impact, where the anchor moves with W = U (1 - e) / (1 + e),
/// and each impulse is (1 + e) (U + W) = 2. `push` is added to its first speed.
template <class Real>
[[nodiscard]] BasicSystem<Real, 2> bouncer(const Real& a, const Real& push = Real(0)) {
  const Real e = Real(1) / 2;
  const Real w = (1 - e) / (1 + e);
  const Real phase = acos(Real(w / (a * pi<Real>())));
  BasicSystem<Real, 2> system;
  system.bodies.push_back({});
  auto cable = to_world<Real>(0, pair_of<Real>(Real(0), Real(0)), pair_of<Real>(Real(0), Real(0)),
                              Real(1), e);
  cable.to.motion.waves = {{pair_of<Real>(Real(0), a), pi<Real>(), Real(phase - pi<Real>() / 2)}};
  system.cables = {cable};
  system.initial.bodies = {
      {{Real(0), a * sin(phase) - 1}, Real(0), {Real(0), Real(1) + push}, Real(0)}};
  system.duration = Real(121);
  return system;
}

/// The breakwater in two waves of force and one of moment, with linear drag.
template <class Real>
[[nodiscard]] BasicSystem<Real, 2> waves() {
  auto system = breakwater_system<Real>(Real(9) / 10);
  auto& body = system.bodies[0];
  body.drag = Real(1) / 20;
  body.spin_drag = Real(1) / 2000;
  body.force.waves = {{pair_of<Real>(Real(3) / 10, Real(1) / 10), Real(17) / 10, Real(3) / 10},
                      {pair_of<Real>(Real(1) / 10, Real(1) / 4), Real(31) / 10, Real(-1)}};
  body.moment.waves = {{Eigen::Matrix<Real, 1, 1>(Real(1) / 200), Real(17) / 10, Real(4) / 5}};
  return system;
}

/// A hanging load that a winch lifts out of slack, by 0.5 m/s from 0.2 s until 1.4 s.
template <class Real>
[[nodiscard]] BasicSystem<Real, 2> winch() {
  using Length = Eigen::Matrix<Real, 1, 1>;
  BasicSystem<Real, 2> system;
  system.bodies.push_back({});
  system.bodies[0].inertia = Real(1) / 50;
  system.gravity = BasicFunction<Real, 2>::constant(pair_of<Real>(Real(0), Real(-981) / 100));
  auto cable = to_world<Real>(0, pair_of<Real>(Real(3) / 100, Real(1) / 10),
                              pair_of<Real>(Real(0), Real(0)), Real(1), Real(3) / 10);
  cable.length = BasicFunction<Real, 1>::linear({Real(1) / 5, Real(7) / 5},
                                                {Length(Real(5) / 4), Length(Real(13) / 20)});
  system.cables = {
      cable, to_world<Real>(0, pair_of<Real>(Real(1) / 10, Real(0)),
                            pair_of<Real>(Real(1) / 2, Real(-1) / 10), Real(8) / 5, Real(1) / 2)};
  system.initial.bodies = {
      {{Real(1) / 50, Real(-6) / 5}, Real(0), {Real(1) / 10, Real(0)}, Real(0)}};
  system.duration = Real(2);
  return system;
}

/// A breakwater with a ball hung below it.
template <class Real>
[[nodiscard]] BasicSystem<Real, 2> in_series() {
  auto system = breakwater_system<Real>(Real(4) / 5);
  system.bodies.push_back({});
  system.bodies[1].mass = Real(1) / 2;
  system.initial.bodies.push_back(
      {{Real(1) / 4, Real(-1) / 5}, Real(0), {Real(-1) / 2, Real(3) / 10}, Real(0)});
  BasicCableOfSystem<Real, 2> cable;
  cable.from = {1, pair_of<Real>(Real(0), Real(0)), {}};
  cable.to = {0, pair_of<Real>(Real(0), Real(-1) / 20), {}};
  cable.length = BasicFunction<Real, 1>::constant(Real(Real(2) / 5));
  cable.restitution = Real(7) / 10;
  system.cables.push_back(cable);
  system.duration = Real(6);
  return system;
}

/// Three spinning bodies on two cables, without gravity.
template <class Real>
[[nodiscard]] BasicSystem<Real, 2> chain(const Real& e) {
  const auto of = [](int hundredths) { return Real(hundredths) / 100; };
  BasicSystem<Real, 2> system;
  system.gravity = {};
  system.bodies.resize(3);
  system.bodies[0].inertia = of(2);
  system.bodies[1].mass = Real(2);
  system.bodies[1].inertia = of(5);
  system.bodies[2].mass = of(150);
  system.bodies[2].inertia = Real(1) / 30;
  system.initial.bodies = {{{of(0), of(0)}, of(0), {of(-100), of(20)}, of(300)},
                           {{of(50), of(10)}, of(0), {of(10), of(0)}, of(-200)},
                           {{of(100), of(-10)}, of(0), {of(80), of(-30)}, of(100)}};
  const auto join = [&](std::size_t a, const BasicVec2<Real>& at, std::size_t b,
                        const BasicVec2<Real>& to, const Real& length) {
    BasicCableOfSystem<Real, 2> cable;
    cable.from = {a, at, {}};
    cable.to = {b, to, {}};
    cable.length = BasicFunction<Real, 1>::constant(length);
    cable.restitution = e;
    system.cables.push_back(cable);
  };
  join(0, {of(5), of(2)}, 1, {of(-10), of(0)}, of(70));
  join(1, {of(10), of(0)}, 2, {of(-5), of(3)}, of(80));
  system.duration = Real(12);
  return system;
}

/// A block and a ball on one cable through a ring on the ceiling, which goes up and down; each on a
/// cable of its own, too.
template <class Real>
[[nodiscard]] BasicSystem<Real, 2> pulley() {
  const auto of = [](int hundredths) { return Real(hundredths) / 100; };
  BasicSystem<Real, 2> system;
  system.bodies.resize(2);
  system.bodies[0].inertia = of(2);
  system.bodies[1].mass = of(80);
  system.initial.bodies = {{{of(-50), of(-80)}, of(0), {of(20), of(0)}, of(0)},
                           {{of(40), of(-70)}, of(0), {of(0), of(10)}, of(0)}};
  BasicCableOfSystem<Real, 2> rope;
  rope.from = {0, pair_of<Real>(of(5), of(10)), {}};
  BasicEnd<Real, 2> ring;
  ring.motion.waves = {{pair_of<Real>(of(0), of(5)), Real(3), Real(0)}};
  rope.through = {ring};
  rope.to = {1, pair_of<Real>(of(0), of(0)), {}};
  rope.length = BasicFunction<Real, 1>::constant(of(210));
  rope.restitution = of(70);
  system.cables = {rope, to_world<Real>(0, {of(-5), of(10)}, {of(-100), of(0)}, of(150), of(50)),
                   to_world<Real>(1, {of(0), of(0)}, {of(100), of(0)}, of(140), of(50))};
  system.duration = Real(12);
  return system;
}

}  // namespace tautline::test
