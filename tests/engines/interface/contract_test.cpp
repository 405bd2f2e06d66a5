// What every model of every engine must keep, for every plug-in of the build.

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <iostream>
#include <map>
#include <numbers>

#include "analytic/support.hpp"
#include "bench/check/cases.hpp"
#include "bench/check/claims.hpp"
#include "bench/check/claims/measures.hpp"
#include "engines/engine_support.hpp"
#include "engines/interface/claims.hpp"
#include "tautline/geometry.hpp"
#include "tautline/scenarios.hpp"

namespace tautline::test {
namespace {

class Contract : public testing::TestWithParam<ModelUnderTest> {
 protected:
  [[nodiscard]] const Engine& engine() const { return plugin_.engine(); }

 private:
  bench::Plugin plugin_ = bench::Plugin::open(GetParam().plugin);
};

/// Claims that the engines here keep to rounding, and how many roundings are allowed [-]. What
/// takes a contact of one step to be so exact is an exception of a model that takes more.
const std::map<std::string_view, double> roundings = {
    {"flight", 1e4},  // numbers grow to 15, in 500 steps of a few roundings each
    {"central-restitution", 1e4},
    {"off-centre-restitution", 1e4},
    {"slow-restitution", 1e4},
    {"step-momentum", 1e3},
    {"mirror-symmetry", 1e5},  // grow with every impact; a solver's order starts at 1e-6
};

constexpr std::string_view convergence_claim = "convergence";
constexpr std::string_view moving_anchor_claim = "moving-anchor";

/// Models whose cables in space end at points that stay where they are.
bool knows_no_moving_anchor(std::string_view engine_name, std::string_view model) {
  return engine_name == "siconos" ||
         (engine_name == "simbody" && (model == "rope" || model == "event-handler"));
}

/// Whether the model `name` refuses the systems of `claim`. A model that says it runs systems in
/// space runs all of the claims, but for moving anchors where it has none.
bool is_refused(const bench::Claim& claim, const EngineInfo& info, std::string_view name) {
  const bool in_space =
      std::any_of(info.models.begin(), info.models.end(),
                  [name](const Model& model) { return model.name == name && model.in_space; });
  return claim.in_space && (!in_space || (claim.name == moving_anchor_claim &&
                                          knows_no_moving_anchor(info.name, name)));
}

/// What `measure` may reach here: at most what a sound engine must.
double allowed(const bench::Claim& claim, const bench::Measure& measure, double rounding) {
  const auto strict = roundings.find(claim.name);
  return strict == roundings.end() ? measure.limit
                                   : std::min(measure.limit, strict->second * rounding);
}

TEST_P(Contract, KeepsItsClaims) {
  const auto& [plugin, engine_name, model, precision] = GetParam();
  const bench::Subject subject(engine(), model);
  for (const bench::Claim& claim : bench::claims()) {
    if (claim.name == convergence_claim) {
      continue;  // below
    }
    const bool refused = is_refused(claim, engine().info(), model);
    try {
      const bench::Measure measure = claim.measure(subject);
      EXPECT_FALSE(refused) << claim.name << " applies now";
      expect_claim(engine_name, model, claim.name, measure.found,
                   allowed(claim, measure, subject.rounding()));
      std::cout << "    " << measure.sentence << '\n';
    } catch (const bench::NotRun& why) {
      EXPECT_TRUE(refused) << claim.name << ": " << why.what();
      std::cout << "  " << claim.name << " does not apply: " << why.what() << '\n';
    }
  }
}

/// Where an impact falls in its step scatters a slope of 1 by this [-].
constexpr double slope_scatter = 0.15;

/// An impact noticed a step late costs its speed times the step. Speeds are about 1 m/s here, and a
/// run has a few impacts: those that are solved in one step come to 1.71 at most.
constexpr double accuracy_limit = 2.0;  // [m/s], deviation over step

/// The order is asked for from both sides in double, and in float only from below: there rounding
/// adds to the smallest deviation, and steps cover one decade only.
TEST_P(Contract, ComesToTheExactMotionAtFirstOrder) {
  const auto& [plugin, engine_name, model, precision] = GetParam();
  const bench::Convergence run = bench::convergence(bench::Subject(engine(), model));
  double worst = 0.0;  // deviation over step [m/s]
  for (std::size_t k = 0; k < run.steps.size(); ++k) {
    worst = bench::worse(worst, run.deviations[k] / run.steps[k]);
    std::cout << "    off by " << run.deviations[k] << " m at " << run.steps[k] << " s\n";
  }
  // what is rounding alone does not fall with the step; a slope is none where all deviations are 0
  EXPECT_FALSE(run.exact && run.slope > 0.5) << "taken as exact with a slope of " << run.slope;
  const double missed = GetParam().in_double() ? std::abs(1.0 - run.slope) : 1.0 - run.slope;
  expect_claim(engine_name, model, convergence_claim, run.exact ? 0.0 : missed, slope_scatter);
  expect_claim(engine_name, model, bench::accuracy_claim, worst, accuracy_limit);
}

/// The two models of Bullet whose error no step makes small, whatever slope it scatters to.
TEST(ContractOfBullet64, ContactAndBounceLimitDoNotConvergeAtAll) {
  const std::optional<bench::Plugin> plugin = plugin_of("bullet64");
  if (!plugin) {
    GTEST_SKIP() << "bullet64 is not built";
  }
  constexpr double stays = 1e-2;  // [m], of cables of 1 m
  for (const char* const model : {"contact", "bounce-limit"}) {
    const bench::Convergence run = bench::convergence(bench::Subject(plugin->engine(), model));
    EXPECT_FALSE(run.exact) << model;
    EXPECT_GT(run.deviations.back(), run.deviations.front() / 3.0) << model;
    EXPECT_GT(run.deviations.back(), stays) << model;
  }
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

/// A rigid cable overstretches by the way of one step. A spring on which a bounce takes 20 steps
/// stretches by 20 / pi of them.
constexpr double longest_stretch = bench::longest_contact / std::numbers::pi;

TEST_P(Contract, RunsEveryKindOfCase) {
  std::vector<std::string> names = {"bouncing-ball",     "crane-load",     "buoy-three-cables",
                                    "plate-four-cables", "tilted-gravity", "breakwater/1900461100"};
  for (const std::string& name : names) {
    const Case the_case = bench::shipped_case(name);
    const auto simulation = engine().start(the_case, GetParam().model, 1e-2);
    double fastest = 0.0;
    double worst = 0.0;  // overstretch [m]
    bool finite = true;
    bench::run(*simulation, 1e-2, the_case.duration, [&](const bench::Moment& moment) {
      finite = finite && is_finite(moment.after);
      fastest = std::max(fastest, speed_scale(the_case, moment.after));
      for (const Cable& cable : the_case.cables) {
        worst = std::max(worst, -gap(cable, moment.after));
      }
    });
    EXPECT_TRUE(finite) << name;
    expect_within(name + ": overstretch, in steps at the fastest speed", worst / (1e-2 * fastest),
                  longest_stretch);
    if (const auto stop = simulation->stopped()) {
      std::cout << "  " << name << ": " << stop->reason << '\n';
    }
  }
}

INSTANTIATE_TEST_SUITE_P(All, Contract, testing::ValuesIn(models_under_test()), test_name);

}  // namespace
}  // namespace tautline::test
