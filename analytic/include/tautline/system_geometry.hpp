#pragma once

#include <Eigen/Core>
#include <array>
#include <type_traits>
#include <utility>

#include "tautline/geometry.hpp"
#include "tautline/system.hpp"

namespace tautline {

// The names of geometry.hpp for systems. Equations (T2), (B6), ... are in analytic/README.md,
// section 11.

/// How many freedoms each body has.
template <int D>
inline constexpr Eigen::Index freedoms_of_body = D + spins<D>;

/// A point, and its velocity.
template <class Real, int D>
struct MovingPoint {
  BasicVector<Real, D> position;  // [m]
  BasicVector<Real, D> velocity;  // [m/s]
};

/// The place of `end` in the world.
template <class Real, int D>
[[nodiscard]] MovingPoint<Real, D> moving_point(const BasicEnd<Real, D>& end,
                                                const BasicSystemState<Real, D>& state) {
  if (end.body) {
    const auto& body = state.bodies[*end.body];
    const BasicVector<Real, D> arm = in_the_world(body, end.at);
    return {body.position + arm, body.velocity + swept(body, spin_of(body), arm)};
  }
  if (end.motion.empty()) {
    return {end.at, BasicVector<Real, D>::Zero()};
  }
  std::array<BasicVector<Real, D>, 2> given;
  end.motion.expand(state.time, given);
  return {end.at + given[0], given[1]};
}

/// A straight piece of a cable.
template <class Real, int D>
struct Segment {
  BasicVector<Real, D> along;     // [m], from its second end to its first
  BasicVector<Real, D> velocity;  // [m/s], of that
  Real distance;                  // [m]
};

/// The segments of `cable`, one after the other, for `use`.
template <class Real, int D, class Use>
void each_segment(const BasicCableOfSystem<Real, D>& cable, const BasicSystemState<Real, D>& state,
                  const Use& use) {
  MovingPoint<Real, D> first = moving_point(cable.from, state);
  for (std::size_t i = 0; i < cable.segments(); ++i) {
    const MovingPoint<Real, D> second = moving_point(cable.end(i + 1), state);
    const BasicVector<Real, D> along = first.position - second.position;
    use(i, Segment<Real, D>{along, first.velocity - second.velocity, along.norm()});
    first = second;
  }
}

/// Coefficients 0 to 2 of the length of `cable` at the time of `state`: [m], [m/s], [m/s^2] / 2.
template <class Real, int D>
[[nodiscard]] std::array<Real, 3> length_over_time(const BasicCableOfSystem<Real, D>& cable,
                                                   const BasicSystemState<Real, D>& state) {
  std::array<Eigen::Matrix<Real, 1, 1>, 3> given;
  cable.length.expand(state.time, given);
  return {given[0][0], given[1][0], given[2][0]};
}

/// The length of `cable` at the time of `state` [m].
template <class Real, int D>
[[nodiscard]] Real length_at(const BasicCableOfSystem<Real, D>& cable,
                             const BasicSystemState<Real, D>& state) {
  return cable.length.at(state.time)[0];
}

/// Length minus the distances from end to end [m]; infinite where the cable does not act.
template <class Real, int D>
[[nodiscard]] Real gap(const BasicCableOfSystem<Real, D>& cable,
                       const BasicSystemState<Real, D>& state) {
  if (!cable.acts_at(state.time)) {
    return infinity<Real>();
  }
  Real result = length_at(cable, state);
  each_segment(cable, state, [&](std::size_t, const auto& segment) { result -= segment.distance; });
  return result;
}

/// d gap / dt [m/s]; negative when closing (T2).
template <class Real, int D>
[[nodiscard]] Real gap_rate(const BasicCableOfSystem<Real, D>& cable,
                            const BasicSystemState<Real, D>& state) {
  if (!cable.acts_at(state.time)) {
    return Real(0);
  }
  Real result = length_over_time(cable, state)[1];
  each_segment(cable, state, [&](std::size_t, const auto& segment) {
    result -= segment.along.dot(segment.velocity) / segment.distance;
  });
  return result;
}

/// Adds to `row` what a `force` at `end` does to its body, if it has one, and its moment.
template <class Real, int D, class Row>
void add_wrench(const BasicEnd<Real, D>& end, const BasicSystemState<Real, D>& state,
                const BasicVector<Real, D>& force, Row& row) {
  if (!end.body) {
    return;
  }
  const Eigen::Index first = static_cast<Eigen::Index>(*end.body) * freedoms_of_body<D>;
  row.template segment<D>(first) += force;
  const auto& body = state.bodies[*end.body];
  const BasicVector<Real, D> arm = in_the_world(body, end.at);
  row.template segment<spins<D>>(first + D) += moment_of(body, end.at, arm, force);
}

/// No change of any freedom.
template <class Real, int D>
[[nodiscard]] RowOf<BasicSystem<Real, D>> no_change(const BasicSystemState<Real, D>& state) {
  return RowOf<BasicSystem<Real, D>>::Zero(static_cast<Eigen::Index>(state.bodies.size()) *
                                           freedoms_of_body<D>);
}

/// d gap / d(poses of all bodies): the row of the constraint Jacobian (B6).
template <class Real, int D>
[[nodiscard]] RowOf<BasicSystem<Real, D>> gap_gradient(const BasicCableOfSystem<Real, D>& cable,
                                                       const BasicSystemState<Real, D>& state) {
  RowOf<BasicSystem<Real, D>> row = no_change(state);
  if (!cable.acts_at(state.time)) {
    return row;
  }
  each_segment(cable, state, [&](std::size_t i, const auto& segment) {
    const BasicVector<Real, D> u = segment.along / segment.distance;
    add_wrench<Real, D>(cable.end(i), state, -u, row);
    add_wrench<Real, D>(cable.end(i + 1), state, u, row);
  });
  return row;
}

/// The rate of that row along the motion. `rate_of_moment` says what the turn of a body does to a
/// moment.
template <class Real, int D, class RateOfMoment>
[[nodiscard]] RowOf<BasicSystem<Real, D>> gap_gradient_rate(
    const BasicCableOfSystem<Real, D>& cable, const BasicSystemState<Real, D>& state,
    const RateOfMoment& rate_of_moment) {
  RowOf<BasicSystem<Real, D>> row = no_change(state);
  const auto add = [&](const BasicEnd<Real, D>& end, const BasicVector<Real, D>& force,
                       const BasicVector<Real, D>& force_rate) {
    add_wrench<Real, D>(end, state, force_rate, row);
    if (end.body) {
      const auto& body = state.bodies[*end.body];
      const BasicVector<Real, D> arm = in_the_world(body, end.at);
      const Eigen::Index first = static_cast<Eigen::Index>(*end.body) * freedoms_of_body<D>;
      row.template segment<spins<D>>(first + D) += rate_of_moment(body, end.at, arm, force);
    }
  };
  each_segment(cable, state, [&](std::size_t i, const auto& segment) {
    const BasicVector<Real, D> u = segment.along / segment.distance;
    const BasicVector<Real, D> u_rate =
        (segment.velocity - u.dot(segment.velocity) * u) / segment.distance;
    add(cable.end(i), -u, -u_rate);
    add(cable.end(i + 1), u, u_rate);
  });
  return row;
}

/// The rate of its numbers, those of turns in the axes of the bodies.
template <class Real, int D>
[[nodiscard]] RowOf<BasicSystem<Real, D>> gap_gradient_rate(
    const BasicCableOfSystem<Real, D>& cable, const BasicSystemState<Real, D>& state) {
  return gap_gradient_rate(cable, state, [](const auto&... one) { return moment_rate(one...); });
}

/// The rate of its forces and moments in the world (S18).
template <class Real, int D>
[[nodiscard]] RowOf<BasicSystem<Real, D>> wrench_rate(const BasicCableOfSystem<Real, D>& cable,
                                                      const BasicSystemState<Real, D>& state) {
  return gap_gradient_rate(cable, state,
                           [](const auto&... one) { return moment_rate_in_world(one...); });
}

/// The tension of elastic cable `index` [N] by (E1) and its damping in `state`; below 0 where it is
/// loose, or pushes.
template <class Real, int D>
[[nodiscard]] Real elastic_tension(const BasicSystem<Real, D>& system, std::size_t index,
                                   const BasicSystemState<Real, D>& state) {
  const BasicCableOfSystem<Real, D>& cable = system.cables[index];
  const Real damper = state.elastic.damping[index] * gap_rate(cable, state);
  if (state.elastic.resisting.contains(index)) {
    return -damper;
  }
  return spring_force(*cable.elasticity, Real(-gap(cable, state)), length_at(cable, state)) -
         damper;
}

/// The accelerations of all bodies where no inextensible cable is taut: of their centres [m/s^2]
/// and their spins [rad/s^2]. Elastic cables pull that are engaged in `state`.
template <class Real, int D>
[[nodiscard]] RowOf<BasicSystem<Real, D>> free_accelerations(
    const BasicSystem<Real, D>& system, const BasicSystemState<Real, D>& state) {
  RowOf<BasicSystem<Real, D>> result = no_change(state);
  const BasicVector<Real, D> gravity = system.gravity.at(state.time);
  for (std::size_t i = 0; i < system.bodies.size(); ++i) {
    const auto& body = system.bodies[i];
    const auto& now = state.bodies[i];
    const Eigen::Index first = static_cast<Eigen::Index>(i) * freedoms_of_body<D>;
    const BasicVector<Real, D> force = body.force.at(state.time) - body.drag * now.velocity;
    result.template segment<D>(first) = gravity + force / body.mass;
    if (has_inertia(body.inertia)) {
      const BasicTurn<Real, D> moment = in_the_body(now, body.moment.at(state.time)) -
                                        body.spin_drag * spin_of(now) +
                                        gyroscopic(body.inertia, now);
      result.template segment<spins<D>>(first + D) = moment.cwiseQuotient(moments(body.inertia));
    }
  }
  for (const std::size_t index : state.elastic.pulling()) {
    result += elastic_tension(system, index, state) *
              gap_gradient(system.cables[index], state).cwiseProduct(inverse_mass(system.bodies));
  }
  return result;
}

/// The acceleration of `end` [m/s^2] where the bodies have these `accelerations`.
template <class Real, int D>
[[nodiscard]] BasicVector<Real, D> end_acceleration(
    const BasicEnd<Real, D>& end, const BasicSystemState<Real, D>& state,
    const RowOf<BasicSystem<Real, D>>& accelerations) {
  if (end.body) {
    const auto& body = state.bodies[*end.body];
    const Eigen::Index first = static_cast<Eigen::Index>(*end.body) * freedoms_of_body<D>;
    const BasicVector<Real, D> arm = in_the_world(body, end.at);
    const BasicVector<Real, D> turning = swept(body, spin_of(body), arm);
    return accelerations.template segment<D>(first) +
           swept(body, accelerations.template segment<spins<D>>(first + D), arm) +
           swept(body, spin_of(body), turning);
  }
  if (end.motion.empty()) {
    return BasicVector<Real, D>::Zero();
  }
  std::array<BasicVector<Real, D>, 3> given;
  end.motion.expand(state.time, given);
  return 2 * given[2];
}

/// d^2 gap / dt^2 where no inextensible cable is taut [m/s^2] (T2).
template <class Real, int D>
[[nodiscard]] Real free_gap_acceleration(const BasicSystem<Real, D>& system, std::size_t index,
                                         const BasicSystemState<Real, D>& state) {
  const BasicCableOfSystem<Real, D>& cable = system.cables[index];
  const RowOf<BasicSystem<Real, D>> accelerations = free_accelerations(system, state);
  Real result = 2 * length_over_time(cable, state)[2];
  BasicVector<Real, D> first = end_acceleration<Real, D>(cable.from, state, accelerations);
  each_segment(cable, state, [&](std::size_t i, const auto& segment) {
    const BasicVector<Real, D> second =
        end_acceleration<Real, D>(cable.end(i + 1), state, accelerations);
    const BasicVector<Real, D> u = segment.along / segment.distance;
    const BasicVector<Real, D> across = segment.velocity - u.dot(segment.velocity) * u;
    result -= u.dot(first - second) + across.squaredNorm() / segment.distance;
    first = second;
  });
  return result;
}

/// All that moves.
template <class Real, int D>
[[nodiscard]] const std::vector<BasicBodyOfSystem<Real, D>>& bodies_of(
    const BasicSystem<Real, D>& system) {
  return system.bodies;
}

/// How many ways to move they have.
template <class Real, int D>
[[nodiscard]] std::size_t freedoms_of(const BasicSystem<Real, D>& system) {
  return system.bodies.size() * static_cast<std::size_t>(freedoms_of_body<D>);
}

/// The numbers that `of_mass` and `of_inertia` give, one for each freedom of `bodies`; 0 for the
/// turn of a point mass.
template <class Real, int D, class OfMass>
[[nodiscard]] RowOf<BasicSystem<Real, D>> masses(
    const std::vector<BasicBodyOfSystem<Real, D>>& bodies, const OfMass& of_mass) {
  RowOf<BasicSystem<Real, D>> result(static_cast<Eigen::Index>(bodies.size()) *
                                     freedoms_of_body<D>);
  Eigen::Index row = 0;
  for (const auto& body : bodies) {
    result.template segment<D>(row).setConstant(of_mass(body.mass));
    for (Eigen::Index axis = 0; axis < spins<D>; ++axis) {
      const Real moment = moments(body.inertia)[axis];
      result[row + D + axis] = moment > 0 ? Real(of_mass(moment)) : Real(0);
    }
    row += freedoms_of_body<D>;
  }
  return result;
}

/// Diagonal of the inverse mass matrix of all bodies [1/kg, 1/(kg m^2)].
template <class Real, int D>
[[nodiscard]] RowOf<BasicSystem<Real, D>> inverse_mass(
    const std::vector<BasicBodyOfSystem<Real, D>>& bodies) {
  return masses(bodies, [](const Real& mass) { return Real(Real(1) / mass); });
}

/// J M^-1 J^T over `cables`, in rising index order, symmetric positive semidefinite (B6).
template <class Real, int D>
[[nodiscard]] BasicCableMatrix<Real> delassus(const BasicSystem<Real, D>& system,
                                              const BasicSystemState<Real, D>& state,
                                              CableSet cables) {
  const auto count = static_cast<Eigen::Index>(cables.size());
  RowsOf<BasicSystem<Real, D>> rows(count, static_cast<Eigen::Index>(freedoms_of(system)));
  Eigen::Index row = 0;
  for (const std::size_t index : cables) {
    rows.row(row++) = gap_gradient(system.cables[index], state).transpose();
  }
  BasicCableMatrix<Real> result =
      rows * inverse_mass(system.bodies).asDiagonal() * rows.transpose();
  return result;
}

/// Its entry for one cable with itself [1/kg].
template <class Real, int D>
[[nodiscard]] Real delassus(const BasicSystem<Real, D>& system,
                            const BasicSystemState<Real, D>& state, std::size_t index) {
  const RowOf<BasicSystem<Real, D>> row = gap_gradient(system.cables[index], state);
  return row.dot(row.cwiseProduct(inverse_mass(system.bodies)));
}

/// `state` standing still.
template <class Real, int D>
[[nodiscard]] BasicSystemState<Real, D> standing_still(BasicSystemState<Real, D> state) {
  for (auto& body : state.bodies) {
    body = standing_still(body);
  }
  return state;
}

/// `state` with `gain` added to its velocities and spins.
template <class Real, int D>
[[nodiscard]] BasicSystemState<Real, D> with_gain(
    BasicSystemState<Real, D> state,
    const std::type_identity_t<RowOf<BasicSystem<Real, D>>>& gain) {
  Eigen::Index row = 0;
  for (auto& body : state.bodies) {
    body.velocity += gain.template segment<D>(row);
    body = with_spin(body, spin_of(body) + gain.template segment<spins<D>>(row + D));
    row += freedoms_of_body<D>;
  }
  return state;
}

/// `there`, a state near `state`, with the momentum and the angular momentum that `state` has, and
/// `gain` more over mass and inertia, in the axes of the bodies at `state` (S18).
template <class Real, int D>
[[nodiscard]] BasicSystemState<Real, D> with_momentum(
    const std::vector<BasicBodyOfSystem<Real, D>>& bodies, BasicSystemState<Real, D> there,
    const BasicSystemState<Real, D>& state,
    const std::type_identity_t<RowOf<BasicSystem<Real, D>>>& gain) {
  Eigen::Index row = 0;
  for (std::size_t i = 0; i < bodies.size(); ++i) {
    auto& body = there.bodies[i];
    body.velocity += gain.template segment<D>(row);
    body = with_spin(body, spin_carried(bodies[i].inertia, state.bodies[i], body,
                                        gain.template segment<spins<D>>(row + D)));
    row += freedoms_of_body<D>;
  }
  return there;
}

/// `state` after its poses have moved by `step` [m, rad].
template <class Real, int D>
[[nodiscard]] BasicSystemState<Real, D> moved(
    BasicSystemState<Real, D> state,
    const std::type_identity_t<RowOf<BasicSystem<Real, D>>>& step) {
  Eigen::Index row = 0;
  for (auto& body : state.bodies) {
    body.position += step.template segment<D>(row);
    body = turned(body, step.template segment<spins<D>>(row + D));
    row += freedoms_of_body<D>;
  }
  return state;
}

/// Applies `impulses` [N s], one per cable of `cables`, at the state's poses.
template <class Real, int D>
[[nodiscard]] BasicSystemState<Real, D> with_impulses(const BasicSystem<Real, D>& system,
                                                      const BasicSystemState<Real, D>& state,
                                                      CableSet cables,
                                                      const BasicCableVector<Real>& impulses) {
  RowOf<BasicSystem<Real, D>> change = no_change(state);
  Eigen::Index row = 0;
  for (const std::size_t index : cables) {
    change += impulses[row++] * gap_gradient(system.cables[index], state);
  }
  return with_gain(state, change.cwiseProduct(inverse_mass(system.bodies)).eval());
}

/// Kinetic energy of all bodies [J].
template <class Real, int D>
[[nodiscard]] Real kinetic_energy(const std::vector<BasicBodyOfSystem<Real, D>>& bodies,
                                  const BasicSystemState<Real, D>& state) {
  Real result(0);
  for (std::size_t i = 0; i < bodies.size(); ++i) {
    const auto& now = state.bodies[i];
    Real twice = bodies[i].mass * now.velocity.squaredNorm();
    if (has_inertia(bodies[i].inertia)) {
      twice += moments(bodies[i].inertia).cwiseProduct(spin_of(now)).dot(spin_of(now));
    }
    result += twice;
  }
  return result / 2;
}

/// The energy that stretched elastic cables store at the poses of `state` [J].
template <class Real, int D>
[[nodiscard]] Real stored_energy(const BasicSystem<Real, D>& system,
                                 const BasicSystemState<Real, D>& state) {
  Real result(0);
  for (const auto& cable : system.cables) {
    if (cable.elasticity) {
      result += spring_energy(*cable.elasticity, Real(-gap(cable, state)), length_at(cable, state));
    }
  }
  return result;
}

/// Kinetic energy, the energy that elastic cables store, and the potential energy of what gravity
/// and the given forces and moments are at the time of `state` [J]; zero potential at the origin of
/// the world, and at angle 0. In space a moment has no potential.
template <class Real, int D>
[[nodiscard]] Real energy(const BasicSystem<Real, D>& system,
                          const BasicSystemState<Real, D>& state) {
  Real result = kinetic_energy(system.bodies, state) + stored_energy(system, state);
  const BasicVector<Real, D> gravity = system.gravity.at(state.time);
  for (std::size_t i = 0; i < system.bodies.size(); ++i) {
    const auto& body = system.bodies[i];
    result -= (body.mass * gravity + body.force.at(state.time)).dot(state.bodies[i].position);
    result -= body.moment.at(state.time).dot(angle_of_potential(state.bodies[i]));
  }
  return result;
}

/// Linear momentum of all bodies [N s].
template <class Real, int D>
[[nodiscard]] BasicVector<Real, D> momentum(const BasicSystem<Real, D>& system,
                                            const BasicSystemState<Real, D>& state) {
  BasicVector<Real, D> result = BasicVector<Real, D>::Zero();
  for (std::size_t i = 0; i < system.bodies.size(); ++i) {
    result += system.bodies[i].mass * state.bodies[i].velocity;
  }
  return result;
}

/// Angular momentum of all bodies about a world point [N m s].
template <class Real>
[[nodiscard]] Real angular_momentum(const BasicSystem<Real, 2>& system,
                                    const BasicSystemState<Real, 2>& state,
                                    const BasicVec2<Real>& about) {
  Real result(0);
  for (std::size_t i = 0; i < system.bodies.size(); ++i) {
    result += angular_momentum(system.bodies[i].mass, system.bodies[i].inertia, state.bodies[i],
                               about)[0];
  }
  return result;
}
/// In space, in world axes.
template <class Real>
[[nodiscard]] BasicVector<Real, 3> angular_momentum(const BasicSystem<Real, 3>& system,
                                                    const BasicSystemState<Real, 3>& state,
                                                    const BasicVector<Real, 3>& about) {
  BasicVector<Real, 3> result = BasicVector<Real, 3>::Zero();
  for (std::size_t i = 0; i < system.bodies.size(); ++i) {
    result +=
        angular_momentum(system.bodies[i].mass, system.bodies[i].inertia, state.bodies[i], about);
  }
  return result;
}

}  // namespace tautline
