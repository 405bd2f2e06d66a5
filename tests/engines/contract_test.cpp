// What every model of every engine must keep, found in the folder of the build's plug-ins.

#include <gtest/gtest.h>

#include <cmath>
#include <iostream>

#include "analytic/support.hpp"
#include "claims.hpp"
#include "engine_support.hpp"
#include "tautline/flight.hpp"
#include "tautline/geometry.hpp"
#include "tautline/scenarios.hpp"

namespace tautline::test {
namespace {

/// The motion of a slack step: the parabola, or semi-implicit Euler in one of its two orders.
enum class Flight { parabola, velocity_first, position_first };

class Contract : public testing::TestWithParam<ModelUnderTest> {
 protected:
  [[nodiscard]] const Engine& engine() const { return plugin_.engine(); }

  [[nodiscard]] std::unique_ptr<Simulation> start(const Case& the_case, double step) const {
    return engine().start(the_case, GetParam().model, step);
  }

  /// Rounding of an engine's numbers [-].
  [[nodiscard]] double rounding() const { return GetParam().limit(1e-15, 1e-6); }

  /// How it flies, found from one long step of a fall: the three are 0.5 m apart in it.
  [[nodiscard]] Flight flight() const {
    Case fall = bouncing_ball();
    fall.cables.front().length = 100.0;
    const auto simulation = start(fall, 1.0);
    simulation->step(1.0);
    const double fallen = fall.initial.position.y() - simulation->state().position.y();
    return fallen > 0.75 ? Flight::velocity_first
                         : (fallen > 0.25 ? Flight::parabola : Flight::position_first);
  }

  void expect(Claim claim, double reached, double allowed) const {
    expect_claim(GetParam().engine, GetParam().model, claim, reached, allowed);
  }

