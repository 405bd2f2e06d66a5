#include "bench/base/text.hpp"

#include <gtest/gtest.h>
#include <rapidcheck.h>
#include <rapidcheck/gtest.h>

#include <algorithm>
#include <bit>
#include <charconv>
#include <cstdint>
#include <limits>

namespace tautline::bench {
namespace {

using Strings = std::vector<std::string>;

TEST(Shortest, KeepsFamiliarNumbersFamiliar) {
  EXPECT_EQ(shortest(0.1), "0.1");
  EXPECT_EQ(shortest(20.0), "20");
  EXPECT_EQ(shortest(-0.0), "-0");
  EXPECT_EQ(shortest(1e300), "1e+300");
  EXPECT_EQ(shortest(-std::numeric_limits<double>::max()), "-1.7976931348623157e+308");
  EXPECT_EQ(shortest(std::numeric_limits<double>::infinity()), "inf");
}

TEST(FixedText, GivesNoSignToWhatRoundsToZero) {
  EXPECT_EQ(fixed_text(-0.0, 2), "0.00");
  EXPECT_EQ(fixed_text(-0.004, 2), "0.00");
  EXPECT_EQ(fixed_text(-1e-300, 0), "0");
  EXPECT_EQ(fixed_text(-0.006, 2), "-0.01");
  EXPECT_EQ(fixed_text(0.9, 4), "0.9000");
  EXPECT_EQ(fixed_text(-std::numeric_limits<double>::infinity(), 2), "-inf");
}

RC_GTEST_PROP(Shortest, ReadsBackEqual, (std::uint64_t pattern)) {
  const double value = std::bit_cast<double>(pattern);
  RC_PRE(value == value);  // a nan has no bits to keep
  const std::string text = shortest(value);
  double back = 0.0;
  std::from_chars(text.data(), text.data() + text.size(), back);
  RC_ASSERT(std::bit_cast<std::uint64_t>(back) == pattern);
}

TEST(Nearest, FindsSlipsOfTheHand) {
  const Strings keys = {"anchor", "attachment", "length", "restitution"};
  EXPECT_EQ(nearest("lenght", keys), Strings{"length"});
  EXPECT_EQ(nearest("restitusion", keys), Strings{"restitution"});
  EXPECT_EQ(nearest("achor", keys), Strings{"anchor"});
}

TEST(Nearest, KeepsSilentWhereNothingIsNear) {
  const Strings keys = {"anchor", "attachment", "length", "restitution"};
  EXPECT_EQ(nearest("colour", keys), Strings{});
  EXPECT_EQ(nearest("e", keys), Strings{});
  EXPECT_EQ(nearest("", keys), Strings{});
  EXPECT_EQ(nearest("length", Strings{}), Strings{});
}

TEST(Nearest, GivesAtMostThreeTheLikeliestFirst) {
  const Strings names = {"case-12", "case-345", "case-1", "case-13", "case-2"};
  EXPECT_EQ(nearest("case-1", names), (Strings{"case-1", "case-12", "case-13"}));
}

TEST(Nearest, KnowsANameByATellingPartOfIt) {
  EXPECT_EQ(nearest("1910121100", Strings{"breakwater/1910121100", "bouncing-ball"}),
            Strings{"breakwater/1910121100"});
}

TEST(Nearest, AnswersForAHugeName) {
  EXPECT_EQ(nearest(std::string(8'000'000, 'x'), Strings{"length"}), Strings{});
}

TEST(Joined, ReadsLikeASentence) {
  EXPECT_EQ(joined(Strings{}, "or"), "");
  EXPECT_EQ(joined(Strings{"a"}, "or"), "a");
  EXPECT_EQ(joined(Strings{"a", "b"}, "or"), "a or b");
  EXPECT_EQ(joined(Strings{"a", "b", "c"}, "and"), "a, b and c");
}

TEST(Printable, LeavesLegibleTextAlone) {
  EXPECT_EQ(printable("breakwater/1910121100"), "breakwater/1910121100");
  EXPECT_EQ(printable("Größe 重力 \U0001F6A2"), "Größe 重力 \U0001F6A2");
}

TEST(Printable, EscapesWhatMovesACursorOrReordersText) {
  EXPECT_EQ(printable("\x1b[2J"), "\\x1b[2J");
  EXPECT_EQ(printable("a\nb\tc\x7f"), "a\\x0ab\\x09c\\x7f");
  EXPECT_EQ(printable(std::string_view("\0", 1)), "\\x00");
  EXPECT_EQ(printable("\u009b31m"), "\\xc2\\x9b31m");       // C1: a one-character escape sequence
  EXPECT_EQ(printable("\u202egnp"), "\\xe2\\x80\\xaegnp");  // turns the direction of writing
}

TEST(Printable, EscapesBytesThatAreNotUtf8) {
  EXPECT_EQ(printable("\xff"), "\\xff");
  EXPECT_EQ(printable("\xc3"), "\\xc3");                             // cut short
  EXPECT_EQ(printable("\xc0\xaf"), "\\xc0\\xaf");                    // an overlong "/"
  EXPECT_EQ(printable("\xed\xa0\x80"), "\\xed\\xa0\\x80");           // half of a surrogate pair
  EXPECT_EQ(printable("\xf4\x90\x80\x80"), "\\xf4\\x90\\x80\\x80");  // beyond U+10FFFF
}

TEST(Printable, CutsBetweenCharacters) {
  EXPECT_EQ(printable("abcdef", 4), "abcd...");
  EXPECT_EQ(printable("abcd", 4), "abcd");
  EXPECT_EQ(printable("abcä", 4), "abc...");
}

RC_GTEST_PROP(Printable, NeverPassesAControlByteAndIsItsOwnFixedPoint, (const std::string& text)) {
  const std::string once = printable(text);
  RC_ASSERT(std::none_of(once.begin(), once.end(), [](char c) {
    return static_cast<unsigned char>(c) < 0x20 || c == '\x7f';
  }));
  RC_ASSERT(once.size() <= quotable_length + 3);
  RC_ASSERT(printable(once, once.size()) == once);
}

}  // namespace
}  // namespace tautline::bench
