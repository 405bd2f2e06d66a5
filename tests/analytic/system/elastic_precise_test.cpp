#include <gtest/gtest.h>

#include <algorithm>
#include <string>

#include "support.hpp"
#include "system/elastic_systems.hpp"
#include "tautline/elastic_contacts.hpp"
#include "tautline/multiprecision.hpp"
#include "tautline/solve.hpp"
#include "tautline/system_ledger.hpp"

// Elastic cables in 40 digits: against closed forms, and of the same numbers against double.

namespace tautline::test {
namespace {

TEST(ElasticDigits, AreThoseOfTheClosedForms) {
  const Digits digits(40);
  const Multi k("100");
  Multi most(0);
  for (const char* text : {"0", "0.05", "0.3", "0.7", "1", "1.5", "3"}) {
    const Multi ratio(text);
    const auto found = elastic_contacts(
        solve(drop<Multi>(with_ratio(k, ratio), Multi(0), Multi(1), Multi(Multi(1) / 4))));
    ASSERT_EQ(found.size(), 1U) << text;
    const Multi root = sqrt(Multi(abs(Multi(1 - ratio * ratio))));
    const Multi angle = ratio < 1   ? Multi(acos(ratio) / root)
                        : ratio > 1 ? Multi(acosh(ratio) / root)
                                    : Multi(1);
    const Multi kept = exp(Multi(-2 * ratio * angle));
    const Multi half = Multi(1) / 2;
    const Multi phase = (acos(Multi(0)) - 3 * asin(ratio)) / root;
    const Multi peak = ratio < half ? Multi(exp(Multi(-ratio * phase))) : Multi(2 * ratio);
    most = max(most, Multi(abs(Multi(found[0].exit_speed - kept))));
    most = max(most, Multi(abs(Multi((*found[0].exit - found[0].entry) * 10 - 2 * angle))));
    most = max(most, Multi(abs(Multi(found[0].peak / 10 - peak))));
    most = max(most, Multi(abs(Multi(found[0].greatest_stretch * 10 - sqrt(kept)))));
    most = max(most, Multi(abs(Multi(found[0].impulse - 1 - kept))));
    most = max(most, Multi(abs(Multi(contact_phase(ratio) - 2 * angle))));
    most = max(most, Multi(abs(Multi(restitution_of(ratio) - kept))));
    most = max(most, Multi(abs(Multi(damping_ratio_of(kept) - ratio))));
  }
  expect_within("contact in 40 digits", static_cast<double>(most), 1e-30);
}

TEST(ElasticDigits, AreThoseOfTheTableUnderALoad) {
  const Digits digits(40);
  const auto system =
      drop<Multi>(with_ratio(Multi(10000), Multi("0.1")), Multi("9.81"), Multi(1), Multi(0));
  const auto first = elastic_contacts(solve(system)).at(0);
  const Multi most = max(max(Multi(abs(Multi(*first.exit - Multi(".03190896504687642834")))),
                             Multi(abs(Multi(first.exit_speed - Multi(".7263610024201973040"))))),
                         max(Multi(abs(Multi(first.peak / 100 - Multi(".96522859850036329926")))),
                             Multi(abs(Multi(first.impulse - Multi("2.03938794953005506607"))))));
  // the table has 19 digits and more
  expect_within("contact under a load", static_cast<double>(most), 1e-19);
}

/// The largest difference of the times of the first `count` events from those of `precise`.
template <int D>
double late(const BasicSystem<double, D>& system, const BasicSystem<Multi, D>& precise,
            std::size_t count) {
  SolveOptions options;
  options.max_events = count;
  const auto rounded = solve(system, options);
  const auto exact = solve(precise, options);
  EXPECT_GE(rounded.events().size(), count);
  EXPECT_GE(exact.events().size(), count);
  double most = 0.0;
  for (std::size_t i = 0; i < std::min(rounded.events().size(), exact.events().size()); ++i) {
    EXPECT_EQ(rounded.events()[i].kind, exact.events()[i].kind) << "event " << i;
    most = std::max(
        most,
        std::abs(static_cast<double>(Multi(rounded.events()[i].time - exact.events()[i].time))));
  }
  const auto ledger = energy_ledger(precise, exact);
  expect_within("  ledger", std::abs(static_cast<double>(Multi(ledger.residual / ledger.range))),
                1e-35);
  return most;
}

TEST(ElasticDigits, AgreeWithDoubleOnMixedCables) {
  const Digits digits(40);
  const Elasticity law = with_ratio(1e3, 0.05);
  System mixed = breakwater_system<double>(0.9);
  mixed.cables[0] = elastic(mixed.cables[0], law);
  expect_within("one of two", late(mixed, converted<Multi>(mixed), 20), 1e-11);
  System below = in_series<double>();
  below.cables[2] = elastic(below.cables[2], law);
  expect_within("one of three", late(below, converted<Multi>(below), 20), 1e-11);
  // the numbers of a start in double leave its cable not quite taut
  const auto precise = pendulum_into_a_cable<Multi>(with_ratio(Multi(1000), Multi("0.05")));
  expect_within("pendulum", late(pendulum_into_a_cable<double>(law), precise, 2), 1e-12);
  const SpatialSystem box = elastic_box<double>(law);
  expect_within("box", late(box, converted<Multi>(box), 8), 1e-11);
}

}  // namespace
}  // namespace tautline::test
