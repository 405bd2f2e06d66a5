#pragma once

#include "slow_bounces.hpp"
#include "system/elastic.hpp"
#include "tautline/detail/rounding.hpp"
#include "tautline/system_geometry.hpp"

// Sizes of what a system has, and of what rounding leaves of it: rounding.hpp and slow_bounces.hpp
// for systems, with what is given over time (T7).

namespace tautline {

/// Sizes of a function of time, in its unit.
template <class Real>
struct GivenSizes {
  Real speed = Real(0);         // [/s]
  Real acceleration = Real(0);  // [/s^2]
  Real frequency = Real(0);     // [1/s], of its fastest wave

  GivenSizes& operator+=(const GivenSizes& other) {
    speed += other.speed;
    acceleration += other.acceleration;
    frequency = max(frequency, other.frequency);
    return *this;
  }
};

/// Sizes of `function` from `time` [s] on: its rates then, and bounds of its waves at all times.
template <class Real, int N>
[[nodiscard]] GivenSizes<Real> sizes_of(const BasicFunction<Real, N>& function, const Real& time) {
  GivenSizes<Real> result;
  if (function.is_constant()) {
    return result;
  }
  std::array<Eigen::Matrix<Real, N, 1>, 3> given;
  function.expand(time, given);
  result.speed = given[1].norm();
  result.acceleration = 2 * given[2].norm();
  for (const auto& wave : function.waves) {
    const Real speed = wave.amplitude.norm() * wave.frequency;
    result.speed += speed;
    result.acceleration += speed * wave.frequency;
    result.frequency = max(result.frequency, wave.frequency);
  }
  return result;
}

/// The size of `function` at `time` [s], and at most of its waves.
template <class Real, int N>
[[nodiscard]] Real size_of(const BasicFunction<Real, N>& function, const Real& time) {
  Real result = function.empty() ? Real(0) : Real(function.at(time).norm());
  for (const auto& wave : function.waves) {
    result += wave.amplitude.norm();
  }
  return result;
}

/// Sizes of the moving ends and the length of `cable`.
template <class Real, int D>
[[nodiscard]] GivenSizes<Real> sizes_of(const BasicCableOfSystem<Real, D>& cable,
                                        const Real& time) {
  GivenSizes<Real> result = sizes_of(cable.length, time);
  for (std::size_t i = 0; i <= cable.segments(); ++i) {
    result += sizes_of(cable.end(i).motion, time);
  }
  return result;
}

/// True where ends of cables move in the world at this time, or lengths change: then they do work.
template <class Real, int D>
[[nodiscard]] bool is_driven(const BasicSystem<Real, D>& system,
                             const BasicSystemState<Real, D>& state) {
  for (const auto& cable : system.cables) {
    if (sizes_of(cable, state.time).speed > 0) {
      return true;
    }
  }
  return false;
}

/// The largest distance of an end on this body from its centre of mass [m].
template <class Real, int D>
[[nodiscard]] Real longest_arm(const BasicSystem<Real, D>& system, std::size_t body) {
  Real result(0);
  for (const auto& cable : system.cables) {
    for (std::size_t i = 0; i <= cable.segments(); ++i) {
      if (cable.end(i).body == body) {
        result = max(result, Real(cable.end(i).at.norm()));
      }
    }
  }
  return result;
}

/// The largest number that a gap is computed from [m], and what it may change in a rounding of the
/// time.
template <class Real, int D>
[[nodiscard]] Real gap_operand(const BasicCableOfSystem<Real, D>& cable,
                               const BasicSystemState<Real, D>& state) {
  Real result = cable.length.at(state.time)[0];
  for (std::size_t i = 0; i <= cable.segments(); ++i) {
    const auto& end = cable.end(i);
    result = max(result, Real(end.at.norm()));
    result = max(result, end.body ? Real(state.bodies[*end.body].position.norm())
                                  : size_of(end.motion, state.time));
  }
  return result + sizes_of(cable, state.time).speed * state.time;
}

/// One rounding of a gap [m].
template <class Real, int D>
[[nodiscard]] Real rounding_of_gap(const BasicCableOfSystem<Real, D>& cable,
                                   const BasicSystemState<Real, D>& state) {
  return epsilon<Real>() * gap_operand(cable, state);
}

/// The shortest distance that a direction of `cable` is computed from [m]: its length, or its
/// shortest segment.
template <class Real, int D>
[[nodiscard]] Real shortest_segment(const BasicCableOfSystem<Real, D>& cable,
                                    const BasicSystemState<Real, D>& state) {
  Real result = cable.length.at(state.time)[0];
  if (cable.segments() > 1) {
    each_segment(cable, state,
                 [&](std::size_t, const auto& segment) { result = min(result, segment.distance); });
  }
  return result;
}

/// One rounding of the directions of a taut cable [-].
template <class Real, int D>
[[nodiscard]] Real rounding_of_direction(const BasicCableOfSystem<Real, D>& cable,
                                         const BasicSystemState<Real, D>& state) {
  return rounding_of_gap(cable, state) / shortest_segment(cable, state);
}

/// The speeds [m/s] and accelerations [m/s^2] of the ends of `cable`, summed, of bodies that only
/// turn.
template <class Real, int D>
[[nodiscard]] GivenSizes<Real> sizes_of(const BasicCableOfSystem<Real, D>& cable,
                                        const BasicSystemState<Real, D>& state) {
  GivenSizes<Real> result = sizes_of(cable, state.time);
  for (std::size_t i = 0; i <= cable.segments(); ++i) {
    if (const auto& end = cable.end(i); end.body) {
      const auto& body = state.bodies[*end.body];
      const Real turn = spin_size(body) * end.at.norm();
      result.speed += body.velocity.norm() + turn;
      result.acceleration += spin_size(body) * turn;
    }
  }
  return result;
}

/// One rounding of the gap rate [m/s] of a taut cable.
template <class Real, int D>
[[nodiscard]] Real rounding_of_rate(const BasicCableOfSystem<Real, D>& cable,
                                    const BasicSystemState<Real, D>& state) {
  const Real late = epsilon<Real>() * state.time;
  return rounding_of_direction(cable, state) * sizes_of(cable, state).speed +
         late * sizes_of(cable, state.time).acceleration;
}

/// The smallest moment of inertia of `body` [kg m^2].
template <class Real, int D>
[[nodiscard]] Real least_moment(const BasicBodyOfSystem<Real, D>& body) {
  return moments(body.inertia).minCoeff();
}

/// The size of the accelerations that forces, moments and drag give `body` [m/s^2], its points up
/// to `arm` [m] from its centre.
template <class Real, int D, class State>
[[nodiscard]] Real driven(const BasicBodyOfSystem<Real, D>& body, const State& now,
                          const Real& time, const Real& arm) {
  Real result = (size_of(body.force, time) + body.drag * now.velocity.norm()) / body.mass;
  if (has_inertia(body.inertia) && arm > 0) {
    result +=
        arm * (size_of(body.moment, time) + body.spin_drag * spin_size(now)) / least_moment(body);
    result += arm * gyroscopic_size(body.inertia, now);
  }
  return result;
}

/// The largest response of a cable that acts to an impulse of its own [1/kg].
template <class Real, int D>
[[nodiscard]] Real largest_response(const BasicSystem<Real, D>& system,
                                    const BasicSystemState<Real, D>& state) {
  Real result(0);
  for (std::size_t index = 0; index < system.cables.size(); ++index) {
    result = max(result, delassus(system, state, index));
  }
  return result;
}

/// One rounding of the accelerations of gaps that the pulls of engaged elastic cables give [m/s^2].
template <class Real, int D>
[[nodiscard]] Real rounding_of_pulls(const BasicSystem<Real, D>& system,
                                     const BasicSystemState<Real, D>& state) {
  Real result(0);
  for (const std::size_t index : state.elastic.pulling()) {
    const auto& cable = system.cables[index];
    const Real stretch = -gap(cable, state);
    const Real force =
        abs(spring_stiffness(*cable.elasticity, stretch, length_at(cable, state))) *
            rounding_of_gap(cable, state) +
        state.elastic.damping[index] * rounding_of_rate(cable, state) +
        abs(elastic_tension(system, index, state)) * rounding_of_direction(cable, state);
    result += force * sqrt(Real(delassus(system, state, index) * largest_response(system, state)));
  }
  return result;
}

/// One rounding of a taut cable's acceleration in free flight [m/s^2].
template <class Real, int D>
[[nodiscard]] Real rounding_of_acceleration(const BasicSystem<Real, D>& system,
                                            const BasicCableOfSystem<Real, D>& cable,
                                            const BasicSystemState<Real, D>& state) {
  const GivenSizes<Real> sizes = sizes_of(cable, state);
  Real result = size_of(system.gravity, state.time) + sizes.acceleration +
                sizes.speed * sizes.speed / shortest_segment(cable, state);
  for (std::size_t i = 0; i <= cable.segments(); ++i) {
    if (const auto& end = cable.end(i); end.body) {
      result += driven(system.bodies[*end.body], state.bodies[*end.body], state.time,
                       Real(end.at.norm()));
    }
  }
  return rounding_of_direction(cable, state) * result + rounding_of_pulls(system, state);
}

/// One rounding of the energy [J].
template <class Real, int D>
[[nodiscard]] Real rounding_of_energy(const BasicSystem<Real, D>& system,
                                      const BasicSystemState<Real, D>& state) {
  Real result = kinetic_energy(system.bodies, state);
  const Real gravity = size_of(system.gravity, state.time);
  for (std::size_t i = 0; i < system.bodies.size(); ++i) {
    const auto& body = system.bodies[i];
    Real height = state.bodies[i].position.norm();
    for (const auto& cable : system.cables) {
      height = max(height, Real(cable.length.at(state.time)[0]));
    }
    result +=
        (body.mass * gravity + size_of(body.force, state.time)) * height +
        size_of(body.moment, state.time) * angle_of_potential(state.bodies[i]).cwiseAbs().sum();
  }
  for (const std::size_t index : state.elastic.stretched()) {
    const auto& cable = system.cables[index];
    const Real force =
        spring_force(*cable.elasticity, Real(-gap(cable, state)), length_at(cable, state));
    result += abs(force) * gap_operand(cable, state);
  }
  return epsilon<Real>() * result;
}

/// True where the gap of an inextensible cable counts as zero where it begins to act: within
/// `gap_rounding` of the input, or of what its coordinates can tell.
template <class Real, int D>
[[nodiscard]] bool starts_at_zero(const BasicCableOfSystem<Real, D>& cable,
                                  const BasicSystemState<Real, D>& state) {
  return !cable.elasticity &&
         gap(cable, state) <= max(Real(gap_rounding * cable.length.at(state.time)[0]),
                                  Real(few_roundings * rounding_of_gap(cable, state)));
}

/// The speed of the fastest centre of mass [m/s].
template <class Real, int D>
[[nodiscard]] Real centre_speed(const BasicSystemState<Real, D>& state) {
  Real result(0);
  for (const auto& body : state.bodies) {
    result = max(result, Real(body.velocity.norm()));
  }
  return result;
}

/// The largest sizes of ends and lengths of a cable.
template <class Real, int D>
[[nodiscard]] GivenSizes<Real> given_sizes_of_cables(const BasicSystem<Real, D>& system,
                                                     const BasicSystemState<Real, D>& state) {
  GivenSizes<Real> result;
  for (const auto& cable : system.cables) {
    const GivenSizes<Real> one = sizes_of(cable, state.time);
    result.speed = max(result.speed, one.speed);
    result.acceleration = max(result.acceleration, one.acceleration);
    result.frequency = max(result.frequency, one.frequency);
  }
  return result;
}

/// The accelerations [m/s^2] that the pulls of elastic cables may give gaps, and the rate [1/s] at
/// which they change.
template <class Real, int D>
[[nodiscard]] GivenSizes<Real> sizes_of_pulls(const BasicSystem<Real, D>& system,
                                              const BasicSystemState<Real, D>& state) {
  GivenSizes<Real> result;
  for (std::size_t index = 0; index < system.cables.size(); ++index) {
    const auto& cable = system.cables[index];
    if (!cable.elasticity || !cable.acts_at(state.time)) {
      continue;
    }
    const Real response = delassus(system, state, index);
    const Real stretch = max(Real(0), Real(-gap(cable, state)));
    const Real damping = damping_of(system, index, state);
    const Real length = length_at(cable, state);
    const Real stiffness = abs(spring_stiffness(*cable.elasticity, stretch, length));
    result.frequency =
        max(result.frequency, Real(sqrt(Real(stiffness * response)) + damping * response));
    if ((state.elastic.stretched() | state.elastic.resisting).contains(index)) {
      result.acceleration += tension_size(*cable.elasticity, length, damping, response, stretch,
                                          gap_rate(cable, state)) *
                             sqrt(Real(response * largest_response(system, state)));
    }
  }
  return result;
}

/// Sizes of all ends, lengths, forces, moments and pulls of elastic cables (T7).
template <class Real, int D>
[[nodiscard]] GivenSizes<Real> given_sizes(const BasicSystem<Real, D>& system,
                                           const BasicSystemState<Real, D>& state) {
  GivenSizes<Real> result = given_sizes_of_cables(system, state);
  Real most(0);
  for (std::size_t i = 0; i < system.bodies.size(); ++i) {
    const auto& body = system.bodies[i];
    most = max(most, driven(body, state.bodies[i], state.time, longest_arm(system, i)));
    result.frequency = max(result.frequency, Real(body.drag / body.mass));
    result.frequency = max(result.frequency, sizes_of(body.force, state.time).frequency);
    if (has_inertia(body.inertia)) {
      result.frequency = max(result.frequency, Real(body.spin_drag / least_moment(body)));
      result.frequency = max(result.frequency, sizes_of(body.moment, state.time).frequency);
    }
  }
  result.acceleration += most;
  result.frequency = max(result.frequency, sizes_of(system.gravity, state.time).frequency);
  return result += sizes_of_pulls(system, state);
}

/// Sizes of a motion at an instant.
template <class Real>
struct MotionSizes {
  Real speed;         // [m/s], a bound of the speeds of the ends of cables
  Real acceleration;  // [m/s^2], of the gaps
  Real shortest;      // [m], of the cables that act; infinite if there are none
  Real rate;          // [1/s], at which accelerations change
};

/// The shortest length of a cable that acts [m]; infinite if there is none.
template <class Real, int D>
[[nodiscard]] Real shortest_length(const BasicSystem<Real, D>& system,
                                   const BasicSystemState<Real, D>& state) {
  Real result = infinity<Real>();
  for (const auto& cable : system.cables) {
    if (cable.acts_at(state.time)) {
      result = min(result, shortest_segment(cable, state));
    }
  }
  return result;
}

/// Those of `state`.
template <class Real, int D>
[[nodiscard]] MotionSizes<Real> motion_sizes(const BasicSystem<Real, D>& system,
                                             const BasicSystemState<Real, D>& state) {
  const GivenSizes<Real> given = given_sizes(system, state);
  MotionSizes<Real> result{Real(0), Real(0), shortest_length(system, state), Real(0)};
  Real turning(0);
  Real fastest(0);
  for (std::size_t i = 0; i < system.bodies.size(); ++i) {
    const Real spin = spin_size(state.bodies[i]);
    const Real turn = spin * longest_arm(system, i);
    result.speed = max(result.speed, Real(state.bodies[i].velocity.norm() + turn));
    turning = max(turning, Real(spin * turn));
    fastest = max(fastest, spin);
  }
  result.speed += given.speed;
  result.acceleration = size_of(system.gravity, state.time) + given.acceleration + turning +
                        result.speed * result.speed / result.shortest;
  result.rate = fastest + result.speed / result.shortest +
                sqrt(Real(result.acceleration / result.shortest)) + given.frequency;
  return result;
}

/// A bound of the speeds of the ends of cables [m/s], in the world and on bodies.
template <class Real, int D>
[[nodiscard]] Real speed_scale(const BasicSystem<Real, D>& system,
                               const BasicSystemState<Real, D>& state) {
  return motion_sizes(system, state).speed;
}

/// The size of the gaps' accelerations [m/s^2].
template <class Real, int D>
[[nodiscard]] Real acceleration_scale(const BasicSystem<Real, D>& system,
                                      const BasicSystemState<Real, D>& state) {
  return motion_sizes(system, state).acceleration;
}

/// Sizes of a motion in `state`, for the certificate.
template <class Real, int D>
[[nodiscard]] Scales<Real> scales_of(const BasicSystem<Real, D>& system,
                                     const BasicSystemState<Real, D>& state, double margin) {
  const MotionSizes<Real> sizes = motion_sizes(system, state);
  return {sizes.acceleration, sizes.rate, margin};
}

/// True where an elastic cable that is slack may begin to pull within `remaining` [s], and change
/// accelerations by more than `scale` has them change meanwhile.
template <class Real, int D>
[[nodiscard]] bool may_engage(const BasicSystem<Real, D>& system,
                              const BasicSystemState<Real, D>& state, const Real& remaining,
                              const Scales<Real>& scale) {
  const Real drift = scale.acceleration * remaining;
  for (std::size_t index = 0; index < system.cables.size(); ++index) {
    const auto& cable = system.cables[index];
    if (!cable.elasticity || is_stretched(state, index)) {
      continue;
    }
    const Real closing = max(Real(0), Real(-gap_rate(cable, state))) + scale.margin * drift;
    const Real response =
        sqrt(Real(delassus(system, state, index) * largest_response(system, state)));
    const Real force =
        damping_of(system, index, state) * closing +
        spring_force(*cable.elasticity, Real(closing * remaining), length_at(cable, state));
    if (gap(cable, state) <= closing * remaining && force * response > scale.rate * drift) {
      return true;
    }
  }
  return false;
}

/// Cables of a system known to be at exactly zero gap.
template <class Real, int D>
struct SystemTouching {
  CableSet cables;               // that touch at this instant
  ElasticZeros at_zero;          // of elastic cables
  ElasticSwitches switches;      // of elastic cables, at the next stop
  Real rate_rounding = Real(0);  // [m/s], a closing rate up to this is rounding of zero,
  Real spin_rounding = Real(0);  // [rad/s], and one up to this times the arm more
  Real time_rounding = Real(0);  // [s], what is nearer than this is now

