#pragma once

#include <cstddef>
#include <string>
#include <string_view>
#include <vector>

#include "bench/chapter/study.hpp"

namespace tautline::bench {

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

/// The columns of `motion_data`.
namespace motion_column {
inline constexpr std::size_t time = 0;
inline constexpr std::size_t x = 1;
inline constexpr std::size_t y = 2;
inline constexpr std::size_t angle = 3;
}  // namespace motion_column

/// The columns of `impacts_data`.
namespace impacts_column {
inline constexpr std::size_t time = 0;
inline constexpr std::size_t cable = 1;
inline constexpr std::size_t speed = 2;  // normal velocity before
}  // namespace impacts_column

/// The columns of `boundary_data`.
namespace boundary_column {
inline constexpr std::size_t x = 0;
inline constexpr std::size_t lowest = 3;
}  // namespace boundary_column

/// The whole motion: a row each `figure_step` and two at each event, before and after.
[[nodiscard]] FigureData motion_data(const ChapterCase& solved);

/// One row per impact and cable: normal velocity and energy before and after.
[[nodiscard]] FigureData impacts_data(const ChapterCase& solved);

/// Where the centre of mass is on g1 = 0 and on g2 = 0 at angle 0 (Eqs. 5.65 and 5.93): x, then
/// the two and the lower bound of both.
[[nodiscard]] FigureData boundary_data(const Breakwater& parameters);

}  // namespace tautline::bench
