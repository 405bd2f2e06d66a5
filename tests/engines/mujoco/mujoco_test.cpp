// What is MuJoCo's own: its tendon's bounce, and what it would tell the user's folder.

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <filesystem>

#include "analytic/support.hpp"
#include "engines/engine_support.hpp"
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

constexpr double step = 1e-3;

/// The restitution of the first bounce without gravity, which begins `late` [-] of a step before
/// the cable is looked at: the rate when the pull has ended.
double restitution_of_bounce(const Engine& engine, const std::string& model, double e,
                             double late) {
  Case the_case = bouncing_ball(e);
  the_case.gravity = Vec2(0.0, 0.0);
  the_case.initial.velocity = Vec2(0.0, -1.0);
  the_case.initial.position.y() = (200.0 - late) * step;
  double result = std::nan("");
  bool pulled = false;
  const auto simulation = engine.start(the_case, model, step);
  run(*simulation, step, 1.0, [&](const Moment& moment) {
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
