#pragma once

#include <functional>
#include <string>
#include <string_view>
#include <vector>

#include "tautline/case.hpp"
#include "tautline/scenarios.hpp"
#include "tautline/settling.hpp"
#include "tautline/solution.hpp"

namespace tautline::bench {

/// Decimal digits in which the chapter's cases are solved. Near the end of a run the distance of
/// neighbouring motions grows faster than any power that a double could follow: of a square's lock
/// time it keeps one or two decimals. 60 and 100 digits agree to 3e-5 in every lock time.
inline constexpr unsigned chapter_digits = 60;

/// An impact that closes faster than this is counted [sqrt(gS)]; there are infinitely many slower.
inline constexpr double counted_speed = 1e-2;

/// A case of Table 5.1 and its exact motion, solved in `chapter_digits` and rounded to double.
struct ChapterCase {
  std::string number;
  Breakwater parameters;
  Case the_case;
  Solution solution;
  Settling settling;
};

/// The chapter's cases and what else its tables and figures need.
struct ChapterStudy {
  std::vector<ChapterCase> cases;  // as `table_5_1()`
  ChapterCase rigid_point;         // the last of them as a body that has inertia
  double limit_time;               // of case 1110121100: |theta| reaches pi / 2

  /// Throws std::out_of_range if there is none with this number.
  [[nodiscard]] const ChapterCase& at(std::string_view number) const;

  /// The last of Table 5.1.
  [[nodiscard]] const ChapterCase& point_mass() const { return cases.back(); }
};

/// Calls `ended` with the number of cases solved, each time that it grows.
[[nodiscard]] ChapterStudy solve_chapter(const std::function<void(std::size_t)>& ended);

/// The impacts of `solution` that close faster than `speed`.
[[nodiscard]] std::size_t impact_count(const Case& the_case, const Solution& solution,
                                       double speed);

/// The fastest impact of the motion [sqrt(gS)].
[[nodiscard]] double fastest_impact(const ChapterCase& solved);

/// How far two motions differ at most in x, y and their rates, at a hundred samples per time unit
/// up to the end of the shorter.
[[nodiscard]] double largest_difference(const ChapterCase& one, const ChapterCase& other);

/// The largest |angle| of the whole motion, and of the swing that follows it [rad].
[[nodiscard]] double largest_angle(const ChapterCase& solved);

}  // namespace tautline::bench