  /// Keeps the rounding of gap rates up to date, by the fastest speeds so far.
  void note_speed(const BasicSystem<Real, D>& system, const BasicSystemState<Real, D>& state) {
    const Real rounding = few_roundings * epsilon<Real>();
    const GivenSizes<Real> given = given_sizes_of_cables(system, state);
    const Real speed = centre_speed(state) + given.speed + given.acceleration * state.time;
    rate_rounding = max(rate_rounding, Real(rounding * speed));
    for (const auto& body : state.bodies) {
      spin_rounding = max(spin_rounding, Real(rounding * spin_size(body)));
    }
  }

  /// A rate up to this is rounding of the fastest end's [m/s].
  [[nodiscard]] Real rounding_of_all(const BasicSystem<Real, D>& system) const {
    Real arm(0);
    for (std::size_t i = 0; i < system.bodies.size(); ++i) {
      arm = max(arm, longest_arm(system, i));
    }
    return rate_rounding + spin_rounding * arm;
  }

  /// A closing rate of `cable` up to this is rounding of zero [m/s].
  [[nodiscard]] Real rounding(const BasicCableOfSystem<Real, D>& cable) const {
    Real arms(0);
    for (std::size_t i = 0; i <= cable.segments(); ++i) {
      arms += cable.end(i).body ? Real(cable.end(i).at.norm()) : Real(0);
    }
    return rate_rounding + spin_rounding * arms;
  }
};

}  // namespace tautline
