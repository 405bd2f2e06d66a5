#pragma once

#include <span>
#include <string>
#include <string_view>
#include <vector>

#include "bench/base/table.hpp"

namespace tautline::bench {

/// The source chapter in full, with its title *stressed* as Markdown does.
inline constexpr std::string_view source_chapter =
    "A. L. Farmer, *Free Motions of a Rigid-Body Breakwater*, 1999, chapter 5 of a thesis";

/// A digit of a case number of Table 5.1, by that of the standard case.
struct CaseDigit {
  std::string digit;     // "9"
  std::string quantity;  // "e"
  std::string value;     // "0.9"
};

/// The number of the standard case, digit by digit.
[[nodiscard]] std::vector<CaseDigit> standard_digits();

/// The same as a table of three rows.
[[nodiscard]] Table case_number_table();

/// How to read any case number, beside the digits of the standard case: sentences.
[[nodiscard]] std::vector<std::string> case_number_rules();

/// The source and its case numbers, for a terminal.
[[nodiscard]] std::string case_number_text();

/// A row of the source chapter's Table 5.1 as it is printed.
struct PrintedCase {
  std::string_view study;  // the heading above it: what its group of cases varies
  std::string_view cells;  // case number, r, h, e, a, b, x, vx, y, vy, theta, vtheta
};

/// A row of Table 5.2.
struct PrintedInertia {
  std::string_view shape;
  std::string_view cells;  // a, b, I
};

/// Two rows of Table 5.3: the chapter prints the same digits for its point mass and for its rigid
/// body, whose angle and spin it gives as 0.0.
struct PrintedState {
  std::string_view instant;
  std::string_view cells;  // t, x, vx, y, vy, g1, g2
};

[[nodiscard]] std::span<const PrintedCase> printed_table_5_1();
[[nodiscard]] std::span<const PrintedInertia> printed_table_5_2();
[[nodiscard]] std::span<const PrintedState> printed_table_5_3();

/// The row of Table 5.3 at `instant`. Throws std::out_of_range if there is none.
[[nodiscard]] const PrintedState& find_printed_state(std::string_view instant);

/// The cells of a row, one by one.
[[nodiscard]] std::vector<std::string_view> split(std::string_view cells);

/// The number that `cell` prints.
[[nodiscard]] double printed_value(std::string_view cell);

/// An error this small is the decimal's own rounding to double: it counts as none [-].
inline constexpr double printed_rounding = 1e-15;

/// Half a unit of the last digit that `cell` prints: what rounding alone may put it off by.
[[nodiscard]] double half_unit(std::string_view cell);

}  // namespace tautline::bench
