// The case files of docs/guides/recipes.md, held to the closed form that the page names for each.

#include <gtest/gtest.h>

#include <cmath>
#include <fstream>
#include <iterator>
#include <numbers>

#include "tautline/case_file.hpp"
#include "tautline/detail/scalar.hpp"
#include "tautline/elastic_contacts.hpp"
#include "tautline/solve.hpp"

namespace tautline::bench {
namespace {

namespace fs = std::filesystem;

constexpr double g = 9.81;  // [m/s^2], of all the files

/// The closed forms are evaluated in doubles too: this is a few roundings of either [-].
constexpr double rounding = 1e-13;

/// The same after a swing, whose arcs are chains of Taylor series [-].
constexpr double swing_rounding = 1e-11;

void expect_near(double found, double expected, double relative) {
  EXPECT_NEAR(found, expected, relative * std::abs(expected));
}

fs::path recipes() { return TAUTLINE_RECIPES; }

Case recipe(const std::string& name) {
  const CaseReading reading = read_case(recipes() / (name + ".toml"));
  for (const std::string& problem : reading.problems) {
    ADD_FAILURE() << problem;
  }
  return reading.the_case.value_or(Case());
}

std::vector<Event> impacts(const Solution& solution) {
  std::vector<Event> found;
  for (const Event& event : solution.events()) {
    if (event.kind == EventKind::impact) {
      found.push_back(event);
    }
  }
  return found;
}

/// The instants at which a ball falls on a flat floor from `height`.
std::vector<double> flat_impacts(double height, double restitution, std::size_t count) {
  std::vector<double> times = {std::sqrt(2.0 * height / g)};
  double flight = 2.0 * restitution * times.front();
  while (times.size() < count) {
    times.push_back(times.back() + flight);
    flight *= restitution;
  }
  return times;
}

/// Of a pendulum of `length` that swings out to an angle with this cosine [s], by the mean of
/// Gauss.
double swing_period(double length, double cosine) {
  double a = 1.0;
  double b = std::sqrt(0.5 * (1.0 + cosine));
  for (int step = 0; step < 10; ++step) {  // doubles the right digits each time
    const double mean = 0.5 * (a + b);
    b = std::sqrt(a * b);
    a = mean;
  }
  return 2.0 * std::numbers::pi * std::sqrt(length / g) / a;
}

TEST(Recipes, AreAllOnThePageAndHere) {
  std::ifstream file(recipes().parent_path() / "recipes.md");
  const std::string page(std::istreambuf_iterator<char>(file), {});
  std::size_t count = 0;
  for (const fs::directory_entry& entry : fs::directory_iterator(recipes())) {
    const std::string name = entry.path().stem();
    EXPECT_NE(page.find("(recipes/" + name + ".toml)"), std::string::npos) << name;
    const SystemReading reading = read_system(entry.path());
    EXPECT_EQ(reading.problems, std::vector<std::string>());
    EXPECT_EQ(reading.the_case ? reading.the_case->name : reading.system->name, name);
    ++count;
  }
  EXPECT_EQ(count, 10U);  // those that have a test below
}

TEST(Recipes, FloorIsFlatToTheSquareOverTwiceTheLength) {
  const Case near = recipe("floor");
  const std::vector<Event> found = impacts(solve(near));
  const std::vector<double> flat = flat_impacts(1.0, 0.8, found.size());
  ASSERT_EQ(found.size(), 6U);
  const double x = near.initial.velocity.x() * flat.front();
  const double rise = x * x / (2.0 * near.cables.front().length);
  EXPECT_NEAR(found.front().after.position.y(), rise, 1e-3 * rise);  // the next term of the circle
  const double sooner = rise / (g * flat.front());
  EXPECT_NEAR(flat.front() - found.front().time, sooner, 1e-3 * sooner);

  // a floor a thousand times flatter is a thousand times nearer to the flat one at each impact
  const std::vector<Event> flatter = impacts(solve(recipe("flatter-floor")));
  ASSERT_EQ(flatter.size(), found.size());
  for (std::size_t k = 0; k < found.size(); ++k) {
    const double off = flat[k] - found[k].time;
    // the gap is a difference of lengths of a million metres, and each impact adds some roundings
    const double speed = std::abs(found[k].after.velocity.y());
    const double roundings = 4.0 * static_cast<double>(k + 1) * epsilon<double>() * 1e6 / speed;
    EXPECT_NEAR(flat[k] - flatter[k].time, off / 1000.0, 0.01 * off / 1000.0 + roundings);
  }
}

TEST(Recipes, BallInOneDimensionRestsAfterAllItsBounces) {
  const Case the_case = recipe("one-dimension");
  const Solution solution = solve(the_case);
  const double fall = std::sqrt(2.0 * 1.0 / g);
  const double e = the_case.cables.front().restitution;
  ASSERT_EQ(solution.accumulations().size(), 1U);
  expect_near(solution.accumulations().front().time, fall * (1.0 + e) / (1.0 - e), rounding);
  EXPECT_EQ(solution.ending(), Ending::rest);
  for (const Event& event : solution.events()) {
    EXPECT_EQ(event.after.position.x(), 0.0);
  }
}

TEST(Recipes, TwoMassesShareTheirMomentum) {
  const Case the_case = recipe("two-masses");
  expect_near(the_case.body.mass, 2.0 * 1.5 / (2.0 + 1.5), rounding);
  const std::vector<Event> found = impacts(solve(the_case));
  ASSERT_EQ(found.size(), 1U);
  expect_near(found.front().time, 1.5 / 7.0, rounding);
  const double impulse = found.front().impulses[0];
  expect_near(7.0 - impulse / 2.0, 2.0 * 7.0 / (2.0 + 1.5), rounding);
  expect_near(impulse / 1.5, 2.0 * 7.0 / (2.0 + 1.5), rounding);
}

TEST(Recipes, CutStringLeavesAPendulum) {
  const Case the_case = recipe("cut");
  const Solution solution = solve(the_case);
  EXPECT_TRUE(impacts(solution).empty());
  const double length = 5.0;
  const double cosine = 0.8;
  const double period = swing_period(length, cosine);
  ASSERT_TRUE(solution.repetition());
  expect_near(solution.repetition()->period, period, swing_rounding);
  const State lowest = solution.at(0.25 * period);
  EXPECT_NEAR(lowest.position.x(), -3.0, swing_rounding * length);
  expect_near(lowest.velocity.x(), -std::sqrt(2.0 * g * length * (1.0 - cosine)), swing_rounding);
}

TEST(Recipes, ThresholdEndsTheBounces) {
  const Case the_case = recipe("threshold");
  const Solution solution = solve(the_case);
  const std::vector<Event> found = impacts(solution);
  const double e = the_case.cables.front().restitution;
  const double first = std::sqrt(2.0 * g * 1.0);  // [m/s]
  // the last is the first that is slower than the threshold: first * e^(count - 1)
  const double threshold = the_case.cables.front().capture_speed;
  const auto count =
      static_cast<std::size_t>(std::ceil(std::log(threshold / first) / std::log(e))) + 1;
  ASSERT_EQ(found.size(), count);
  const std::vector<double> times = flat_impacts(1.0, e, count);
  for (std::size_t k = 0; k < count; ++k) {
    expect_near(found[k].time, times[k], rounding);
  }
  EXPECT_EQ(solution.ending(), Ending::rest);
  EXPECT_NEAR(found.back().after.velocity.y(), 0.0, rounding);
}

TEST(Recipes, BuoyRisesByWhatIsLeftOfItsWeight) {
  const Case the_case = recipe("buoyancy");
  const double moved = 400.0 + 0.5 * 1000.0;
  const double rise = (1000.0 - 400.0) * g / moved;
  expect_near(the_case.body.mass, moved, rounding);
  expect_near(the_case.gravity.y(), rise, rounding);
  const std::vector<Event> found = impacts(solve(the_case));
  ASSERT_EQ(found.size(), 1U);
  expect_near(found.front().time, std::sqrt(2.0 * 2.0 / rise), rounding);
  expect_near(found.front().impulses[0], moved * std::sqrt(2.0 * rise * 2.0), rounding);
}

TEST(Recipes, StartInMidSwingIsAPendulumAtOnce) {
  const Solution solution = solve(recipe("mid-swing"));
  EXPECT_TRUE(impacts(solution).empty());
  const double length = 5.0;
  const double speed = 1.0;  // [rad/s], at the start
  const double cosine = 0.8 - length * speed * speed / (2.0 * g);
  ASSERT_TRUE(solution.repetition());
  expect_near(solution.repetition()->period, swing_period(length, cosine), swing_rounding);
}

TEST(Recipes, MovingAnchorPullsAtItsOwnSpeed) {
  const Case the_case = recipe("moving-anchor");
  const double anchor = 2.0;  // [m/s]
  const double e = the_case.cables.front().restitution;
  const Solution solution = solve(the_case);
  const std::vector<Event> found = impacts(solution);
  ASSERT_EQ(found.size(), 1U);
  expect_near(found.front().time, 3.0 / anchor, rounding);
  expect_near(found.front().impulses[0], the_case.body.mass * (1.0 + e) * anchor, rounding);
  expect_near(anchor + found.front().after.velocity.x(), (1.0 + e) * anchor, rounding);
}

TEST(Recipes, HawserPullsAsADampedOscillator) {
  const SystemReading reading = read_system(recipes() / "hawser.toml");
  ASSERT_TRUE(reading.system);
  const double mass = 20000.0;
  const double stiffness = 6e6 / 30.0;
  const double ratio = 4000.0 / (2.0 * std::sqrt(stiffness * mass));
  const double root = std::sqrt(1.0 - ratio * ratio);
  const double duration = 2.0 * std::acos(ratio) / (std::sqrt(stiffness / mass) * root);
  const double wait = (0.5 * std::numbers::pi - 3.0 * std::asin(ratio)) / root;  // of 1/frequency
  const auto contacts = elastic_contacts(solve(*reading.system));
  ASSERT_EQ(contacts.size(), 1U);
  expect_near(contacts.front().entry, 1.0, rounding);
  expect_near(contacts.front().peak, std::sqrt(stiffness * mass) * std::exp(-ratio * wait),
              swing_rounding);
  ASSERT_TRUE(contacts.front().exit);
  expect_near(*contacts.front().exit - 1.0, duration, swing_rounding);
  expect_near(contacts.front().exit_speed,
              std::exp(-ratio * std::sqrt(stiffness / mass) * duration), swing_rounding);
}

}  // namespace
}  // namespace tautline::bench
