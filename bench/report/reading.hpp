#pragma once

#include <filesystem>

#include "bench/report/json/json.hpp"

namespace tautline::bench {

/// Reads report.json of this version of the program's `bench`. What it gives lists the engine and
/// the case of each of its runs, and no run twice.
[[nodiscard]] ReportReading read_report(const std::filesystem::path& path);

}  // namespace tautline::bench
