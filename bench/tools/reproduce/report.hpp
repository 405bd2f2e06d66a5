#pragma once

#include <cstddef>
#include <optional>
#include <string>
#include <string_view>
#include <variant>
#include <vector>

#include "bench/tools/reproduce/study.hpp"

namespace tautline::bench {

/// A cell of a table, or a number with a name: nothing, a number, a count or words.
struct ChapterCell : std::variant<std::monostate, double, long, std::string> {
  using variant::variant;
};

[[nodiscard]] inline ChapterCell count(std::size_t number) { return static_cast<long>(number); }

/// A column of a table: how its numbers read.
struct ChapterColumn {
  std::string name;
  std::string unit;    // as the chapter's nondimensional lengths and times have it, or empty
  std::string format;  // of a number to be read, as fmt has it; empty: words or counts
};

/// A table that is written as Markdown, CSV and JSON from the same cells.
struct ChapterTable {
  std::string name;   // "Table 5.1"
  std::string title;  // a sentence
  std::string file;   // of its CSV
  std::size_t left;   // columns of words, set to the left
  std::vector<ChapterColumn> columns;
  std::vector<std::vector<ChapterCell>> rows;
  std::vector<std::string> notes;  // sentences below it
};

/// `cell` as words to read, its number by the column's format; a dash for nothing.
[[nodiscard]] std::string cell_text(const ChapterCell& cell, const ChapterColumn& column);

/// A number with its name, or one number for each of the cases that are compared.
struct NamedNumber {
  std::string name;
  std::vector<ChapterCell> values;
};
using NamedNumbers = std::vector<NamedNumber>;

/// The same numbers of several bodies or cases.
struct NumberList {
  std::string name;
  std::vector<NamedNumbers> rows;
};

/// Something that the chapter says and that was checked.
struct Correction {
  bool holds = false;    // or it is not so, or not quite
  std::string where;     // "Eq. 5.66", "Section 5.8.1"
  std::string chapter;   // what it says
  std::string right;     // what is right
  std::string shown;     // the computed numbers that show it, in a sentence
  NamedNumbers numbers;  // the same, by name
  NumberList list = {};  // and those of several cases; without a name if there are none
  bool main = false;     // what the chapter missed altogether: told first
};

/// The time between two samples of a figure's data [sqrt(S/g)], the chapter's own step.
inline constexpr double figure_step = 0.01;

/// One row of a figure's data.
struct DataRow {
  std::vector<double> numbers;          // in the order of the columns
  std::vector<std::string_view> words;  // of the columns behind those; literals
};

/// The data of a figure.
struct FigureData {
  std::vector<std::string> columns;  // their headings, with units
  std::vector<DataRow> rows;
};

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

/// What a plot draws: a line, or points where nothing lies between them.
struct Curve {
  std::string name;
  std::vector<double> x;
  std::vector<double> y;
};

/// A curve is thinned to at most so many points; a plot is not wider in pixels.
inline constexpr std::size_t most_points = 600;

/// One curve of a motion, thinned without losing what can be seen; of impacts the points of each
/// cable, the fastest of them.
[[nodiscard]] std::vector<Curve> figure_curves(const ChapterFigure& figure);

/// What bounds the region from below while the body is not turned, thinned.
[[nodiscard]] Curve boundary_curve(const Boundary& boundary);

/// Everything that `tautline reproduce` has to say of the source chapter. Its sentences have
/// **strong**, *stressed* and `code` words as Markdown does.
struct ChapterReport {
  std::string introduction;              // what the chapter is, and what is done with it here
  std::vector<std::string> conventions;  // units, names and how it was computed
  std::vector<ChapterTable> tables;
  std::vector<ChapterFigure> figures;
  std::vector<Correction> corrections;
};
[[nodiscard]] ChapterReport chapter_report(const ChapterStudy& study);

// Its parts.

/// Tables 5.1, 5.2 and 5.3: what is printed beside what is exact.
[[nodiscard]] std::vector<ChapterTable> chapter_tables(const ChapterStudy& study);

/// Printed less exact numbers of the row `instant` in the order t, x, vx, y, vy, g1, g2.
/// Throws std::out_of_range if there is no such row.
[[nodiscard]] std::vector<double> table_5_3_errors(const ChapterStudy& study,
                                                   std::string_view instant);

/// Figures 5.6 to 5.20. 5.1 to 5.5 are drawings of the geometry, without data.
[[nodiscard]] std::vector<ChapterFigure> chapter_figures(const ChapterStudy& study);

/// What is known to be wrong in the chapter, in its order, then what was checked and holds.
[[nodiscard]] std::vector<Correction> chapter_corrections(const ChapterStudy& study);

}  // namespace tautline::bench
