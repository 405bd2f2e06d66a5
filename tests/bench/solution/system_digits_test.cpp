// What `tautline solve` prints of systems: no digit is wrong, held against 60 digits.

#include <gtest/gtest-spi.h>
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <cstdio>
#include <cstdlib>
#include <string>
#include <utility>
#include <vector>

#include "bench/solution/certify_events.hpp"
#include "bench/solution/checked_motion.hpp"
#include "bench/solution/right_digits.hpp"
#include "system/random_system.hpp"
#include "tautline/multiprecision.hpp"
#include "tautline/solve.hpp"
#include "tautline/system_geometry.hpp"

namespace tautline::bench {
namespace {

/// In the environment: which random systems are solved, as "75-300". 300 take some hours.
constexpr const char* which = "TAUTLINE_DIGITS_OF_SYSTEMS";

/// The first of them, and how many there are with those before it.
std::pair<int, int> random_systems() {
  std::pair<int, int> result(0, 4);
  if (const char* const wanted = std::getenv(which)) {
    const bool both = std::sscanf(wanted, "%d-%d", &result.first, &result.second) == 2;
    EXPECT_TRUE(both) << which << " is " << wanted << ", not like 75-300";
  }
  return result;
}

/// Events of a system: what comes later is beyond most horizons.
constexpr std::size_t most_system_events = 150;

constexpr unsigned digits_of_truth = 60;
constexpr double completion_of_truth = 1e-40;  // [-], its error

/// The truth goes on past the last event of the other solution by this part of its time [-]: the
/// true event may be later, by far less.
constexpr double past_the_end = 1e-3;

/// The numbers of a sample of a system's motion, in the order of CheckedMotion::names().
std::vector<Multi> true_numbers(const BasicSystem<Multi, 2>& system,
                                const BasicSystemState<Multi, 2>& state, CableSet taut,
                                const BasicCableVector<Multi>& tensions) {
  std::vector<Multi> result;
  Multi energy(0);
  for (std::size_t i = 0; i < system.bodies.size(); ++i) {
    const auto& body = state.bodies[i];
    const auto& given = system.bodies[i];
    result.insert(result.end(), {body.position.x(), body.position.y(), body.angle,
                                 body.velocity.x(), body.velocity.y(), body.spin});
    energy += (given.mass * body.velocity.squaredNorm() + given.inertia * body.spin * body.spin) /
              Multi(2);
    const BasicVec2<Multi> force =
        given.mass * system.gravity.at(state.time) + given.force.at(state.time);
    energy -= force.dot(body.position) + given.moment.at(state.time)[0] * body.angle;
  }
  for (std::size_t i = 0; i < system.cables.size(); ++i) {
    const bool held = taut.contains(i);
    result.push_back(held ? Multi(0) : gap(system.cables[i], state));
    result.push_back(held ? Multi(0) : gap_rate(system.cables[i], state));
    result.push_back(tensions[static_cast<Eigen::Index>(i)]);
  }
  result.push_back(energy);
  return result;
}

/// Counts the numbers that are printed, and the wrong ones.
struct PrintedNumbers {
  long printed = 0;
  long digits = 0;
  long wrong = 0;

  void add(const Bounded& number, const Multi& truth, const std::string& what) {
    constexpr int digits_of_double = 17;
    const std::string shown = right_general(number.value, number.error, digits_of_double);
    if (shown == dash) {
      return;
    }
    // half a unit of its last digit
    const std::size_t end = std::min(shown.find('e'), shown.size());
    const std::size_t point = std::min(shown.find('.'), end);
    const int power = end < shown.size() ? std::atoi(shown.c_str() + end + 1) : 0;
    const int last = power - static_cast<int>(point < end ? end - point - 1 : 0);
    const Multi off = abs(Multi(Multi(shown) - truth));
    ++printed;
    digits += static_cast<long>(end);
    const Multi half = pow(Multi(10), Multi(last)) / Multi(2);
    if (!(off <= half * (1 + 1e-9))) {
      ++wrong;
      ADD_FAILURE() << what << " is printed " << shown << ", is " << truth.str(25) << " (double "
                    << number.value << " +- " << number.error << ")";
    }
  }

