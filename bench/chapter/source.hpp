#pragma once

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

}  // namespace tautline::bench
