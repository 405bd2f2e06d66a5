// Planar worlds beside the exact motion of the same system.

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <cstdio>
#include <cstdlib>
#include <functional>
#include <string>

#include "engines/cables/draw.hpp"
#include "engines/cables/measure.hpp"
#include "tautline/elastic_contacts.hpp"
#include "tautline/solve.hpp"
#include "tautline/system_geometry.hpp"

namespace tautline::test {
namespace {

using Ends = BasicEnd<double, 2>;

/// A system that an engine's world can be, and until when its first impacts are all that happens.
template <int D>
struct ExactWorld {
  std::string name;
  BasicSystem<double, D> system;
  double end;  // [s], before the first cable stays taut
};
using PlanarWorld = ExactWorld<2>;
using SpatialWorld = ExactWorld<3>;

Ends on(std::size_t body, const Vec2& at = Vec2::Zero()) { return {body, at, {}}; }
Ends world_at(const Vec2& at) { return {std::nullopt, at, {}}; }

CableOfSystem rope(const Ends& from, const Ends& to, double length, double restitution) {
  CableOfSystem result;
  result.from = from;
  result.to = to;
  result.length = Function<1>::constant(length);
  result.restitution = restitution;
  return result;
}

System with_bodies(const std::vector<BasicState<double>>& states, double down) {
  System system;
  for (const auto& state : states) {
    BodyOfSystem body;
    body.mass = load_mass;
    body.inertia = load_moment;
    system.bodies.push_back(body);
    system.initial.bodies.push_back(state);
  }
  system.gravity = System::Gravity::constant(Vec2(0.0, -down));
  return system;
}

/// Two loads below each other fall into the slack of their cables.
PlanarWorld series() {
  System system = with_bodies(
      {{Vec2(0.1, 4.0), 0.0, Vec2::Zero(), 0.0}, {Vec2(0.0, 3.0), 0.0, Vec2::Zero(), 0.0}},
      gravity);
  system.cables = {rope(on(0, Vec2(0.02, 0.1)), world_at(Vec2(0.0, 5.5)), 1.6, 0.8),
                   rope(on(1, Vec2(0.0, 0.1)), on(0, Vec2(0.0, -0.1)), 1.0, 0.7)};
  return {"series", system, 0.9};
}

/// Three bodies fly apart, without gravity.
PlanarWorld chain() {
  System system = with_bodies({{Vec2(0.0, 0.0), 0.0, Vec2(-1.0, 0.2), 0.3},
                               {Vec2(0.5, 0.1), 0.0, Vec2(0.1, 0.0), -0.2},
                               {Vec2(1.0, -0.1), 0.0, Vec2(0.8, -0.3), 0.1}},
                              0.0);
  system.cables = {rope(on(0, Vec2(0.05, 0.02)), on(1, Vec2(-0.1, 0.0)), 0.7, 0.9),
                   rope(on(1, Vec2(0.1, 0.0)), on(2, Vec2(-0.05, 0.03)), 0.8, 0.9)};
  return {"chain", system, 1.2};
}

/// A load falls while a winch takes its cable in.
PlanarWorld winch() {
  System system = with_bodies({{Vec2(0.05, 4.0), 0.0, Vec2::Zero(), 0.0}}, gravity);
  system.cables = {rope(on(0, Vec2(0.0, 0.1)), world_at(Vec2(0.0, 5.5)), 1.9, 0.8)};
  system.cables[0].length.pieces[0].coefficients.push_back(Eigen::Matrix<double, 1, 1>(-0.25));
  return {"winch", system, 0.8};
}

/// A load falls while the hook of its cable goes up and to the side.
PlanarWorld hook() {
  System system = with_bodies({{Vec2(0.05, 4.0), 0.0, Vec2::Zero(), 0.0}}, gravity);
  system.cables = {rope(on(0, Vec2(0.0, 0.1)), world_at(Vec2(0.0, 5.5)), 1.8, 0.8)};
  system.cables[0].to.motion.pieces = {{0.0, {Vec2::Zero(), Vec2(0.2, 0.3)}}};
  return {"hook", system, 0.8};
}

std::vector<PlanarWorld> planar_worlds() { return {series(), chain(), winch(), hook()}; }

SpatialEnd in_the_world_at(const Vec3& at, const Vec3& velocity = Vec3::Zero()) {
  SpatialEnd result;
  result.at = at;
  if (!velocity.isZero(0)) {
    result.motion.pieces = {{0.0, {Vec3::Zero(), velocity}}};
  }
  return result;
}

SpatialSystem balls_in_space(double down, const std::vector<SpatialState>& states) {
  SpatialSystem system;
  for (const SpatialState& state : states) {
    SpatialBody body;
    body.mass = load_mass;
    body.inertia.setConstant(load_moment);
    system.bodies.push_back(body);
    system.initial.bodies.push_back(state);
  }
  system.gravity = Function<3>::constant(Vec3(0.0, -down, 0.0));
  return system;
}

SpatialCable rope_in_space(const SpatialEnd& from, const SpatialEnd& to, double length,
                           double restitution) {
  SpatialCable result;
  result.from = from;
  result.to = to;
  result.length = Function<1>::constant(length);
  result.restitution = restitution;
  return result;
}

/// A spinning ball is thrown between three anchors.
SpatialWorld slings() {
  SpatialState ball;
  ball.position = Vec3(0.1, 4.0, 0.05);
  ball.velocity = Vec3(0.5, 1.0, -0.4);
  ball.spin = Vec3(1.0, -0.7, 0.5);
  SpatialSystem system = balls_in_space(gravity, {ball});
  system.cables = {
      rope_in_space({0, Vec3(0.0, 0.1, 0.0), {}}, in_the_world_at(Vec3(1.0, 5.0, 0.0)), 1.5, 0.8),
      rope_in_space({0, Vec3(-0.05, 0.0, 0.08), {}}, in_the_world_at(Vec3(-0.6, 5.0, 0.8)), 1.6,
                    0.7),
      rope_in_space({0, Vec3(-0.05, 0.0, -0.08), {}}, in_the_world_at(Vec3(-0.6, 5.0, -0.8)), 1.6,
                    0.9)};
  return {"slings", system, 0.9};
}

/// Two spinning balls fall, one on the other; the hook of the upper one goes away sideways, and a
/// winch hauls the lower one in.
SpatialWorld tandem() {
  SpatialState upper;
  upper.position = Vec3(0.1, 4.0, 0.1);
  upper.velocity = Vec3(0.3, 0.4, -0.2);
  upper.spin = Vec3(0.5, 1.0, -0.5);
  SpatialState lower;
  lower.position = Vec3(0.0, 3.2, -0.1);
  lower.velocity = Vec3(-0.2, 0.0, 0.4);
  lower.spin = Vec3(-1.0, 0.3, 0.8);
  SpatialSystem system = balls_in_space(gravity, {upper, lower});
  system.cables = {
      rope_in_space({0, Vec3(0.02, 0.1, 0.03), {}},
                    in_the_world_at(Vec3(0.0, 5.5, 0.0), Vec3(0.2, 0.1, -0.3)), 1.6, 0.8),
      rope_in_space({1, Vec3(0.03, 0.1, 0.0), {}}, {0, Vec3(0.0, -0.1, 0.02), {}}, 1.0, 0.7)};
  system.cables[1].length.pieces[0].coefficients.push_back(Eigen::Matrix<double, 1, 1>(-0.15));
  return {"tandem", system, 0.8};
}

std::vector<SpatialWorld> spatial_worlds() { return {slings(), tandem()}; }

Vec3 in_space(const Vec2& at) { return {at.x(), at.y(), 0.0}; }
Vec3 in_space(const Vec3& at) { return at; }

/// Of a body in its first pose, where its axes are those of the world.
Vec3 spin_in_space(const BasicState<double>& state) { return state.spin * Vec3::UnitZ(); }
Vec3 spin_in_space(const SpatialState& state) { return state.spin; }

/// The scene of a system, and what to do before each of its steps.
struct Played {
  std::unique_ptr<Scene> scene;
  std::vector<std::function<void(double)>> each_step;  // of the time at its end [s]