  void add(const std::vector<Bounded>& numbers, const std::vector<Multi>& truth,
           const std::vector<SampleName>& names, const std::string& where) {
    ASSERT_EQ(numbers.size(), truth.size());
    for (std::size_t i = 0; i < numbers.size(); ++i) {
      add(numbers[i], truth[i], where + names[i].name);
    }
  }
};

using TrueSolution = BasicSolution<BasicSystem<Multi, 2>>;

/// For each event of `solution` the one of `truth` that it should be, in the same order; null:
/// none.
std::vector<const BasicEvent<BasicSystem<Multi, 2>>*> true_events(
    const BasicSolution<System>& solution, const TrueSolution& truth) {
  std::vector<const BasicEvent<BasicSystem<Multi, 2>>*> result(solution.events().size());
  const Alignment alignment(solution, truth);
  for (const auto& [mine, other] : alignment.places()) {
    if (mine > 0) {
      result[mine - 1] = &truth.events()[other - 1];
    }
  }
  return result;
}

/// All that is printed of `system`: its events, and samples between them.
void compare_with_truth(const System& system, const std::string& name, PrintedNumbers& count) {
  SolveOptions options;
  options.max_events = most_system_events;
  const CheckedMotion motion(system, options);
  const tautline::Digits precision(digits_of_truth);
  auto sharp = converted<Multi>(system);
  const Multi enough = (1 + past_the_end) * Multi(motion.solution().end_time());
  sharp.duration = std::min(sharp.duration, enough);
  options.completion = {.error = completion_of_truth, .speed = std::nullopt};
  options.max_events = 20 * most_system_events;
  const TrueSolution truth = solve(sharp, options);
  const auto names = motion.names();
  const auto same_events = true_events(motion.solution(), truth);
  for (std::size_t i = 0; i < motion.solution().events().size(); ++i) {
    const std::string where = name + ", event " + std::to_string(i) + ": ";
    const Bounded time = motion.time(i);
    const auto* const same = same_events[i];
    if (time.error < 0.0 || same == nullptr) {
      EXPECT_LT(time.error, 0.0) << where;
      continue;
    }
    count.add(time, same->time, where + "time");
    const std::vector<Bounded> impulses = motion.impulses(i);
    for (std::size_t k = 0; k < impulses.size() && impulses[k].error >= 0.0; ++k) {
      const Multi impulse = same->impulses[static_cast<Eigen::Index>(k)];
      count.add(impulses[k], impulse > 0 ? impulse : Multi(0), where + "impulse");
    }
    const CableVector none = CableVector::Zero(static_cast<Eigen::Index>(system.cables.size()));
    for (const Side side : {Side::before, Side::after}) {
      std::vector<Bounded> numbers = motion.at_event(i, side);
      numbers.resize(6 * system.bodies.size());  // cables at an instant have two tensions
      std::vector<Multi> states = true_numbers(
          sharp, side == Side::before ? same->before : same->after, {}, none.cast<Multi>());
      states.resize(numbers.size());
      count.add(numbers, states, names, where);
    }
  }
  constexpr int samples = 24;
  for (int k = 0; k <= samples; ++k) {
    const double time = motion.solution().end_time() * k / samples;
    if (time > motion.solution().end_time() || Multi(time) > truth.end_time()) {
      continue;
    }
    const auto place = truth.place(Multi(time));
    count.add(motion.at(time),
              true_numbers(sharp, truth.at(Multi(time)), truth.arcs()[place.arc].taut,
                           truth.tensions(Multi(time))),
              names, name + ", t = " + std::to_string(time) + ": ");
  }
}

TEST(SystemDigits, NoneIsWrong) {
  tautline::test::Random random(3960);
  PrintedNumbers count;
  const auto [first, end] = random_systems();
  for (int drawn = 0; drawn < end;) {
    const System system = tautline::test::random_system(random);
    if (!problems(system).empty() || drawn++ < first) {
      continue;
    }
    compare_with_truth(system, "system " + std::to_string(drawn - 1), count);
    if (std::getenv(which) != nullptr) {
      std::printf("  %d systems: %ld numbers, %ld wrong\n", drawn, count.printed, count.wrong);
      std::fflush(stdout);
    }
  }
  std::printf("  %d systems: %ld numbers of %ld digits, %ld wrong\n", end - first, count.printed,
              count.digits, count.wrong);
  EXPECT_GT(count.printed, 1000 * (end - first) / 2);
  EXPECT_EQ(count.wrong, 0);
}

TEST(SystemDigits, ACountSeesAWrongOne) {
  PrintedNumbers count;
  const tautline::Digits precision(digits_of_truth);
  const Multi truth = Multi(1) / Multi(3);
  count.add({1.0 / 3.0, 1e-10}, truth, "a third");
  EXPECT_EQ(count.printed, 1);
  EXPECT_EQ(count.wrong, 0);
  EXPECT_NONFATAL_FAILURE(count.add({0.3334, 1e-6}, truth, "a third"), "is printed 0.3334");
}

}  // namespace
}  // namespace tautline::bench
