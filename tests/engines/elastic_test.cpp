// Elastic cables in the engines: the models `spring` and `cable`, the control, and what the other
// models say.

#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <optional>
#include <span>
#include <stdexcept>
#include <string>
#include <vector>

#include "adapter/spring_model.hpp"
#include "analytic/support.hpp"
#include "bench/run/record.hpp"
#include "engines/engine_support.hpp"
#include "tautline/elastic_contacts.hpp"
#include "tautline/elasticity.hpp"
#include "tautline/solve.hpp"
#include "tautline/system_geometry.hpp"

namespace tautline::test {
namespace {

using Vec3 = Eigen::Vector3d;

/// An engine that says it has a model of elastic cables.
class ElasticInEngine : public testing::TestWithParam<ModelUnderTest> {
 protected:
  [[nodiscard]] const Engine& engine() const { return plugin_.engine(); }
  [[nodiscard]] static bool in_double() { return GetParam().in_double(); }

 private:
  bench::Plugin plugin_ = bench::Plugin::open(GetParam().plugin);
};

/// The model `spring` of each engine of the build that has one, and `plain` of the control.
std::vector<ModelUnderTest> engines_with_springs() {
  std::vector<ModelUnderTest> result;
  for (const bench::RegisteredEngine& engine : engines_of_the_build()) {
    for (const Model& model : engine.info ? engine.info->models : std::vector<Model>()) {
      if (model.name == "spring" || model.name == "plain") {
        result.push_back({engine.plugin, engine.name, model.name, engine.info->precision});
      }
    }
  }
  return result;
}

/// The models with fixed steps of an engine that take elastic cables.
std::vector<std::string> stepped_models(const Engine& engine) {
  std::vector<std::string> result;
  for (const Model& model : engine.info().models) {
    if (model.cables != Cables::inextensible && model.name != "event" && model.name != "sampled") {
      result.push_back(model.name);
    }
  }
  return result;
}

/// The drop-in cables take an implicit step, which damps by half of the frequency times the step,
/// and go through no rings.
bool is_drop_in(const std::string& model) { return model == "cable"; }

SpatialCable elastic_cable(const SpatialEnd& from, const SpatialEnd& to, double stiffness,
                           double ratio) {
  SpatialCable result;
  result.from = from;
  result.to = to;
  result.length = Function<1>::constant(1.0);
  result.elasticity = Elasticity{{stiffness}, 0.0, ratio};
  return result;
}

SpatialEnd on_body(std::size_t body, const Vec3& at = Vec3::Zero()) { return {body, at, {}}; }
SpatialEnd in_the_world_at(const Vec3& at) { return {std::nullopt, at, {}}; }

constexpr double snap_mass = 1.0;         // [kg]
constexpr double snap_frequency = 100.0;  // [rad/s]
constexpr double snap_speed = 1.0;        // [m/s]

/// Steps [s]: 300 in a contact, and four times as many. The error depends on where in a step the
/// contact begins; it begins at a third of both.
constexpr std::array snap_steps = {1e-4, 2.5e-5};
constexpr double snap_way = (123.0 + 1.0 / 3.0) * snap_steps[0] * snap_speed;  // [m], to the entry

/// A point mass that flies into its only cable, with no load.
SpatialSystem snap(double ratio) {
  SpatialSystem result;
  result.name = "snap";
  result.gravity = Function<3>::constant(Vec3::Zero());
  SpatialBody body;
  body.mass = snap_mass;
  result.bodies = {body};
  result.cables = {
      elastic_cable(on_body(0), {}, snap_mass * snap_frequency * snap_frequency, ratio)};
  SpatialState start;
  start.position = Vec3(0.0, 1.0 - snap_way, 0.0);
  start.velocity = Vec3(0.0, snap_speed, 0.0);
  result.initial.bodies = {start};
  result.duration = 0.1;
  return result;
}

/// What a run shows of a snap.
struct Shown {
  double exit_speed = 0.0;  // [m/s]
  double peak = 0.0;        // [N]
  double impulse = 0.0;     // [N s]
};

Shown shown(const Engine& engine, const std::string& model, double ratio, double step) {
  const SpatialSystem system = snap(ratio);
  const auto run = engine.start_system(system, model, step);
  Shown result;
  for (int k = 1; k * step <= system.duration + 0.5 * step; ++k) {
    run->step(step);
    const double impulse = dynamic_cast<const TensionImpulses&>(*run).tension_impulses()[0];
    EXPECT_GE(impulse, 0.0) << model;
    result.peak = std::max(result.peak, impulse / step);
    result.impulse += impulse;
  }
  result.exit_speed = -run->state().bodies[0].velocity.y();
  return result;
}

/// The closed forms (E6) and (E8) with a ratio below 1/2.
Shown closed_form(double ratio) {
  const double e = restitution_of(ratio);
  const double root = std::sqrt(1.0 - ratio * ratio);
  const double part = std::exp(-ratio * (std::acos(0.0) - 3.0 * std::asin(ratio)) / root);
  return {e * snap_speed, snap_mass * snap_frequency * snap_speed * part,
          snap_mass * (1.0 + e) * snap_speed};
}

TEST_P(ElasticInEngine, SnapsAsTheClosedFormsSayToFirstOrder) {
  for (const std::string& model : stepped_models(engine())) {
    for (const double ratio : {0.05, 0.3}) {
      const Shown exact = closed_form(ratio);
      std::array<double, snap_steps.size()> errors{};  // [-], the sum of the three
      for (std::size_t i = 0; i < snap_steps.size(); ++i) {
        const Shown found = shown(engine(), model, ratio, snap_steps[i]);
        // the momentum is what the cable gave, whatever the step
        expect_within(model + ": momentum less impulse [N s]",
                      std::abs(snap_mass * (found.exit_speed + snap_speed) - found.impulse),
                      in_double() ? 1e-10 : 1e-3);
        const double of_speed = std::abs(found.exit_speed / exact.exit_speed - 1.0);
        const double of_peak = std::abs(found.peak / exact.peak - 1.0);
        const double of_impulse = std::abs(found.impulse / exact.impulse - 1.0);
        // the errors are less than the frequency times the step; in float a step's way near 1 m is
        // rounded by 2e-3 of it
        const std::string at = model + ", ratio " + std::to_string(ratio) + ", step " +
                               std::to_string(snap_steps[i]) + ": ";
        const double allowed = snap_frequency * snap_steps[i] + (in_double() ? 0.0 : 1e-2);
        expect_within(at + "exit speed off [-]", of_speed, allowed);
        expect_within(at + "peak off [-]", of_peak, allowed);
        expect_within(at + "impulse off [-]", of_impulse, allowed);
        errors[i] = of_speed + of_peak + of_impulse;
      }
      // a fourth to first order; in float rounding is as large as the error of the smaller step
      if (in_double()) {
        EXPECT_NEAR(errors[1] / errors[0], 0.25, 0.05) << model << ", ratio " << ratio;
      }
    }
  }
}

/// A ball of 1 kg and a spinning box of 2 kg that fall into elastic cables: one joins them, one
/// holds the box, and one goes from the box through a ring of the ball, or straight past it. With
/// `mixed` an inextensible cable, the first, holds the ball.
SpatialSystem pair_on_springs(bool mixed, bool straight) {
  SpatialSystem result;
  result.name = mixed ? "mixed pair" : "pair on springs";
  result.gravity = Function<3>::constant(Vec3(0.0, 0.0, -9.81));
  SpatialBody ball;
  ball.inertia = Vec3::Constant(0.004);
  SpatialBody box;
  box.mass = 2.0;
  box.inertia = Vec3(0.02, 0.03, 0.04);
  result.bodies = {ball, box};
  SpatialState of_ball;
  of_ball.position = Vec3(0.2, 0.1, -0.9);
  SpatialState of_box;
  of_box.position = Vec3(0.6, -0.6, -1.5);
  of_box.velocity = Vec3(0.4, -0.5, -0.8);
  of_box.spin = Vec3(1.0, 2.0, -1.0);
  result.initial.bodies = {of_ball, of_box};
  result.cables = {elastic_cable(on_body(0, Vec3(0.0, 0.0, -0.05)),
                                 on_body(1, Vec3(0.05, 0.0, 0.1)), 800.0, 0.1),
                   elastic_cable(on_body(1, Vec3(-0.1, 0.02, 0.1)),
                                 in_the_world_at(Vec3(0.5, -0.5, -0.5)), 1500.0, 0.2),
                   elastic_cable(on_body(1, Vec3(0.0, 0.1, 0.1)),
                                 in_the_world_at(Vec3(0.8, 0.0, -0.2)), 400.0, 0.1)};
  if (!straight) {
    result.cables[2].through = {on_body(0, Vec3(0.05, 0.0, 0.0))};
  }
  result.cables[2].length = Function<1>::constant(straight ? 1.35 : 1.8);
  if (mixed) {
    SpatialCable rigid;
    rigid.from = on_body(0, Vec3(0.0, 0.0, 0.05));
    rigid.restitution = 0.0;
    result.cables.insert(result.cables.begin(), rigid);
  }
  result.duration = 0.6;
  return result;
}

/// The largest distance of a centre from the exact motion [m].
double farthest(const BasicSolution<SpatialSystem>& exact, const Engine& engine,
                const SpatialSystem& system, const std::string& model, double step) {
  const auto run = engine.start_system(system, model, step);
  double result = 0.0;
  for (int k = 1; k * step <= system.duration; ++k) {
    run->step(step);
    const SpatialSystemState right = exact.at(k * step);
    const SpatialSystemState now = run->state();
    for (std::size_t i = 0; i < system.bodies.size(); ++i) {
      result = std::max(result, (now.bodies[i].position - right.bodies[i].position).norm());
    }
  }
  return result;
}

TEST_P(ElasticInEngine, FollowsTheExactMotionOfAPairToFirstOrder) {
  constexpr double coarse = 1e-3;
  constexpr double fine = 1e-4;  // [s]
  for (const std::string& model : stepped_models(engine())) {
    for (const bool mixed : {false, true}) {
      const SpatialSystem system = pair_on_springs(mixed, is_drop_in(model));
      ASSERT_EQ(problems(system), std::vector<std::string>());
      const auto exact = solve(system);
      CableSet stretched;
      for (const auto& contact : elastic_contacts(exact)) {
        stretched.insert(contact.cable);
      }
      ASSERT_EQ(stretched.size(), 3U) << system.name;
      const double at_coarse = farthest(exact, engine(), system, model, coarse);
      const double at_fine = farthest(exact, engine(), system, model, fine);
      // semi-implicit steps of 1 ms are off by 3 mm in a fall of 0.6 s
      expect_within(model + " of " + system.name + ", 1e-3 s, off [m]", at_coarse, 0.01);
      expect_within(model + " of " + system.name + ", 1e-4 s, off [m]", at_fine,
                    0.2 * at_coarse + (in_double() ? 0.0 : 1e-3));
    }
  }
}

/// Two bodies on all that the law takes: the first cable is a winch's, whose load comes back and is
/// caught again, at another inertia; the second has an end that moves and a stiffness that grows;
/// the third is damped so much that it is loose before it is slack. The winch's is cut while it
/// pulls.
SpatialSystem pair_at_work() {
  SpatialSystem result = pair_on_springs(false, true);
  result.name = "pair at work";
  result.cables.pop_back();
  SpatialCable& winch = result.cables[0];
  winch.from = on_body(0, Vec3(0.0, 0.0, 0.05));
  winch.to = in_the_world_at(Vec3(0.2, 0.1, 0.2));
  winch.length.pieces = {
      {0.0, {Eigen::Matrix<double, 1, 1>(1.1), Eigen::Matrix<double, 1, 1>(-0.2)}}};
  winch.elasticity = Elasticity{{2000.0}, 0.0, 0.1};
  winch.cut_at = 0.75;
  SpatialCable& moving = result.cables[1];
  moving.to.motion.pieces = {{0.0, {Vec3::Zero(), Vec3(0.2, -0.1, 0.1)}}};
  moving.elasticity = Elasticity{{1500.0, 3000.0}, 0.0, 0.2};
  SpatialCable damped = elastic_cable(on_body(0, Vec3(0.0, 0.0, -0.05)),
                                      on_body(1, Vec3(0.05, 0.0, 0.1)), 800.0, 0.0);
  damped.elasticity->damping = 60.0;
  result.cables.push_back(damped);
  result.duration = 0.9;
  return result;
}

TEST_P(ElasticInEngine, FollowsWinchesMovingEndsCutsAndSecondContacts) {
  const SpatialSystem system = pair_at_work();
  ASSERT_EQ(problems(system), std::vector<std::string>());
  const auto exact = solve(system);
  std::array<int, 3> contacts{};
  bool loose = false;
  bool cut = false;
  for (const auto& contact : elastic_contacts(exact)) {
    ++contacts[contact.cable];
    loose = loose || (contact.cable == 2 && contact.exit &&
                      gap(system.cables[2], exact.at(*contact.exit)) < -1e-6);
    cut = cut || (contact.cable == 0 && contact.exit == system.cables[0].cut_at);
  }
  ASSERT_GE(contacts[0], 2);
  ASSERT_GE(contacts[1], 1);
  ASSERT_TRUE(loose);
  ASSERT_TRUE(cut);
  for (const std::string& model : stepped_models(engine())) {
    const double at_coarse = farthest(exact, engine(), system, model, 1e-3);
    const double at_fine = farthest(exact, engine(), system, model, 1e-4);
    // semi-implicit steps of 1 ms are off by 5 mm in a fall of 0.9 s; errors of several contacts
    // may all but cancel at one of two steps
    constexpr double usual = 2e-3;  // [m], at 1e-3 s
    expect_within(model + ", 1e-3 s, off [m]", at_coarse, 0.02);
    expect_within(model + ", 1e-4 s, off [m]", at_fine,
                  0.25 * std::max(at_coarse, usual) + (in_double() ? 0.0 : 1e-3));
  }
}

/// The same pair on the laws that only `spring` has: one force with a corner, an EA on a winch, and
/// a damper that pushes, of `cut`.
SpatialSystem pair_on_other_laws(ElasticCut cut) {
  SpatialSystem result = pair_on_springs(false, true);
  result.name = "pair on other laws";
  result.cables[0].elasticity->corners = {{0.02, 2400.0}};
  result.cables[1].elasticity->of_strain = true;
  result.cables[1].length.pieces = {
      {0.0, {Eigen::Matrix<double, 1, 1>(1.0), Eigen::Matrix<double, 1, 1>(-0.2)}}};
  result.cables[2].elasticity->damping_ratio = 0.0;
  result.cables[2].elasticity->damping = 20.0;
  result.cables[2].elasticity->cut = cut;
  return result;
}

TEST_P(ElasticInEngine, FollowsCornersStrainsAndDampersThatPush) {
  for (const ElasticCut cut : {ElasticCut::stretch, ElasticCut::never}) {
    const SpatialSystem system = pair_on_other_laws(cut);
    ASSERT_EQ(problems(system), std::vector<std::string>());
    const auto exact = solve(system);
    double bent = 0.0;    // [m], the largest stretch of the cable with a corner
    double pushed = 0.0;  // [N], the least tension of the damper that pushes
    for (int k = 0; k <= 600; ++k) {
      const SpatialSystemState state = exact.at(1e-3 * k);
      bent = std::max(bent, -gap(system.cables[0], state));
      pushed = std::min(pushed, exact.tensions(1e-3 * k)[2]);
    }
    ASSERT_GT(bent, 0.03);
    ASSERT_LT(pushed, -0.1);
    for (const std::string& model : stepped_models(engine())) {
      if (is_drop_in(model)) {
        continue;
      }
      const double at_coarse = farthest(exact, engine(), system, model, 1e-3);
      const double at_fine = farthest(exact, engine(), system, model, 1e-4);
      constexpr double usual = 2e-3;  // [m], as above
      expect_within(model + ", 1e-3 s, off [m]", at_coarse, 0.02);
      expect_within(model + ", 1e-4 s, off [m]", at_fine,
                    0.25 * std::max(at_coarse, usual) + (in_double() ? 0.0 : 1e-3));
      const auto run = engine().start_system(system, model, 1e-3);
      EXPECT_NO_THROW(static_cast<void>(bench::record(system, *run, 1e-3))) << model;
    }
  }
}

/// A rigid cable holds a load that a spring below pulls at with ten times its weight.
TEST_P(ElasticInEngine, HoldsARigidCableAgainstAPullOfManyWeights) {
  constexpr double step = 1e-3;
  constexpr double weight = 9.81;  // [m/s^2]
  constexpr double pull = 10.0;    // [-], of the weight
  SpatialSystem system = snap(0.0);
  system.gravity = Function<3>::constant(Vec3(0.0, 0.0, -weight));
  system.initial.bodies[0].position = Vec3(0.0, 0.0, -1.0);
  system.initial.bodies[0].velocity = Vec3::Zero();
  SpatialCable rigid;
  rigid.from = on_body(0);
  rigid.restitution = 0.0;
  system.cables = {elastic_cable(on_body(0), in_the_world_at(Vec3(0.0, 0.0, -3.0)),
                                 pull * weight * snap_mass, 0.0),
                   rigid};
  // In a step the load gains (1 + pull) g h, and a fifth of the overstretch goes out: it ends where
  // both are one, at 5 (1 + pull) g h^2. The pull falls by a part of the overstretch over 1 m. The
  // first step, and a step in which the cable acts late, add a way of their own each.
  const double allowed = 7.0 * (1.0 + pull) * weight * step * step;  // [m]
  for (const std::string& model : stepped_models(engine())) {
    const auto run = engine().start_system(system, model, step);
    double most = 0.0;  // [m]
    for (int k = 0; k < 2000; ++k) {
      run->step(step);
      most = std::max(most, -gap(rigid, run->state()));
    }
    expect_within(model + ": overstretch [m]", most, allowed);
  }
}

/// The same sum of the impulses by another way: the exact contacts.
TEST_P(ElasticInEngine, TellsTheImpulsesOfItsTensions) {
  constexpr double step = 1e-4;
  for (const Model& model : engine().info().models) {
    if (model.cables == Cables::inextensible) {
      continue;
    }
    const SpatialSystem system = pair_on_springs(false, is_drop_in(model.name));
    std::array<double, 3> wanted{};
    for (const auto& contact : elastic_contacts(solve(system))) {
      wanted[contact.cable] += contact.impulse;
    }
    const auto run = engine().start_system(system, model.name, step);
    std::array<double, 3> found{};
    for (int k = 0; k < 6000; ++k) {
      run->step(step);
      const auto impulses = dynamic_cast<const TensionImpulses&>(*run).tension_impulses();
      for (std::size_t cable = 0; cable < found.size(); ++cable) {
        found[cable] += impulses[cable];
      }
    }
    const bool is_exact = model.name == "event" || model.name == "sampled";
    for (std::size_t cable = 0; cable < found.size(); ++cable) {
      // some of the 3e-3 N s that a weight of 29 N gives in a step
      expect_within(model.name + ": impulse of cable " + std::to_string(cable) + " off [N s]",
                    std::abs(found[cable] - wanted[cable]), is_exact ? 1e-9 : 0.02);
    }
  }
}

/// A force that stays as it is in a step gives a spring energy where the bodies go by the mean of
/// their velocities before and after; by the new ones it does not.
TEST_P(ElasticInEngine, LetsALoadRingWithoutAGain) {
  constexpr double step = 1e-3;
  constexpr double speed = 0.05;   // [m/s]: the load rings by less than it hangs below the length
  constexpr double weight = 9.81;  // [m/s^2]
  SpatialSystem system = snap(0.0);
  system.gravity = Function<3>::constant(Vec3(0.0, weight, 0.0));
  SpatialState& start = system.initial.bodies[0];
  start.position.y() = 1.0 + weight / (snap_frequency * snap_frequency);
  start.velocity.y() = speed;
  constexpr double part = snap_frequency * step / 2.0;  // [-], of the speed, what a step changes
  for (const std::string& model : stepped_models(engine())) {
    const auto run = engine().start_system(system, model, step);
    double fastest = 0.0;  // [m/s], in the last 0.1 s
    for (int k = 0; k < 20'000; ++k) {
      run->step(step);
      const double now = std::abs(run->state().bodies[0].velocity.y());
      fastest = k < 19'900 ? 0.0 : std::max(fastest, now);
    }
    // in float rounding is a thousandth of the way of a step; a gain would be a factor of e^50, and
    // an implicit step takes as much out
    EXPECT_NEAR(fastest / speed, is_drop_in(model) ? 0.0 : 1.0, in_double() ? part : 0.5) << model;
  }
}

TEST_P(ElasticInEngine, KeepsTheDampingOfTheEntry) {
  const SpatialSystem by_ratio = snap(0.2);
  SpatialSystem by_damping = by_ratio;
  by_damping.cables[0].elasticity = Elasticity{
      {snap_mass * snap_frequency * snap_frequency}, 2.0 * 0.2 * snap_mass * snap_frequency, 0.0};
  constexpr double step = 1e-3;
  for (const std::string& model : stepped_models(engine())) {
    const auto one = engine().start_system(by_ratio, model, step);
    const auto other = engine().start_system(by_damping, model, step);
    double most = 0.0;
    for (int k = 0; k < 100; ++k) {
      one->step(step);
      other->step(step);
      most = std::max(most,
                      (one->state().bodies[0].position - other->state().bodies[0].position).norm());
    }
    expect_within(model + ": apart [m]", most, in_double() ? 1e-12 : 1e-5);
  }
}

std::string why_not(const Engine& engine, const SpatialSystem& system, const std::string& model) {
  try {
    (void)engine.start_system(system, model, 1e-3);
  } catch (const std::exception& error) {
    return error.what();
  }
  return "";
}

TEST_P(ElasticInEngine, OtherModelsSayWhichCableIsElastic) {
  std::size_t refused = 0;
  for (const Model& model : engine().info().models) {
    const SpatialSystem system = pair_on_springs(true, is_drop_in(model.name));
    if (model.cables == Cables::inextensible) {
      EXPECT_EQ(why_not(engine(), system, model.name),
                "unsupported: model " + model.name +
                    " has inextensible cables alone, cable 1 of the case is elastic");
      ++refused;
    } else {
      EXPECT_EQ(why_not(engine(), system, model.name), "");
    }
  }
  EXPECT_EQ(refused == 0, GetParam().engine == "exact");
}

/// An inextensible cable behind an elastic one keeps its number.
TEST_P(ElasticInEngine, RefusesTheInextensibleCableOfTheUser) {
  SpatialSystem system = snap(0.0);
  SpatialCable winch;
  winch.from = on_body(0);
  winch.length.pieces = {
      {0.0, {Eigen::Matrix<double, 1, 1>(1.0), Eigen::Matrix<double, 1, 1>(0.1)}}};
  system.cables.push_back(winch);
  const std::string& name = GetParam().engine;
  const std::string why =
      name == "simbody" ? "unsupported: a rope of Simbody has one length between points that stay "
                          "where they are, cable 1 changes over time"
      : name == "siconos"
          ? "unsupported: a relation of Siconos joins one body or two and knows no time, cable 1 "
            "changes over time"
          : "";
  for (const std::string& model : stepped_models(engine())) {
    EXPECT_EQ(why_not(engine(), system, model), why);
  }
}

TEST_P(ElasticInEngine, DropInCablesNeedAStiffnessThatNeverFalls) {
  SpatialSystem system = snap(0.0);
  system.cables[0].elasticity->stiffness.push_back(-1.0);
  for (const std::string& model : stepped_models(engine())) {
    EXPECT_EQ(why_not(engine(), system, model),
              is_drop_in(model)
                  ? "unsupported: cable 0 as tautline's drop-in cable: each stiffness "
                    "of an elastic cable must be a finite number of at least 0"
                  : "");
  }
}

TEST_P(ElasticInEngine, DropInCablesHaveNoCornersNoOtherCutAndNoStrainOnAWinch) {
  const auto why = [](const std::string& model, const char* problem) {
    return is_drop_in(model)
               ? std::string("unsupported: cable 0 as tautline's drop-in cable: ") + problem
               : "";
  };
  SpatialSystem bent = snap(0.0);
  bent.cables[0].elasticity->corners = {{0.01, 1.0}};
  SpatialSystem pushing = snap(0.0);
  pushing.cables[0].elasticity->cut = ElasticCut::stretch;
  SpatialSystem strained = snap(0.0);
  strained.cables[0].elasticity->of_strain = true;
  SpatialSystem wound = strained;
  wound.cables[0].length.pieces = {
      {0.0, {Eigen::Matrix<double, 1, 1>(1.0), Eigen::Matrix<double, 1, 1>(-0.2)}}};
  for (const std::string& model : stepped_models(engine())) {
    EXPECT_EQ(why_not(engine(), bent, model), why(model, "it takes no corners, but a polynomial"));
    EXPECT_EQ(why_not(engine(), pushing, model), why(model, "it takes no other cut than force"));
    EXPECT_EQ(why_not(engine(), strained, model), "");
    EXPECT_EQ(why_not(engine(), wound, model),
              why(model, "it takes an EA only of a length that does not vary"));
  }
}

TEST_P(ElasticInEngine, SpringNeedsAnElasticCable) {
  SpatialSystem system = snap(0.0);
  system.cables[0].elasticity.reset();
  constexpr const char* why =
      "unsupported: model spring needs an elastic cable, all cables of the case are inextensible";
  for (const Model& model : engine().info().models) {
    if (model.cables == Cables::inextensible) {
      continue;
    }
    if (model.cables == Cables::any) {
      EXPECT_EQ(why_not(engine(), system, model.name), "") << model.name;
      continue;
    }
    EXPECT_EQ(why_not(engine(), system, model.name), why);
    EXPECT_THROW((void)engine().start(Case{}, model.name, 1e-3), std::invalid_argument);
  }
}

/// An engine of the test's own that stops in its second step.
class StopsSoon final : public SteppedSystemSimulation {
 public:
  StopsSoon(const SpatialSystem& system, const RunSettings& /*run*/)
      : now_(system.initial), impulses_(system.cables.size()) {}

