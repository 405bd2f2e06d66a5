#include "bench/base/progress.hpp"

#include <gtest/gtest.h>

#include <string>
#include <vector>

namespace tautline::bench {
namespace {

/// A screen that keeps what is written to it, and a clock that goes when told.
struct Fake {
  std::vector<std::string> written;
  double now = 100.0;  // [s], the clock of no one in particular

  ProgressScreen screen(bool terminal, std::size_t width = 80) {
    return {terminal, width, [this](std::string_view text) { written.emplace_back(text); },
            [this] { return now; }};
  }
};

/// What of `text` is seen on a terminal.
std::string seen(const std::string& text) {
  std::string result = text;
  for (const std::string mark : {"\r", "\033[K"}) {
    for (std::size_t at = result.find(mark); at != std::string::npos; at = result.find(mark)) {
      result.erase(at, mark.size());
    }
  }
  return result;
}

TEST(Progress, TimeLeftGoesByTheWorkAndNotByTheCount) {
  Fake fake;
  Progress progress(1000.0, 4, "runs", fake.screen(true));
  fake.now += 8.0;
  progress.ended(100.0);  // a tenth of the work: nine times as long to go
  EXPECT_EQ(seen(fake.written.back()).substr(seen(fake.written.back()).find(']')),
            "]  10 %, 1 of 4 runs, about 72 s left");
  fake.now += 42.0;
  progress.ended(400.0);
  EXPECT_NE(fake.written.back().find(" 50 %, 2 of 4 runs, about 50 s left"), std::string::npos)
      << fake.written.back();
}

TEST(Progress, SaysHowManyEndInASecondWithoutThoseThatWereKept) {
  Fake fake;
  Progress progress(100.0, 100, "draws", fake.screen(true));
  progress.show_rate();
  for (int draw = 0; draw < 20; ++draw) {
    progress.ended(1.0, true);
  }
  fake.now += 4.0;
  for (int draw = 0; draw < 30; ++draw) {
    progress.ended(1.0);
    fake.now += 0.2;
  }
  EXPECT_NE(fake.written.back().find("50 of 100 draws, 3.06 a second, about 17 s left"),
            std::string::npos)
      << fake.written.back();
}

TEST(Progress, WhatWasKeptDoesNotMakeTheRestLookFast) {
  Fake fake;
  Progress progress(1000.0, 10, "runs", fake.screen(true));
  for (int run = 0; run < 8; ++run) {
    progress.ended(100.0, true);
  }
  fake.now += 30.0;
  progress.ended(100.0);
  EXPECT_NE(fake.written.back().find(" 90 %, 9 of 10 runs, about 30 s left"), std::string::npos)
      << fake.written.back();
}

TEST(Progress, OnATerminalIsOneLineThatFits) {
  for (const std::size_t width : {20U, 40U, 80U, 200U}) {
    Fake fake;
    Progress progress(2016.0, 2016, "runs", fake.screen(true, width));
    for (int run = 0; run < 2016; ++run) {
      fake.now += 7.0;
      progress.ended(1.0);
      const std::string line = seen(fake.written.back());
      ASSERT_LT(line.size(), width) << line;
      ASSERT_EQ(line.find('\n'), std::string::npos);
      ASSERT_EQ(fake.written.back().front(), '\r');
    }
    EXPECT_NE(fake.written.back().find("100 %"), std::string::npos);
    progress.finish();
    EXPECT_EQ(fake.written.back(), "\r\033[K");
  }
}

TEST(Progress, IsNotDrawnMoreOftenThanItCanBeRead) {
  Fake fake;
  Progress progress(10'000.0, 10'000, "runs", fake.screen(true));
  for (int run = 0; run < 10'000; ++run) {
    fake.now += 0.001;
    progress.ended(1.0);
  }
  EXPECT_LE(fake.written.size(), 102U);
}

TEST(Progress, InAPipeIsALineNowAndThenAndNoneOfAShortSuite) {
  Fake fake;
  Progress progress(600.0, 600, "runs", fake.screen(false));
  for (int run = 0; run < 600; ++run) {
    fake.now += 0.1;
    progress.ended(1.0);
  }
  progress.finish();
  ASSERT_EQ(fake.written.size(), 3U);  // of a minute
  EXPECT_EQ(fake.written.front().substr(fake.written.front().find(" of ")),
            " of 600 runs, about 45 s left\n");

  Fake quick;
  Progress soon(2.0, 2, "runs", quick.screen(false));
  soon.ended(1.0);
  quick.now += 1.0;
  soon.ended(1.0);
  soon.finish();
  EXPECT_TRUE(quick.written.empty());
}

TEST(Progress, SaysNothingOfTheTimeLeftBeforeItKnows) {
  Fake fake;
  Progress progress(100.0, 100, "runs", fake.screen(true));
  fake.now += 1.0;
  progress.ended(1.0);
  EXPECT_EQ(fake.written.back().find("left"), std::string::npos);
  fake.now += 5.0;
  progress.ended(1.0, true);
  EXPECT_NE(fake.written.back().find("left"), std::string::npos);
}

TEST(Progress, DurationsAreAsExactAsAnEstimate) {
  EXPECT_EQ(rough_duration(0.2), "1 s");
  EXPECT_EQ(rough_duration(59.0), "59 s");
  EXPECT_EQ(rough_duration(600.0), "10 min");
  EXPECT_EQ(rough_duration(12'000.0), "3 h 20 min");
  EXPECT_EQ(rough_duration(7'199.0), "2 h 00 min");
}

}  // namespace
}  // namespace tautline::bench
