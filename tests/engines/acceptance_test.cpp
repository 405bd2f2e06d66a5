// What the engines reach on the cases of Table 5.1, held against the exact solver.

#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <iostream>
#include <utility>

#include "analytic/support.hpp"
#include "bench/check/cases.hpp"
#include "engines/engine_support.hpp"
#include "tautline/cable_row.hpp"
#include "tautline/geometry.hpp"
#include "tautline/impact.hpp"
#include "tautline/solve.hpp"

namespace tautline::test {
namespace {

constexpr const char* standard = "1910121100";
constexpr const char* elastic = "1110121100";  // the same with e = 1

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

/// The `event` model of every engine that has one.
class EventModel : public testing::TestWithParam<ModelUnderTest> {
 protected:
  [[nodiscard]] const Engine& engine() const { return plugin_.engine(); }

  /// In float the rounding grows with the number of steps, and a long step loses little: the step
  /// at which it does best is the one that is asked for.
  [[nodiscard]] static std::vector<double> steps() {
    return in_double() ? std::vector<double>{0.1, 1e-2, 1e-3} : std::vector<double>{1e-2};
  }
  [[nodiscard]] static bool in_double() { return GetParam().in_double(); }
  [[nodiscard]] static double limit(double for_double, double for_float) {
    return GetParam().limit(for_double, for_float);
  }

