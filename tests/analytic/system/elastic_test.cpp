#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <numbers>
#include <string>
#include <tuple>
#include <vector>

#include "support.hpp"
#include "system/elastic_systems.hpp"
#include "system/extrapolation.hpp"
#include "tautline/elastic_contacts.hpp"
#include "tautline/solve.hpp"
#include "tautline/system_geometry.hpp"
#include "tautline/system_ledger.hpp"

// Elastic cables against closed forms and against another method.

namespace tautline::test {
namespace {

/// The angle acos(ratio) over sqrt(1 - ratio^2), and its limit and continuation from 1 on (E5).
double angle_of_contact(double ratio) {
  const double root = std::sqrt(std::abs((1.0 - ratio) * (1.0 + ratio)));
  return ratio < 1.0 ? std::acos(ratio) / root : ratio > 1.0 ? std::acosh(ratio) / root : 1.0;
}

/// The peak tension over v sqrt(k m), and when it is, times the frequency (E8).
struct ClosedPeak {
  double size;
  double phase;
};
ClosedPeak closed_peak(double ratio) {
  if (ratio >= 0.5) {
    return {2.0 * ratio, 0.0};
  }
  const double root = std::sqrt(1.0 - ratio * ratio);
  const double phase = (std::numbers::pi / 2.0 - 3.0 * std::asin(ratio)) / root;
  return {std::exp(-ratio * phase), phase};
}

TEST(ElasticCable, HasTheRestitutionOfItsDampingRatio) {
  struct Row {
    double ratio;
    double restitution;
  };
  constexpr Row rows[] = {{0.05, .85875810177509182744}, {0.1, .74407939772177968881},
                          {0.2, .57174002758477682516},  {0.3, .45097545289312848221},
                          {0.5, .29843605919227488654},  {1.0, .13533528323661269189},
                          {1.5, .07558830936495606916}};
  double most = 0.0;
  for (const Row& row : rows) {
    most = std::max(most, std::abs(restitution_of(row.ratio) / row.restitution - 1.0));
  }
  constexpr Row inverse[] = {{.016498230920168432463, 0.95},
                             {.034265204126232760984, 0.9},
                             {.12221474778772474105, 0.7},
                             {.25527563764865180659, 0.5}};
  for (const Row& row : inverse) {
    most = std::max(most, std::abs(damping_ratio_of(row.restitution) / row.ratio - 1.0));
  }
  for (const double ratio : {1e-9, 0.7, 0.999999999, 1.000000001, 1.9, 2.1, 40.0}) {
    most = std::max(most, std::abs(contact_phase(ratio) / (2.0 * angle_of_contact(ratio)) - 1.0));
    EXPECT_NEAR(damping_ratio_of(restitution_of(ratio)) / ratio, 1.0, 1e-6) << ratio;
  }
  expect_within("restitution and its inverse [-]", most, 4e-15);
  EXPECT_EQ(damping_ratio_of(1.0), 0.0);
  EXPECT_EQ(damping_ratio_of(0.0), infinity<double>());
}

/// The largest relative error of a contact of mass `mass` against the closed forms (E5) to (E8).
double error_of_contact(const ElasticContact& contact, double stiffness, double ratio, double mass,
                        double speed) {
  const double frequency = std::sqrt(stiffness / mass);
  const double angle = angle_of_contact(ratio);
  const double kept = std::exp(-2.0 * ratio * angle);
  const ClosedPeak peak = closed_peak(ratio);
  const double lasts = contact.exit.value_or(-1.0) - contact.entry;
  const double force = speed * std::sqrt(stiffness * mass);
  return std::max(
      {std::abs(contact.entry_speed / speed - 1.0), std::abs(contact.exit_speed / speed - kept),
       std::abs(lasts * frequency - 2.0 * angle), std::abs(contact.peak / force - peak.size),
       std::abs(contact.greatest_stretch * frequency / speed - std::sqrt(kept)),
       std::abs(contact.impulse / (mass * speed) - 1.0 - kept)});
}

TEST(ElasticCable, KeepsToTheClosedFormsOfOneContact) {
  for (const double stiffness : {1e2, 1e4, 1e6, 1e8}) {
    double most = 0.0;
    double peak_late = 0.0;
    for (const double ratio : {0.0, 0.05, 0.1, 0.2, 0.3, 0.49, 0.5, 1.0, 1.5}) {
      const System system = drop<double>(with_ratio(stiffness, ratio), 0.0, 1.0, 0.25);
      const auto found = elastic_contacts(solve(system));
      ASSERT_EQ(found.size(), 1U) << "stiffness " << stiffness << ", ratio " << ratio;
      most = std::max(most, error_of_contact(found[0], stiffness, ratio, 1.0, 1.0));
      const double phase = (found[0].peak_time - found[0].entry) * std::sqrt(stiffness);
      peak_late = std::max(peak_late, std::abs(phase - closed_peak(ratio).phase));
    }
    // a stretch v / w is known to a rounding of the length
    const double rounding = 3.0 * epsilon<double>() * std::sqrt(stiffness);
    expect_within("contact, stiffness " + std::to_string(stiffness), most,
                  std::max(1e-13, rounding));
    // the tension is flat at its peak
    expect_within("instant of the peak", peak_late, 2e-6);
  }
}

TEST(ElasticCable, OfTwoBodiesHasTheReducedMass) {
  double most = 0.0;
  for (const double ratio : {0.0, 0.05, 0.3, 1.0}) {
    const double damping = 2.0 * ratio * std::sqrt(1e3 * 0.75);
    for (const Elasticity& law : {with_ratio(1e3, ratio), with_damping(1e3, damping)}) {
      const auto found = elastic_contacts(solve(pair_on_a_cable<double>(law)));
      ASSERT_EQ(found.size(), 1U);
      most = std::max(most, error_of_contact(found[0], 1e3, ratio, 0.75, 2.0));
    }
  }
  expect_within("contact of two bodies", most, 1e-13);
}

TEST(ElasticCable, KeepsToTheTableUnderAConstantLoad) {
  struct Row {
    double ratio, lasts, exit, stretch, peak, at, impulse;
  };
  constexpr Row rows[] = {
      {.05, .03259358735541270802, .84877547515929556909, 8.4877547515929556909e-4,
       102.47936938841098924, .01520779832850176082, 2.16851856711589423478},
      {.1, .03190896504687642834, .7263610024201973040, 1.4527220048403946080e-3,
       96.522859850036329926, .01375446426663969516, 2.03938794953005506607},
      {.3, .03005469589351468509, .41399178570143503466, 2.4839507142086102079e-3,
       86.760931312719184176, .00789191047720667904, 1.70882835241681409536}};
  double most = 0.0;
  double at = 0.0;
  for (const Row& row : rows) {
    const System system = drop<double>(with_ratio(1e4, row.ratio), 9.81, 1.0, 0.0);
    const auto solution = solve(system);
    const auto found = elastic_contacts(solution);
    ASSERT_FALSE(found.empty());
    const ElasticContact& first = found[0];
    ASSERT_TRUE(first.exit);
    most = std::max({most, std::abs((*first.exit - first.entry) / row.lasts - 1.0),
                     std::abs(first.exit_speed / row.exit - 1.0),
                     std::abs(first.peak / row.peak - 1.0),
                     std::abs(first.impulse / row.impulse - 1.0)});
    const double stretch = -gap(system.cables[0], solution.at(*first.exit));
    most = std::max(most, std::abs(stretch / row.stretch - 1.0));
    at = std::max(at, std::abs(first.peak_time - first.entry - row.at) * 100.0);
  }
  expect_within("contact under a load", most, 1e-13);
  expect_within("instant of the peak", at, 2e-6);
}

TEST(ElasticCable, UndampedUnderALoadFallsAsDeepAsItsEnergySays) {
  constexpr double g = 9.81;
  constexpr double k = 400.0;
  const double frequency = std::sqrt(k);
  const auto found = elastic_contacts(solve(drop<double>(with_ratio(k, 0.0), g, 0.0, 0.5)));
  ASSERT_FALSE(found.empty());
  const double speed = std::sqrt(2.0 * g * 0.5);
  const double half = std::numbers::pi - std::atan(frequency * speed / g);
  const double peak = g + std::sqrt(g * g + k * speed * speed);
  const double most = std::max(
      {std::abs(found[0].entry_speed / speed - 1.0), std::abs(found[0].exit_speed / speed - 1.0),
       std::abs((*found[0].exit - found[0].entry) * frequency - 2.0 * half),
       std::abs(found[0].peak / peak - 1.0), std::abs(found[0].greatest_stretch * k / peak - 1.0)});
  expect_within("undamped contact under a load", most, 1e-13);
}

TEST(ElasticCable, EngagesAgainWhileLoose) {
  struct Row {
    double ratio, speed;
  };
  constexpr double g = 9.81;
  constexpr double w = 100.0;
  for (const auto& [ratio, speed] : {Row{0.3, 0.4}, Row{0.1, 0.6}}) {
    const System system = drop<double>(with_ratio(1e4, ratio), g, speed, 1e-4);
    const auto solution = solve(system);
    const auto found = elastic_contacts(solution);
    int again = 0;
    for (std::size_t i = 1; i < found.size(); ++i) {
      if (found[i].entry_speed > 0.0) {
        continue;  // from slack
      }
      ++again;
      // the exit of a damped oscillation about its equilibrium, with T = 0
      const double lasts = *found[i - 1].exit - found[i - 1].entry;
      const double entry = found[i - 1].entry_speed;
      const double wd = w * std::sqrt(1.0 - ratio * ratio);
      const double b = (entry - ratio * w * g / (w * w)) / wd;
      const double fade = std::exp(-ratio * w * lasts);
      const double c = std::cos(wd * lasts);
      const double s = std::sin(wd * lasts);
      const double rest = g / (w * w);
      const double stretch = rest + fade * (-rest * c + b * s);
      const double rate = -ratio * w * (stretch - rest) + fade * wd * (rest * s + b * c);
      EXPECT_NEAR(w * w * stretch + 2.0 * ratio * w * rate, 0.0, 1e-11);
      // then it falls freely until the tension is zero again, still stretched
      const double bend = w * w * g / 2.0;
      const double slope = w * w * rate + 2.0 * ratio * w * g;
      const double later = -slope / bend;
      expect_within("ratio " + std::to_string(ratio) + ", engages again",
                    std::abs(found[i].entry - *found[i - 1].exit - later), 1e-13);
      expect_within("its rate", std::abs(found[i].entry_speed - (rate + g * later)), 1e-11);
    }
    EXPECT_GT(again, 0) << "ratio " << ratio;
  }
}

TEST(ElasticCable, MayStartStretched) {
  System system = drop<double>(with_ratio(1e4, 0.0), 0.0, 0.0, -0.01);
  auto solution = solve(system);
  auto found = elastic_contacts(solution);
  ASSERT_EQ(found.size(), 1U);
  const double most = std::max(
      std::abs(*found[0].exit * 100.0 - std::numbers::pi / 2.0),
      std::max(std::abs(found[0].exit_speed - 1.0), std::abs(found[0].peak / 100.0 - 1.0)));
  expect_within("released", most, 1e-13);
  EXPECT_EQ(found[0].entry, 0.0);
  // too fast for its damper: it does not pull
  system = drop<double>(with_damping(1e4, 20.0), 0.0, -6.0, -0.01);
  system.duration = 0.2;
  solution = solve(system);
  EXPECT_TRUE(elastic_contacts(solution).empty());
  EXPECT_EQ(solution.at(0.2).bodies[0].velocity.y(), 6.0);
  const SystemLedger ledger = energy_ledger(system, solution);
  EXPECT_NEAR(ledger.dissipated, 0.5, 1e-14);
  EXPECT_LE(std::abs(ledger.residual), 1e-14);
}

TEST(ElasticCable, GrazesWithoutAJump) {
  // thrown down against gravity, it turns as much beyond the length as `over`
  for (const double over : {-1e-9, -1e-13, 0.0, 1e-15, 1e-13, 1e-11, 1e-9}) {
    const double slack = 0.5 - over;
    System system = drop<double>(with_ratio(1e4, 0.3), -1.0, 1.0, slack);
    const auto solution = solve(system);
    ASSERT_EQ(solution.ending(), Ending::reached_duration) << over;
    const auto found = elastic_contacts(solution);
    const double speed = std::sqrt(std::max(0.0, 2.0 * over));
    constexpr double damping = 60.0;  // [N s/m]
    double impulse = 0.0;
    for (const ElasticContact& contact : found) {
      impulse += contact.impulse;
    }
    const double rounding = std::sqrt(8.0 * epsilon<double>());
    if (over > 1e-14) {  // the load turns it back, and the damper adds a little
      EXPECT_NEAR(found.at(0).entry_speed, speed, rounding) << over;
      EXPECT_NEAR(impulse, damping * over, 0.01 * damping * over + damping * rounding * rounding)
          << over;
    } else if (over < -1e-14) {
      EXPECT_TRUE(found.empty()) << over;
    }
    EXPECT_NEAR(solution.at(1.0).bodies[0].velocity.y(), impulse, 1e-13) << over;
  }
}

void expect_alike(const std::string& what, const Apart& apart, std::size_t least, double allowed) {
  EXPECT_GE(apart.switchings, least) << what;
  expect_within(what + ", " + std::to_string(apart.switchings) + " switches", apart.time, allowed);
  expect_within(what + ", state", apart.state, 20.0 * allowed);
}

TEST(ElasticCable, AgreesWithAnotherMethod) {
  const Elasticity soft = with_damping(1e3, 3.0);
  const System breakwater = breakwater_system<double>(1.0);
  expect_alike("breakwater", apart_from_extrapolation(elastic(breakwater, soft), 4.0, 2e-3), 30,
               2e-12);
  expect_alike("stiff breakwater",
               apart_from_extrapolation(elastic(breakwater, with_damping(1e5, 60.0)), 3.0, 4e-4),
               88, 1e-10);
  expect_alike("undamped breakwater",
               apart_from_extrapolation(elastic(breakwater, with_damping(1e3, 0.0)), 2.0, 2e-3), 10,
               1e-11);
  Elasticity hard = soft;
  hard.stiffness = {1e3, 1e4, 1e5};
  expect_alike("cubic force", apart_from_extrapolation(elastic(breakwater, hard), 2.0, 1e-3), 10,
               2e-12);
  expect_alike("two bodies in series",
               apart_from_extrapolation(elastic(in_series<double>(), soft), 2.0, 2e-3), 20, 1e-11);
  expect_alike("ring", apart_from_extrapolation(elastic_pulley<double>(soft), 3.0, 2e-3), 10,
               5e-11);
}

TEST(ElasticCable, AgreesWithAnotherMethodInSpace) {
  expect_alike("box",
               apart_from_extrapolation(elastic_box<double>(with_damping(2e3, 4.0)), 3.0, 1e-3), 8,
               2e-11);
}

TEST(ElasticCable, PullsAtABodyOnAnInextensibleCable) {
  constexpr double k = 50.0;
  constexpr double c = 0.8;
  const System system = pendulum_into_a_cable<double>(with_damping(k, c));
  const auto solution = solve(system);
  // the angle from straight down, and its rate
  const auto stretch = [](const Numbers& y) {
    const Vec2 apart(std::sin(y[0]) + 1.0, 2.0 - std::cos(y[0]));
    const Vec2 along(std::cos(y[0]), std::sin(y[0]));
    const double slope = apart.normalized().dot(along);
    return std::array<double, 3>{apart.norm() - 1.4, slope * y[1], slope};
  };
  const auto pull = [&](const Numbers& y) {
    const auto [s, rate, slope] = stretch(y);
    return k * s + c * rate;
  };
  const auto move = [&](const Numbers& y, double dt, bool pulls) {
    return extrapolated(
        [&](const Numbers& now) {
          Numbers rates(2);
          rates << now[1], -std::sin(now[0]) - (pulls ? pull(now) * stretch(now)[2] : 0.0);
          return rates;
        },
        y, dt);
  };
  /// when `value` of the motion from `y` falls below zero, in steps of 10 ms
  const auto until = [&](Numbers& y, bool pulls, const auto& value) {
    double low = 0.0;
    double high = 0.01;
    double before = 0.0;
    for (Numbers next = move(y, high, pulls); value(next) >= 0.0; next = move(y, high, pulls)) {
      y = next;
      before += high;
    }
    while (high - low > 1e-17) {
      const double middle = (low + high) / 2.0;
      if (!(low < middle && middle < high)) {
        break;
      }
      (value(move(y, middle, pulls)) < 0.0 ? high : low) = middle;
    }
    y = move(y, high, pulls);
    return before + high;
  };
  Numbers y(2);
  y << -std::asin(0.6), 2.0;
  const double entry = until(y, false, [&](const Numbers& now) { return -stretch(now)[0]; });
  const double exit = entry + until(y, true, pull);
  const auto found = elastic_contacts(solution);
  ASSERT_FALSE(found.empty());
  ASSERT_TRUE(found[0].exit);
  EXPECT_TRUE(solution.arcs().back().taut.contains(0));
  const State end = solution.at(*found[0].exit).bodies[0];
  expect_within("entry", std::abs(found[0].entry - entry), 1e-13);
  expect_within("exit", std::abs(*found[0].exit - exit), 1e-13);
  expect_within("place", (end.position - Vec2(std::sin(y[0]), -std::cos(y[0]))).norm(), 1e-13);
  expect_within("velocity", (end.velocity - y[1] * Vec2(std::cos(y[0]), std::sin(y[0]))).norm(),
                1e-12);
  // the tension of the inextensible cable at the entry: no jump of the rate, one of the pull
  const double speed = end.velocity.norm();
  const double inner = speed * speed + std::cos(y[0]);
  EXPECT_NEAR(solution.tensions(*found[0].exit)[0], inner, 1e-11);
}

/// What is left of the ledger, over its range.
template <int D>
double residual(const BasicSystem<double, D>& system) {
  const SystemLedger ledger = energy_ledger(system, solve(system));
  EXPECT_GE(ledger.dissipated, -1e-14 * ledger.range);
  return std::abs(ledger.residual) / ledger.range;
}

/// All systems whose energy is looked at.
std::vector<std::pair<std::string, System>> elastic_systems() {
  const Elasticity soft = with_damping(1e3, 3.0);
  Elasticity hard = soft;
  hard.stiffness = {1e3, 0.0, 1e5};
  std::vector<std::pair<std::string, System>> result = {
      {"breakwater", elastic(breakwater_system<double>(1.0), soft)},
      {"cubic force", elastic(breakwater_system<double>(1.0), hard)},
      {"moved anchors", elastic(shaken<double>(), soft)},
      {"winch", elastic(winch<double>(), soft)},
      {"waves", elastic(waves<double>(), soft)},
      {"two bodies", elastic(in_series<double>(), soft)},
      {"ring that moves", elastic(pulley<double>(), soft)},
      {"pendulum", pendulum_into_a_cable<double>(with_damping(50.0, 0.8))}};
  System mixed = breakwater_system<double>(0.9);
  mixed.cables[0] = elastic(mixed.cables[0], with_ratio(1e3, 0.05));
  result.emplace_back("one of two", mixed);
  System below = in_series<double>();
  below.cables[2] = elastic(below.cables[2], with_ratio(1e3, 0.05));
  result.emplace_back("one of three", below);
  System cut = elastic(breakwater_system<double>(1.0), soft);
  cut.cables[0].cut_at = 2.3;
  cut.cables[1].from_time = 0.4;
  result.emplace_back("cut and hooked up", cut);
  for (auto& [name, system] : result) {
    system.duration = 3.0;
  }
  return result;
}

TEST(ElasticCable, AccountsForEveryJoule) {
  // each arc knows a stretch to a rounding of the length, and its energy to that times the tension
  constexpr double allowed = 5e-14;
  for (const auto& [name, system] : elastic_systems()) {
    EXPECT_TRUE(problems(system).empty()) << problems(system).front();
    expect_within(name, residual(system), allowed);
  }
  expect_within("box", residual(elastic_box<double>(with_ratio(2e3, 0.05))), allowed);
}

TEST(ElasticCable, AccountsForAContactOfNanoseconds) {
  System system = drop<double>(with_ratio(4e14, 0.1), 0.0, 1.0, 0.05);
  system.duration = 0.1;
  ASSERT_TRUE(problems(system).empty());
  const SystemLedger ledger = energy_ledger(system, solve(system));
  const double kept = restitution_of(0.1);
  // a stretch of 4e-8 m is the difference of numbers like 1 m
  EXPECT_NEAR(ledger.dissipated, (1.0 - kept * kept) / 2.0, 1e-7);
  expect_within("residual", std::abs(ledger.residual), 1e-7);
}

TEST(ElasticCable, AccountsForArcsThatDoubleItsLength) {
  // an anchor that runs away at 20 m/s stretches a soft cable by metres
  System system = drop<double>(with_damping(10.0, 0.0), 0.0, 0.0, 0.1);
  system.cables[0].to.motion = Function<2>::linear({0.0, 1.0}, {Vec2(0.0, 0.0), Vec2(0.0, 20.0)});
  system.duration = 0.7;
  const SystemLedger ledger = energy_ledger(system, solve(system));
  EXPECT_GT(ledger.stored, 100.0);
  expect_within("residual", std::abs(ledger.residual) / ledger.range, 1e-14);
}

TEST(ElasticCable, PullsInTheTensionsOfItsSolution) {
  const System system = drop<double>(with_ratio(1e4, 0.1), 9.81, 1.0, 0.0);
  const auto solution = solve(system);
  const auto found = elastic_contacts(solution);
  EXPECT_NEAR(solution.tensions(found[0].peak_time)[0], found[0].peak, 1e-10);
  EXPECT_EQ(solution.tensions(*found[0].exit + 1e-6)[0], 0.0);
}

TEST(ElasticCable, EndsAContactWhereItIsCut) {
  System system = drop<double>(with_ratio(100.0, 0.1), 9.81, 1.0, 0.0);
  system.cables[0].cut_at = 0.1;  // before the greatest stretch
  const auto solution = solve(system);
  const auto found = elastic_contacts(solution);
  ASSERT_EQ(found.size(), 1U);
  EXPECT_EQ(found[0].exit, 0.1);
  const double rising = solution.at(0.1).bodies[0].velocity.y();
  EXPECT_LT(rising, 0.0);
  EXPECT_NEAR(found[0].exit_speed, rising, 1e-14);
}

/// Expects one sentence that has `words`.
void expect_problem(const System& system, const std::string& words) {
  const auto found = problems(system);
  ASSERT_EQ(found.size(), 1U) << words;
  EXPECT_NE(found[0].find(words), std::string::npos) << found[0];
  EXPECT_THROW((void)solve(system), std::invalid_argument);
}

/// The number that follows `words` in the only sentence on `system`.
double advised(const System& system, const std::string& words) {
  const auto found = problems(system);
  EXPECT_EQ(found.size(), 1U);
  const std::size_t place = found.empty() ? std::string::npos : found[0].find(words);
  if (place == std::string::npos) {
    ADD_FAILURE() << "\"" << words << "\" is not in: " << (found.empty() ? "" : found[0]);
    return 0.0;
  }
  return std::stod(found[0].substr(place + words.size()));
}

TEST(ElasticCable, SaysHowToSlowAStiffCableOrADamper) {
  System stiff = drop<double>(with_ratio(1e15, 0.1), 9.81, 1.0, 0.1);
  System damped = drop<double>(with_damping(1.0, 1e9), 9.81, 1.0, 0.1);
  System by_ratio = drop<double>(with_ratio(1e4, 1e6), 9.81, 1.0, 0.1);
  for (const auto& [system, advice, number] :
       {std::tuple(&stiff, "or lower its stiffness to ",
                   &stiff.cables[0].elasticity->stiffness.front()),
        std::tuple(&damped, "lower its damping to ", &damped.cables[0].elasticity->damping),
        std::tuple(&by_ratio, "lower its damping_ratio to ",
                   &by_ratio.cables[0].elasticity->damping_ratio)}) {
    *number = 0.999 * advised(*system, advice);
    EXPECT_TRUE(problems(*system).empty()) << problems(*system).front();
  }
}

TEST(ElasticCable, TellsAFastDamperFromAStiffCable) {
  // of 100 rad/s
  System system = drop<double>(with_ratio(1e4, damping_ratio_of(1e-12)), 9.81, 1.0, 0.1);
  Elasticity& law = *system.cables[0].elasticity;
  EXPECT_NEAR(advised(system, "the rate of its damper, ") / 1e8, 1.0, 1e-9);
  law.damping_ratio = 1.001 * damping_ratio_of(advised(system, "(a restitution of "));
  EXPECT_EQ(problems(system).size(), 1U);
  law.damping_ratio *= 0.998;
  EXPECT_TRUE(problems(system).empty());
  // where both are too fast it says how to slow both
  for (const bool of_ratio : {true, false}) {
    law = of_ratio ? with_ratio(1e16, 30.0) : with_damping(1e16, 6e9);
    const double softer = 0.999 * advised(system, of_ratio ? ") and its stiffness to "
                                                           : " N s/m and its stiffness to ");
    double& damper = of_ratio ? law.damping_ratio : law.damping;
    damper =
        0.999 * advised(system, of_ratio ? "lower its damping_ratio to " : "lower its damping to ");
    law.stiffness = {softer};
    EXPECT_TRUE(problems(system).empty()) << problems(system).front();
  }
}

TEST(ElasticCable, IsTooStiffAlsoWhereItsEndsMeetAtTheStart) {
  // in any direction, as the bound for the directions has it: that of an arm, and of the mass
  System system = drop<double>(with_ratio(1e17, 0.0), 9.81, 0.0, 1.0);
  EXPECT_NEAR(advised(system, "its frequency, ") / std::sqrt(1e17), 1.0, 1e-12);
  system.bodies[0].inertia = 0.25;
  system.cables[0].from.at = Vec2(0.0, 0.5);
  system.initial.bodies[0].position.y() -= 0.5;
  EXPECT_NEAR(advised(system, "its frequency, ") / std::sqrt(2e17), 1.0, 1e-12);
  system.cables[0].elasticity->stiffness = {1e4};
  EXPECT_TRUE(problems(system).empty());
}

TEST(ElasticCable, WithoutACutNeedsADirectionAtTheStart) {
  System system = drop<double>(with_damping(160.0, 5.0), 9.81, 0.0, 1.0);
  EXPECT_TRUE(problems(system).empty());
  system.cables[0].elasticity->cut = ElasticCut::never;
  expect_problem(system,
                 "start 0 m apart, which gives it no direction, and with cut \"never\" its damper "
                 "acts there; must be at least 1e-06 m");
}

TEST(ElasticCable, HasOneSentenceForEachProblem) {
  const System good = drop<double>(with_ratio(1e4, 0.1), 9.81, 1.0, 0.1);
  EXPECT_TRUE(problems(good).empty());
  const auto with = [&](const auto& change) {
    System system = good;
    change(system.cables[0]);
    return system;
  };
  expect_problem(with([](auto& cable) { cable.elasticity->stiffness.clear(); }), "empty");
  expect_problem(with([](auto& cable) { cable.elasticity->stiffness = {0.0}; }), "above 0 [N/m]");
  expect_problem(with([](auto& cable) { cable.elasticity->stiffness = {infinity<double>()}; }),
                 "finite");
  expect_problem(with([](auto& cable) { cable.elasticity->damping_ratio = -0.1; }), "0 or above");
  expect_problem(with([](auto& cable) {
                   cable.elasticity->damping_ratio = 0.0;
                   cable.elasticity->damping = -1.0;
                 }),
                 "0 or above");
  expect_problem(with([](auto& cable) { cable.elasticity->damping = 1.0; }), "both given");
  expect_problem(with([](auto& cable) { cable.restitution = 0.9; }), "inextensible");
  expect_problem(with([](auto& cable) { cable.elasticity->stiffness = {1e14}; }),
                 "inextensible with restitution 0.744");
  expect_problem(with([](auto& cable) {
                   cable.elasticity->stiffness = {1e2, -1e2};
                 }),
                 "falls at a stretch");
  EXPECT_TRUE(problems(with([](auto& cable) {
                cable.elasticity->stiffness = {1e4, -1.0};
              })).empty());
}

}  // namespace
}  // namespace tautline::test
