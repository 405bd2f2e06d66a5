#pragma once

#include <cstddef>
#include <optional>
#include <string>
#include <vector>

#include "bench/chapter/figures/figure_data.hpp"
#include "bench/chapter/study.hpp"

namespace tautline::bench {

/// An instant that a plot should show.
struct FigureMark {
  double time;  // [sqrt(S/g)]
  std::string meaning;
};

/// The boundaries of the region that the cables leave to the centre of mass.
struct Boundary {
  std::string file;  // of its CSV
  FigureData data;   // x, then one column per boundary
};

/// The data of one of the chapter's figures, and what is to be said of it.
struct ChapterFigure {
  std::string number;             // "5.6"
  std::string title;              // what over what, and of which case
  std::string file;               // of its CSV
  FigureData data;                //
  std::size_t x = 0;              // the columns that it plots
  std::size_t y = 0;              //
  std::optional<std::size_t> by;  // one set of points for each value of this column
  std::string case_number;        //
  std::string chapter;            // what the chapter says of it
  std::string truth;              // where the exact motion differs, or goes on
  std::vector<FigureMark> marks;  //
  std::optional<Boundary> boundary;
};

/// Figures 5.6 to 5.20. 5.1 to 5.5 are drawings of the geometry, without data.
[[nodiscard]] std::vector<ChapterFigure> chapter_figures(const ChapterStudy& study);

}  // namespace tautline::bench
