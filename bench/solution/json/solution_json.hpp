#pragma once

#include <cstdint>
#include <optional>
#include <span>
#include <string>
#include <vector>

#include "bench/solution/certificate.hpp"
#include "bench/solution/checked_motion.hpp"
#include "tautline/settling.hpp"
#include "tautline/solution.hpp"
#include "tautline/solve.hpp"

namespace tautline::bench {

/// The numbers of the formats of a case and of a system below. One changes when a name or a meaning
/// does.
inline constexpr std::int32_t solution_schema = 4;
inline constexpr std::int32_t system_solution_schema = 5;

/// The schema of `solution_json`, of either: the meaning and the unit of each of its members.
[[nodiscard]] std::string solution_schema_json();

/// One sentence for each of `sample_times` at which a solution that ends at `end` [s] has no state.
[[nodiscard]] std::vector<std::string> sample_problems(double end, Ending ending,
                                                       std::span<const double> sample_times);

/// What `tautline solve --json` writes, as `solution_schema_json` describes it. Each value, event
/// and sample is a line.
/// Requires that `sample_problems` is empty; else throws std::out_of_range.
[[nodiscard]] std::string solution_json(const Case& the_case, const SolveOptions& options,
                                        const Solution& solution, const Settling& settling,
                                        std::span<const double> sample_times,
                                        const std::optional<Certificate>& certificate);

/// The JSON of a system, likewise.
template <int D>
[[nodiscard]] std::string solution_json(const BasicCheckedMotion<D>& motion,
                                        const SolveOptions& options,
                                        std::span<const double> sample_times);

}  // namespace tautline::bench
