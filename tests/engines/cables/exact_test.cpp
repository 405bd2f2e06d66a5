// Planar worlds beside the exact motion of the same system.

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <cstdio>
#include <cstdlib>
#include <functional>
#include <string>

#include "engines/cables/measure.hpp"
#include "tautline/solve.hpp"
#include "tautline/system.hpp"

namespace tautline::test {
namespace {

using Ends = BasicEnd<double, 2>;

/// A system that an engine's world can be, and until when its first impacts are all that happens.
struct PlanarWorld {
  std::string name;
  System system;
  double end;  // [s], before the first cable stays taut
};

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

Vec3 in_space(const Vec2& at) { return {at.x(), at.y(), 0.0}; }

/// The scene of `system`, and what to do before each of its steps.
struct Played {
  std::unique_ptr<Scene> scene;
  std::vector<std::function<void(double)>> each_step;  // of the time at its end [s]

  Played(const System& system, double rate)
      : scene(std::make_unique<Scene>(-system.gravity.at(0.0).y(), rate)) {
    for (std::size_t i = 0; i < system.bodies.size(); ++i) {
      const auto& state = system.initial.bodies[i];
      const int body =
          scene->add_body(system.bodies[i].mass, system.bodies[i].inertia * Vec3::Ones(),
                          in_space(state.position), in_space(state.velocity));
      scene->set_velocity(body, in_space(state.velocity), state.spin * Vec3::UnitZ());
    }
    for (const CableOfSystem& cable : system.cables) {
      const CableEnd from = end_of(cable.from);
      const CableEnd to = end_of(cable.to);
      const int index = scene->add_cable({from, to, cable.length.at(0.0)[0], cable.restitution});
      if (!cable.length.is_constant()) {
        scene->wind(index, cable.length.pieces[0].coefficients[1][0]);
      }
    }
  }

 private:
  CableEnd end_of(const Ends& end) {
    if (end.body) {
      return {static_cast<int>(*end.body), in_space(end.at)};
    }
    if (end.motion.empty()) {
      return {-1, in_space(end.at)};
    }
    const int body = scene->add_hook(in_space(end.at));
    each_step.emplace_back([this, body, end](double time) {
      scene->move_hook(body, in_space(end.at + end.motion.at(time)));
    });
    return {body, Vec3::Zero()};
  }
};

/// How far the bodies of the scene are from those of the exact motion at most [m], at each 0.1 s.
double farthest(const PlanarWorld& world, double rate, bool by_events) {
  System system = world.system;
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
std::size_t impacts_of(const PlanarWorld& world) {
  System system = world.system;
  system.duration = world.end;
  const auto exact = solve(system);
  EXPECT_TRUE(exact.arcs().back().taut.empty()) << world.name;
  return static_cast<std::size_t>(
      std::count_if(exact.events().begin(), exact.events().end(),
                    [](const auto& event) { return event.kind == EventKind::impact; }));
}

/// Shows a figure of docs/guides/cables.md where it is asked for.
void show(const PlanarWorld& world, const std::string& how, double rate, double off) {
  if (std::getenv("TAUTLINE_MEASURE") != nullptr) {
    std::printf("%s %s %g Hz: %.1e m\n", world.name.c_str(), how.c_str(), rate, off);
  }
}

TEST(CablesBesideTheExactMotion, AreOfFirstOrderInFixedSteps) {
  constexpr double most = 9.0;         // [m/s]: the speeds before and after an impact, some times
  constexpr double slope_error = 0.3;  // [-]: where in a step an impact falls is chance
  for (const PlanarWorld& world : planar_worlds()) {
    EXPECT_GE(impacts_of(world), 1U) << world.name;
    double sum = 0.0, sum_off = 0.0, squares = 0.0, products = 0.0, count = 0.0;
    for (double rate = 60.0; rate < 8000.0; rate *= 2.0) {
      const double off = farthest(world, rate, false);
      show(world, "in fixed steps", rate, off);
      EXPECT_LE(off, most / rate) << world.name << " at " << rate << " Hz";
      const double x = -std::log(rate);
      const double y = std::log(off);
      sum += x;
      sum_off += y;
      squares += x * x;
      products += x * y;
      count += 1.0;
    }
    const double order = (products - sum * sum_off / count) / (squares - sum * sum / count);
    EXPECT_NEAR(order, 1.0, slope_error) << world.name;
  }
}

/// How far an engine that turns bodies by `Scene::turn` takes them at most, by their spins [m].
double off_by_turning(const PlanarWorld& world, double rate) {
  constexpr double arm = 1.0;  // [m], ten times the arms: later impacts are elsewhere for it
  System system = world.system;
  system.duration = world.end;
  const auto exact = solve(system);
  double fastest = 0.0;
  for (const auto& event : exact.events()) {
    for (const auto& body : event.after.bodies) {
      fastest = std::max(fastest, std::abs(body.spin));
    }
  }
  return arm * world.end * rate * std::abs(fastest / rate - Scene::turn(fastest, 1.0 / rate));
}

TEST(CablesBesideTheExactMotion, AreExactByEvents) {
  for (const PlanarWorld& world : planar_worlds()) {
    for (const double rate : {60.0, 240.0}) {
      const double off = farthest(world, rate, true);
      show(world, "by events", rate, off);
      EXPECT_LE(off, 1e5 * Scene::rounding + off_by_turning(world, rate))
          << world.name << " at " << rate << " Hz";
    }
  }
}

}  // namespace
}  // namespace tautline::test
