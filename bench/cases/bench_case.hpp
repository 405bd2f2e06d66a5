#pragma once

#include <string>
#include <variant>
#include <vector>

#include "tautline/case_text.hpp"

namespace tautline::bench {

/// What engines run: one body in the plane, or a system in space.
using BenchCase = std::variant<Case, SpatialSystem>;

[[nodiscard]] inline const std::string& name_of(const BenchCase& any) {
  return std::visit([](const auto& one) -> const std::string& { return one.name; }, any);
}

[[nodiscard]] inline double duration_of(const BenchCase& any) {  // [s]
  return std::visit([](const auto& one) { return one.duration; }, any);
}

/// The text of its file.
[[nodiscard]] inline std::string written(const BenchCase& any) {
  const auto* const system = std::get_if<SpatialSystem>(&any);
  return system != nullptr ? write_system(*system) : write_case(std::get<Case>(any));
}

/// The one that `text`, which `written` wrote, has. Throws std::runtime_error where it has none.
[[nodiscard]] BenchCase bench_case_from(const std::string& text, const std::string& source_name);

/// `system`, which is in the plane, in the plane z = 0 of space: its bodies have three equal
/// moments, so that turning brings them no moment.
[[nodiscard]] SpatialSystem in_space(const System& system);

}  // namespace tautline::bench
