#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <iostream>

#include "support.hpp"
#include "tautline/geometry.hpp"
#include "tautline/solve.hpp"

namespace tautline::test {
namespace {

/// Where a case of Table 5.1 locks into the swing on both cables, computed with 60-digit arithmetic
/// from the exact decimals of the table.
struct Swing {
  const char* number;
  double time;    // [-], of the accumulation on both cables, six decimals
  double energy;  // [-], left for the swing, nine decimals
};

void PrintTo(const Swing& swing, std::ostream* out) { *out << swing.number; }

class Settling : public ::testing::TestWithParam<Swing> {};

/// The earliest and latest accumulation of copies started one rounding error apart, with what each
/// says of its own uncertainty.
struct Spread {
  double earliest = 1e300;
  double latest = -1e300;
};

Spread spread_of_copies(const Case& the_case) {
  constexpr std::uint64_t seed = 5;
  constexpr int copies = 40;
  constexpr double rounding = 1e-16;  // of the decimals 0.1 and 0.2 of the start
  Random random(seed);
  Spread result;
  for (int copy = 0; copy < copies; ++copy) {
    Case other = the_case;
    other.initial.position += random.in_square(rounding);
    other.initial.velocity += random.in_square(rounding);
    const Solution solution = solve(other);
    if (solution.ending() != Ending::zeno || solution.accumulation()->cables.size() != 2) {
      continue;
    }
    const Accumulation& end = *solution.accumulation();
    result.earliest = std::min(result.earliest, end.time - end.uncertainty);
    result.latest = std::max(result.latest, end.time + end.uncertainty);
  }
  return result;
}

TEST_P(Settling, AccumulatesOnBothCablesAtTheKnownTime) {
  const Case the_case = table_case(GetParam().number);
  const Solution solution = solve(the_case);
  ASSERT_EQ(solution.ending(), Ending::zeno) << to_string(solution.ending());
  const Accumulation& end = *solution.accumulation();
  EXPECT_EQ(end.cables.size(), 2U);
  // the instant is ill-conditioned: rounding of the start moves it by more than the uncertainty,
  // which counts from the last impact on. The copies show by how much.
  const Spread copies = spread_of_copies(the_case);
  std::cout << "  " << GetParam().number << ": " << end.time << " +- " << end.uncertainty
            << ", expected " << GetParam().time << ", copies from " << copies.earliest << " to "
            << copies.latest << '\n';
  constexpr double printed = 0.5e-6;
  EXPECT_GE(GetParam().time, copies.earliest - printed);
  EXPECT_LE(GetParam().time, copies.latest + printed);
  constexpr double worst_case = 3e-4;  // measured on 60 copies 1e-16 apart of the standard case
  expect_within("error of the time", std::abs(end.time - GetParam().time), worst_case);
  // the energy varies with the cube of what moves the time
  expect_within("error of the energy", std::abs(end.energy - GetParam().energy), 2e-9);
}

INSTANTIATE_TEST_SUITE_P(Table51, Settling,
                         ::testing::Values(Swing{"1910121100", 8.128808, 0.019679140},
                                           Swing{"2910121100", 10.111110, 0.021261313},
                                           Swing{"19101211050", 8.168028, 0.020663484},
                                           Swing{"1910121110", 8.345253, 0.016823732},
                                           Swing{"1931121100", 7.359323, 0.020654809}),
                         [](const auto& param) {
                           return "Case" + std::string(param.param.number);
                         });

TEST(Accumulation, KeepsItsPromisesInEveryCaseOfTable51) {
  double worst_rate = 0.0;
  double worst_gap = 0.0;
  for (const TableRow& row : table_5_1()) {
    Case the_case = breakwater(row.parameters, std::string(row.number));
    the_case.duration = 60.0;  // long enough for all that dissipate
    const Solution solution = solve(the_case);
    ASSERT_EQ(solution.accumulation().has_value(), solution.ending() == Ending::zeno);
    EXPECT_EQ(solution.ending() == Ending::zeno, row.parameters.e < 1.0) << row.number;
    if (!solution.accumulation()) {
      continue;
    }
    const Accumulation& end = *solution.accumulation();
    EXPECT_GE(end.time, solution.end_time()) << row.number;
    EXPECT_GT(end.uncertainty, 0.0) << row.number;
    EXPECT_EQ(solution.events().back().kind, EventKind::taut) << row.number;
    EXPECT_EQ(difference(solution.at(solution.end_time()), end.state), 0.0) << row.number;
    EXPECT_EQ(end.energy, energy(the_case, end.state)) << row.number;
    for (const std::size_t index : end.cables) {
      worst_rate = std::max(worst_rate, std::abs(gap_rate(the_case.cables[index], end.state)));
      worst_gap = std::max(worst_gap, std::abs(gap(the_case.cables[index], end.state)));
    }
  }
  constexpr double rounding = 1e-14;
  constexpr double least_pull =
      0.01;  // [-], smallest gap acceleration of these cases, rounded down
  const double capture = SolveOptions{}.capture_speed;
  expect_within("rate of a captured cable", worst_rate, rounding);
  expect_within("gap of a captured cable", worst_gap, 0.5 * capture * capture / least_pull);
}

TEST(Accumulation, ComesOutTheSameForAnyCaptureSpeed) {
  const Case the_case = table_case("1510121100");
  const Accumulation fine = *solve(the_case).accumulation();
  for (const double speed : {1e-3, 1e-4, 1e-5}) {
    SolveOptions options;
    options.capture_speed = speed;
    const Solution solution = solve(the_case, options);
    ASSERT_EQ(solution.ending(), Ending::zeno) << "capture speed " << speed;
    const Accumulation& coarse = *solution.accumulation();
    EXPECT_LE(std::abs(coarse.time - fine.time), coarse.uncertainty + fine.uncertainty)
        << "capture speed " << speed;
    std::cout << "  capture speed " << speed << ": time differs by " << coarse.time - fine.time
              << ", uncertainty " << coarse.uncertainty << '\n';
  }
}

}  // namespace
}  // namespace tautline::test
