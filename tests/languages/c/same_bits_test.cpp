// What comes out of libtautline.so is what the solver says in C++, bit for bit.

#include <gtest/gtest.h>

#include <array>
#include <bit>
#include <cmath>
#include <cstring>
#include <limits>
#include <memory>
#include <string>
#include <vector>

#include "owned.hpp"
#include "support.hpp"
#include "tautline/case_text.hpp"
#include "tautline/geometry.hpp"
#include "tautline/scenarios.hpp"
#include "tautline/settling.hpp"
#include "tautline/solve.hpp"
#include "tautline/uncertainty.hpp"

namespace tautline::c::test {
namespace {

using tautline::test::Draw;
using tautline::test::Random;
using tautline::test::random_case;

constexpr std::uint64_t seed = 20261126;
#ifdef TAUTLINE_SANITIZED
constexpr std::size_t systems = 20;
#else
constexpr std::size_t systems = 200;
#endif

/// The shipped cases, and random ones of one to four cables.
std::vector<Case> all_cases() {
  std::vector<Case> cases = shipped_cases();
  Random random(seed);
  for (std::size_t index = 0; index < systems; ++index) {
    Draw draw;
    draw.cables = 1 + index % 4;
    draw.taut_chance = index % 3 == 0 ? 0.3 : 0.0;
    cases.push_back(random_case(random, draw));
    cases.back().name = "random " + std::to_string(index);
    cases.back().duration = 5.0;
  }
  return cases;
}

/// NaN has many bits: any is as good as another.
std::uint64_t bits_of(double number) {
  return std::isnan(number) ? 1 : std::bit_cast<std::uint64_t>(number);
}

void expect_same(const std::vector<double>& got, const std::vector<double>& expected,
                 const std::string& what) {
  ASSERT_EQ(got.size(), expected.size()) << what;
  for (std::size_t index = 0; index < got.size(); ++index) {
    ASSERT_EQ(bits_of(got[index]), bits_of(expected[index]))
        << what << "[" << index << "]: " << got[index] << ", not " << expected[index];
  }
}

void add_state(std::vector<double>& row, const State& s) {
  row.insert(row.end(),
             {s.position.x(), s.position.y(), s.angle, s.velocity.x(), s.velocity.y(), s.spin});
}

std::int32_t bits_of(CableSet cables) {
  std::int32_t bits = 0;
  for (const std::size_t cable : cables) {
    bits |= 1 << cable;
  }
  return bits;
}

std::vector<double> times_of(const Solution& solution) {
  std::vector<double> times;
  for (int k = 0; k <= 40; ++k) {
    times.push_back(solution.end_time() * (k / 40.0));
  }
  for (const Event& event : solution.events()) {
    times.push_back(event.time);
  }
  return times;
}

void expect_same_events(const OwnedMotion& motion, const Case& the_case, const Solution& solution) {
  const std::size_t rows = solution.events().size();
  const std::size_t width = the_case.cables.size();
  std::vector<double> time(rows);
  std::vector<std::int32_t> kind(rows);
  std::vector<std::int32_t> cables(rows);
  std::vector<double> before(6 * rows);
  std::vector<double> after(6 * rows);
  std::vector<double> impulses(width * rows);
  ASSERT_EQ(tautline_events(motion.get(), 0, rows, time.data(), kind.data(), cables.data(),
                            before.data(), after.data(), impulses.data()),
            TAUTLINE_OK);
  std::vector<double> times;
  std::vector<double> befores;
  std::vector<double> afters;
  std::vector<double> jumps(width * rows);
  for (std::size_t row = 0; row < rows; ++row) {
    const Event& event = solution.events()[row];
    times.push_back(event.time);
    add_state(befores, event.before);
    add_state(afters, event.after);
    EXPECT_EQ(tautline_event_kind_name(kind[row]), to_string(event.kind));
    EXPECT_EQ(cables[row], bits_of(event.cables));
    Eigen::Index place = 0;
    for (const std::size_t cable : event.cables) {
      jumps[row * width + cable] = place < event.impulses.size() ? event.impulses[place++] : 0.0;
    }
  }
  expect_same(time, times, "time");
  expect_same(before, befores, "before");
  expect_same(after, afters, "after");
  expect_same(impulses, jumps, "impulses");
}

void expect_same_states(const OwnedMotion& motion, const Case& the_case, const Solution& solution) {
  const std::vector<double> times = times_of(solution);
  const std::size_t width = the_case.cables.size();
  std::vector<double> states(6 * times.size());
  std::vector<double> tensions(width * times.size());
  std::vector<double> kinetic(times.size());
  std::vector<double> potential(times.size());
  std::vector<double> total(times.size());
  std::vector<std::int32_t> taut(times.size());
  ASSERT_EQ(tautline_states(motion.get(), times.data(), times.size(), states.data(), taut.data(),
                            nullptr),
            TAUTLINE_OK);
  ASSERT_EQ(tautline_tensions(motion.get(), times.data(), times.size(), tensions.data(), nullptr),
            TAUTLINE_OK);
  ASSERT_EQ(tautline_energy(motion.get(), times.data(), times.size(), kinetic.data(),
                            potential.data(), total.data(), nullptr),
            TAUTLINE_OK);
  std::vector<double> expected_states;
  std::vector<double> expected_tensions;
  std::vector<double> expected_total;
  for (std::size_t row = 0; row < times.size(); ++row) {
    const State state = solution.at(times[row]);
    add_state(expected_states, state);
    for (const double tension : solution.tensions(times[row])) {
      expected_tensions.push_back(tension);
    }
    EXPECT_EQ(taut[row], bits_of(solution.arcs()[solution.place(times[row]).arc].taut));
    expected_total.push_back(energy(the_case, state));
    // one rounding of the sum
    EXPECT_NEAR(kinetic[row] + potential[row], total[row], 1e-15 * (1.0 + kinetic[row]));
  }
  expect_same(states, expected_states, "states");
  expect_same(tensions, expected_tensions, "tensions");
  expect_same(total, expected_total, "energy");
}

void expect_same_settling(const OwnedMotion& motion, const Case& the_case,
                          const Solution& solution) {
  auto got = sized<tautline_settling>();
  ASSERT_EQ(tautline_settle(motion.get(), &got), TAUTLINE_OK);
  const Settling expected = settling(the_case, solution);
  const double none = std::numeric_limits<double>::quiet_NaN();
  EXPECT_EQ(got.cables, expected.lock ? bits_of(expected.lock->cables) : 0);
  EXPECT_EQ(got.permanent, expected.lock && expected.lock->permanent ? 1 : 0);
  EXPECT_EQ(got.rests, expected.lock && expected.lock->rests ? 1 : 0);
  EXPECT_EQ(got.swings, expected.lock && expected.lock->swing ? 1 : 0);
  const auto swing = expected.lock ? expected.lock->swing : std::nullopt;
  expect_same(
      {got.time, got.uncertainty, got.last_impact_time[0], got.last_impact_time[1],
       got.swing_energy, got.swing_period, got.swing_least, got.swing_largest, got.swing_amplitude},
      {expected.lock ? expected.lock->time : none,
       expected.lock ? expected.lock->uncertainty : none,
       expected.last_impacts[0].time.value_or(none), expected.last_impacts[1].time.value_or(none),
       swing ? swing->energy : none, swing ? swing->period : none, swing ? swing->least : none,
       swing ? swing->largest : none, swing ? swing->amplitude : none},
      "settling");
}

void expect_same_errors(const OwnedMotion& motion, const Case& the_case, const Solution& solution) {
  const Uncertainty expected(the_case, solution);
  double horizon = 0.0;
  double lock = 0.0;
  std::size_t unsure = 0;
  ASSERT_EQ(tautline_horizon(motion.get(), &horizon, &lock, &unsure), TAUTLINE_OK);
  const double none = std::numeric_limits<double>::quiet_NaN();
  expect_same({horizon, lock},
              {expected.horizon().value_or(std::numeric_limits<double>::infinity()),
               expected.lock().value_or(none)},
              "horizon");
  ASSERT_EQ(unsure, expected.unsure().size());
  std::vector<double> from(unsure);
  std::vector<double> until(unsure);
  std::vector<std::int32_t> kind(unsure);
  ASSERT_EQ(
      tautline_unsure(motion.get(), 0, unsure, from.data(), until.data(), kind.data(), nullptr),
      TAUTLINE_OK);
  for (std::size_t row = 0; row < unsure; ++row) {
    expect_same({from[row], until[row]},
                {expected.unsure()[row].from, expected.unsure()[row].until}, "unsure");
    EXPECT_EQ(kind[row] >= 0, expected.unsure()[row].tie.has_value());
  }
  const std::size_t rows = expected.events().size();
  std::vector<double> time(rows);
  std::vector<double> after(6 * rows);
  ASSERT_EQ(tautline_event_errors(motion.get(), 0, rows, time.data(), nullptr, nullptr,
                                  after.data(), nullptr, nullptr),
            TAUTLINE_OK);
  std::vector<double> times;
  std::vector<double> afters;
  for (const auto& event : expected.events()) {
    times.push_back(event ? event->time : none);
    add_state(afters, event ? event->after : State{{none, none}, none, {none, none}, none});
  }
  expect_same(time, times, "errors of times");
  expect_same(after, afters, "errors of states after");
}

TEST(CInterface, EveryNumberIsThatOfTheSolver) {
  for (const Case& the_case : all_cases()) {
    SCOPED_TRACE(the_case.name);
    for (const ImpactLaw law : impact_laws) {
      SolveOptions options;
      options.law = law;
      auto asked = sized<tautline_options>();
      asked.law = static_cast<std::int32_t>(law);
      const OwnedCase given = from_numbers(the_case);
      ASSERT_EQ(problems_of(given), "");
      const OwnedMotion motion = solved(given, &asked);
      ASSERT_TRUE(motion);
      const Solution solution = solve(the_case, options);
      auto summary = sized<tautline_summary>();
      ASSERT_EQ(tautline_summarise(motion.get(), &summary), TAUTLINE_OK);
      EXPECT_EQ(tautline_ending_name(summary.ending), to_string(solution.ending()));
      EXPECT_EQ(static_cast<std::size_t>(summary.events), solution.events().size());
      expect_same_events(motion, the_case, solution);
      if (law == ImpactLaw::simultaneous) {
        expect_same_states(motion, the_case, solution);
        expect_same_settling(motion, the_case, solution);
        expect_same_errors(motion, the_case, solution);
      }
      if (testing::Test::HasFatalFailure()) {
        return;
      }
    }
  }
}

TEST(CInterface, TextReadsBackToTheSameBits) {
  for (const Case& the_case : all_cases()) {
    const OwnedCase given = from_numbers(the_case);
    for (const std::int32_t format : {TAUTLINE_TOML, TAUTLINE_JSON}) {
      const std::string text = text_of(given, format);
      const OwnedCase again(tautline_case_from_text(text.data(), text.size(), nullptr));
      ASSERT_EQ(problems_of(again), "") << text;
      EXPECT_EQ(text_of(again, TAUTLINE_TOML), write_case(the_case));
    }
  }
}

TEST(CInterface, GapsAreThoseOfTheCase) {
  const Case the_case = breakwater(table_5_1()[0].parameters, "one");
  const OwnedCase given = from_numbers(the_case);
  std::vector<double> state;
  add_state(state, the_case.initial);
  std::array<double, 2> gaps{};
  std::array<double, 2> rates{};
  ASSERT_EQ(tautline_gaps(given.get(), state.data(), 1, gaps.data(), rates.data()), TAUTLINE_OK);
  for (std::size_t cable = 0; cable < 2; ++cable) {
    EXPECT_EQ(gaps[cable], gap(the_case.cables[cable], the_case.initial));
    EXPECT_EQ(rates[cable], gap_rate(the_case.cables[cable], the_case.initial));
  }
}

/// What a sweep gives of all cases.
struct Swept {
  std::vector<tautline_summary> summaries;
  std::vector<tautline_settling> settlings;
  std::vector<double> states;