  template <int D>
  Played(const BasicSystem<double, D>& system, double rate)
      : scene(std::make_unique<Scene>(-system.gravity.at(0.0).y(), rate)) {
    for (std::size_t i = 0; i < system.bodies.size(); ++i) {
      const auto& state = system.initial.bodies[i];
      Vec3 inertia = Vec3::Ones();
      if constexpr (D == 2) {
        inertia *= system.bodies[i].inertia;
      } else {
        inertia = system.bodies[i].inertia;
      }
      const int body = scene->add_body(system.bodies[i].mass, inertia, in_space(state.position),
                                       in_space(state.velocity));
      scene->set_velocity(body, in_space(state.velocity), spin_in_space(state));
    }
    for (const auto& cable : system.cables) {
      const CableEnd from = end_of(cable.from);
      const CableEnd to = end_of(cable.to);
      CableData data{from, to, cable.length.at(0.0)[0], cable.restitution};
      if (cable.elasticity) {
        data.stiffness = cable.elasticity->stiffness;
        data.damping = cable.elasticity->damping;
        data.damping_ratio = cable.elasticity->damping_ratio;
      }
      const int index = scene->add_cable(data);
      if (!cable.length.is_constant()) {
        scene->wind(index, cable.length.pieces[0].coefficients[1][0]);
      }
    }
  }

