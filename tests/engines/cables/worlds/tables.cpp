#include "engines/cables/worlds/tables.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <functional>
#include <memory>
#include <vector>

#include "engines/cables/cost.hpp"
#include "engines/cables/measure.hpp"
#include "engines/cables/worlds/ledger.hpp"

namespace tautline::test {
namespace {

constexpr double mass = 2.0;    // [kg]
constexpr double length = 1.0;  // [m] of a cable
constexpr double top = 6.0;     // [m]

/// Loads below each other, from rest: on cables, or on ball joints at the place of each cable's
/// upper end.
std::unique_ptr<Scene> series(const std::vector<double>& masses, Held held, double rate,
                              double speed) {
  auto scene = std::make_unique<Scene>(gravity, rate);
  int above = -1;
  double height = top;
  for (const double one : masses) {
    height -= length;
    const int load =
        scene->add_body(one, 0.01 * one * Vec3::Ones(), Vec3(0, height, 0), Vec3(speed, 0, 0));
    if (held == Held::by_joint) {
      scene->add_ball_joint(load, Vec3(0, length, 0), above);
    } else {
      const CableEnd end =
          above < 0 ? CableEnd{-1, Vec3(0, top, 0)} : CableEnd{above, Vec3::Zero()};
      scene->add_cable({{load, Vec3::Zero()}, end, length, 0.0});
    }
    above = load;
  }
  return scene;
}

struct Fall {
  double drop;  // of the lowest load, farthest [m]
  double gain;  // of energy, highest [J]
};

/// What a minute does to 1 kg with `ratio` below it.
Fall fall(double ratio, Held held, double rate) {
  const int loads = 2;
  const auto scene = series({1.0, ratio}, held, rate, 0.0);
  auto before = bodies_of(*scene, loads);
  const double start = before[1].position.y();
  const Energy at_start =
      energy_at_start(before, loads, Stepping::fixed, scene->dt(), world_gravity);
  Fall result{0.0, 0.0};
  for (int step = 0; step < static_cast<int>(60.0 * rate); ++step) {
    scene->step();
    const auto after = bodies_of(*scene, loads);
    const Energy now = energy_between(before, after, loads, Stepping::fixed, world_gravity);
    result.drop = std::max(result.drop, start - after[1].position.y());
    result.gain =
        std::max(result.gain, now.kinetic + now.potential - at_start.kinetic - at_start.potential);
    before = after;
  }
  return result;
}

void print_mass_ratios(double rate) {
  fmt::print(
      "| mass ratio | cable: drop [m] | energy gained [J] | joint: drop [m] | energy gained "
      "[J] |\n|---|---|---|---|---|\n");
  for (const double ratio : {1.0, 3.0, 10.0, 30.0, 100.0, 300.0, 1000.0}) {
    const Fall cable = fall(ratio, Held::by_cable, rate);
    const Fall joint = fall(ratio, Held::by_joint, rate);
    fmt::print("| 1:{:g} | {:.1e} | {:.1e} | {:.1e} | {:.1e} |\n", ratio, cable.drop, cable.gain,
               joint.drop, joint.gain);
  }
}

/// One load on `count` cables, or ball joints, at corners of its lid.
void add_load(Scene& scene, int count, Held held, double x) {
  const int load = scene.add_body(mass, 0.02 * Vec3::Ones(), Vec3(x, top - 2.0 * length, 0.0),
                                  Vec3(0.3, 0.0, 0.0));
  const std::vector<Vec3> lid = {Vec3(0.2, 0.1, 0.2), Vec3(-0.2, 0.1, -0.2), Vec3(0.2, 0.1, -0.2),
                                 Vec3(-0.2, 0.1, 0.2)};
  for (int index = 0; index < count; ++index) {
    const Vec3 corner = count == 1 ? Vec3(0.0, 0.1, 0.0) : lid[static_cast<std::size_t>(index)];
    const Vec3 hook = corner + length * Vec3::UnitY();
    if (held == Held::by_joint) {
      scene.add_ball_joint(load, hook);
    } else {
      const Vec3 anchor = Vec3(x, top - 2.0 * length, 0.0) + hook;
      scene.add_cable({{load, corner}, {-1, anchor}, length, 0.5});
    }
  }
}

std::unique_ptr<Scene> loads_on(int count, Held held, double rate) {
  constexpr int loads = 40;  // that a step is long enough to be timed
  auto scene = std::make_unique<Scene>(gravity, rate);
  for (int index = 0; index < loads; ++index) {
    add_load(*scene, count, held, 2.0 * index);
  }
  return scene;
}

Costs costs_of(const std::function<std::unique_ptr<Scene>(Held)>& make) {
  const double seconds = 2.0;
  const auto cables = make(Held::by_cable);
  const auto joints = make(Held::by_joint);
  return costs(*cables, *joints, seconds);
}

void print_costs(double rate) {
  fmt::print(
      "| beside ball joints in the same places | cables [us a step] | joints [us a step] | "
      "ratio |\n|---|---|---|---|\n");
  const auto print = [](const std::string& name, const Costs& cost) {
    fmt::print("| {} | {:.1f} | {:.1f} | {:.2f} |\n", name, 1e6 * cost.cable, 1e6 * cost.joint,
               cost.cable / cost.joint);
  };
  for (const int count : {1, 2, 4}) {
    print(fmt::format("40 loads on {} each", count),
          costs_of([&](Held held) { return loads_on(count, held, rate); }));
  }
  const std::vector<double> ten(10, 1.0);
  print("a chain of 10", costs_of([&](Held held) { return series(ten, held, rate, 0.3); }));
}

}  // namespace

void print_tables(double rate) {
  fmt::print(
      "{} at {:g} Hz: 1 kg on a cable of 1 m, the rest on another below it, for 60 s from "
      "rest.\n\n",
      Scene::engine, rate);
  print_mass_ratios(rate);
  fmt::print("\n{} at {:g} Hz: what a step costs.\n\n", Scene::engine, rate);
  print_costs(rate);
  fmt::print("\n");
}

}  // namespace tautline::test
