// What is MuJoCo's own: its tendon's bounce and its law, and what it would tell the user's folder.

#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <filesystem>
#include <memory>
#include <string>
#include <vector>

#include "analytic/support.hpp"
#include "bench/measure/attribution/carry.hpp"
#include "bench/measure/attribution/soft_motion.hpp"
#include "engines/engine_support.hpp"
#include "tautline/elasticity.hpp"
#include "tautline/geometry.hpp"
#include "tautline/scenarios.hpp"

namespace tautline::test {
namespace {

class Mujoco : public testing::Test {
 protected:
  void SetUp() override {
    plugin_ = plugin_of("mujoco");
    if (!plugin_) {
      GTEST_SKIP() << "mujoco is not built";
    }
  }
  [[nodiscard]] const Engine& engine() const { return plugin_->engine(); }

 private:
  std::optional<bench::Plugin> plugin_;
};

constexpr double bounce_step = 1e-3;

/// The restitution of the first bounce without gravity, which begins `late` [-] of a step before
/// the cable is looked at: the rate when the pull has ended.
double restitution_of_bounce(const Engine& engine, const std::string& model, double e,
                             double late) {
  Case the_case = bouncing_ball(e);
  the_case.gravity = Vec2(0.0, 0.0);
  the_case.initial.velocity = Vec2(0.0, -1.0);
  the_case.initial.position.y() = (200.0 - late) * bounce_step;
  double result = std::nan("");
  bool pulled = false;
  const auto simulation = engine.start(the_case, model, bounce_step);
  run(*simulation, bounce_step, 1.0, [&](const Moment& moment) {
    const bool pulls = simulation->impulses()[0] > 0.0;
    if (pulled && !pulls && std::isnan(result)) {
      result = gap_rate(the_case.cables.front(), moment.after);  // it closed at 1 m/s
    }
    pulled = pulls;
  });
  return result;
}

/// By how much the bounces of a model miss their restitution.
double restitution_error(const Engine& engine, const std::string& model) {
  double worst = 0.0;
  for (const double e : {1.0, 0.9, 0.7, 0.5, 0.3, 0.1, 0.02}) {
    for (const double late : {0.1, 0.3, 0.5, 0.7, 0.9}) {
      worst = std::max(worst, std::abs(restitution_of_bounce(engine, model, e, late) - e));
    }
  }
  return worst;
}

TEST_F(Mujoco, TendonLimitsReboundWithNearlyTheirRestitution) {
  // a bounce lasts 20 steps or fewer: Euler's damping lags by part of one, and both integrators
  // see the pull set in and end inside one
  expect_within("Euler", restitution_error(engine(), "tendon-limit"), 0.04);
  expect_within("RK4", restitution_error(engine(), "tendon-limit-rk4"), 0.02);
}

constexpr double soft_frequency = 50.0;                  // [1/s]: a contact lasts 60 steps of 1 ms
constexpr double soft_ratio = 0.1;                       // [-]
constexpr double soft_speed = 0.5;                       // [m/s], at the entry
constexpr std::array soft_steps = {1e-3, 5e-4, 2.5e-4};  // [s]

/// A run with the same spring and damper at every step.
std::unique_ptr<Simulation> start_soft(const Engine& engine, const Case& the_case,
                                       const std::string& model, double dt) {
  RunSettings settings(dt);
  settings.parameters = {{"stiffness", soft_frequency * soft_frequency},
                         {"damping", 2.0 * soft_ratio * soft_frequency}};
  return engine.start(the_case, model, settings);
}

/// A ball that flies into its cable, with a load on it or none, and back.
Case into_the_cable(double load) {
  Case the_case = bouncing_ball(0.5);
  the_case.gravity = Vec2(0.0, -load);
  the_case.initial.velocity = Vec2(0.0, -soft_speed);
  the_case.initial.position.y() = 0.01;
  the_case.duration = 0.12;
  return the_case;
}

/// The mean of `error(case, dt)` over where in a step of `dt` [s] the contact begins.
template <class Error>
double over_the_step(Case the_case, double dt, const Error& error) {
  constexpr int parts = 5;
  double sum = 0.0;
  for (int part = 0; part < parts; ++part) {
    sum += error(the_case, dt);
    the_case.initial = bench::flown(the_case, the_case.initial, dt / parts);
  }
  return sum / parts;
}

/// The errors at the three steps are small, and the last is a fourth of the first.
template <class Error>
void expect_first_order(const std::string& what, const Case& the_case, double most,
                        const Error& error) {
  std::vector<double> found;
  for (const double dt : soft_steps) {
    found.push_back(over_the_step(the_case, dt, error));
    expect_within(what + " at " + std::to_string(dt), found.back(), most * dt / soft_steps[0]);
  }
  // an order of 1 within 0.3: where in its step a contact ends is not averaged
  EXPECT_NEAR(std::log2(found.front() / found.back()) / 2.0, 1.0, 0.3) << what;
}

TEST_F(Mujoco, TendonLimitsFollowTheirRowLawToFirstOrder) {
  const std::vector<Case> shipped = shipped_cases();
  Case spinning = *std::ranges::find(shipped, "breakwater/2910121100", &Case::name);
  spinning.duration = 0.9;
  constexpr double most = 5e-4;  // [m], a step's way at the speeds of these cases
  for (const std::string model : {"tendon-limit", "tendon-limit-rk4"}) {
    for (const Case& the_case : {into_the_cable(0.0), into_the_cable(9.81), spinning}) {
      const auto off = [&](const Case& one, double dt) {
        const auto simulation = start_soft(engine(), one, model, dt);
        const auto told = dynamic_cast<const SoftCables&>(*simulation).soft_rows();
        EXPECT_EQ(told.size(), one.cables.size());
        EXPECT_DOUBLE_EQ(told[0].stiffness, soft_frequency * soft_frequency);
        EXPECT_DOUBLE_EQ(told[0].damping, 2.0 * soft_ratio * soft_frequency);
        EXPECT_DOUBLE_EQ(told[0].load, 0.9999);
        run(*simulation, dt, one.duration, [](const Moment&) {});
        const auto exact = bench::soft_motion(one, told, one.duration);
        return exact ? (simulation->state().position - exact->position).norm() : std::nan("");
      };
      expect_first_order(model + ", " + the_case.name, the_case, most, off);
    }
  }
}

// (E6) and (E8) of analytic/README.md: no load, so that the row is an elastic cable
TEST_F(Mujoco, TendonLimitsBounceAsTheClosedFormsSay) {
  const double root = std::sqrt(1.0 - soft_ratio * soft_ratio);
  const double part = std::exp(-soft_ratio * (std::acos(0.0) - 3.0 * std::asin(soft_ratio)) / root);
  const auto bounce = [&](const Case& one, double dt) {
    const auto simulation = start_soft(engine(), one, "tendon-limit", dt);
    double peak = 0.0;
    run(*simulation, dt, one.duration,
        [&](const Moment&) { peak = std::max(peak, simulation->impulses()[0] / dt); });
    const double e = simulation->state().velocity.y() / soft_speed;
    const double exact_peak = one.body.mass * soft_speed * soft_frequency * part;
    return std::abs(e - restitution_of(soft_ratio)) + std::abs(peak / exact_peak - 1.0);
  };
  // the frequency times the step is 0.05: a tenth of it
  expect_first_order("restitution and peak", into_the_cable(0.0), 0.01, bounce);
}

// a spring of this frequency sags by g / w^2 = 4 mm; the limit lets a body fall for less than a
// step dt at a time, and a speed of g dt stretches it by g dt / w at most
TEST_F(Mujoco, ATendonLimitTakesOverTheLoad) {
  constexpr double weight = 9.81;  // [m/s^2]
  constexpr double settled = 2.0;  // [s]
  Case the_case = into_the_cable(weight);
  the_case.duration = 3.0;
  for (const double dt : soft_steps) {
    const auto simulation = start_soft(engine(), the_case, "tendon-limit", dt);
    double sag = 0.0;
    run(*simulation, dt, the_case.duration, [&](const Moment& moment) {
      const double stretch = -gap(the_case.cables[0], simulation->state());
      sag = moment.time < settled ? 0.0 : std::max(sag, stretch);
    });
    expect_within("stretch at " + std::to_string(dt), sag, weight * dt / soft_frequency);
  }
}

TEST_F(Mujoco, FailsWhereABodyDivergesAndWritesNoLog) {
  Case the_case = bouncing_ball();
  the_case.gravity = Vec2(0.0, -1e12);  // MuJoCo goes back to the start beyond 1e10
  for (const std::string model : {"tendon-limit", "tendon-limit-rk4", "impulse", "event"}) {
    const auto simulation = engine().start(the_case, model, 1e-2);
    EXPECT_THROW(simulation->step(1e-2), std::exception) << model;
  }
  EXPECT_FALSE(std::filesystem::exists("MUJOCO_LOG.TXT"));
}

TEST_F(Mujoco, RefusesABodyLighterThanItCanDo) {
  Case the_case = bouncing_ball();
  the_case.body.mass = 1e-16;
  EXPECT_THROW((void)engine().start(the_case, "event", 1e-2), std::exception);
}

}  // namespace
}  // namespace tautline::test
