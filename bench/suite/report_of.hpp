#pragma once

#include <filesystem>
#include <optional>
#include <string>
#include <vector>

#include "bench/judge/allowance.hpp"
#include "bench/replay/replay.hpp"
#include "bench/report/report.hpp"
#include "bench/store/plan.hpp"
#include "bench/suite/suite.hpp"

namespace tautline::bench {

/// The report of a suite, without verdicts. `certified` has an entry for each of `expectations`. Of
/// `context`, the command, the times and the memory are the caller's to tell; what the suite and
/// this build know is filled in.
[[nodiscard]] Report report_of(const SuiteOptions& options, const Expectations& expectations,
                               const std::vector<std::optional<CertifiedDigits>>& certified,
                               const SuiteResult& result, Context context);

/// What is drawn of that report.
[[nodiscard]] Replay replay_of(const Expectations& expectations, const SuiteResult& result);

/// The file with the motions of all runs of a case, seen from the page: motions/<case>.js.
[[nodiscard]] std::string motion_file(const std::string& case_name);

/// Writes those files below `out` that the cases of `report` name. Each is a script, which a page
/// on disk may load where it may not read data.
void write_motions(const std::filesystem::path& out, const Report& report, const Replay& replay);

}  // namespace tautline::bench
