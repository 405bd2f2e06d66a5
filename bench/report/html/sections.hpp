#pragma once

#include <string>

#include "bench/report/report.hpp"

namespace tautline::bench {

// The sections of the report's page, in their order.

/// Over all cases, by engine, model and step.
[[nodiscard]] std::string answers_section(const Report& report);

/// Every run.
[[nodiscard]] std::string runs_section(const Report& report);

/// How fast errors shrink with the step.
[[nodiscard]] std::string error_section(const Report& report);

/// What was found of thresholds, sleeping and restitution.
[[nodiscard]] std::string distributions_section(const Report& report);  // "" without draws
[[nodiscard]] std::string audit_section(const Report& report);

/// The causes of the errors and their shares.
[[nodiscard]] std::string causes_section(const Report& report);

/// How each engine models a cable.
[[nodiscard]] std::string models_section(const Report& report);

/// How to read all of it.
[[nodiscard]] std::string reading_section(const Report& report);

/// What made the page, and how to make it again.
[[nodiscard]] std::string context_section(const Report& report);

}  // namespace tautline::bench
