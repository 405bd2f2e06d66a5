#pragma once

#include <string>

#include "bench/report/report.hpp"

namespace tautline::bench {

// What the page answers first.

/// "2,226 runs: 1 breaks a limit, ...": the verdict of all engines, in a line.
[[nodiscard]] std::string verdict_paragraph(const Report& report);

/// A row for each engine and maker: restitution, which model and step, cost, findings, verdict.
[[nodiscard]] std::string scorecards_section(const Report& report);

/// Why the reference can be believed, and what the comparison itself costs.
[[nodiscard]] std::string trust_section(const Report& report);

/// A part that few readers want, folded.
[[nodiscard]] std::string folded(const std::string& summary, const std::string& html);

/// A command to be copied.
[[nodiscard]] std::string command_html(const std::string& command);

}  // namespace tautline::bench
