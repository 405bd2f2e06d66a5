// Systems in space in the engines: each plug-in against the exact motion of the shipped systems.

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <iostream>
#include <memory>
#include <optional>
#include <set>
#include <stdexcept>
#include <string>
#include <vector>

#include "analytic/support.hpp"
#include "engines/engine_support.hpp"
#include "tautline/scenarios.hpp"
#include "tautline/solve.hpp"
#include "tautline/system_geometry.hpp"

namespace tautline::test {
namespace {

using Started = std::unique_ptr<SystemSimulation>;
using Point = Eigen::Vector3d;

/// One of these models for each engine: a test opens the plug-in and asks for the others.
std::vector<ModelUnderTest> one_for_each_engine(const std::vector<ModelUnderTest>& models) {
  std::vector<ModelUnderTest> result;
  std::set<std::string> seen;
  for (const ModelUnderTest& model : models) {
    if (seen.insert(model.engine).second) {
      result.push_back(model);
    }
  }
  return result;
}

std::string engine_name(const testing::TestParamInfo<ModelUnderTest>& info) {
  return info.param.engine;
}

class EngineInSpace : public testing::TestWithParam<ModelUnderTest> {
 protected:
  [[nodiscard]] const Engine& engine() const { return plugin_.engine(); }
  [[nodiscard]] static double limit(double for_double, double for_float) {
    return GetParam().limit(for_double, for_float);
  }

  /// The names of the models that take systems of inextensible cables.
  [[nodiscard]] std::vector<std::string> models() const {
    std::vector<std::string> result;
    for (const Model& model : engine().info().models) {
      if (model.in_space && model.cables != Cables::elastic) {
        result.push_back(model.name);
      }
    }
    return result;
  }
  [[nodiscard]] bool has(const std::string& name) const {
    const std::vector<std::string> all = models();
    return std::find(all.begin(), all.end(), name) != all.end();
  }

  /// A run; none where the model says in one sentence that it cannot.
  [[nodiscard]] Started start(const SpatialSystem& system, const std::string& model,
                              double step) const {
    try {
      return engine().start_system(system, model, step);
    } catch (const std::exception& error) {
      const std::string why = error.what();
      EXPECT_EQ(why.rfind("unsupported: ", 0), 0U) << why;
      EXPECT_EQ(why.find(". "), std::string::npos) << why;
      return nullptr;
    }
  }