  [[nodiscard]] SpatialSystemState state() const override { return now_; }
  [[nodiscard]] std::span<const double> impulses() const override { return impulses_; }
  [[nodiscard]] std::optional<StopOfRun> stopped() const override {
    return steps_ < 2 ? std::nullopt : std::optional(StopOfRun{now_.time, "it is enough"});
  }
  void pull(const std::vector<BodyLoad>& /*loads*/) {}
  void step(double /*dt*/) override { ++steps_; }

 private:
  SpatialSystemState now_;
  std::vector<double> impulses_;
  int steps_ = 0;
};

TEST(SpringSimulation, PullsNoMoreAfterAStop) {
  constexpr double step = 1e-3;
  constexpr double stretch = 0.1;  // [m]
  SpatialSystem system = snap(0.0);
  system.initial.bodies[0].position = Vec3(1.0 + stretch, 0.0, 0.0);
  system.initial.bodies[0].velocity = Vec3::Zero();
  SpringSimulation<StopsSoon> run(system, step);
  run.step(step);
  EXPECT_NEAR(run.impulses()[0], step * snap_mass * snap_frequency * snap_frequency * stretch,
              1e-12);
  for (int k = 0; k < 2; ++k) {
    run.step(step);
    EXPECT_TRUE(run.stopped());
    EXPECT_EQ(run.impulses()[0], 0.0);
  }
}

INSTANTIATE_TEST_SUITE_P(Engines, ElasticInEngine, testing::ValuesIn(engines_with_springs()),
                         test_name);

}  // namespace
}  // namespace tautline::test
