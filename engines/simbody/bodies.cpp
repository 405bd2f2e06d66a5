#include "bodies.hpp"

#include <algorithm>
#include <limits>
#include <stdexcept>
#include <string>

#include "tautline/geometry.hpp"
#include "tautline/point_mass.hpp"

namespace tautline::simbody {
namespace {

// the coordinates of MobilizedBody::Planar
constexpr int angle = 0;
constexpr int x = 1;
constexpr int y = 2;

// as MobilizedBody::Free has them: a quaternion, then a position; a spin in the world, then a
// velocity
constexpr int position_of_free = 4;
constexpr int velocity_of_free = 3;

SimTK::Body::Rigid rigid(double mass, const SimTK::Vec3& moments) {
  return SimTK::Body::Rigid(SimTK::MassProperties(mass, SimTK::Vec3(0.0), SimTK::Inertia(moments)));
}

/// Gravity and what is given to act on the bodies of a system, at every instant.
class Loads final : public SimTK::Force::Custom::Implementation {
 public:
  Loads(const SpatialSystem& system, const std::vector<SimTK::MobilizedBody>& bodies,
        const std::vector<BodyLoad>& pulls)
      : system_(system), bodies_(bodies), pulls_(pulls) {}

  void calcForce(const SimTK::State& state, SimTK::Vector_<SimTK::SpatialVec>& forces,
                 SimTK::Vector_<SimTK::Vec3>& /*of_particles*/,
                 SimTK::Vector& /*of_mobilities*/) const override {
    const double time = state.getTime();
    const Eigen::Vector3d gravity = system_.gravity.at(time);
    for (std::size_t index = 0; index < bodies_.size(); ++index) {
      const SpatialBody& body = system_.bodies[index];
      const SimTK::SpatialVec& motion = bodies_[index].getBodyVelocity(state);
      const Eigen::Vector3d given = body.mass * gravity + body.force.at(time);
      forces[bodies_[index].getMobilizedBodyIndex()] += SimTK::SpatialVec(
          vector(Eigen::Vector3d(body.moment.at(time))) - body.spin_drag * motion[0],
          vector(given) - body.drag * motion[1]);
    }
    for (std::size_t index = 0; index < pulls_.size(); ++index) {
      forces[bodies_[index].getMobilizedBodyIndex()] +=
          SimTK::SpatialVec(vector(pulls_[index].moment), vector(pulls_[index].force));
    }
  }
  SimTK::Real calcPotentialEnergy(const SimTK::State& /*state*/) const override { return 0.0; }