 private:
  bench::Plugin plugin_ = bench::Plugin::open(GetParam().plugin);
};

TEST_P(EventModel, IsExactToRoundingWhateverTheStep) {
  const Case the_case = table_case(standard);
  const Event first = solve(the_case).events().front();
  for (const double step : steps()) {
    const std::string at = " at step " + std::to_string(step);
    const auto events = events_of(engine(), the_case, step, 2.0);
    ASSERT_FALSE(events.empty());
    expect_within("position error [m], t <= 2" + at,
                  largest_deviation(engine(), "event", the_case, step, 2.0), limit(1e-11, 2e-6));
    expect_within("first impact time error [s]" + at, std::abs(events.front().time - first.time),
                  limit(1e-12, 2e-6));
    // in float the hit is found at a pose that is off by rounding, and the spin is 10 times larger
    expect_within("first impact velocity error" + at, difference(events.front().after, first.after),
                  limit(1e-12, 2e-5));
  }
}

TEST_P(EventModel, CountsTheImpactsOfTheStandardCase) {
  const Case the_case = table_case(standard);
  for (const double step : steps()) {
    int fast = 0;
    for (const Event& event : events_of(engine(), the_case, step, 5.0)) {
      fast += closing_speed(the_case, event.cables, event.before) > 1e-2 ? 1 : 0;
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
  run(*simulation, 1e-2, 20.0, [&](const Moment& moment) {
    drift = std::max(drift, std::abs(energy(the_case, moment.after) - start));
    reached = moment.time;
  });
  EXPECT_NEAR(reached, 20.0, 1e-2);
  expect_within("energy drift [J], t <= 20", drift, limit(1e-12, 1e-5));
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

/// Far from the origin a float has few digits of a gap: closing what is left of one in a short
/// swing would throw the body away.
TEST_P(EventModel, GainsNoEnergyFarFromTheOrigin) {
  Case the_case;
  the_case.body = {1.0, 0.01};
  the_case.gravity = {0.0, -9.81};
  the_case.duration = 3.0;
  the_case.cables.resize(2);
  the_case.cables[0].anchor = {300.0, 303.0};
  the_case.cables[0].attachment = {0.1, 0.0};
  the_case.cables[0].length = 1.0;
  the_case.cables[0].restitution = 0.7;
  the_case.cables[1].anchor = {301.0, 303.0};
  the_case.cables[1].attachment = {-0.1, 0.0};
  the_case.cables[1].length = 1.2;
  the_case.cables[1].restitution = 0.7;
  the_case.initial.position = {300.3, 302.6};
  const auto simulation = engine().start(the_case, "event", 1e-2);
  const double start = energy(the_case, the_case.initial);
  double highest = start;
  run(*simulation, 1e-2, 3.0,
      [&](const Moment& moment) { highest = std::max(highest, energy(the_case, moment.after)); });
  expect_within("rise of the energy [J]", highest - start, limit(1e-9, 0.02));
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
    expect_within(std::to_string(count) + " cables: velocity error [-]", worst, limit(1e-11, 5e-3));
  }
}

/// Six cases over the range of parameters, and their impacts faster than 1e-2 m/s up to t = 5.
struct CountedCase {
  const char* name;
  Breakwater parameters;
  int impacts;
};

std::vector<CountedCase> counted_cases() {
  const auto parameters = [](double r, double e, double a, double b, double angle, double spin) {
    Breakwater result = table_row(standard);
    result.r = r;
    result.e = e;
    result.a = a;
    result.b = b;
    result.shape = b > 0.0 ? Shape::box : Shape::ring;
    result.initial.angle = angle;
    result.initial.spin = spin;
    return result;
  };
  return {{"standard", parameters(1.5, 0.9, 0.1, 0.0, 0.0, 0.0), 21},
          {"elastic", parameters(1.5, 1.0, 0.1, 0.0, 0.0, 0.0), 16},
          {"long-cables", parameters(2.5, 0.7, 0.2, 0.2, 0.1, 0.0), 20},
          {"wide-body", parameters(1.5, 0.9, 0.3, 0.1, 0.05, 0.1), 26},
          {"soft", parameters(1.5, 0.5, 0.1, 0.1, 0.15, 0.05), 22},
          {"long-elastic", parameters(2.5, 1.0, 0.3, 0.3, 0.05, 0.02), 12}};
}

bool accumulates_before(const Case& the_case, double time) {
  const Solution exact = solve(the_case);
  return !exact.accumulations().empty() && exact.accumulations().front().start < time;
}

TEST_P(EventModel, CountsTheImpactsOfSixCases) {
  for (const CountedCase& counted : counted_cases()) {
    const Case the_case = breakwater(counted.parameters, counted.name);
    if (!in_double() && accumulates_before(the_case, 5.0)) {
      continue;  // which cable is hit when from there on, rounding to float decides
    }
    for (const double step : {1e-2, 1e-3}) {
      int fast = 0;
      for (const Event& event : events_of(engine(), the_case, step, 5.0)) {
        fast += closing_speed(the_case, event.cables, event.before) > 1e-2 ? 1 : 0;
      }
      std::cout << "  " << counted.name << " at step " << step << ": " << fast << '\n';
      EXPECT_EQ(fast, counted.impacts) << counted.name << " at step " << step;
    }
  }
}

TEST_P(EventModel, FollowsTheMotionOnTautCables) {
  const Case the_case = table_case(standard);
  for (const double step : {1e-2, 1e-3}) {
    expect_within("position error [m], t <= 20, step " + std::to_string(step),
                  largest_deviation(engine(), "event", the_case, step, 20.0),
                  0.5 * step * step + limit(0.0, 1e-3));
  }
}

TEST_P(EventModel, IsOfSecondOrderOnTautCables) {
  const CountedCase soft = counted_cases()[4];  // taut from t = 0.58 on
  const Case the_case = breakwater(soft.parameters, soft.name);
  const double coarse = largest_deviation(engine(), "event", the_case, 1e-2, 2.0);
  const double fine = largest_deviation(engine(), "event", the_case, 1e-3, 2.0);
  std::cout << "  largest deviation [m]: " << coarse << " and " << fine << '\n';
  if (coarse <= 1e-11) {
    return;  // the exact solver has no step
  }
  if (GetParam().in_double()) {
    EXPECT_NEAR(std::log10(coarse / fine), 2.0, 0.1);
  } else {
    EXPECT_LT(fine, coarse);  // the rounding of float is as large as the error of the smaller step
  }
}

TEST_P(EventModel, GoesThroughEveryShippedCaseToItsEnd) {
  for (const ImpactLaw law : {ImpactLaw::simultaneous, ImpactLaw::sequential}) {
    double overstretch = 0.0;
    double gain = 0.0;
    for (const Case& the_case : shipped_cases()) {
      const double end = std::min(the_case.duration, 30.0);
      const auto simulation = engine().start(the_case, "event", {1e-2, law});
      double last = energy(the_case, the_case.initial);
      run(*simulation, 1e-2, end - 1e-9, [&](const Moment& moment) {
        for (const Cable& cable : the_case.cables) {
          overstretch = std::max(overstretch, -gap(cable, moment.after) / cable.length);
        }
        last = energy(the_case, moment.after);
      });
      EXPECT_FALSE(simulation->stopped()) << the_case.name << ": " << simulation->stopped()->reason;
      gain = std::max(gain, (last - energy(the_case, the_case.initial)) / energy_scale(the_case));
    }
    expect_within("overstretch by length, law " + std::string(to_string(law)), overstretch,
                  limit(1e-12, 1e-5));
    expect_within("energy gained, of its scale", gain, limit(1e-11, 1e-5));
  }
}

INSTANTIATE_TEST_SUITE_P(Acceptance, EventModel, testing::ValuesIn(event_models()), test_name);

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

/// The models with fixed steps that take out overstretch by the rule of `row`, and those that have
/// their own; not those whose engine does it.
std::vector<ModelUnderTest> models_that_hold() {
  std::vector<ModelUnderTest> result = models_under_test();
  std::erase_if(result, [](const ModelUnderTest& one) {
    constexpr std::array names = {"row",       "row-sleeping", "early",        "impulse",
                                  "two-phase", "cable",        "contact-tuned"};
    return std::find(names.begin(), names.end(), one.model) == names.end();
  });
  return result;
}

class WithoutRestitution : public testing::TestWithParam<ModelUnderTest> {};

TEST_P(WithoutRestitution, NothingIsThrownBackByItsOverstretch) {
  const auto plugin = bench::Plugin::open(GetParam().plugin);
  const Case the_case = bench::shipped_case("caught-swing");
  for (const double step : {1e-2, 1e-3}) {
    const auto simulation = plugin.engine().start(the_case, GetParam().model, step);
    double fastest = 0.0;  // [-], opening of a cable that pulls, of what flight gives in a step
    int pulled = 0;
    run(*simulation, step, 0.5, [&](const Moment& moment) {
      if (simulation->impulses()[0] > 0.0) {
        const double rate = gap_rate(the_case.cables[0], moment.after);
        fastest = std::max(fastest, rate / change_in_step(the_case, 0, moment.after, step));
        ++pulled;
      }
    });
    EXPECT_GT(pulled, 0);
    // a fifth of the overstretch in a step would be several times as fast at 1e-3 s
    expect_within("rebound, of gravity and swing in a step, step " + std::to_string(step), fastest,
                  1.5);
  }
}

INSTANTIATE_TEST_SUITE_P(Acceptance, WithoutRestitution, testing::ValuesIn(models_that_hold()),
                         test_name);

class SameRow : public testing::TestWithParam<std::string> {};

TEST_P(SameRow, AsInBullet) {
  const auto bullet = plugin_of("bullet64");
  const auto other_engine = plugin_of(GetParam());
  if (!bullet || !other_engine) {
    GTEST_SKIP() << "bullet64 or " << GetParam() << " is not built";
  }
  const Case the_case = table_case(standard);
  for (const std::string model : {"row", "early"}) {
    const auto one = bullet->engine().start(the_case, model, 1e-3);
    const auto other = other_engine->engine().start(the_case, model, 1e-3);
    double largest = 0.0;
    run(*one, 1e-3, 5.0, [&](const Moment& moment) {
      other->step(1e-3);
      largest = std::max(largest, difference(moment.after, other->state()));
    });
    expect_within(model + ": difference of the whole state, t <= 5", largest, 1e-10);
  }
}

INSTANTIATE_TEST_SUITE_P(Acceptance, SameRow, testing::Values<std::string>("ode", "dart"),
                         [](const auto& instance) { return instance.param; });

}  // namespace
}  // namespace tautline::test