 private:
  bench::Plugin plugin_ = bench::Plugin::open(GetParam().plugin);
};

/// How far two states are apart: positions [m] and orientations [rad] of bodies that turn.
double apart(const SpatialSystem& system, const SpatialSystemState& a,
             const SpatialSystemState& b) {
  double result = 0.0;
  for (std::size_t i = 0; i < system.bodies.size(); ++i) {
    result = std::max(result, (a.bodies[i].position - b.bodies[i].position).norm());
    if (has_inertia(system.bodies[i].inertia)) {
      result =
          std::max(result, angle_between<double>(a.bodies[i].orientation, b.bodies[i].orientation));
    }
  }
  return result;
}

/// Two bodies that a cable joins, and a third that a ring of a cable of theirs is on.
SpatialSystem with_a_ring(bool of_two_bodies) {
  SpatialSystem result;
  result.name = "ring";
  result.gravity = Function<3>::constant(Point(0.0, 0.0, -1.0));
  result.duration = 3.0;
  SpatialBody body;
  body.inertia = Point::Constant(0.01);
  result.bodies.push_back(body);
  SpatialState start;
  start.position = Point(0.1, 0.05, -0.4);
  start.velocity = Point(0.3, 0.1, 0.2);
  start.spin = Point(1.0, 2.0, -1.0);
  result.initial.bodies.push_back(start);
  SpatialCable cable;
  cable.from.at = Point(-0.6, 0.0, 0.0);
  cable.through = {{0, Point(0.02, 0.01, 0.05), {}}};
  cable.to.at = Point(0.6, 0.0, 0.0);
  if (of_two_bodies) {
    result.bodies.push_back(body);
    start.position = Point(0.6, 0.0, -0.1);
    result.initial.bodies.push_back(start);
    cable.to = {1, Point::Zero(), {}};
  }
  cable.length = Function<1>::constant(1.7);
  cable.restitution = 0.8;
  result.cables = {cable};
  return result;
}

/// A ball whose cables are cut, hooked up, hauled in and led away at instants within steps.
SpatialSystem with_changes() {
  SpatialSystem result = with_a_ring(false);
  result.name = "changes";
  const auto cable = [](const Point& anchor, const Point& at, double length) {
    SpatialCable made;
    made.from = {0, at, {}};
    made.to.at = anchor;
    made.length = Function<1>::constant(length);
    made.restitution = 0.8;
    return made;
  };
  result.cables = {cable(Point(-0.3, 0.0, 0.2), Point(0.05, 0.0, 0.02), 0.9),
                   cable(Point(0.4, 0.1, 0.0), Point(0.0, 0.04, 0.0), 1.2)};
  result.cables[0].cut_at = 2.1234;
  result.cables[1].from_time = 0.3456;
  result.cables[1].to.motion.pieces = {{0.0, {Point::Zero(), Point(0.1, 0.05, 0.0)}}};
  using One = Function<1>::Value;
  result.cables[1].length = Function<1>::linear({0.4567, 1.9}, {One(1.2), One(0.9)});
  return result;
}

/// The shipped systems and two more, with bodies of three equal moments: what turns them is
/// no matter of integration.
std::vector<SpatialSystem> spherical_systems() {
  std::vector<SpatialSystem> result = {with_a_ring(false), with_changes()};
  for (const ShippedSpatialSystem& shipped : shipped_spatial_systems()) {
    result.push_back(shipped.system);
    for (SpatialBody& body : result.back().bodies) {
      body.inertia.setConstant(body.inertia.mean());
    }
  }
  return result;
}

/// Bodies under drag and forces over time do not fly as an engine's step has it.
bool flies_freely(const SpatialSystem& system) {
  return std::ranges::all_of(system.bodies, [](const SpatialBody& body) {
    return body.drag == 0.0 && body.spin_drag == 0.0 && body.force.empty() && body.moment.empty();
  });
}

/// The first time at which a cable stays taut, or before which impacts accumulate [s].
double first_taut(const BasicSolution<SpatialSystem>& exact) {
  double result = exact.end_time();
  if (!exact.accumulations().empty()) {
    result = std::min(result, exact.accumulations().front().start);
  }
  for (const auto& arc : exact.arcs()) {
    if (!arc.taut.empty()) {
      return std::min(result, arc.start);
    }
  }
  return result;
}

/// The time of impact `count`, or of the last one [s].
double time_of_impact(const BasicSolution<SpatialSystem>& exact, std::size_t count) {
  double result = 0.0;
  for (const auto& event : exact.events()) {
    if (event.kind == EventKind::impact && count > 0) {
      result = event.time;
      --count;
    }
  }
  return result;
}

/// A neighbour of the exact motion: where the former goes away, so does a run.
class Growth {
 public:
  explicit Growth(SpatialSystem system) : system_(system) {
    for (SpatialState& body : system.initial.bodies) {
      body.position += difference * Point(0.6, 0.0, 0.8);
      body.spin += difference * Point(0.0, 0.6, -0.8);
    }
    neighbour_ = solve(system);
  }

  /// By how much a difference of the start has grown until `time` [-], at least 1.
  double until(double time, const SpatialSystemState& exact) {
    if (time <= neighbour_->end_time()) {
      most_ = std::max(most_, apart(system_, neighbour_->at(time), exact) / difference);
    }
    return most_;
  }