  explicit Swept(std::size_t count, std::size_t times)
      : summaries(count, sized<tautline_summary>()),
        settlings(count, sized<tautline_settling>()),
        states(6 * count * times) {}

  /// Its bytes, with one NaN for all.
  [[nodiscard]] std::vector<std::uint64_t> bits() const {
    std::vector<double> numbers = states;
    const auto add = [&](const auto& structs) {
      for (const auto& one : structs) {
        std::array<double, sizeof one / sizeof(double)> words{};
        std::memcpy(words.data(), &one, sizeof one);
        numbers.insert(numbers.end(), words.begin(), words.end());
      }
    };
    add(summaries);
    add(settlings);
    std::vector<std::uint64_t> result;
    for (const double number : numbers) {
      result.push_back(bits_of(number));
    }
    return result;
  }
};

constexpr std::array times_of_sweep = {0.0, 1.0, 4.5, 100.0};

/// The same by one solution after the other.
Swept one_by_one(const std::vector<OwnedCase>& cases, const tautline_options* options) {
  Swept all(cases.size(), times_of_sweep.size());
  for (std::size_t index = 0; index < cases.size(); ++index) {
    const OwnedMotion motion = solved(cases[index], options);
    tautline_summary& summary = all.summaries[index];
    EXPECT_EQ(tautline_summarise(motion.get(), &summary), TAUTLINE_OK);
    EXPECT_EQ(tautline_settle(motion.get(), &all.settlings[index]), TAUTLINE_OK);
    for (std::size_t k = 0; k < times_of_sweep.size(); ++k) {
      double* row = &all.states[6 * (index * times_of_sweep.size() + k)];
      if (tautline_states(motion.get(), &times_of_sweep[k], 1, row, nullptr, nullptr) !=
          TAUTLINE_OK) {
        std::fill_n(row, 6, std::numeric_limits<double>::quiet_NaN());
      }
    }
  }
  return all;
}

TEST(CInterface, SweepIsOneSolutionAfterTheOtherInAnyNumberOfThreads) {
  std::vector<OwnedCase> cases;
  std::vector<const tautline_case*> pointers;
  for (const Case& the_case : all_cases()) {
    cases.push_back(from_numbers(the_case));
    pointers.push_back(cases.back().get());
  }
  auto options = sized<tautline_options>();
  options.until_locked = 1;
  const Swept expected = one_by_one(cases, &options);
  for (const std::int32_t threads : {1, 4, 0}) {
    Swept got(cases.size(), times_of_sweep.size());
    ASSERT_EQ(tautline_sweep(pointers.data(), pointers.size(), &options, threads,
                             times_of_sweep.data(), times_of_sweep.size(), got.summaries.data(),
                             got.settlings.data(), got.states.data(), nullptr),
              TAUTLINE_OK);
    EXPECT_EQ(got.bits(), expected.bits()) << threads << " threads";
  }
}

TEST(CInterface, SweepVariesACase) {
  const OwnedCase base = from_numbers(breakwater(table_5_1()[0].parameters, "one"));
  const std::array names = {"restitution", "vx", "length_1", "mass"};
  std::vector<double> values;
  std::vector<OwnedCase> cases;
  Random random(seed);
  for (int row = 0; row < 100; ++row) {
    const std::array<double, 4> one = {random.uniform(0.1, 0.9), random.uniform(-0.2, 0.2), 1.5,
                                       random.uniform(0.5, 2.0)};
    values.insert(values.end(), one.begin(), one.end());
    tautline_case* varied = nullptr;
    ASSERT_EQ(tautline_case_vary(base.get(), names.data(), one.data(), 4, &varied, nullptr),
              TAUTLINE_OK);
    cases.emplace_back(varied);
    ASSERT_EQ(problems_of(cases.back()), "");
  }
  const Swept expected = one_by_one(cases, nullptr);
  for (const std::int32_t threads : {1, 4}) {
    Swept got(cases.size(), times_of_sweep.size());
    ASSERT_EQ(tautline_sweep_varied(base.get(), names.data(), names.size(), values.data(), 100,
                                    nullptr, threads, times_of_sweep.data(), times_of_sweep.size(),
                                    got.summaries.data(), got.settlings.data(), got.states.data(),
                                    nullptr),
              TAUTLINE_OK);
    EXPECT_EQ(got.bits(), expected.bits()) << threads << " threads";
  }
  // the second row cannot be: only its results say so
  values[4] = 2.0;
  Swept got(3, 1);
  ASSERT_EQ(tautline_sweep_varied(base.get(), names.data(), names.size(), values.data(), 3, nullptr,
                                  1, times_of_sweep.data(), 1, got.summaries.data(),
                                  got.settlings.data(), got.states.data(), nullptr),
            TAUTLINE_OK);
  EXPECT_EQ(got.summaries[0].status, TAUTLINE_OK);
  EXPECT_EQ(got.summaries[1].status, TAUTLINE_BAD_CASE);
  EXPECT_TRUE(std::isnan(got.summaries[1].end_time) && std::isnan(got.settlings[1].time));
  EXPECT_TRUE(std::isnan(got.settlings[1].swing_tension) && std::isnan(got.states[6]));
  EXPECT_EQ(got.summaries[2].status, TAUTLINE_OK);
}

}  // namespace
}  // namespace tautline::c::test
