#include "bench/run/cost.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <memory>
#include <span>
#include <stdexcept>
#include <string>
#include <string_view>
#include <vector>

#include "bench/cases/bench_case.hpp"
#include "tautline/scenarios.hpp"

namespace tautline::bench {
namespace {

/// How far each of an engine's simulations went [s].
using Ways = std::vector<double>;

/// Does nothing but count.
class Counting final : public Simulation {
 public:
  explicit Counting(Ways& ways) : ways_(ways), place_(ways.size()) { ways_.push_back(0.0); }

  [[nodiscard]] State state() const override { return {}; }
  void step(double dt) override { ways_[place_] += dt; }
  [[nodiscard]] std::span<const double> impulses() const override { return {}; }

 private:
  Ways& ways_;
  std::size_t place_;
};

class CountingEngine final : public Engine {
 public:
  explicit CountingEngine(Ways& ways) : ways_(ways) {}

  [[nodiscard]] EngineInfo info() const override {
    EngineInfo result;
    result.models = {{.name = "m", .sentence = "It counts.", .settings = {}}};
    return result;
  }
  [[nodiscard]] std::unique_ptr<Simulation> start(const Case& /*the_case*/,
                                                  std::string_view /*model*/,
                                                  const RunSettings& /*settings*/) const override {
    return std::make_unique<Counting>(ways_);
  }

 private:
  Ways& ways_;
};

TEST(Cost, TimesTheSameMotionAtEveryStepSeveralTimes) {
  const Case the_case = shipped_cases().front();
  ASSERT_GT(the_case.duration, timed_motion);
  for (const double step : {1e-2, 1e-3, 1e-4}) {
    Ways ways;
    const Cost cost = measure_cost(the_case, CountingEngine(ways), "m", {step});
    EXPECT_GE(ways.size(), 3U) << step;
    EXPECT_EQ(cost.repetitions, ways.size()) << step;
    for (const double way : ways) {
      EXPECT_NEAR(way, timed_motion, 1e-9) << step;
    }
    EXPECT_LE(cost.smallest, cost.lower);
    EXPECT_LE(cost.lower, cost.step);
    EXPECT_LE(cost.step, cost.upper);
  }
}

TEST(Cost, OfACaseThatIsShorterIsThatOfAllOfIt) {
  Case the_case = shipped_cases().front();
  the_case.duration = 0.25;
  Ways ways;
  static_cast<void>(measure_cost(the_case, CountingEngine(ways), "m", {1e-2}));
  EXPECT_NEAR(*std::max_element(ways.begin(), ways.end()), 0.25, 1e-12);
}

/// A system in the plane runs in space.
TEST(Started, RefusesAnElasticCableByItsNumberBeforeTheEngineSeesIt) {
  System in_the_plane = shipped_systems().front().system;
  in_the_plane.cables.push_back(in_the_plane.cables.front());
  in_the_plane.cables.back().elasticity = Elasticity{.stiffness = {1e3}};
  const std::string last = std::to_string(in_the_plane.cables.size() - 1);
  Ways ways;
  try {
    static_cast<void>(started(CountingEngine(ways), in_space(in_the_plane), "m", {1e-2}));
    ADD_FAILURE() << "it started";
  } catch (const std::invalid_argument& error) {
    EXPECT_EQ(error.what(), "unsupported: model m has inextensible cables alone, cable " + last +
                                " of the case is elastic");
  }
}

}  // namespace
}  // namespace tautline::bench
