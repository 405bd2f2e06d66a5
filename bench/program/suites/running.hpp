#pragma once

#include <string>

#include "bench/base/descriptor.hpp"
#include "bench/program/suites/request.hpp"
#include "bench/report/manifest.hpp"
#include "bench/report/report.hpp"
#include "bench/suite/suite.hpp"

namespace tautline::bench {

/// A suite that was run, and its report with verdicts, which is not written yet.
struct RunSuite {
  Descriptor tree;  // the result tree is this program's alone until it is gone
  Manifest manifest;
  SuiteResult result;
  Report report;
};

/// Runs what `request`, which has no problems, asks for, and shows how far it is. `command_line` is
/// what was typed. From here on an interruption ends the runs, not the program.
[[nodiscard]] RunSuite run_request(const Request& request, const std::string& command_line);

}  // namespace tautline::bench
