#include "system/random_system.hpp"

#include "tautline/system_geometry.hpp"

namespace tautline::test {
namespace {

template <int D>
using Vector = BasicVector<double, D>;

/// A point of a square, or of a cube.
template <int D>
Vector<D> in_cube(Random& random, double half_width) {
  if constexpr (D == 2) {
    return random.in_square(half_width);
  } else {
    Vector<D> result;
    for (double& number : result) {
      number = random.uniform(-half_width, half_width);
    }
    return result;
  }
}

/// The moments of a body with this radius of gyration, in space of a box of other sides.
double inertia_like(Random& /*random*/, double about, const double& /*plane*/) { return about; }
Eigen::Vector3d inertia_like(Random& random, double about, const Eigen::Vector3d& /*space*/) {
  Eigen::Vector3d square;  // of the sides
  for (double& number : square) {
    number = about * random.log_uniform(0.1, 1.0);
  }
  return {square.y() + square.z(), square.x() + square.z(), square.x() + square.y()};
}

/// A moment in space: in the plane the draws stay those of a test that came first.
void add_moment(Random& /*random*/, BodyOfSystem& /*body*/) {}
void add_moment(Random& random, SpatialBody& body) {
  if (has_inertia(body.inertia) && random.chance(0.3)) {
    body.moment.waves = {{body.inertia.minCoeff() * in_cube<3>(random, 2.0),
                          random.uniform(0.5, 4.0), random.uniform(0, 6)}};
  }
}

/// A body that turns, anyhow; a point mass does not.
State random_state(Random& random, bool turns, const State& /*plane*/) {
  return {random.in_square(1.0), random.uniform(-1, 1), random.in_square(0.5),
          turns ? random.uniform(-1, 1) : 0.0};
}
SpatialState random_state(Random& random, bool turns, const SpatialState& /*space*/) {
  SpatialState result;
  result.position = in_cube<3>(random, 1.0);
  result.orientation = quaternion_of<double>(in_cube<3>(random, 2.0));
  result.velocity = in_cube<3>(random, 0.5);
  if (turns) {
    result.spin = in_cube<3>(random, 2.0);
  }
  return result;
}

template <int D>
BasicEnd<double, D> on_body(Random& random, const BasicSystem<double, D>& system,
                            std::size_t body) {
  const bool point = !has_inertia(system.bodies[body].inertia);
  return {body, point ? Vector<D>(Vector<D>::Zero()) : in_cube<D>(random, 0.3), {}};
}

template <int D>
BasicEnd<double, D> in_the_world(Random& random) {
  BasicEnd<double, D> end{std::nullopt, in_cube<D>(random, 2.0), {}};
  if (random.chance(0.3)) {
    end.motion.waves = {{in_cube<D>(random, 0.1), random.uniform(0.5, 4.0), random.uniform(0, 6)}};
  }
  return end;
}

/// A ring in the world; in space on a body, too.
End random_ring(Random& random, const System& /*plane*/) { return in_the_world<2>(random); }
SpatialEnd random_ring(Random& random, const SpatialSystem& system) {
  if (random.chance(0.7)) {
    return in_the_world<3>(random);
  }
  const double most = static_cast<double>(system.bodies.size()) - 1e-9;
  return on_body(random, system, static_cast<std::size_t>(random.uniform(0.0, most)));
}

template <int D>
BasicBodyOfSystem<double, D> random_body(Random& random) {
  BasicBodyOfSystem<double, D> body;
  body.mass = random.log_uniform(0.03, 30.0);
  const double gyration = random.log_uniform(0.1, 0.5);
  if (!random.chance(0.3)) {
    body.inertia = inertia_like(random, body.mass * gyration * gyration, body.inertia);
  }
  if (random.chance(0.3)) {
    body.drag = body.mass * random.uniform(0.0, 0.3);
    body.spin_drag = moments(body.inertia).minCoeff() * random.uniform(0.0, 0.3);
  }
  if (random.chance(0.3)) {
    body.force.waves = {{body.mass * in_cube<D>(random, 0.5), random.uniform(0.5, 4.0), 0.3}};
  }
  add_moment(random, body);
  return body;
}

/// Its length leaves it slack, or just taut, at the start; a winch may draw it in later.
template <int D>
BasicCableOfSystem<double, D> random_cable(Random& random, const BasicSystem<double, D>& system) {
  const auto body = [&] {
    const double most = static_cast<double>(system.bodies.size()) - 1e-9;
    return static_cast<std::size_t>(random.uniform(0.0, most));
  };
  BasicCableOfSystem<double, D> cable;
  cable.from = on_body(random, system, body());
  if (random.chance(0.25)) {
    cable.through.push_back(random_ring(random, system));
  }
  const std::size_t other = body();
  cable.to = other != *cable.from.body && random.chance(0.5) ? on_body(random, system, other)
                                                             : in_the_world<D>(random);
  cable.restitution = random.chance(0.2) ? 0.0 : random.chance(0.1) ? 1.0 : random.uniform(0, 1);
  cable.length = Function<1>::constant(0.0);
  const double span = -gap(cable, system.initial);
  const double length = span * (1.0 + (random.chance(0.1) ? 0.0 : random.uniform(0.01, 0.6)));
  cable.length = Function<1>::constant(length);
  if (random.chance(0.2)) {
    const double drawn = random.uniform(0.75, 1.1) * length;
    cable.length =
        Function<1>::linear({0.5, 1.5}, {Function<1>::Value(length), Function<1>::Value(drawn)});
  }
  return cable;
}

template <int D>
BasicSystem<double, D> system_of(Random& random) {
  BasicSystem<double, D> system;
  const auto count = static_cast<std::size_t>(random.uniform(1.0, 5.999));
  for (std::size_t i = 0; i < count; ++i) {
    system.bodies.push_back(random_body<D>(random));
    const bool turns = has_inertia(system.bodies.back().inertia);
    system.initial.bodies.push_back(
        random_state(random, turns, typename Turning<double, D>::BodyState{}));
  }
  const auto cables = static_cast<std::size_t>(random.uniform(1.0, 8.999));
  for (std::size_t i = 0; i < cables; ++i) {
    system.cables.push_back(random_cable(random, system));
  }
  system.duration = 3.0;
  return system;
}

}  // namespace

System random_system(Random& random) { return system_of<2>(random); }

SpatialSystem random_spatial_system(Random& random) { return system_of<3>(random); }

}  // namespace tautline::test
