#pragma once

#include <cstddef>
#include <string>
#include <variant>

namespace tautline::bench {

/// A cell of a table, or a number with a name: nothing, a number, a count or words.
using ChapterCell = std::variant<std::monostate, double, long, std::string>;

[[nodiscard]] inline ChapterCell count(std::size_t number) { return static_cast<long>(number); }

}  // namespace tautline::bench