 private:
  static constexpr double difference = 1e-8;  // [m, rad/s]
  SpatialSystem system_;
  std::optional<BasicSolution<SpatialSystem>> neighbour_;
  double most_ = 1.0;
};

/// True where an end goes its way unevenly: in a step of a drop-in cable it does not.
bool moves_unevenly(const SpatialSystem& system) {
  return std::ranges::any_of(system.cables, [](const SpatialCable& cable) {
    return !cable.from.motion.waves.empty() || !cable.to.motion.waves.empty();
  });
}

/// By how much a model that finds events may be off in steps of 0.01 s, over the growth. DART
/// turns a body by two terms of a series where it turns by less than 1e-3 rad, which is 2e-10 rad
/// off each time. Simbody's integrator controls its error. Engines in float lose some roundings of
/// an orientation in each step; Havok turns a body too far in each.
double allowed_of(const ModelUnderTest& engine) {
  if (!engine.in_double()) {
    return engine.engine == "havok" ? 5e-5 : 1e-5;
  }
  return engine.engine == "dart" ? 1e-9 : engine.engine == "simbody" ? 1e-8 : 1e-12;
}

TEST_P(EngineInSpace, IsExactByEventsUntilCablesStayTaut) {
  constexpr double step = 1e-2;
  for (const std::string& model : models()) {
    if (model.find("event") == std::string::npos) {
      continue;
    }
    std::size_t held = 0;
    for (const SpatialSystem& system : spherical_systems()) {
      const auto exact = solve(system);
      const double end = std::min(first_taut(exact), time_of_impact(exact, 10));
      const bool uneven = model == "cable-events" && moves_unevenly(system);
      if (!flies_freely(system) || end == 0.0 || uneven) {
        std::cout << "  " << model << ", " << system.name << ": left out, "
                  << (end == 0.0 ? "it starts taut"
                      : uneven   ? "its hook moves unevenly"
                                 : "it is under forces over time")
                  << '\n';
        continue;
      }
      const Started run = start(system, model, step);
      if (!run) {
        std::cout << "  " << model << ", " << system.name << ": the model cannot\n";
        continue;
      }
      Growth growth(system);
      double worst = 0.0;
      double grown = 1.0;
      for (int k = 1; k * step <= end; ++k) {
        run->step(step);
        ASSERT_FALSE(run->stopped()) << system.name << ": " << run->stopped()->reason;
        const auto right = exact.at(k * step);
        grown = growth.until(k * step, right);
        worst = std::max(worst, apart(system, run->state(), right) / grown);
      }
      ++held;
      expect_within(
          model + ", " + system.name + " off, over its growth of " + std::to_string(grown), worst,
          allowed_of(GetParam()));
    }
    EXPECT_GE(held, 6U);
  }
}

/// Each tautens and releases its cables hundreds of times, which rounding turns into many events at
/// one instant.
TEST_P(EngineInSpace, FollowsBusyCablesByEventsToTheEnd) {
  constexpr double step = 1e-2;
  constexpr double longest = 40.0;  // [s]
  for (const ShippedSpatialSystem& shipped : shipped_spatial_systems()) {
    const SpatialSystem& system = shipped.system;
    if (!has("event") || (system.name != "moored-buoy" && system.name != "parallel-robot" &&
                          system.name != "hoisted-load")) {
      continue;
    }
    const Started run = start(system, "event", step);
    ASSERT_TRUE(run) << system.name;
    constexpr double fastest = 5.0;  // [m/s], of these bodies: they reach 2
    for (int k = 1; k * step <= std::min(system.duration, longest); ++k) {
      run->step(step);
      ASSERT_FALSE(run->stopped()) << system.name << ": " << run->stopped()->reason;
      for (const SpatialState& body : run->state().bodies) {
        ASSERT_LT(body.velocity.norm(), fastest) << system.name << " at " << k * step << " s";
      }
    }
  }
}

/// The joints that engines on npm ship have no restitution; with a bounce by hand, what float
/// leaves of a taut cable is more than the error of a step.
bool is_a_joint_on_npm(const ModelUnderTest& engine, const std::string& model) {
  return engine.plugin.extension() != ".so" &&
         (model.starts_with("distance") || model.starts_with("rope") ||
          model.starts_with("limit-spring") || model == "tendon-limit-defaults");
}

/// As shipped, bodies of some engines are damped.
bool is_damped(const std::string& model) { return model == "distance-defaults"; }

TEST_P(EngineInSpace, IsOfFirstOrderInFixedSteps) {
  constexpr double scatter = 0.4;  // [-], of a slope: where in its step an impact falls is chance
  constexpr double impacts = 3;
  for (const std::string& model : models()) {
    // the control, `sampled`, has no error of a step
    if (model.find("event") != std::string::npos || GetParam().engine == "exact" ||
        is_a_joint_on_npm(GetParam(), model)) {
      continue;
    }
    double sum = 0.0;
    double count = 0.0;
    for (const SpatialSystem& system : spherical_systems()) {
      // a motion without bounces of its own, and two with
      if (system.name != "bifilar" && system.name != "crane-slings" &&
          system.name != "breakwater-in-a-tilted-plane") {
        continue;
      }
      const auto exact = solve(system);
      const double bounces = time_of_impact(exact, static_cast<std::size_t>(impacts));
      const double end = bounces > 0.0 ? bounces : 2.0;
      std::vector<double> errors;
      for (const double step : {1e-2, 1e-3, 1e-4}) {
        const Started run = start(system, model, step);
        ASSERT_TRUE(run) << model << " of " << system.name;
        double worst = 0.0;
        for (int k = 1; k * step <= end; ++k) {
          run->step(step);
          worst = std::max(worst, apart(system, run->state(), exact.at(k * step)));
        }
        errors.push_back(worst);
      }
      std::cout << "  " << model << ", " << system.name << ": off by " << errors[0] << ", "
                << errors[1] << " and " << errors[2] << '\n';
      EXPECT_LT(errors[1], 0.05) << model << " of " << system.name;
      // in float rounding is more than the error of a step of 1e-4 s
      sum += GetParam().in_double() ? std::log10(errors[0] / errors[2]) / 2.0
                                    : std::log10(errors[0] / errors[1]);
      count += 1.0;
    }
    EXPECT_NEAR(sum / count, 1.0, scatter) << model;
  }
}

/// Two bodies that nothing but their cable holds.
SpatialSystem free_pair() {
  SpatialSystem result;
  result.name = "free pair";
  result.gravity = Function<3>::constant(Point::Zero());
  result.duration = 3.0;
  for (const double side : {-1.0, 1.0}) {
    SpatialBody body;
    body.mass = 1.5 + 0.5 * side;
    body.inertia = Point(0.02, 0.03, 0.04);
    result.bodies.push_back(body);
    SpatialState start;
    start.position = Point(0.3 * side, 0.1, -0.2 * side);
    start.velocity = Point(0.8 * side, 0.2, 0.3);
    start.spin = Point(0.5, -0.3 * side, 0.2);
    result.initial.bodies.push_back(start);
  }
  SpatialCable cable;
  cable.from = {0, Point(0.1, 0.0, 0.05), {}};
  cable.to = {1, Point(-0.1, 0.02, 0.0), {}};
  cable.restitution = 0.7;
  result.cables = {cable};
  return result;
}

TEST_P(EngineInSpace, KeepsTheMomentumOfAFreePair) {
  constexpr double step = 1e-3;
  const SpatialSystem pair = free_pair();
  const Point before = momentum(pair, pair.initial);
  for (const std::string& model : models()) {
    if (is_damped(model)) {
      continue;
    }
    const Started run = start(pair, model, step);
    ASSERT_TRUE(run) << model;
    double worst = 0.0;
    double pulled = 0.0;
    for (int k = 0; k < 3000; ++k) {
      run->step(step);
      worst = std::max(worst, (momentum(pair, run->state()) - before).norm());
      pulled += run->impulses()[0];
    }
    EXPECT_GT(pulled, 0.5) << model;  // [N s]
    expect_within("momentum of " + model + " [N s]", worst, limit(1e-11, 2e-5));
  }
}

TEST_P(EngineInSpace, GivesTheSameRunTwice) {
  constexpr double step = 1e-2;
  for (const std::string& model : models()) {
    for (const SpatialSystem& system : spherical_systems()) {
      if (system.name != "hoisted-load" && system.name != "crane-slings") {
        continue;
      }
      const Started first = start(system, model, step);
      const Started second = start(system, model, step);
      for (int k = 0; first && k < 200; ++k) {
        first->step(step);
        second->step(step);
        const auto a = first->state();
        const auto b = second->state();
        ASSERT_EQ(apart(system, a, b), 0.0) << model << " of " << system.name << " in step " << k;
      }
    }
  }
}

TEST_P(EngineInSpace, SaysInOneSentenceWhatAModelCannotDo) {
  for (const Model& model : engine().info().models) {
    std::string why;
    try {
      // three bodies of which one is a ring are too much for some
      (void)engine().start_system(with_a_ring(true), model.name, 1e-2);
    } catch (const std::exception& error) {
      why = error.what();
    }
    std::cout << "  " << model.name << ": " << (why.empty() ? "starts" : why) << '\n';
    if (model.cables == Cables::elastic) {
      EXPECT_EQ(why,
                "unsupported: model spring needs an elastic cable, all cables of the case are "
                "inextensible");
    } else if (engine().info().dimensions == 2) {
      EXPECT_EQ(why, "unsupported: " + GetParam().engine + " is an engine of the plane");
    } else if (!model.in_space) {
      EXPECT_EQ(why, "unsupported: model " + model.name + " has one body in the plane alone");
    } else if (model.name.rfind("cable", 0) == 0) {
      EXPECT_EQ(why,
                "unsupported: tautline's drop-in cable goes straight from a body to another one or "
                "to the world, cable 0 does not");
    } else if (!why.empty()) {
      EXPECT_EQ(why.rfind("unsupported: ", 0), 0U) << why;
      EXPECT_NE(why.find("cable 0"), std::string::npos) << why;
    }
  }
}

/// A body at `position` on a cable of 1 m.
void hang(SpatialSystem& system, double mass, const Point& position, const SpatialEnd& to) {
  SpatialBody& body = system.bodies.emplace_back();
  body.mass = mass;
  body.inertia = mass * Point(0.010, 0.020, 0.025);
  system.initial.bodies.emplace_back().position = position;
  SpatialCable& cable = system.cables.emplace_back();
  cable.from.body = system.bodies.size() - 1;
  cable.to = to;
  cable.restitution = 0.0;
}

TEST_P(EngineInSpace, RunsACableWhoseEndsMeet) {
  SpatialSystem system;
  system.gravity = Function<3>::constant(Point::Zero());
  hang(system, 1.0, Point::Zero(), {});
  system.initial.bodies[0].spin = Point(2.0, 3.0, 1.0);
  for (const std::string& model : models()) {
    const Started run = start(system, model, 1e-3);
    ASSERT_TRUE(run) << model;
    for (int step = 0; step < 20; ++step) {
      run->step(1e-3);
    }
    EXPECT_LT(run->state().bodies[0].position.norm(), 1e-6) << model;
  }
}

TEST_P(EngineInSpace, HoldsALoadBelowALightBody) {
  SpatialSystem system;
  system.gravity = Function<3>::constant(Point(0.0, 0.0, -9.81));
  hang(system, 1.0, Point(0.0, 0.0, -0.99), {});
  SpatialEnd block;
  block.body = 0;
  hang(system, 100.0, Point(0.0, 0.0, -1.98), block);
  constexpr double step = 1e-3;
  constexpr double of_catch = 2e-3;       // [m]: 0.44 m/s for four steps, two of each cable
  constexpr double of_joint = 4e-3;       // [m]: PhysX's own takes twice as many; measured 2.8e-3
  constexpr double of_impact = 1e-3;      // [m]: 0.44 m/s for two steps
  constexpr double of_iterations = 0.02;  // [m]: 50 or 60 pass a push on from row to row
  for (const std::string& model : models()) {
    // as shipped PhysX's joint is 25 mm longer, and MuJoCo's limit a soft spring. Jolt's is one for
    // the light body between, and gives where it has a hundred times its weight to hold
    const bool gives = model.ends_with("-defaults") || model.starts_with("limit-spring");
    const Started run = gives ? nullptr : start(system, model, step);
    if (!run) {
      continue;
    }
    const bool iterates = model == "plain" || (GetParam().engine.starts_with("bullet") &&
                                               (model == "row" || model == "early"));
    const double caught = iterates                               ? of_iterations
                          : is_a_joint_on_npm(GetParam(), model) ? of_joint
                                                                 : of_catch;
    double worst = 0.0;  // [m]
    for (int index = 0; index < 300; ++index) {
      run->step(step);
      for (const SpatialCable& cable : system.cables) {
        worst = std::min(worst, gap(cable, run->state()));
      }
    }
    EXPECT_GT(worst, -caught) << model;
    for (const SpatialCable& cable : system.cables) {
      EXPECT_GT(gap(cable, run->state()), iterates ? -of_iterations : -of_impact) << model;
    }
  }
}

INSTANTIATE_TEST_SUITE_P(Engines, EngineInSpace,
                         testing::ValuesIn(one_for_each_engine(models_under_test())), engine_name);
INSTANTIATE_TEST_SUITE_P(OnNpm, EngineInSpace,
                         testing::ValuesIn(one_for_each_engine(models_outside())), engine_name);

}  // namespace
}  // namespace tautline::test
