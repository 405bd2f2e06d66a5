#pragma once

#include <nlohmann/json.hpp>
#include <string>
#include <vector>

#include "bench/chapter/study.hpp"

namespace tautline::bench {

/// The time between two samples of a figure's data [sqrt(S/g)], the chapter's own step.
inline constexpr double figure_step = 0.01;

/// The data of one of the chapter's figures, and what is to be said of it.
struct ChapterFigure {
  std::string number;            // "5.6"
  std::string title;             // what over what, and of which case
  std::string file;              // of its CSV
  std::string csv;               //
  std::string x;                 // the columns it plots, by their headings
  std::string y;                 //
  std::string case_number;       //
  std::string chapter;           // what the chapter says of it
  std::string truth;             // where the exact motion differs, or goes on
  nlohmann::ordered_json marks;  // [{time, meaning}]: instants that a plot should show
  std::string boundary_file;     // of the boundaries of the region, or empty
  std::string boundary_csv;      //
};

/// Figures 5.6 to 5.20. 5.1 to 5.5 are drawings of the geometry, without data.
[[nodiscard]] std::vector<ChapterFigure> chapter_figures(const ChapterStudy& study);

/// The whole motion: a row each `figure_step` and two at each event, before and after.
[[nodiscard]] std::string motion_csv(const ChapterCase& solved);

/// One row per impact and cable: normal velocity and energy before and after.
[[nodiscard]] std::string impacts_csv(const ChapterCase& solved);

/// Where the centre of mass is on g1 = 0 and on g2 = 0 at angle 0 (Eqs. 5.65 and 5.93).
[[nodiscard]] std::string boundary_csv(const Breakwater& parameters);

/// The angle at which the two boundaries meet at the origin, at angle 0 [rad].
[[nodiscard]] double corner_angle(const Breakwater& parameters);

}  // namespace tautline::bench
