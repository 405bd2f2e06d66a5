#pragma once

#include <filesystem>
#include <string>

#include "bench/report/report.hpp"

namespace tautline::bench {

/// The file with the motions of all runs of a case, seen from the page: motions/<case>.js.
[[nodiscard]] std::string motion_file(const std::string& case_name);

/// Writes those files below `out` that the cases of `report` name. Each is a script, which a page
/// on disk may load where it may not read data.
void write_motions(const std::filesystem::path& out, const Report& report);

}  // namespace tautline::bench
