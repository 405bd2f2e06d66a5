#pragma once

#include <string>

#include "bench/report/report.hpp"

namespace tautline::bench {

/// What was compared and what was found, in a paragraph and a list of the main findings.
[[nodiscard]] std::string answer_paragraph(const Report& report);

}  // namespace tautline::bench
