// Contacts of elastic cables of a run beside those of the exact motion.

#include "bench/measure/contact_match.hpp"

#include <gtest/gtest.h>

#include <limits>
#include <vector>

namespace tautline::bench {
namespace {

constexpr double never = std::numeric_limits<double>::infinity();

/// Contacts that begin faster than 0.01 m/s, or by 2 ms, up to 1 s, on a cable that is cut then.
CountedContacts counted(double cut_at = never) { return {0.01, 0.002, 1.0, {cut_at}}; }

/// A contact from 0.4 s to 0.6 s with a restitution of 0.5.
ElasticContact contact() {
  return {.cable = 0,
          .entry = 0.4,
          .exit = 0.6,
          .entry_speed = 2.0,
          .exit_speed = 1.0,
          .peak = 100.0,
          .peak_time = 0.5,
          .greatest_stretch = 0.1,
          .impulse = 10.0};
}

/// What a run makes of it: its peak is 2 % too high, its impulse 10 %, its time 5 % too long, and
/// its restitution 0.1 too high.
ElasticContact off(ElasticContact one) {
  one.peak *= 1.02;
  one.impulse *= 1.1;
  one.exit_speed += 0.1 * one.entry_speed;
  if (one.exit) {
    *one.exit += 0.05 * (*one.exit - one.entry);
  }
  return one;
}

ElasticContact later(ElasticContact one, double by) {
  one.entry += by;
  one.peak_time += by;
  *one.exit += by;
  return one;
}

TEST(ContactMatch, HasTheWorstOfAllPairs) {
  const ElasticContact first = contact();
  const ElasticContact second = later(contact(), 0.3);
  const ContactMatch match = match_contacts({first, second}, {first, off(second)}, counted());
  EXPECT_EQ(match.matched, 2U);
  EXPECT_NEAR(match.peak_error.value(), 2.0, 1e-12);
  EXPECT_NEAR(match.impulse_error.value(), 10.0, 1e-12);
  EXPECT_NEAR(match.time_error.value(), 5.0, 1e-12);
  EXPECT_NEAR(match.restitution_error.value(), 0.1, 1e-12);
}

TEST(ContactMatch, ALineThatIsTautFromTheStartHasAPeakAndNoRestitution) {
  ElasticContact taut = contact();
  taut.entry = 0.0;
  taut.entry_speed = 0.0;
  ElasticContact late = off(taut);
  late.entry = 0.001;  // an engine's begins a step late
  const ContactMatch ended = match_contacts({taut}, {late}, counted());
  EXPECT_EQ(ended.matched, 1U);
  EXPECT_NEAR(ended.peak_error.value(), 2.0, 1e-12);
  EXPECT_TRUE(ended.impulse_error && ended.time_error);
  EXPECT_FALSE(ended.restitution_error);
  taut.exit.reset();
  const ContactMatch open = match_contacts({taut}, {late}, counted());
  EXPECT_EQ(open.peak.value().exact, taut.peak);
  EXPECT_FALSE(open.impulse_error || open.time_error || open.restitution_error);
}

TEST(ContactMatch, NothingBeyondTheHorizonIsCompared) {
  const ElasticContact ends_later = later(contact(), 0.45);  // its peak is at 0.95 s
  const ContactMatch match = match_contacts({ends_later}, {off(ends_later)}, counted());
  EXPECT_EQ(match.matched, 1U);
  EXPECT_NEAR(match.peak_error.value(), 2.0, 1e-12);
  EXPECT_FALSE(match.impulse_error || match.time_error || match.restitution_error);
  const ElasticContact peaks_later = later(contact(), 0.55);
  const ContactMatch no_peak = match_contacts({peaks_later}, {off(peaks_later)}, counted());
  EXPECT_EQ(no_peak.matched, 1U);
  EXPECT_FALSE(no_peak.peak || no_peak.peak_error || no_peak.impulse_error);
  const ElasticContact begins_later = later(contact(), 0.65);
  EXPECT_EQ(match_contacts({begins_later}, {off(begins_later)}, counted()).matched, 0U);
}

TEST(ContactMatch, AContactThatACutEndsHasNoRestitution) {
  ElasticContact cut = contact();
  cut.exit_speed = -0.5;  // it is still being stretched
  const ContactMatch match = match_contacts({cut}, {off(cut)}, counted(*cut.exit));
  EXPECT_NEAR(match.impulse_error.value(), 10.0, 1e-12);
  EXPECT_NEAR(match.time_error.value(), 5.0, 1e-12);
  EXPECT_FALSE(match.restitution_error);
  // one that ends before the cut, of a run in which the cut ends it
  const double between = *cut.exit + 0.005;
  EXPECT_FALSE(match_contacts({contact()}, {off(contact())}, counted(between)).restitution_error);
  EXPECT_TRUE(match_contacts({contact()}, {off(contact())}, counted(0.9)).restitution_error);
}

TEST(ContactMatch, ASlowOneIsNotCounted) {
  ElasticContact slow = contact();
  slow.entry_speed = 0.005;
  const ContactMatch match = match_contacts({slow}, {slow}, counted());
  EXPECT_EQ(match.exact, 0U);
  EXPECT_EQ(match.found, 0U);
  EXPECT_EQ(match.matched, 0U);
  EXPECT_FALSE(match.peak);
}

}  // namespace
}  // namespace tautline::bench
