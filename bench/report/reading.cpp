#include "bench/report/json/json.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <set>
#include <string>
#include <system_error>
#include <vector>

#include "bench/base/input_file.hpp"
#include "bench/base/text.hpp"

namespace tautline::bench {
namespace {

/// A longer file is no report: 10,000 runs are some 60 MB [bytes].
constexpr std::size_t longest_report = std::size_t{1} << 30U;

template <class Row>
std::set<std::string> names(const std::vector<Row>& rows) {
  std::set<std::string> result;
  for (const Row& row : rows) {
    result.insert(row.name);
  }
  return result;
}

}  // namespace

std::string contradiction(const Report& report) {
  const std::set<std::string> engines = names(report.engines);
  const std::set<std::string> cases = names(report.cases);
  const bool whole = std::all_of(report.cases.begin(), report.cases.end(), [](const CaseRow& row) {
    return std::isfinite(row.horizon + row.duration + row.start_energy);
  });
  if (!whole || !std::isfinite(report.options.count_speed)) {
    return "lacks a number that every case or its options must have";
  }
  std::set<RunKey> seen;
  for (const RunRow& run : report.runs) {
    const RunKey& key = run.key;
    if (!(std::isfinite(key.step) && key.step > 0.0)) {
      return "has a run whose step is no number above 0";
    }
    if (!engines.contains(key.engine) || !cases.contains(key.the_case)) {
      return "has a run whose engine or case it does not list";
    }
    if (!seen.insert(key).second) {
      return fmt::format("has two rows of {} on {} {} with the step {:g}, must have one",
                         printable(key.the_case), printable(key.engine), printable(key.model),
                         key.step);
    }
  }
  return "";
}

ReportReading read_report(const std::filesystem::path& path) {
  const std::string name = path.empty() ? "\"\"" : printable(path.native(), 1024);
  // room for what the file has, not for the longest: that would be a gigabyte of zeros
  std::error_code no_size;
  const std::uintmax_t size = std::filesystem::file_size(path, no_size);
  const InputFile file = read_input_file(
      path, no_size ? longest_report : std::min<std::uintmax_t>(size, longest_report));
  if (file.problem) {
    return {std::nullopt, {name + ": " + *file.problem}};
  }
  ReportReading reading = report_from(file.content, name);
  const std::string wrong = reading.report ? contradiction(*reading.report) : "";
  return wrong.empty() ? reading : ReportReading{std::nullopt, {name + ": " + wrong}};
}

}  // namespace tautline::bench
