#include "engines/cables/worlds/world.hpp"

namespace tautline::test {

std::unique_ptr<Scene> play(const World& world, double rate) {
  auto scene = std::make_unique<Scene>(world.gravity, rate);
  for (const Load& load : world.loads) {
    const double moment = load.mass * load.radius * load.radius;
    const int body = load.is_box ? scene->add_box(load.mass, load.position)
                                 : scene->add_body(load.mass, moment * Vec3::Ones(), load.position,
                                                   load.velocity);
    scene->set_velocity(body, load.velocity, load.spin);
    scene->keep_awake(body);
  }
  for (const Hook& hook : world.hooks) {
    scene->add_hook(hook.at(0.0));
  }
  for (const CableData& cable : world.cables) {
    scene->add_cable(cable);
  }
  if (world.has_ground) {
    scene->add_ground();
  }
  for (const Vec3& position : world.boxes) {
    scene->add_box(1.0, position);
  }
  if (world.may_sleep) {
    scene->let_sleep();
  }
  return scene;
}

void move_hooks(Scene& scene, const World& world, double time) {
  for (std::size_t index = 0; index < world.hooks.size(); ++index) {
    scene.move_hook(world.hook(static_cast<int>(index)), world.hooks[index].at(time));
  }
}

Vec3 place(const World& world, const CableEnd& end) {
  if (end.body < 0) {
    return end.point;
  }
  if (end.body < world.load_count()) {
    return world.loads[static_cast<std::size_t>(end.body)].position + end.point;
  }
  return world.hooks[static_cast<std::size_t>(end.body - world.load_count())].at(0.0) + end.point;
}

void tie(World& world, const CableEnd& first, const CableEnd& second, double slack,
         double restitution) {
  const double distance = (place(world, second) - place(world, first)).norm();
  world.cables.push_back({first, second, distance + slack, restitution});
}

}  // namespace tautline::test
