#include "engines/cables/measure.hpp"

namespace tautline::test {
namespace {

struct End {
  Vec3 arm;
  Vec3 point;
};

End end_at(const CableEnd& end, const std::vector<BodyState>& bodies) {
  if (end.body < 0) {
    return {Vec3::Zero(), end.point};
  }
  const BodyState& body = bodies[static_cast<std::size_t>(end.body)];
  const Vec3 arm = body.axes * end.point;
  return {arm, body.position + arm};
}

}  // namespace

Line line_of(const CableData& cable, const std::vector<BodyState>& bodies) {
  const End first = end_at(cable.first, bodies);
  const End second = end_at(cable.second, bodies);
  Line line;
  line.distance = (second.point - first.point).norm();
  line.towards = (second.point - first.point) / line.distance;
  line.moments = {first.arm.cross(line.towards), second.arm.cross(line.towards)};
  const std::array ends = {cable.first.body, cable.second.body};
  for (std::size_t side = 0; side < ends.size(); ++side) {
    line.inverse[side] = 0.0;
    if (ends[side] >= 0 && !bodies[static_cast<std::size_t>(ends[side])].is_hook()) {
      const BodyState& body = bodies[static_cast<std::size_t>(ends[side])];
      const Vec3& moment = line.moments[side];
      line.inverse[side] = 1.0 / body.mass + moment.dot(body.inertia().inverse() * moment);
    }
  }
  return line;
}

double gap_rate(const Line& line, const CableData& cable, const std::vector<BodyState>& bodies) {
  const std::array ends = {cable.first.body, cable.second.body};
  double rate = 0.0;
  for (std::size_t side = 0; side < ends.size(); ++side) {
    if (ends[side] >= 0) {
      const BodyState& body = bodies[static_cast<std::size_t>(ends[side])];
      const double one = line.towards.dot(body.velocity) + line.moments[side].dot(body.spin);
      rate += side == 0 ? one : -one;
    }
  }
  return rate;
}

std::vector<BodyState> bodies_of(const Scene& scene, int count) {
  std::vector<BodyState> result;
  result.reserve(static_cast<std::size_t>(count));
  for (int index = 0; index < count; ++index) {
    result.push_back(scene.body(index));
  }
  return result;
}

double energy(const BodyState& body, Velocity velocity) {
  const double lag = velocity == Velocity::lags ? 0.5 * Scene::step_length : 0.0;
  const Vec3 now = body.velocity - lag * gravity * Vec3::UnitY();
  return 0.5 * body.mass * now.squaredNorm() + 0.5 * body.spin.dot(body.inertia() * body.spin) +
         body.mass * gravity * body.position.y();
}

const std::vector<Arrangement>& arrangements() {
  static const std::vector<Arrangement> all = {
      {"central", Vec3(0, 0.2, 0), Vec3(0, 1, 0), 0.0},
      {"off-centre", Vec3(0.25, 0.2, 0), Vec3(0, 1, 0), 0.0},
      {"spatial", Vec3(0.25, 0.2, -0.1), Vec3(0.4, 0.9, 0.3), 0.0},
      {"pair", Vec3(0.1, 0.2, 0.05), Vec3(0.5, 0.8, 0.2), load_mass},
      {"heavy-pair", Vec3(0.1, 0.2, 0.05), Vec3(0.5, 0.8, 0.2), 100 * load_mass}};
  return all;
}

OneCable about_to_close(const Arrangement& arrangement, double restitution, double speed) {
  OneCable setup{std::make_unique<Scene>(gravity), {}, 1};
  const double step = Scene::step_length;
  const double gap = 0.3 * speed * step;               // the first step passes it
  const Vec3 raised = gravity * step * Vec3::UnitY();  // what gravity takes in the first step
  const Vec3 towards = arrangement.towards.normalized();
  const Vec3 start(0, 6, 0);
  const int load =
      setup.scene->add_body(load_mass, load_moment * Vec3::Ones(), start, raised - speed * towards);
  const Vec3 other_end = start + arrangement.attachment + (cable_length - gap) * towards;
  CableEnd second{-1, other_end};
  if (arrangement.other_mass > 0.0) {
    const Vec3 attachment(-0.1, -0.2, 0.1);
    const double moment = load_moment * arrangement.other_mass / load_mass;
    second = {setup.scene->add_body(arrangement.other_mass, moment * Vec3::Ones(),
                                    other_end - attachment, raised),
              attachment};
    setup.count = 2;
  }
  setup.cable = {{load, arrangement.attachment}, second, cable_length, restitution};
  setup.scene->add_cable(setup.cable);
  setup.scene->add_scenery();
  return setup;
}

Step take_step(OneCable& setup, int index) {
  const auto before = bodies_of(*setup.scene, setup.count);
  const Line line = line_of(setup.cable, before);
  setup.scene->step();
  const auto after = bodies_of(*setup.scene, setup.count);
  return {setup.cable.length - line.distance, gap_rate(line, setup.cable, before),
          gap_rate(line, setup.cable, after), setup.scene->impulse(index)};
}

}  // namespace tautline::test
