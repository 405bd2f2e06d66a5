#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <iostream>

#include "support.hpp"
#include "tautline/geometry.hpp"
#include "tautline/solve.hpp"

namespace tautline::test {
namespace {

/// What one impact takes, from the rates before it alone: sum of P (1 - e) |rate| / 2 (Eq. 15).
double predicted_loss(const Case& the_case, const Event& event) {
  double loss = 0.0;
  Eigen::Index row = 0;
  for (const std::size_t index : event.cables) {
    const Cable& cable = the_case.cables[index];
    loss -= 0.5 * event.impulses[row++] * (1.0 - cable.restitution) * gap_rate(cable, event.before);
  }
  return loss;
}

/// How far start - losses is from the energy at the end of the last flight, against the case's own
/// scale of energies.
double ledger_error(const Case& the_case, const Solution& solution) {
  double booked = energy(the_case, the_case.initial);
  double worst = 0.0;
  for (const Event& event : solution.events()) {
    worst = std::max(worst, std::abs(booked - energy(the_case, event.before)));
    if (event.kind == EventKind::impact) {
      booked -= predicted_loss(the_case, event);
      worst = std::max(worst, std::abs(booked - energy(the_case, event.after)));
    } else {
      const double completed = energy(the_case, event.before) - energy(the_case, event.after);
      EXPECT_LE(std::abs(completed), 1e-7 * energy_scale(the_case)) << event.time;
      booked -= completed;
    }
  }
  if (solution.ending() == Ending::reached_duration) {
    worst = std::max(worst, std::abs(booked - energy(the_case, solution.at(solution.end_time()))));
  }
  return worst / energy_scale(the_case);
}

TEST(Energy, BalancesOverEveryFlightAndImpactOfTable51) {
  double worst = 0.0;
  for (const TableRow& row : table_5_1()) {
    const Case the_case = breakwater(row.parameters, std::string(row.number));
    const double error = ledger_error(the_case, solve(the_case));
    std::cout << "  " << row.number << ": " << error << '\n';
    worst = std::max(worst, error);
  }
  constexpr double relative = 1e-13;  // some hundred roundings of 1e-16 that do not cancel
  expect_within("worst ledger error of 21 cases", worst, relative);
}

TEST(Energy, BalancesOnRandomSystems) {
  constexpr std::uint64_t seed = 11;
  Random random(seed);
  double worst = 0.0;
  constexpr int systems = 500;
  SolveOptions options;
  options.max_events = 1000;  // enough to see an error, and elastic corners do not hold up the test
  for (int k = 0; k < systems; ++k) {
    const Case the_case = random_case(random, {1 + static_cast<std::size_t>(k % 4), 0.01, 0.0});
    worst = std::max(worst, ledger_error(the_case, solve(the_case, options)));
  }
  std::cout << "  seed " << seed << '\n';
  constexpr double relative = 1e-12;  // up to 1000 impacts, each with a rounding of 1e-15
  expect_within("worst ledger error of random systems", worst, relative);
}

TEST(Energy, StaysWithFullRestitution) {
  Case the_case = table_case("1110121100");
  the_case.duration = 10.0;
  const Solution solution = solve(the_case);
  ASSERT_EQ(solution.ending(), Ending::reached_duration);
  const double start = energy(the_case, the_case.initial);
  const double drift = std::abs(energy(the_case, solution.at(10.0)) - start) / start;
  constexpr double relative = 1e-12;  // asked for; 40 roundings of 1e-16 are near 1e-14
  expect_within("energy drift to t = 10", drift, relative);
}

TEST(Impact, ConservesMomentumAcrossTheCableAndAngularMomentumAboutTheAnchor) {
  double across = 0.0;
  double about_anchor = 0.0;
  double predicted = 0.0;
  for (const TableRow& row : table_5_1()) {
    const Case the_case = breakwater(row.parameters, std::string(row.number));
    const Solution solution = solve(the_case);
    for (const Event& event : solution.events()) {
      if (event.kind != EventKind::impact || event.cables.size() != 1) {
        continue;
      }
      const Cable& cable = the_case.cables[*event.cables.begin()];
      const Vec2 along = (attachment_point(event.before, cable) - cable.anchor).normalized();
      const Vec2 change = momentum(the_case, event.after) - momentum(the_case, event.before);
      across = std::max(across, std::abs(change.dot(perpendicular(along))));
      about_anchor =
          std::max(about_anchor, std::abs(angular_momentum(the_case, event.after, cable.anchor) -
                                          angular_momentum(the_case, event.before, cable.anchor)));
      predicted = std::max(predicted, std::abs(gap_rate(cable, event.after) +
                                               cable.restitution * gap_rate(cable, event.before)));
    }
  }
  constexpr double rounding =
      1e-14;  // some ten operations on numbers near one, gains of 1 / inertia
  expect_within("momentum across the cable", across, rounding);
  expect_within("angular momentum about the anchor", about_anchor, rounding);
  expect_within("rate after + e rate before", predicted, rounding);
}

TEST(Flight, ConservesHorizontalMomentumAndSpin) {
  std::size_t flights = 0;
  for (const TableRow& row : table_5_1()) {
    const Case the_case = breakwater(row.parameters, std::string(row.number));
    const Solution solution = solve(the_case);
    for (const Arc& arc : solution.arcs()) {
      if (!arc.taut.empty()) {
        continue;
      }
      const State end = arc.after(arc.end - arc.start, solution.gravity());
      EXPECT_EQ(end.velocity.x(), arc.initial.velocity.x()) << row.number << " " << arc.start;
      EXPECT_EQ(end.spin, arc.initial.spin) << row.number << " " << arc.start;
      ++flights;
    }
  }
  EXPECT_GT(flights, 1000U);
}

}  // namespace
}  // namespace tautline::test