 private:
  const SpatialSystem& system_;
  const std::vector<SimTK::MobilizedBody>& bodies_;
  const std::vector<BodyLoad>& pulls_;
};

/// Ropes and rods of Simbody do no more.
void check_cables(const SpatialSystem& system) {
  check_straight(system, "a rope of Simbody");
  for (std::size_t index = 0; index < system.cables.size(); ++index) {
    const SpatialCable& cable = system.cables[index];
    if (!cable.length.is_constant() || !cable.from.motion.empty() || !cable.to.motion.empty() ||
        cable.from_time || cable.cut_at) {
      throw CableRefused("a rope of Simbody has one length between points that stay where they are",
                         index, "changes over time");
    }
  }
}

}  // namespace

// ---- in the plane

template <>
Bodies<Case>::Bodies(const Case& the_case) : case_(the_case) {
  bodies_.push_back(SimTK::MobilizedBody::Planar(
      matter_.updGround(),
      rigid(the_case.body.mass, SimTK::Vec3(turnable_inertia(the_case.body)))));
  SimTK::Force::UniformGravity(forces_, matter_, vector(the_case.gravity));
}

template <>
SimTK::State Bodies<Case>::initial_state() {
  system_.realizeTopology();
  SimTK::State result = system_.getDefaultState();
  system_.realizeModel(result);
  const State& wanted = case_.initial;
  bodies_[0].setOneQ(result, angle, wanted.angle);
  bodies_[0].setOneQ(result, x, wanted.position.x());
  bodies_[0].setOneQ(result, y, wanted.position.y());
  bodies_[0].setOneU(result, angle, wanted.spin);
  bodies_[0].setOneU(result, x, wanted.velocity.x());
  bodies_[0].setOneU(result, y, wanted.velocity.y());
  system_.realize(result, SimTK::Stage::Velocity);
  return result;
}

template <>
State Bodies<Case>::state_of(const SimTK::State& state) const {
  const SimTK::MobilizedBody& body = bodies_[0];
  State result;
  result.angle = body.getOneQ(state, angle);
  result.position = Vec2(body.getOneQ(state, x), body.getOneQ(state, y));
  result.spin = body.getOneU(state, angle);
  result.velocity = Vec2(body.getOneU(state, x), body.getOneU(state, y));
  return result;
}

template <>
Station Bodies<Case>::from(std::size_t cable) const {
  return {bodies_[0], vector(case_.cables[cable].attachment)};
}
template <>
Station Bodies<Case>::to(std::size_t cable) const {
  return {matter_.getGround(), vector(case_.cables[cable].anchor)};
}
template <>
double Bodies<Case>::length(std::size_t cable) const {
  return case_.cables[cable].length;
}

double speed_of(const Case& the_case, const State& state) { return speed_scale(the_case, state); }
double acceleration_of(const Case& the_case, const State& state) {
  return acceleration_scale(the_case, state);
}

// ---- in space

template <>
Bodies<SpatialSystem>::Bodies(const SpatialSystem& system) : case_(system) {
  check_cables(system);
  for (const SpatialBody& body : system.bodies) {
    bodies_.push_back(SimTK::MobilizedBody::Free(matter_.updGround(),
                                                 rigid(body.mass, vector(turnable_inertia(body)))));
  }
  SimTK::Force::Custom(forces_, new Loads(case_, bodies_, pulls_));
}

template <>
SimTK::State Bodies<SpatialSystem>::initial_state() {
  system_.realizeTopology();
  SimTK::State result = system_.getDefaultState();
  system_.realizeModel(result);
  for (std::size_t index = 0; index < bodies_.size(); ++index) {
    const SpatialState& wanted = case_.initial.bodies[index];
    const Eigen::Vector3d spin = in_the_world(wanted, wanted.spin);
    for (int i = 0; i < 4; ++i) {
      bodies_[index].setOneQ(result, i, wanted.orientation[i]);
    }
    for (int i = 0; i < 3; ++i) {
      bodies_[index].setOneQ(result, position_of_free + i, wanted.position[i]);
      bodies_[index].setOneU(result, i, spin[i]);
      bodies_[index].setOneU(result, velocity_of_free + i, wanted.velocity[i]);
    }
  }
  system_.realize(result, SimTK::Stage::Velocity);
  return result;
}

template <>
SpatialSystemState Bodies<SpatialSystem>::state_of(const SimTK::State& state) const {
  SpatialSystemState result;
  result.time = state.getTime();
  for (const SimTK::MobilizedBody& body : bodies_) {
    SpatialState one;
    Eigen::Vector3d spin;
    for (int i = 0; i < 4; ++i) {
      one.orientation[i] = body.getOneQ(state, i);
    }
    one.orientation.normalize();
    for (int i = 0; i < 3; ++i) {
      one.position[i] = body.getOneQ(state, position_of_free + i);
      spin[i] = body.getOneU(state, i);
      one.velocity[i] = body.getOneU(state, velocity_of_free + i);
    }
    one.spin = in_the_body(one, spin);
    result.bodies.push_back(one);
  }
  return result;
}

template <>
Station Bodies<SpatialSystem>::from(std::size_t cable) const {
  const SpatialCable& one = case_.cables[cable];
  const SpatialEnd& end = one.from.body ? one.from : one.to;
  return {bodies_[*end.body], vector(end.at)};
}
template <>
Station Bodies<SpatialSystem>::to(std::size_t cable) const {
  const SpatialCable& one = case_.cables[cable];
  const SpatialEnd& end = one.from.body ? one.to : one.from;
  return {end.body ? bodies_[*end.body] : SimTK::MobilizedBody(matter_.getGround()),
          vector(end.at)};
}
template <>
double Bodies<SpatialSystem>::length(std::size_t cable) const {
  return case_.cables[cable].length.at(0.0)[0];
}

double speed_of(const SpatialSystem& /*system*/, const SpatialSystemState& state) {
  return fastest(state);
}
double acceleration_of(const SpatialSystem& system, const SpatialSystemState& state) {
  const RowOf<SpatialSystem> free = free_accelerations(system, state);
  double shortest = std::numeric_limits<double>::infinity();  // [m]
  for (const SpatialCable& cable : system.cables) {
    shortest = std::min(shortest, cable.length.at(state.time)[0]);
  }
  const double speed = fastest(state);
  return free.norm() + speed * speed / shortest;
}

std::vector<Setting> system_settings() {
  return {{"mobilizers", "MobilizedBody::Free", "Bodies of a system move in space."},
          {"Force::Custom", "gravity, forces, moments and drag at each instant",
           "Simbody's own elements know no function of time."}};
}

}  // namespace tautline::simbody
