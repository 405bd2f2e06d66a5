#include <gtest/gtest.h>

#include <Eigen/LU>
#include <string>

#include "support.hpp"
#include "system/elastic_systems.hpp"
#include "tautline/multiprecision.hpp"
#include "tautline/solve.hpp"
#include "tautline/system_geometry.hpp"

// What an impact at an instant of its own does to a small difference of states, where ends and
// lengths move (T8): against differences of whole motions in 50 digits.

namespace tautline::test {
namespace {

using MultiSystem = BasicSystem<Multi, 2>;
using MultiState = BasicSystemState<Multi, 2>;
using Numbers = Eigen::Matrix<Multi, Eigen::Dynamic, 1>;
using Linear = Eigen::Matrix<Multi, Eigen::Dynamic, Eigen::Dynamic>;

constexpr unsigned digits_used = 50;

Multi tiny() { return Multi("1e-17"); }  // a step of differences: their error is its square

/// The places of all bodies, then their rates.
Numbers numbers_of(const MultiState& state) {
  const auto half = static_cast<Eigen::Index>(3 * state.bodies.size());
  Numbers result(2 * half);
  Eigen::Index at = 0;
  for (const auto& body : state.bodies) {
    result.segment<3>(at) << body.position, body.angle;
    result.segment<3>(half + at) << body.velocity, body.spin;
    at += 3;
  }
  return result;
}

MultiState state_of_numbers(const Numbers& numbers, const Multi& time) {
  const Eigen::Index half = numbers.size() / 2;
  MultiState result;
  result.time = time;
  for (Eigen::Index at = 0; at < half; at += 3) {
    result.bodies.push_back({{numbers[at], numbers[at + 1]},
                             numbers[at + 2],
                             {numbers[half + at], numbers[half + at + 1]},
                             numbers[half + at + 2]});
  }
  return result;
}

/// The derivative of `map` by each number, by central differences.
template <class Map>
Linear slopes(const Numbers& at, const Map& map) {
  Linear result(map(at).size(), at.size());
  for (Eigen::Index axis = 0; axis < at.size(); ++axis) {
    Numbers more = at;
    Numbers less = at;
    more[axis] += tiny();
    less[axis] -= tiny();
    result.col(axis) = (map(more) - map(less)) / (2 * tiny());
  }
  return result;
}

/// The inverse of the masses of all freedoms; zero for the spin of a point.
Numbers lightness(const MultiSystem& system) {
  Numbers result(static_cast<Eigen::Index>(3 * system.bodies.size()));
  Eigen::Index at = 0;
  for (const auto& body : system.bodies) {
    const Multi turning = body.inertia > 0 ? Multi(1 / body.inertia) : Multi(0);
    result.segment<3>(at) << 1 / body.mass, 1 / body.mass, turning;
    at += 3;
  }
  return result;
}

/// Newton's law for one cable at any place, rate and time: R of (T8).
Numbers rebounded(const MultiSystem& system, std::size_t cable, const Numbers& before,
                  const Multi& time) {
  const MultiState state = state_of_numbers(before, time);
  const Numbers row = gap_gradient(system.cables[cable], state);
  const Numbers answer = row.cwiseProduct(lightness(system));
  const Multi rate = gap_rate(system.cables[cable], state);
  Numbers after = before;
  after.tail(row.size()) -=
      Multi((1 + system.cables[cable].restitution) * rate / row.dot(answer)) * answer;
  return after;
}

/// How fast the numbers of a state change in flight.
Numbers flight_rate(const MultiSystem& system, const MultiState& state) {
  const Numbers rates = numbers_of(state);
  Numbers result(rates.size());
  result << rates.tail(rates.size() / 2), free_accelerations(system, state);
  return result;
}

/// The matrix of (T8) for `event`, with or without what the law's own time gives.
Linear saltation_of(const MultiSystem& system, const BasicEvent<MultiSystem>& event,
                    bool with_time) {
  const std::size_t cable = event.cables.indices().front();
  const Numbers before = numbers_of(event.before);
  const Multi& time = event.time;
  const auto at_instant = [&](const Numbers& numbers) {
    return rebounded(system, cable, numbers, time);
  };
  const Linear reset = slopes(before, at_instant);
  Numbers drift = flight_rate(system, event.after) - reset * flight_rate(system, event.before);
  if (with_time) {
    drift -= (rebounded(system, cable, before, time + tiny()) -
              rebounded(system, cable, before, time - tiny())) /
             (2 * tiny());
  }
  Numbers delay = Numbers::Zero(before.size());
  delay.head(before.size() / 2) = gap_gradient(system.cables[cable], event.before);
  return reset + drift * (delay / gap_rate(system.cables[cable], event.before)).transpose();
}

/// The derivative of a flight from `start` to `end` [s]: forces depend on rates alone.
Linear flight_slopes(const MultiSystem& system, const Multi& duration) {
  const auto half = static_cast<Eigen::Index>(3 * system.bodies.size());
  Linear result = Linear::Identity(2 * half, 2 * half);
  Eigen::Index at = 0;
  for (const auto& body : system.bodies) {
    const Multi turning = body.inertia > 0 ? Multi(body.spin_drag / body.inertia) : Multi(0);
    for (const Multi& damping :
         {Multi(body.drag / body.mass), Multi(body.drag / body.mass), turning}) {
      const Multi left = exp(Multi(-damping * duration));
      result(half + at, half + at) = left;
      result(at, half + at) = damping > 0 ? Multi((1 - left) / damping) : duration;
      ++at;
    }
  }
  return result;
}

/// The first `count` impacts of `system`, all of one cable each and in flight. Returns by how much
/// the product of (T8) is off without its term of time.
double compare_saltations(const std::string& what, MultiSystem system, std::size_t count) {
  SolveOptions options;
  options.max_events = count + 1;
  const auto solution = solve(system, options);
  const auto& events = solution.events();
  const Multi end = (events[count - 1].time + events[count].time) / Multi(2);
  Linear exact =
      Linear::Identity(numbers_of(system.initial).size(), numbers_of(system.initial).size());
  Linear timeless = exact;
  Multi now(0);
  for (std::size_t i = 0; i < count; ++i) {
    EXPECT_EQ(events[i].kind, EventKind::impact) << what;
    EXPECT_EQ(events[i].cables.size(), 1U) << what;
    const Linear flown = flight_slopes(system, events[i].time - now);
    exact = (saltation_of(system, events[i], true) * flown * exact).eval();
    timeless = (saltation_of(system, events[i], false) * flown * timeless).eval();
    now = events[i].time;
  }
  const Linear flown = flight_slopes(system, end - now);
  exact = (flown * exact).eval();
  timeless = (flown * timeless).eval();
  const Linear differences = slopes(numbers_of(system.initial), [&](const Numbers& start) {
    MultiSystem nearby = system;
    nearby.initial = state_of_numbers(start, Multi(0));
    return numbers_of(solve(nearby, options).at(end));
  });
  const auto off = [&](const Linear& other) {
    return static_cast<double>(Multi((other - differences).norm() / differences.norm()));
  };
  expect_within(what, off(exact), 1e-25);
  return off(timeless);
}

TEST(SystemSaltation, HasATermOfTime) {
  const Digits digits(digits_used);
  EXPECT_GT(compare_saltations("bouncer", bouncer<Multi>(Multi(14) / 100, Multi(1) / 1000), 3),
            0.1);
  EXPECT_GT(compare_saltations("shaken", shaken<Multi>(), 4), 0.01);
  auto drawn = breakwater_system<Multi>(Multi(9) / 10);
  drawn.cables[0].length.waves =
      sine<Multi, 1>(Eigen::Matrix<Multi, 1, 1>(Multi(1) / 20), Multi(13) / 10).waves;
  EXPECT_GT(compare_saltations("a length that swings", drawn, 4), 1e-4);
  EXPECT_GT(compare_saltations("pulley with a ring that moves", pulley<Multi>(), 4), 1e-4);
  // where forces alone are given over time, or a winch draws at one speed, the law has none
  EXPECT_LT(compare_saltations("winch", winch<Multi>(), 2), 1e-25);
  EXPECT_LT(compare_saltations("waves and drag", waves<Multi>(), 4), 1e-25);
  EXPECT_LT(compare_saltations("two bodies", in_series<Multi>(), 3), 1e-25);
}

TEST(SystemSaltation, HasTheDeterminantOfTheRestitutionsSquare) {
  const Digits digits(digits_used);
  const auto system = shaken<Multi>();
  SolveOptions options;
  options.max_events = 1;
  const auto solution = solve(system, options);
  for (const bool with_time : {true, false}) {  // it does not tell whether the term is there
    const Multi determinant =
        saltation_of(system, solution.events().front(), with_time).determinant();
    const Multi e = system.cables[0].restitution;
    expect_within("determinant", std::abs(static_cast<double>(Multi(determinant / (e * e) - 1))),
                  1e-25);
  }
}

/// What a small difference of a mass's height, and of its rate, becomes after `time` [s]: free, or
/// on a cable that pulls, with a mass of 1 kg.
Linear free_slopes(const Multi& time) {
  Linear result(2, 2);
  result << Multi(1), time, Multi(0), Multi(1);
  return result;
}
Linear pulled_slopes(const Multi& stiffness, const Multi& damping, const Multi& time) {
  const Multi half = damping / 2;
  const Multi frequency = sqrt(Multi(stiffness - half * half));
  const Multi decay = exp(Multi(-half * time));
  const Multi cosine = decay * cos(Multi(frequency * time));
  const Multi sine = decay * sin(Multi(frequency * time)) / frequency;
  Linear result(2, 2);
  result << Multi(cosine + half * sine), sine, Multi(-stiffness * sine),
      Multi(cosine - half * sine);
  return result;
}

/// The first `count` entries and exits of a mass that moves up and down below its cable, against
/// differences of whole motions.
void compare_entries(const std::string& what, const MultiSystem& system, std::size_t count,
                     bool last) {
  const auto& law = *system.cables[0].elasticity;
  const auto solution = solve(system);
  const auto& events = solution.events();
  ASSERT_GE(events.size(), count + (last ? 0 : 1)) << what;
  const Multi end =
      last ? solution.end_time() : Multi((events[count - 1].time + events[count].time) / Multi(2));
  Linear exact = Linear::Identity(2, 2);
  Linear enters(2, 2);  // only from slack: there the damper's force jumps
  enters << Multi(1), Multi(0), Multi(-law.damping), Multi(1);
  Multi now(0);
  bool pulls = false;
  const auto go = [&](const Multi& time) {
    const Multi passed = time - now;
    exact = ((pulls ? pulled_slopes(law.stiffness[0], law.damping, passed) : free_slopes(passed)) *
             exact)
                .eval();
    now = time;
  };
  for (std::size_t i = 0; i < count; ++i) {
    go(events[i].time);
    pulls = events[i].kind == EventKind::entry;
    if (pulls && !events[i].before.elastic.loose.contains(0)) {
      exact = (enters * exact).eval();
    }
  }
  go(end);
  const auto height = [](const MultiState& state) {
    Numbers result(2);
    result << state.bodies[0].position.y(), state.bodies[0].velocity.y();
    return result;
  };
  const Linear differences = slopes(height(system.initial), [&](const Numbers& start) {
    MultiSystem nearby = system;
    nearby.initial.bodies[0].position.y() = start[0];
    nearby.initial.bodies[0].velocity.y() = start[1];
    return height(solve(nearby).at(end));
  });
  expect_within(what, static_cast<double>(Multi((exact - differences).norm() / differences.norm())),
                1e-20);
}

TEST(SystemSaltation, OfAnElasticCableDividesByNoSpeed) {
  const Digits digits(digits_used);
  const auto law = with_damping<Multi>(Multi(1000), Multi(6));
  const Multi tenth = Multi(1) / 10;
  compare_entries("drop", drop<Multi>(law, Multi(10), Multi(1), tenth), 4, false);
  auto shaken = drop<Multi>(law, Multi(10), Multi(1), tenth);
  shaken.cables[0].to.motion =
      sine<Multi, 2>(pair_of<Multi>(Multi(0), Multi(tenth / 5)), Multi(13));
  compare_entries("drop from an anchor that moves", shaken, 4, false);
  // thrown down against gravity it turns after 1 s, 1e-6 m beyond the length, at which it has
  // 1.4 mm/s
  const Multi over = Multi(1) / 1000000;
  auto graze = drop<Multi>(law, Multi(-1), Multi(1), Multi(Multi(1) / 2 - over));
  graze.duration = 3 * tenth + 1;
  compare_entries("graze", graze, 2, true);
}

}  // namespace
}  // namespace tautline::test
