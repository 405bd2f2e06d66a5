#include "bench/chapter/tables/table.hpp"

#include <fmt/format.h>

namespace tautline::bench {

std::string cell_text(const ChapterCell& cell, const ChapterColumn& column) {
  if (const auto* const words = std::get_if<std::string>(&cell)) {
    return *words;
  }
  if (const auto* const number = std::get_if<double>(&cell)) {
    return fmt::format(fmt::runtime(column.format), *number);
  }
  const auto* const whole = std::get_if<long>(&cell);
  return whole != nullptr ? std::to_string(*whole) : "–";
}

}  // namespace tautline::bench