 private:
  bench::Plugin plugin_ = bench::Plugin::open(GetParam().plugin);
};

/// One cable through the attachment of a spinning body, slack for the first `slack` metres.
Case spinning_on_one_cable(double slack) {
  Case result;
  result.name = "spinning";
  result.body = {2.0, 0.3};
  result.gravity = Vec2(0.3, -1.2);
  result.cables = {{Vec2(0.2, 2.0), Vec2(0.3, 0.2), 1.0, 0.6}};
  result.initial = {Vec2(0.0, 1.2), 0.4, Vec2(0.1, -0.6), 1.5};
  const Cable& cable = result.cables.front();
  result.cables.front().length += slack - gap(cable, result.initial);
  result.duration = 20.0;
  return result;
}

State slack_step(State state, const Vec2& gravity, double dt, Flight flight) {
  if (flight == Flight::parabola) {
    return fly(state, gravity, dt);
  }
  if (flight == Flight::velocity_first) {
    state.velocity += dt * gravity;
  }
  state.position += dt * state.velocity;
  state.angle += dt * state.spin;
  if (flight == Flight::position_first) {
    state.velocity += dt * gravity;
  }
  return state;
}

/// The velocity change `impulses` make at the pose of `before`, times mass and inertia.
Eigen::Vector3d pull_of(const Case& the_case, const State& before, CableSet cables,
                        const CableVector& impulses) {
  Eigen::Vector3d result = Eigen::Vector3d::Zero();
  Eigen::Index row = 0;
  for (const std::size_t index : cables) {
    result += impulses[row++] * gap_gradient(the_case.cables[index], before);
  }
  return result;
}

/// By how much the change from `before` to `after` misses `pull`, relative to the momenta there.
double momentum_error(const Case& the_case, const State& before, const State& after,
                      const Eigen::Vector3d& pull) {
  const Vec2 linear = the_case.body.mass * (after.velocity - before.velocity);
  const double angular = the_case.body.inertia * (after.spin - before.spin);
  const double scale = the_case.body.mass * (before.velocity.norm() + after.velocity.norm());
  const double spin_scale =
      scale * 1.0 + the_case.body.inertia * (std::abs(before.spin) + std::abs(after.spin));
  return std::max((linear - pull.head<2>()).norm() / scale,
                  std::abs(angular - pull[2]) / spin_scale);
}

/// The velocity before a step of `dt` at the pose at which the step solves its constraints.
State at_the_solve(State before, double dt, Flight flight) {
  if (flight == Flight::position_first) {
    before.position += dt * before.velocity;
    before.angle += dt * before.spin;
  }
  return before;
}

/// The restitution the first impact of a run shows; located impacts tell it themselves, otherwise
/// it is the gap rate over the first step with an impulse, at the pose of its solve.
double first_restitution(const Case& the_case, Simulation& simulation, double step, double end,
                         Flight flight) {
  const Cable& cable = the_case.cables.front();
  double result = std::nan("");
  run(simulation, step, end, [&](const Moment& moment) {
    if (!std::isnan(result) || simulation.impulses()[0] <= 0.0) {
      return;
    }
    State before = at_the_solve(moment.before, step, flight);
    State after = moment.after;
    if (!simulation.events().empty()) {
      before = simulation.events().front().before;
      after = simulation.events().front().after;
    }
    const Eigen::Vector3d gradient = gap_gradient(cable, before);
    const double rate_after = gradient.head<2>().dot(after.velocity) + gradient[2] * after.spin;
    result = -rate_after / gap_rate(cable, before);
  });
  return result;
}

/// Names go into files and folders: small letters, digits and dashes.
bool is_name(const std::string& text) {
  return !text.empty() &&
         text.find_first_not_of("abcdefghijklmnopqrstuvwxyz0123456789-") == std::string::npos;
}

TEST_P(Contract, SaysWhatItIs) {
  const EngineInfo info = engine().info();
  EXPECT_TRUE(is_name(info.name)) << info.name;
  EXPECT_FALSE(info.version.empty());
  EXPECT_TRUE(info.precision == "float64" || info.precision == "float32") << info.precision;
  for (const Model& model : info.models) {
    EXPECT_TRUE(is_name(model.name)) << model.name;
    EXPECT_TRUE(model.sentence.ends_with('.')) << model.sentence;
    for (const Setting& setting : model.settings) {
      EXPECT_FALSE(setting.name.empty() || setting.value.empty()) << model.name;
      EXPECT_TRUE(setting.reason.ends_with('.')) << setting.name << ": " << setting.reason;
    }
  }
}

TEST_P(Contract, RefusesAModelItDoesNotHave) {
  EXPECT_THROW((void)engine().start(bouncing_ball(), "no-such-model", 1e-2), std::exception);
}

TEST_P(Contract, StartsInTheInitialState) {
  for (Case the_case : {spinning_on_one_cable(0.5), shipped_case("plate-four-cables")}) {
    the_case.initial.angle += 20.0;  // three turns and some: not wrapped
    for (Cable& cable : the_case.cables) {
      cable.length += 2.0;  // slack at any angle
    }
    const double difference_at_start = difference(start(the_case, 1e-2)->state(), the_case.initial);
    expect_within("difference from the initial state", difference_at_start, 20.0 * rounding());
  }
}

TEST_P(Contract, FliesItsRecurrenceWhileSlack) {
  const Case the_case = spinning_on_one_cable(50.0);
  constexpr double step = 1e-2;
  const auto simulation = start(the_case, step);
  const Flight way = flight();
  State wanted = the_case.initial;
  double largest = 0.0;
  run(*simulation, step, 5.0, [&](const Moment& moment) {
    wanted = slack_step(wanted, the_case.gravity, step, way);
    largest = std::max(largest, difference(moment.after, wanted));
    EXPECT_EQ(simulation->impulses()[0], 0.0);
  });
  // the numbers grow to 15; 500 steps of a few roundings each
  expect(Claim::flight, largest, 1e4 * rounding());
}

TEST_P(Contract, ChangesMomentumByItsImpulses) {
  const Flight way = flight();
  for (const std::string name : {"crane-load", "tilted-gravity", "plate-four-cables"}) {
    const Case the_case = shipped_case(name);
    constexpr double step = 1e-3;
    const auto simulation = start(the_case, step);
    const CableSet all = [&] {
      CableSet set;
      for (std::size_t index = 0; index < the_case.cables.size(); ++index) {
        set.insert(index);
      }
      return set;
    }();
    double largest = 0.0;
    int hits = 0;
    run(*simulation, step, 2.5, [&](const Moment& moment) {
      CableVector impulses(static_cast<Eigen::Index>(the_case.cables.size()));
      for (std::size_t index = 0; index < the_case.cables.size(); ++index) {
        const double impulse = simulation->impulses()[index];
        EXPECT_GE(impulse, 0.0) << name << ", cable " << index << ", t = " << moment.time;
        impulses[static_cast<Eigen::Index>(index)] = impulse;
        hits += impulse > 0.0 ? 1 : 0;
      }
      for (const Event& event : simulation->events()) {
        EXPECT_NEAR(event.time, moment.time - 0.5 * step, 0.5 * step + 1e-12) << "not this step's";
        const Eigen::Vector3d pull = pull_of(the_case, event.before, event.cables, event.impulses);
        largest = std::max(largest, momentum_error(the_case, event.before, event.after, pull));
        Eigen::Index row = 0;
        for (const std::size_t index : event.cables) {
          impulses[static_cast<Eigen::Index>(index)] -= event.impulses[row++];
        }
      }
      if (!simulation->events().empty() || GetParam().model == "event") {
        // all of the step's impulses are those of its events
        EXPECT_LE(impulses.cwiseAbs().maxCoeff(), 1e-12 * the_case.body.mass) << name;
        return;
      }
      Eigen::Vector3d pull =
          pull_of(the_case, at_the_solve(moment.before, step, way), all, impulses);
      pull.head<2>() += step * the_case.body.mass * the_case.gravity;
      largest = std::max(largest, momentum_error(the_case, moment.before, moment.after, pull));
    });
    EXPECT_GT(hits, 0) << name << ": nothing was hit, so nothing was tested";
    std::cout << "  " << name << ", momentum change less impulses:\n";
    expect(Claim::step_momentum, largest, 1e3 * rounding());
  }
}

TEST_P(Contract, ReboundsFromACentralHitWithItsRestitution) {
  const Case the_case = bouncing_ball(0.5);
  const double e = first_restitution(the_case, *start(the_case, 1e-3), 1e-3, 2.0, flight());
  expect(Claim::central_restitution, std::abs(e - 0.5), 1e4 * rounding());
}

TEST_P(Contract, ReboundsFromAnOffCentreHitWithItsRestitution) {
  const Case the_case = spinning_on_one_cable(0.05);
  const double e = first_restitution(the_case, *start(the_case, 1e-3), 1e-3, 2.0, flight());
  expect(Claim::off_centre_restitution, std::abs(e - 0.6), 1e4 * rounding());
}

TEST_P(Contract, ReboundsFromASlowHitWithItsRestitution) {
  Case the_case = bouncing_ball(0.5);
  the_case.initial.position.y() = 0.5 * 0.05 * 0.05;  // falls to 0.05 m/s
  const double e = first_restitution(the_case, *start(the_case, 1e-4), 1e-4, 0.1, flight());
  expect(Claim::slow_restitution, std::abs(e - 0.5), 1e4 * rounding());
}

TEST_P(Contract, RepeatsARunBitByBit) {
  const Case the_case = shipped_case("plate-four-cables");
  const auto one = start(the_case, 1e-3);
  const auto other = start(the_case, 1e-3);
  run(*one, 1e-3, 3.0, [&](const Moment& moment) {
    other->step(1e-3);
    ASSERT_EQ(difference(moment.after, other->state()), 0.0) << "t = " << moment.time;
  });
}

TEST_P(Contract, MovesInTheMirrorAsTheMirroredCase) {
  double largest = 0.0;
  for (const std::string name : {"breakwater/19101211150", "tilted-gravity", "plate-four-cables"}) {
    const Case the_case = shipped_case(name);
    const auto original = start(the_case, 1e-3);
    const auto image = start(mirrored(the_case), 1e-3);
    run(*original, 1e-3, 0.5, [&](const Moment& moment) {
      image->step(1e-3);
      if (!image->stopped()) {
        largest = std::max(largest, difference(moment.after, mirrored(image->state())));
      }
    });
  }
  // rounding grows with every impact; a bias of the solver's order starts at 1e-6
  expect(Claim::mirror_symmetry, largest, 1e5 * rounding());
}

TEST_P(Contract, KeepsASymmetricFallSymmetric) {
  Breakwater parameters = table_row("1910121100");
  parameters.initial = {Vec2(0.0, 0.3), 0.0, Vec2(0.0, 0.0), 0.0};
  const Case the_case = breakwater(parameters, "both cables at once");
  double largest = 0.0;
  int hits = 0;
  const auto simulation = start(the_case, 1e-3);
  run(*simulation, 1e-3, 2.0, [&](const Moment& moment) {
    largest = std::max({largest, std::abs(moment.after.position.x()), std::abs(moment.after.spin)});
    hits += simulation->impulses()[0] > 0.0 && simulation->impulses()[1] > 0.0 ? 1 : 0;
  });
  EXPECT_GT(hits, 0) << "the cables were never hit together";
  expect(Claim::mirror_symmetry, largest, 1e5 * rounding());
}

TEST_P(Contract, RunsEveryKindOfCase) {
  std::vector<std::string> names = {"bouncing-ball",     "crane-load",     "buoy-three-cables",
                                    "plate-four-cables", "tilted-gravity", "breakwater/1900461100"};
  double worst = 0.0;  // overstretch [-] of the length
  for (const std::string& name : names) {
    const Case the_case = shipped_case(name);
    const auto simulation = start(the_case, 1e-2);
    bool finite = true;
    run(*simulation, 1e-2, the_case.duration, [&](const Moment& moment) {
      finite = finite && is_finite(moment.after);
      for (const Cable& cable : the_case.cables) {
        worst = std::max(worst, -gap(cable, moment.after) / cable.length);
      }
    });
    EXPECT_TRUE(finite) << name;
    if (const auto stop = simulation->stopped()) {
      std::cout << "  " << name << ": " << stop->reason << '\n';
    }
  }
  // steps of 0.01 s overstretch by about that times the speed
  expect(Claim::overstretch, worst, 0.05);
}

/// The slope of log(deviation) over log(step): the order of a method.
double order(const std::vector<double>& steps, const std::vector<double>& deviations) {
  const auto count = static_cast<double>(steps.size());
  double mean_x = 0.0;
  double mean_y = 0.0;
  for (std::size_t k = 0; k < steps.size(); ++k) {
    mean_x += std::log(steps[k]) / count;
    mean_y += std::log(deviations[k]) / count;
  }
  double across = 0.0;
  double square = 0.0;
  for (std::size_t k = 0; k < steps.size(); ++k) {
    across += (std::log(steps[k]) - mean_x) * (std::log(deviations[k]) - mean_y);
    square += (std::log(steps[k]) - mean_x) * (std::log(steps[k]) - mean_x);
  }
  return across / square;
}

TEST_P(Contract, ConvergesAtFirstOrderOrBetter) {
  const Case the_case = table_case("1910121100");
  // below 1e-3 the rounding of positions in float is as large as the error of the step
  const std::vector<double> steps = GetParam().in_double() ? std::vector<double>{1e-2, 1e-3, 1e-4}
                                                           : std::vector<double>{1e-2, 3e-3, 1e-3};
  std::vector<double> deviations;
  for (const double step : steps) {
    deviations.push_back(largest_deviation(engine(), GetParam().model, the_case, step, 2.0));
    std::cout << "  largest deviation [m] at step " << step << ": " << deviations.back() << '\n';
  }
  if (deviations.front() <= 1e4 * rounding()) {
    return expect(Claim::convergence, 0.0, 0.15);  // exact whatever the step
  }
  // an impact comes up to a step late: 1; less than 0.85 is not the scatter of that any more
  expect(Claim::convergence, 1.0 - order(steps, deviations), 0.15);
}

INSTANTIATE_TEST_SUITE_P(All, Contract, testing::ValuesIn(models_under_test()), test_name);

}  // namespace
}  // namespace tautline::test
