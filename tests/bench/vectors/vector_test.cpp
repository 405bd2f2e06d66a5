#include <gtest/gtest.h>

#include <cmath>
#include <fstream>
#include <limits>
#include <nlohmann/json.hpp>
#include <sstream>

#include "bench/vectors/growth.hpp"
#include "bench/vectors/solve_vector.hpp"
#include "bench/vectors/vector_output.hpp"
#include "tautline/geometry.hpp"
#include "tautline/scenarios.hpp"
#include "tautline/solve.hpp"
#include "tests/bench/program.hpp"
#include "tests/bench/schema.hpp"

namespace tautline::test {
namespace {

using nlohmann::json;

Case vector_case(const std::string& name) {
  for (const Case& the_case : shipped_cases()) {
    if (the_case.name == name) {
      return the_case;
    }
  }
  ADD_FAILURE() << "no case " << name;
  return {};
}

bench::Vector vector_of(const Case& the_case, ImpactLaw law = ImpactLaw::simultaneous) {
  bench::VectorOptions options;
  options.law = law;
  bench::VectorReading reading = bench::vector_of(the_case, options);
  EXPECT_EQ(reading.problem, "");
  return reading.vector.value_or(bench::Vector());
}

std::string content(const std::filesystem::path& path) {
  std::ifstream file(path);
  std::ostringstream text;
  text << file.rdbuf();
  return text.str();
}

TEST(Vectors, TheBallHasItsClosedFormToTheLastBit) {
  const bench::Vector vector = vector_of(bouncing_ball());
  double time = 1.0;   // [s], of the first impact
  double speed = 1.0;  // [m/s]
  std::size_t impacts = 0;
  for (const bench::VectorRow& row : vector.rows) {
    if (row.kind != EventKind::impact) {
      continue;
    }
    EXPECT_EQ(row.time, time);
    EXPECT_EQ(row.rate, speed);
    EXPECT_EQ(row.impulses, std::vector{1.5 * speed});
    EXPECT_EQ(row.state, (std::array{0.0, 0.0, 0.0, 0.0, 0.5 * speed, 0.0}));
    time += speed;  // it rises and falls at half of it, and gravity is 1
    speed *= 0.5;
    ++impacts;
  }
  EXPECT_EQ(impacts, 10U) << "those from 1 m/s to 1 mm/s";
  EXPECT_EQ(vector.ends, "lock");
  EXPECT_EQ(vector.rows.back().kind, EventKind::taut);
  EXPECT_EQ(vector.rows.back().time, 3.0);
}

TEST(Vectors, KeepTheirSchemaAndTheTextHasTheSameNumbers) {
  const TemporaryFolder folder;
  const auto text = folder.path() / "v.txt";
  const auto file = folder.path() / "v.json";
  const Outcome outcome =
      program({"vector", "spinning-rod", "--json", file.string(), "--text", text.string()});
  ASSERT_EQ(outcome.code, 0) << outcome.errors;
  const json vector = json::parse(content(file));
  EXPECT_EQ(broken_rules_of(vector, "vector"), "");
  std::istringstream lines(content(text));
  std::string line;
  std::size_t row = 0;
  while (std::getline(lines, line)) {
    std::istringstream words(line);
    std::string kind;
    words >> kind;
    if (kind != "sample" && kind != "impact" && kind != "taut" && kind != "slack") {
      continue;
    }
    ASSERT_LT(row, vector.at("rows").size());
    const json& same = vector.at("rows").at(row++);
    EXPECT_EQ(same.at("kind"), kind);
    std::vector<double> numbers = {same.at("time")};
    for (const double one : same.at("state")) {
      numbers.push_back(one);
    }
    numbers.push_back(same.at("growth").is_null() ? 0.0 : same.at("growth").get<double>());
    numbers.push_back(same.at("step"));
    for (const double expected : numbers) {
      double number = std::numeric_limits<double>::quiet_NaN();
      words >> number;
      EXPECT_EQ(number, expected) << line;
    }
  }
  EXPECT_EQ(row, vector.at("rows").size());
}

TEST(Vectors, AStepThatCannotJudgeARowJudgesNoneAfterIt) {
  Case the_case = vector_case("breakwater/1910121100");
  the_case.duration = 3.0;
  const bench::Vector vector = vector_of(the_case);
  double before = std::numeric_limits<double>::infinity();
  double growth = 1.0;
  for (const bench::VectorRow& row : vector.rows) {
    EXPECT_LE(row.step, before);
    EXPECT_EQ(row.step > 0.0, row.growth.has_value()) << row.time;
    EXPECT_GE(row.growth.value_or(growth), growth);
    before = row.step;
    growth = row.growth.value_or(growth);
  }
}

TEST(Vectors, GrowthGoesOnAfterTwoCablesAreHitAtOnce) {
  Case the_case = vector_case("level-beam");
  the_case.duration = 0.55;
  const Solution solution = solve(the_case);
  const bench::Growth growth(the_case, solution, ImpactLaw::simultaneous);
  const double time = 0.5;  // [s], after the impact on both at 0.319 s
  EXPECT_EQ(Sensitivity(the_case, solution).growth(time), std::numeric_limits<double>::infinity());
  ASSERT_TRUE(std::isfinite(growth.at(time)));
  // neighbours that are higher or faster hit both at once, too
  const double radius = gyration_radius(the_case);
  constexpr double change = 1e-6;
  double largest = 0.0;
  for (const bool faster : {false, true}) {
    Case near = the_case;
    (faster ? near.initial.velocity : near.initial.position).y() += change;
    const State one = solve(near).at(time);
    const State other = solution.at(time);
    const double turn = radius * (one.angle - other.angle);
    const double spin = radius * (one.spin - other.spin);
    const double apart = std::hypot((one.position - other.position).norm(),
                                    (one.velocity - other.velocity).norm(), std::hypot(turn, spin));
    largest = std::max(largest, apart / change);
  }
  constexpr double of_second_order = 1e-3;  // what `change` leaves of the derivative
  EXPECT_GE(growth.at(time), largest * (1.0 - of_second_order));
  EXPECT_LE(growth.at(time), 10.0 * largest) << "the other neighbours grow no faster by much";
}

TEST(Vectors, RedundantCablesHaveAMotionAndNoImpulses) {
  Case the_case = bouncing_ball();
  the_case.duration = 1.5;
  the_case.cables = {{Vec2(-0.5, 2.0), Vec2(-0.5, 0.0), 2.0, 0.5},
                     {Vec2(0.0, 2.0), Vec2(0.0, 0.0), 2.0, 0.5},
                     {Vec2(0.5, 2.0), Vec2(0.5, 0.0), 2.0, 0.5}};
  for (const bench::VectorRow& row : vector_of(the_case).rows) {
    if (row.kind == EventKind::impact) {
      EXPECT_EQ(row.cables.size(), 3U);
      EXPECT_TRUE(row.impulses.empty());
      EXPECT_EQ(row.state[4], 0.5);
    }
    EXPECT_TRUE(row.growth.has_value()) << row.time;
  }
}

TEST(Vectors, WrongQuestionsGetASentenceEach) {
  const auto sentence = [](std::vector<std::string> words, int code) {
    words.insert(words.begin(), "vector");
    const Outcome outcome = program(words);
    EXPECT_EQ(outcome.code, code) << words.back();
    EXPECT_EQ(outcome.output, "");
    return outcome.errors;
  };
  EXPECT_NE(sentence({"bouncing-ball", "--samples", "0"}, 2).find("--samples 0: must be 1 to"),
            std::string::npos);
  EXPECT_NE(sentence({"bouncing-ball", "--slowest", "nan"}, 2).find("a speed above 0, in m/s"),
            std::string::npos);
  EXPECT_NE(sentence({"bouncing-ball", "--json", "-", "--text", "-"}, 2).find("only one of them"),
            std::string::npos);
  EXPECT_NE(sentence({"bouncing-ball", "--until", "-1"}, 2).find("duration -1"), std::string::npos);
  EXPECT_NE(sentence({"no-such-case"}, 2).find("no-such-case"), std::string::npos);
  EXPECT_NE(sentence({"bouncing-ball", "--json", "/nowhere/v.json"}, 2).find("/nowhere"),
            std::string::npos);
}

}  // namespace
}  // namespace tautline::test
