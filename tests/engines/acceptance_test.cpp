// What the engines reach on the cases of Table 5.1, held against the exact solver.

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <iostream>
#include <utility>

#include "analytic/support.hpp"
#include "engine_support.hpp"
#include "tautline/geometry.hpp"
#include "tautline/impact.hpp"
#include "tautline/solve.hpp"

namespace tautline::test {
namespace {

constexpr const char* standard = "1910121100";
constexpr const char* elastic = "1110121100";  // the same with e = 1

/// A test of one engine, skipped where it is not built.
class WithEngine : public testing::TestWithParam<std::string> {
 protected:
  void SetUp() override {
    plugin_ = plugin_of(GetParam());
    if (!plugin_) {
      GTEST_SKIP() << GetParam() << " is not built";
    }
  }
  [[nodiscard]] const Engine& engine() const { return plugin_->engine(); }

 private:
  std::optional<bench::Plugin> plugin_;
};

/// The events of a run of the `event` model.
std::vector<Event> events_of(const Engine& engine, const Case& the_case, double step, double end) {
  std::vector<Event> result;
  const auto simulation = engine.start(the_case, "event", step);
  run(*simulation, step, end, [&](const Moment&) {
    const auto events = simulation->events();
    result.insert(result.end(), events.begin(), events.end());
  });
  return result;
}

/// The closing rate of the fastest cable of an impact [m/s].
double closing_rate(const Case& the_case, const Event& event) {
  double fastest = 0.0;
  for (const std::size_t index : event.cables) {
    fastest = std::max(fastest, -gap_rate(the_case.cables[index], event.before));
  }
  return fastest;
}

class EventModel : public WithEngine {};

std::string engine_name(const testing::TestParamInfo<std::string>& info) { return info.param; }

TEST_P(EventModel, IsExactToRoundingWhateverTheStep) {
  const Case the_case = table_case(standard);
  const Event first = solve(the_case).events().front();
  for (const double step : {0.1, 1e-2, 1e-3}) {
    const std::string at = " at step " + std::to_string(step);
    const auto events = events_of(engine(), the_case, step, 2.0);
    ASSERT_FALSE(events.empty());
    expect_within("position error [m], t <= 2" + at,
                  largest_deviation(engine(), "event", the_case, step, 2.0), 1e-11);
    expect_within("first impact time error [s]" + at, std::abs(events.front().time - first.time),
                  1e-12);
    expect_within("first impact velocity error" + at, difference(events.front().after, first.after),
                  1e-12);
  }
}

TEST_P(EventModel, CountsTheImpactsOfTheStandardCase) {
  const Case the_case = table_case(standard);
  for (const double step : {0.1, 1e-2, 1e-3}) {
    int fast = 0;
    for (const Event& event : events_of(engine(), the_case, step, 5.0)) {
      fast += closing_rate(the_case, event) > 1e-2 ? 1 : 0;
    }
    std::cout << "  impacts faster than 1e-2 m/s, t <= 5, step " << step << ": " << fast << '\n';
    EXPECT_EQ(fast, 21);
  }
}

TEST_P(EventModel, KeepsTheEnergyOfElasticImpacts) {
  const Case the_case = table_case(elastic);
  const double start = energy(the_case, the_case.initial);
  const auto simulation = engine().start(the_case, "event", 1e-2);
  double drift = 0.0;
  double reached = 0.0;
  run(*simulation, 1e-2, 10.0, [&](const Moment& moment) {
    drift = std::max(drift, std::abs(energy(the_case, moment.after) - start));
    reached = moment.time;
  });
  EXPECT_NEAR(reached, 10.0, 1e-2);
  expect_within("energy drift [J], t <= 10", drift, 1e-12);
}

/// A random body with all of `count` cables at zero gap, and at least one of them closing.
Case hit_on_several_cables(Random& random, std::size_t count) {
  Case result = random_impact(random, count);
  result.duration = 1e-8;  // the hit is all that is asked for
  if (count > 1 && random.chance(0.2)) {
    result.cables[1] = result.cables[0];  // two cables side by side: the rows are the same
  }
  return result;
}

TEST_P(EventModel, SolvesHitsOnManyCablesAsNewtonsLaw) {
  Random random(11);
  for (std::size_t count = 1; count <= max_cables; ++count) {
    double worst = 0.0;
    int hits = 0;
    for (int trial = 0; trial < 200; ++trial) {
      const Case the_case = hit_on_several_cables(random, count);
      const auto simulation = engine().start(the_case, "event", 1e-2);
      simulation->step(1e-9);
      if (simulation->events().empty()) {
        continue;  // all of the closing rates were rounding
      }
      const Event& event = simulation->events().front();
      const State wanted = newton_impact(the_case, event.before, event.cables).after;
      const double speed = speed_scale(the_case, event.before);
      worst = std::max(worst, (event.after.velocity - wanted.velocity).norm() / speed);
      worst = std::max(worst, std::abs(event.after.spin - wanted.spin) / speed);
      ++hits;
    }
    EXPECT_GT(hits, 100);
    expect_within(std::to_string(count) + " cables: velocity error [-]", worst, 1e-11);
  }
}

/// Where the impacts of cases first accumulate whose starts differ from `the_case`'s by up to
/// 1e-14 m: what the rounding of an engine may do to an accumulation on two cables.
std::pair<double, double> accumulations_within_rounding(const Case& the_case) {
  SolveOptions as_the_driver;
  as_the_driver.completion.speed = 1e-6;  // where it gives an accumulation up
  double first = the_case.duration;
  double last = 0.0;
  for (int shift = -10; shift <= 10; ++shift) {
    Case shifted = the_case;
    shifted.initial.position.x() += 1e-15 * shift;
    const Accumulation bounces = solve(shifted, as_the_driver).accumulations().at(0);
    first = std::min(first, bounces.time);
    last = std::max(last, bounces.time);
  }
  return {first, last};
}

TEST_P(EventModel, StopsWhereTheExactImpactsAccumulate) {
  for (const std::string number : {standard, "1510121100"}) {
    const Case the_case = table_case(number);
    const auto [first, last] = accumulations_within_rounding(the_case);
    ASSERT_LT(last, 10.0) << number << ": not before the end of the run";
    // a bounce more or less at the driver's speed, besides
    const double margin = (last - first) + 1e-5;
    for (const double step : {0.1, 1e-3}) {
      const auto simulation = engine().start(the_case, "event", step);
      run(*simulation, step, 20.0, [](const Moment&) {});
      if (GetParam() == "exact") {
        EXPECT_FALSE(simulation->stopped()) << simulation->stopped()->reason;
        continue;  // it follows the motion on taut cables
      }
      ASSERT_TRUE(simulation->stopped()) << number << " at step " << step;
      std::cout << "  " << number << " at step " << step << ": " << simulation->stopped()->reason
                << "; exact from " << first << " to " << last << '\n';
      EXPECT_GE(simulation->stopped()->time, first - margin);
      EXPECT_LE(simulation->stopped()->time, last + margin);
      EXPECT_TRUE(simulation->stopped()->reason.starts_with("impacts accumulate at t = "));
    }
  }
}

INSTANTIATE_TEST_SUITE_P(Acceptance, EventModel,
                         testing::Values<std::string>("exact", "bullet64", "ode"), engine_name);

TEST(Sampled, IsTheExactSolutionWithoutItsEvents) {
  const auto plugin = plugin_of("exact");
  if (!plugin) {
    GTEST_SKIP() << "exact is not built";
  }
  const Case the_case = table_case(standard);
  const auto located = plugin->engine().start(the_case, "event", 1e-2);
  const auto sampled = plugin->engine().start(the_case, "sampled", 1e-2);
  std::size_t impacts = 0;
  run(*located, 1e-2, the_case.duration + 0.1, [&](const Moment& moment) {
    sampled->step(1e-2);
    impacts += located->events().size();
    EXPECT_TRUE(sampled->events().empty()) << "t = " << moment.time;
    EXPECT_EQ(difference(sampled->state(), moment.after), 0.0) << "t = " << moment.time;
    EXPECT_TRUE(std::ranges::equal(sampled->impulses(), located->impulses()))
        << "t = " << moment.time;
    EXPECT_EQ(sampled->stopped().has_value(), located->stopped().has_value());
  });
  EXPECT_GT(impacts, 0U) << "nothing was hit, so nothing was tested";
  EXPECT_TRUE(sampled->stopped()) << "the end of the solution was not reached";
}

class NativeModel : public testing::TestWithParam<ModelUnderTest> {};

TEST_P(NativeModel, ConvergesAtFirstOrder) {
  const auto plugin = plugin_of(GetParam().engine);
  if (!plugin) {
    GTEST_SKIP() << GetParam().engine << " is not built";
  }
  const Case the_case = table_case(standard);
  std::vector<double> deviations;
  for (const double step : {1e-2, 1e-3, 1e-4}) {
    deviations.push_back(
        largest_deviation(plugin->engine(), GetParam().model, the_case, step, 2.0));
    std::cout << "  largest deviation [m] at step " << step << ": " << deviations.back() << '\n';
  }
  const double slope = 0.5 * std::log10(deviations.front() / deviations.back());
  std::cout << "  slope " << slope << '\n';
  testing::Test::RecordProperty("slope", std::to_string(slope));
  EXPECT_GE(slope, 0.85);
  EXPECT_LE(slope, 1.15);
}

INSTANTIATE_TEST_SUITE_P(Acceptance, NativeModel,
                         testing::Values(ModelUnderTest{{}, "bullet64", "row"},
                                         ModelUnderTest{{}, "bullet64", "early"},
                                         ModelUnderTest{{}, "bullet64", "contact-tuned"},
                                         ModelUnderTest{{}, "ode", "row"},
                                         ModelUnderTest{{}, "ode", "early"}),
                         test_name);

TEST(BounceLimit, DoesNotConverge) {
  const auto plugin = plugin_of("bullet64");
  if (!plugin) {
    GTEST_SKIP() << "bullet64 is not built";
  }
  const Case the_case = table_case(standard);
  const auto deviation = [&](double step) {
    const double result = largest_deviation(plugin->engine(), "bounce-limit", the_case, step, 2.0);
    std::cout << "  largest deviation [m] at step " << step << ": " << result << '\n';
    return result;
  };
  const double coarse = deviation(1e-2);
  const double fine = deviation(1e-4);
  EXPECT_GT(fine, coarse / 3.0);
  EXPECT_GT(fine, 1e-2);
}

TEST(BulletContact, DoesNotGetBetterWithSmallerSteps) {
  const auto plugin = plugin_of("bullet64");
  if (!plugin) {
    GTEST_SKIP() << "bullet64 is not built";
  }
  const Case the_case = table_case(standard);
  const auto deviation = [&](double step) {
    const double result = largest_deviation(plugin->engine(), "contact", the_case, step, 2.0);
    std::cout << "  largest deviation [m] at step " << step << ": " << result << '\n';
    return result;
  };
  const double coarse = deviation(1e-2);
  const double middle = deviation(1e-3);
  const double fine = deviation(1e-4);
  // a first-order model would be ten and a hundred times better
  EXPECT_GT(middle, coarse / 3.0);
  EXPECT_GT(fine, coarse / 3.0);
  EXPECT_GT(fine, 1e-2);
}

TEST(Row, IsTheSameInBulletAndOde) {
  const auto bullet = plugin_of("bullet64");
  const auto ode = plugin_of("ode");
  if (!bullet || !ode) {
    GTEST_SKIP() << "bullet64 or ode is not built";
  }
  const Case the_case = table_case(standard);
  for (const std::string model : {"row", "early"}) {
    const auto one = bullet->engine().start(the_case, model, 1e-3);
    const auto other = ode->engine().start(the_case, model, 1e-3);
    double largest = 0.0;
    run(*one, 1e-3, 5.0, [&](const Moment& moment) {
      other->step(1e-3);
      largest = std::max(largest, difference(moment.after, other->state()));
    });
    expect_within(model + ": difference of the whole state, t <= 5", largest, 1e-10);
  }
}

}  // namespace
}  // namespace tautline::test
