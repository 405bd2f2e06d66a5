#include "bench/solution/json/solution_json.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <nlohmann/json.hpp>
#include <optional>

#include "bench/base/text.hpp"
#include "bench/solution/time_errors.hpp"
#include "tautline/case_file.hpp"
#include "tautline/geometry.hpp"
#include "tautline/scenarios.hpp"

namespace tautline::bench {
namespace {

using Json = nlohmann::ordered_json;
using Strings = std::vector<std::string>;

Strings keys(const Json& object) {
  Strings result;
  for (const auto& [key, value] : object.items()) {
    result.push_back(key);
  }
  return result;
}

/// What a script reads.
Json printed(const Case& the_case, const std::vector<double>& sample_times = {}) {
  const SolveOptions options;
  const Solution solution = solve(the_case, options);
  return Json::parse(solution_json(the_case, options, solution, settling(the_case, solution),
                                   sample_times, std::nullopt));
}

TEST(SolutionJson, HasTheNamesScriptsDependOn) {
  const Json written = printed(bouncing_ball(), {0.5});
  const Strings state = {"position", "angle", "velocity", "spin"};
  EXPECT_EQ(written.at("schema"), 4);
  EXPECT_EQ(keys(written.at("case")),
            (Strings{"name", "duration", "gravity", "body", "cables", "initial"}));
  EXPECT_EQ(keys(written.at("case").at("body")), (Strings{"mass", "inertia"}));
  EXPECT_EQ(keys(written.at("case").at("cables").at(0)),
            (Strings{"anchor", "attachment", "length", "restitution"}));
  EXPECT_EQ(keys(written.at("options")),
            (Strings{"law", "completion_error", "max_events", "max_steps"}));
  const Json& event = written.at("events").at(0);
  EXPECT_EQ(keys(event),
            (Strings{"time", "kind", "cables", "impulses", "before", "after", "errors"}));
  EXPECT_EQ(keys(event.at("errors")), (Strings{"time", "impulses", "before", "after"}));
  EXPECT_EQ(keys(event.at("before")), state);
  EXPECT_EQ(keys(written.at("end_state")), state);
  EXPECT_EQ(keys(written.at("energy")),
            (Strings{"start", "impacts", "completions", "end", "residual"}));
  EXPECT_EQ(keys(written.at("settling")), (Strings{"last_impacts", "lock"}));
  EXPECT_EQ(keys(written.at("settling").at("last_impacts").at(0)), (Strings{"speed", "time"}));
  EXPECT_EQ(keys(written.at("settling").at("lock")),
            (Strings{"time", "uncertainty", "cables", "permanent", "rests", "swing"}));
  EXPECT_TRUE(written.at("settling").at("lock").at("swing").is_null()) << "the ball rests";
  Strings sampled = state;
  sampled.insert(sampled.end(), {"gaps", "gap_rates", "tensions", "energy"});
  EXPECT_EQ(keys(written.at("samples").at(0).at("errors")), sampled);
  sampled.insert(sampled.begin(), "time");
  sampled.emplace_back("errors");
  EXPECT_EQ(keys(written.at("samples").at(0)), sampled);
  EXPECT_EQ(written.at("unsure"), Json::array());
}

TEST(SolutionJson, AnEventIsALineWithoutIndents) {
  const Case the_case = bouncing_ball();
  const SolveOptions options;
  const Solution solution = solve(the_case, options);
  const std::string text =
      solution_json(the_case, options, solution, settling(the_case, solution), {}, std::nullopt);
  const std::size_t first = text.find("    {\"time\"");
  ASSERT_NE(first, std::string::npos) << text;
  const Json event = Json::parse(text.substr(first, text.find(",\n", first) - first));
  EXPECT_EQ(event, printed(the_case).at("events").at(0));
}

TEST(SolutionJson, FirstBounceHasItsClosedForm) {
  const Json event = printed(bouncing_ball(0.5)).at("events").at(0);
  // a fall of 0.5 under gravity 1 takes 1 and ends at speed 1; the impulse is (1 + e) m v
  EXPECT_DOUBLE_EQ(event.at("time").get<double>(), std::sqrt(2.0 * 0.5));
  EXPECT_EQ(event.at("kind"), "impact");
  EXPECT_EQ(event.at("cables"), Json::array({0}));
  EXPECT_DOUBLE_EQ(event.at("impulses").at(0).get<double>(), 1.5);
  EXPECT_DOUBLE_EQ(event.at("before").at("velocity").at(1).get<double>(), -1.0);
  EXPECT_DOUBLE_EQ(event.at("after").at("velocity").at(1).get<double>(), 0.5);
}

TEST(SolutionJson, EveryNumberOfTheSolutionReadsBackEqual) {
  const Case the_case = breakwater(table_5_1().front().parameters, "x");
  const Solution solution = solve(the_case);
  const Json written = printed(the_case);
  ASSERT_EQ(written.at("events").size(), solution.events().size());
  for (std::size_t index = 0; index < solution.events().size(); ++index) {
    const Event& event = solution.events()[index];
    const Json& other = written.at("events").at(index);
    EXPECT_EQ(other.at("time").get<double>(), event.time);
    EXPECT_EQ(other.at("impulses").at(0).get<double>(), std::max(0.0, event.impulses[0]));
    EXPECT_EQ(other.at("after").at("spin").get<double>(), event.after.spin);
  }
  EXPECT_EQ(written.at("end_time").get<double>(), solution.end_time());
  EXPECT_EQ(written.at("energy").at("start").get<double>(), energy(the_case, the_case.initial));
}

TEST(SolutionJson, CaseHasTheKeysOfACaseFile) {
  Case the_case = bouncing_ball();
  the_case.angle_limit = 1.5;
  the_case.ceiling = 1.75;
  const Json written = printed(the_case).at("case");
  EXPECT_EQ(written.at("angle_limit"), 1.5);
  EXPECT_EQ(written.at("ceiling"), 1.75);
  // every key of the file is in the object: a reader of one can read the other
  EXPECT_EQ(keys(written), (Strings{"name", "duration", "gravity", "angle_limit", "ceiling", "body",
                                    "cables", "initial"}));
}

TEST(SolutionJson, HasEveryAccumulationOfTheSolution) {
  for (const Case& the_case :
       {bouncing_ball(), breakwater(table_5_1().front().parameters, "standard")}) {
    const Solution solution = solve(the_case);
    const Json all = printed(the_case).at("accumulations");
    ASSERT_FALSE(all.empty()) << the_case.name;
    ASSERT_EQ(all.size(), solution.accumulations().size());
    for (std::size_t index = 0; index < all.size(); ++index) {
      EXPECT_EQ(keys(all.at(index)),
                (Strings{"start", "time", "uncertainty", "cables", "energy_lost"}));
      EXPECT_EQ(all.at(index).at("time").get<double>(), solution.accumulations()[index].time);
    }
  }
  EXPECT_EQ(printed(bouncing_ball(1.0)).at("accumulations"), Json::array());
}

// a ball dropped by h with restitution e rests at sqrt(2 h / g) (1 + e) / (1 - e)
TEST(SolutionJson, TheUncertaintyOfALockHasItsRoundingInIt) {
  for (const double gravity : {9.81, 1.0, 3.7}) {
    for (const double restitution : {0.3, 0.5, 0.8}) {
      Case ball = bouncing_ball(restitution);
      ball.gravity.y() = -gravity;
      ball.duration = 100.0;
      const long double fall = 2.0L * gap(ball.cables[0], ball.initial);
      const long double e = restitution;
      const long double rest = std::sqrt(fall / gravity) * (1 + e) / (1 - e);
      const Json written = printed(ball);
      const Json& lock = written.at("settling").at("lock");
      const Json& limit = written.at("accumulations").back();
      const auto bound = lock.at("uncertainty").get<double>();
      EXPECT_LE(std::abs(lock.at("time").get<double>() - rest), bound) << restitution;
      EXPECT_GE(bound, epsilon<double>()) << "a double is no better than that";
      EXPECT_LE(bound, 1e-6);
      EXPECT_EQ(limit.at("uncertainty"), lock.at("uncertainty"));
      const Solution solution = solve(ball);
      EXPECT_EQ(lock_error(solution, settling(ball, solution), Uncertainty(ball, solution)), bound)
          << "the text's";
    }
  }
}

TEST(SolutionJson, SettlingIsNullWhereNothingSettles) {
  const Json elastic = printed(bouncing_ball(1.0)).at("settling");
  EXPECT_TRUE(elastic.at("lock").is_null());
  Case still = bouncing_ball(1.0);
  still.duration = 0.5;  // before the first impact, at 1
  const Json impacts = printed(still).at("settling").at("last_impacts");
  ASSERT_EQ(impacts.size(), 2U);
  EXPECT_EQ(impacts.at(0).at("speed"), 1e-2);
  EXPECT_EQ(impacts.at(1).at("speed"), 1e-3);
  EXPECT_TRUE(impacts.at(0).at("time").is_null());
}

TEST(SolutionJson, LedgerAccountsForEveryJouleOfTheBall) {
  const Json energy = printed(bouncing_ball(0.5)).at("energy");
  const auto number = [&](const char* key) { return energy.at(key).get<double>(); };
  EXPECT_EQ(number("start"), 0.5);
  EXPECT_NEAR(number("end"), 0.0, 1e-16);  // of a start of 0.5: within rounding
  EXPECT_GT(number("completions"), 0.0);
  EXPECT_LT(std::abs(number("residual")), 1e-15);
  EXPECT_NEAR(number("impacts") + number("completions"), 0.5, 1e-15);
}

TEST(SolutionJson, SamplesComeInTheOrderAsked) {
  const Json written = printed(bouncing_ball(), {0.5, 0.0, 0.5});
  ASSERT_EQ(written.at("samples").size(), 3U);
  EXPECT_EQ(written.at("samples").at(1).at("time"), 0.0);
  EXPECT_EQ(written.at("samples").at(1).at("position"), Json::array({0.0, 0.5}));
  EXPECT_EQ(written.at("samples").at(0), written.at("samples").at(2));
  EXPECT_FALSE(printed(bouncing_ball()).contains("samples"));
}

TEST(SolutionJson, SampleOutsideTheSolutionIsNamedWithItsEnd) {
  Case the_case = bouncing_ball();
  the_case.duration = 0.75;
  const Solution solution = solve(the_case);
  const std::vector<double> times = {0.0, 0.75, 1.25, -1.0,
                                     std::numeric_limits<double>::quiet_NaN()};
  const std::string rest = " is outside [0, 0.75]: the solution ends there (reached_duration)";
  EXPECT_EQ(
      sample_problems(solution.end_time(), solution.ending(), times),
      (Strings{"sample time 1.25" + rest, "sample time -1" + rest, "sample time nan" + rest}));
  EXPECT_THROW(static_cast<void>(solution_json(the_case, {}, solution, {}, times, {})),
               std::out_of_range);
}

TEST(SolutionJson, ZeroAndWholeNumbersStayNumbersWithAPoint) {
  Case the_case = bouncing_ball();
  the_case.gravity = Vec2(-0.0, -20.0);
  const std::string text = solution_json(the_case, {}, solve(the_case), {}, {}, {});
  EXPECT_NE(text.find("\"gravity\":[-0.0,-20.0]"), std::string::npos) << text;
}

}  // namespace
}  // namespace tautline::bench