 private:
  template <int D>
  CableEnd end_of(const BasicEnd<double, D>& end) {
    if (end.body) {
      return {static_cast<int>(*end.body), in_space(end.at)};
    }
    if (end.motion.empty()) {
      return {-1, in_space(end.at)};
    }
    const int body = scene->add_hook(in_space(end.at));
    each_step.emplace_back([this, body, end](double time) {
      scene->move_hook(body, in_space((end.at + end.motion.at(time)).eval()));
    });
    return {body, Vec3::Zero()};
  }
};

/// How far the bodies of the scene are from those of the exact motion at most [m], at each 0.1 s.
template <int D>
double farthest(const ExactWorld<D>& world, double rate, bool by_events) {
  BasicSystem<double, D> system = world.system;
  system.duration = world.end;
  const auto exact = solve(system);
  Played played(system, rate);
  double result = 0.0;
  const int steps = static_cast<int>(std::lround(world.end * rate));
  const int looks = static_cast<int>(std::lround(0.1 * rate));
  for (int step = 1; step <= steps; ++step) {
    const double time = step / rate;
    for (const auto& act : played.each_step) {
      act(time);
    }
    by_events ? static_cast<void>(played.scene->step_by_events()) : played.scene->step();
    if (step % looks == 0) {
      const auto state = exact.at(std::min(time, world.end));
      for (std::size_t i = 0; i < system.bodies.size(); ++i) {
        const Vec3 off =
            played.scene->body(static_cast<int>(i)).position - in_space(state.bodies[i].position);
        result = std::max(result, off.norm());
      }
    }
  }
  return result;
}

/// Impacts before the end, and no cable taut.
template <int D>
std::size_t impacts_of(const ExactWorld<D>& world) {
  BasicSystem<double, D> system = world.system;
  system.duration = world.end;
  const auto exact = solve(system);
  EXPECT_TRUE(exact.arcs().back().taut.empty()) << world.name;
  return static_cast<std::size_t>(
      std::count_if(exact.events().begin(), exact.events().end(),
                    [](const auto& event) { return event.kind == EventKind::impact; }));
}

/// Shows a figure of docs/guides/cables.md where it is asked for.
void show(const std::string& name, const std::string& how, double rate, double off) {
  if (std::getenv("TAUTLINE_MEASURE") != nullptr) {
    std::printf("%s %s %g Hz: %.1e m\n", name.c_str(), how.c_str(), rate, off);
  }
}

/// The error over the step is at most this [m/s]: the speeds before and after an impact, some
/// times.
constexpr double most_over_step = 9.0;

/// The order of the error in steps of `slowest` to 7680 Hz, each of which is off by at most `most`
/// [m/s] times the step.
template <int D>
double order_of(const ExactWorld<D>& world, double slowest, double most) {
  double sum = 0.0, sum_off = 0.0, squares = 0.0, products = 0.0, count = 0.0;
  for (double rate = slowest; rate < 8000.0; rate *= 2.0) {
    const double off = farthest(world, rate, false);
    show(world.name, "in fixed steps", rate, off);
    EXPECT_LE(off, most / rate) << world.name << " at " << rate << " Hz";
    const double x = -std::log(rate);
    const double y = std::log(off);
    sum += x;
    sum_off += y;
    squares += x * x;
    products += x * y;
    count += 1.0;
  }
  return (products - sum * sum_off / count) / (squares - sum * sum / count);
}

template <int D>
void expect_first_order(const ExactWorld<D>& world) {
  constexpr double slope_error = 0.3;  // [-]: where in a step an impact falls is chance
  EXPECT_GE(impacts_of(world), 1U) << world.name;
  EXPECT_NEAR(order_of(world, 60.0, most_over_step), 1.0, slope_error) << world.name;
}

TEST(CablesBesideTheExactMotion, AreOfFirstOrderInFixedSteps) {
  for (const PlanarWorld& world : planar_worlds()) {
    expect_first_order(world);
  }
}

TEST(CablesBesideTheExactMotion, AreOfFirstOrderInFixedStepsInSpace) {
  for (const SpatialWorld& world : spatial_worlds()) {
    expect_first_order(world);
  }
}

/// Lets `cable` stretch by `law`, with no restitution of its own.
template <class AnyCable>
void make_elastic(AnyCable& cable, const Elasticity& law) {
  cable.restitution = AnyCable().restitution;
  cable.elasticity = law;
}

/// A load falls 0.4 m into its elastic cable, and is thrown back.
PlanarWorld bungee() {
  System system = with_bodies({{Vec2(0.05, 4.0), 0.0, Vec2::Zero(), 0.0}}, gravity);
  system.cables = {rope(on(0, Vec2(0.02, 0.1)), world_at(Vec2(0.0, 5.5)), 1.8, 0.0)};
  make_elastic(system.cables[0], {{3000.0}, 0.0, 0.1});
  return {"bungee", system, 0.9};
}

/// The two loads of `series` on cables whose stiffness rises with the stretch.
PlanarWorld elastic_series() {
  PlanarWorld result = series();
  result.name = "elastic series";
  make_elastic(result.system.cables[0], {{800.0, 2000.0, 4000.0}, 0.0, 0.1});
  make_elastic(result.system.cables[1], {{1000.0, 0.0, 5000.0}, 20.0, 0.0});
  return result;
}

/// The balls of `tandem`, the upper one on a cable that does not stretch, with its moving hook and
/// the winch.
SpatialWorld mixed_tandem() {
  SpatialWorld result = tandem();
  result.name = "mixed tandem";
  make_elastic(result.system.cables[1], {{4000.0}, 0.0, 0.2});
  return result;
}

/// The ball of `slings`, with one cable that does not stretch.
SpatialWorld mixed_slings() {
  SpatialWorld result = slings();
  result.name = "mixed slings";
  make_elastic(result.system.cables[1], {{5000.0}, 0.0, 0.05});
  make_elastic(result.system.cables[2], {{2500.0}, 30.0, 0.0});
  return result;
}

/// The error of elastic cables over the step is at most this [m/s]: an implicit step damps a
/// contact at 3 m/s by half of its frequency of 20 to 60 rad/s times the step, and what is lost of
/// the speed shows for some tenths of a second.
constexpr double most_over_step_of_elastic = 80.0;

template <int D>
void expect_first_order_of_elastic(const ExactWorld<D>& world) {
  constexpr double slope_error = 0.3;  // [-]: where in a step a contact begins is chance
  // The order is more than the first on the way to steps that damp less than the cable itself.
  BasicSystem<double, D> system = world.system;
  system.duration = world.end;
  EXPECT_EQ(problems(system), std::vector<std::string>());
  EXPECT_GE(elastic_contacts(solve(system)).size(), 1U) << world.name;
  const double order = order_of(world, 480.0, most_over_step_of_elastic);
  // in float the rounding of a stretch near 5 m, times the stiffness, is as large as a step's error
  if (Scene::rounding < 1e-10) {
    EXPECT_GE(order, 1.0 - slope_error) << world.name;
  }
}

TEST(CablesBesideTheExactMotion, AreOfFirstOrderWhereTheyStretch) {
  expect_first_order_of_elastic(bungee());
  expect_first_order_of_elastic(elastic_series());
}

TEST(CablesBesideTheExactMotion, AreOfFirstOrderWhereSomeStretchInSpace) {
  expect_first_order_of_elastic(mixed_tandem());
  expect_first_order_of_elastic(mixed_slings());
}

/// How far an engine that turns bodies by `Scene::turn` takes them at most, by their spins [m].
template <int D>
double off_by_turning(const ExactWorld<D>& world, double rate) {
  constexpr double arm = 1.0;  // [m], ten times the arms: later impacts are elsewhere for it
  BasicSystem<double, D> system = world.system;
  system.duration = world.end;
  const auto exact = solve(system);
  double fastest = 0.0;
  for (const auto& event : exact.events()) {
    for (const auto& body : event.after.bodies) {
      fastest = std::max(fastest, spin_size(body));
    }
  }
  return arm * world.end * rate * std::abs(fastest / rate - Scene::turn(fastest, 1.0 / rate));
}

template <int D>
void expect_exact_by_events(const ExactWorld<D>& world) {
  for (const double rate : {60.0, 240.0}) {
    const double off = farthest(world, rate, true);
    show(world.name, "by events", rate, off);
    EXPECT_LE(off, 1e5 * Scene::rounding + off_by_turning(world, rate))
        << world.name << " at " << rate << " Hz";
  }
}

TEST(CablesBesideTheExactMotion, AreExactByEvents) {
  for (const PlanarWorld& world : planar_worlds()) {
    expect_exact_by_events(world);
  }
}

TEST(CablesBesideTheExactMotion, AreExactByEventsInSpace) {
  for (const SpatialWorld& world : spatial_worlds()) {
    expect_exact_by_events(world);
  }
}

/// One to three spinning balls on cables to anchors above, some of which move, and to each other,
/// some of them on a winch. Its end is before a fourth impact, and before a cable stays taut.
SpatialWorld random_balls(unsigned int seed) {
  Draw draw(seed);
  std::vector<SpatialState> balls(static_cast<std::size_t>(draw.whole(1, 3)));
  double height = 4.0;
  for (SpatialState& ball : balls) {
    ball.position = Vec3(0.0, height, 0.0) + draw.within(0.5, false);
    ball.velocity = draw.within(1.6, false);
    ball.spin = draw.within(1.6, false);
    height -= 0.8;
  }
  SpatialSystem system = balls_in_space(gravity, balls);
  const auto add = [&](std::size_t ball, const SpatialEnd& to) {
    const SpatialEnd from = {ball, draw.within(0.15, false), {}};
    const double apart =
        (moving_point(from, system.initial).position - moving_point(to, system.initial).position)
            .norm();
    const double length = apart + draw.between(0.02, 0.4);
    system.cables.push_back(rope_in_space(from, to, length, draw.between(0.3, 1.0)));
    if (draw.chance(0.3)) {
      system.cables.back().length.pieces[0].coefficients.push_back(
          Eigen::Matrix<double, 1, 1>(draw.between(-0.2, 0.2)));
    }
  };
  for (std::size_t ball = 0; ball < balls.size(); ++ball) {
    const Vec3 anchor = balls[ball].position + Vec3(0.0, 1.2, 0.0) + draw.within(1.0, false);
    const Vec3 motion = draw.within(draw.chance(0.3) ? 0.5 : 0.0, false);
    add(ball, in_the_world_at(anchor, motion));
    if (ball > 0) {
      add(ball, {ball - 1, draw.within(0.15, false), {}});
    }
  }
  system.duration = 0.9;
  const auto exact = solve(system);
  double end = std::min(system.duration, exact.end_time());
  std::size_t impacts = 0;
  for (const auto& event : exact.events()) {
    if (event.kind != EventKind::impact || ++impacts == 4) {
      end = std::min(end, event.time);
      break;
    }
  }
  for (const auto& arc : exact.arcs()) {
    end = arc.taut.empty() ? end : std::min(end, arc.start);
  }
  return {"random " + std::to_string(seed), system, std::floor(10.0 * end) / 10.0};
}

TEST(CablesBesideTheExactMotion, HoldsForRandomWorldsInSpace) {
  constexpr unsigned int drawn = 500;
  constexpr double rate = 240.0;
  unsigned int compared = 0;
  double of_first_order = 0.0;  // [m/s], the largest error over the step
  double by_events = 0.0;       // [-], of what is allowed
  for (unsigned int seed = 1; seed <= drawn; ++seed) {
    const SpatialWorld world = random_balls(seed);
    if (world.end < 0.2 || impacts_of(world) == 0) {
      continue;
    }
    ++compared;
    for (const double each : {rate, 4.0 * rate}) {
      const double off = farthest(world, each, false);
      of_first_order = std::max(of_first_order, off * each);
      EXPECT_LE(off, most_over_step / each) << world.name << " at " << each << " Hz";
    }
    const double off = farthest(world, rate, true);
    const double allowed = 1e5 * Scene::rounding + off_by_turning(world, rate);
    by_events = std::max(by_events, off / allowed);
    EXPECT_LE(off, allowed) << world.name;
  }
  std::printf(
      "  %u of %u worlds: fixed steps off by up to %.2g m/s times the step, by events by %.2g of "
      "what is allowed\n",
      compared, drawn, of_first_order, by_events);
  EXPECT_GT(compared, drawn / 2);
}

}  // namespace
}  // namespace tautline::test
