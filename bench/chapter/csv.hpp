#pragma once

#include <string>
#include <vector>

#include "bench/chapter/corrections/correction.hpp"
#include "bench/chapter/figures/figure_data.hpp"
#include "bench/chapter/tables/table.hpp"

namespace tautline::bench {

/// The table with its numbers in full.
[[nodiscard]] std::string table_csv(const ChapterTable& table);

/// The data of a figure in twelve digits: a plot needs four, and files stay small.
[[nodiscard]] std::string data_csv(const FigureData& data);

/// The corrections as a table: place, what the chapter says, what is right, what shows it.
[[nodiscard]] std::string corrections_csv(const std::vector<Correction>& corrections);

}  // namespace tautline::bench
