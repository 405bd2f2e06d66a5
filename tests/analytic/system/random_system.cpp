#include "system/random_system.hpp"

#include "tautline/system_geometry.hpp"

namespace tautline::test {
namespace {

End on_body(Random& random, const System& system, std::size_t body) {
  const bool point = system.bodies[body].inertia == 0.0;
  return {body, point ? Vec2(0.0, 0.0) : random.in_square(0.3), {}};
}

End in_the_world(Random& random) {
  End end{std::nullopt, random.in_square(2.0), {}};
  if (random.chance(0.3)) {
    end.motion.waves = {{random.in_square(0.1), random.uniform(0.5, 4.0), random.uniform(0, 6)}};
  }
  return end;
}

BodyOfSystem random_body(Random& random) {
  BodyOfSystem body;
  body.mass = random.log_uniform(0.03, 30.0);
  const double gyration = random.log_uniform(0.1, 0.5);
  body.inertia = random.chance(0.3) ? 0.0 : body.mass * gyration * gyration;
  if (random.chance(0.3)) {
    body.drag = body.mass * random.uniform(0.0, 0.3);
    body.spin_drag = body.inertia * random.uniform(0.0, 0.3);
  }
  if (random.chance(0.3)) {
    body.force.waves = {{body.mass * random.in_square(0.5), random.uniform(0.5, 4.0), 0.3}};
  }
  return body;
}

/// Its length leaves it slack, or just taut, at the start; a winch may draw it in later.
CableOfSystem random_cable(Random& random, const System& system) {
  const auto body = [&] {
    const double most = static_cast<double>(system.bodies.size()) - 1e-9;
    return static_cast<std::size_t>(random.uniform(0.0, most));
  };
  CableOfSystem cable;
  cable.from = on_body(random, system, body());
  if (random.chance(0.25)) {
    cable.through.push_back(in_the_world(random));
  }
  const std::size_t other = body();
  cable.to = other != *cable.from.body && random.chance(0.5) ? on_body(random, system, other)
                                                             : in_the_world(random);
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

}  // namespace

System random_system(Random& random) {
  System system;
  const auto count = static_cast<std::size_t>(random.uniform(1.0, 5.999));
  for (std::size_t i = 0; i < count; ++i) {
    system.bodies.push_back(random_body(random));
    system.initial.bodies.push_back(
        {random.in_square(1.0), random.uniform(-1, 1), random.in_square(0.5),
         system.bodies.back().inertia > 0.0 ? random.uniform(-1, 1) : 0.0});
  }
  const auto cables = static_cast<std::size_t>(random.uniform(1.0, 8.999));
  for (std::size_t i = 0; i < cables; ++i) {
    system.cables.push_back(random_cable(random, system));
  }
  system.duration = 3.0;
  return system;
}

}  // namespace tautline::test
