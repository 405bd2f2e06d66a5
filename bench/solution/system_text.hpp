#pragma once

#include <span>
#include <string>
#include <vector>

#include "bench/base/terminal.hpp"
#include "bench/solution/checked_motion.hpp"

namespace tautline::bench {

/// The motion of a system in a few lines: how it ends, what each cable does, how it
/// settles, its energy, and how far it is right.
template <int D>
[[nodiscard]] std::string system_text(const BasicCheckedMotion<D>& motion);

/// The first contacts of elastic cables, or all, after an empty line; "" without one.
template <int D>
[[nodiscard]] std::string contacts_text(const BasicCheckedMotion<D>& motion, bool all,
                                        const TerminalStyle& style);

/// The first events, or all, after an empty line; "" without one.
template <int D>
[[nodiscard]] std::string events_text(const BasicCheckedMotion<D>& motion, bool all,
                                      const TerminalStyle& style);

/// Samples, a column for each of `times`, after an empty line.
template <int D>
[[nodiscard]] std::string samples_text(const BasicCheckedMotion<D>& motion,
                                       const std::vector<double>& times,
                                       const TerminalStyle& style);

/// The table of `samples_csv` of a case, for a system: its bodies have a group of columns each,
/// after their names.
template <int D>
[[nodiscard]] std::string samples_csv(const BasicCheckedMotion<D>& motion,
                                      std::span<const double> times);

}  // namespace tautline::bench
