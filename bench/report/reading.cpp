// Reads a report back, and says in sentences what is not one.

#include <fmt/format.h>

#include <algorithm>
#include <cstdint>
#include <set>
#include <system_error>
#include <tuple>

#include "bench/base/input_file.hpp"
#include "bench/base/text.hpp"
#include "bench/gate/changes.hpp"
#include "bench/report/report.hpp"

namespace tautline::bench {
namespace {

using nlohmann::ordered_json;

/// A longer file is no report: 10,000 runs are some 60 MB [bytes].
constexpr std::size_t longest_report = std::size_t{1} << 30U;

std::set<std::string> names(const ordered_json& list) {
  std::set<std::string> result;
  for (const ordered_json& entry : list) {
    result.insert(entry.at("name").get<std::string>());
  }
  return result;
}

/// What is wrong with `json` as a report; "" if nothing that is seen from outside.
std::string problem_of(const ordered_json& json) {
  const bool is_report = json.is_object() && json.contains("schema") && json.contains("runs") &&
                         json.contains("context") && json.contains("options");
  if (!is_report) {
    return "is not a report of `tautline bench`: must be its report.json";
  }
  const ordered_json& schema = json.at("schema");
  if (schema != report_schema) {
    return fmt::format("has schema {}, must be {}: run `tautline bench` of this version for it",
                       printable(schema.dump()), report_schema);
  }
  const std::set<std::string> engines = names(json.at("engines"));
  const std::set<std::string> cases = names(json.at("cases"));
  std::set<std::tuple<std::string, std::string, std::string, double>> seen;
  for (const ordered_json& run : json.at("runs")) {
    if (!engines.contains(run.at("engine")) || !cases.contains(run.at("case"))) {
      return "has a run whose engine or case it does not list";
    }
    if (!seen.emplace(run.at("case"), run.at("engine"), run.at("model"),
                      run.at("step").get<double>())
             .second) {
      return fmt::format("has two rows of {} on {} {} with the step {:g}, must have one",
                         printable(run.at("case").get<std::string>()),
                         printable(run.at("engine").get<std::string>()),
                         printable(run.at("model").get<std::string>()),
                         run.at("step").get<double>());
    }
  }
  return "";
}

}  // namespace

ReportReading read_report(const std::filesystem::path& path) {
  const std::string name = path.empty() ? "\"\"" : printable(path.native(), 1024);
  // room for what the file has, not for the longest: that would be a gigabyte of zeros
  std::error_code no_size;
  const std::uintmax_t size = std::filesystem::file_size(path, no_size);
  InputFile file = read_input_file(
      path, no_size ? longest_report : std::min<std::uintmax_t>(size, longest_report));
  if (file.problem) {
    return {std::nullopt, {name + ": " + *file.problem}};
  }
  try {
    ordered_json report = ordered_json::parse(file.content);
    const std::string problem = problem_of(report);
    if (!problem.empty()) {
      return {std::nullopt, {name + ": " + problem}};
    }
    return {std::move(report), {}};
  } catch (const ordered_json::parse_error& error) {
    const bool ends = error.byte > file.content.size();
    return {std::nullopt,
            {fmt::format("{}: is not JSON, or not all of it: {} at byte {} of {}", name,
                         ends ? "it ends too early," : "what it holds makes no sense", error.byte,
                         file.content.size())}};
  } catch (const ordered_json::exception& error) {
    return {std::nullopt,
            {fmt::format("{}: is not a report of `tautline bench`: {}", name,
                         printable(error.what()))}};
  }
}

std::vector<std::string> incomparable(const ordered_json& before, const ordered_json& after) {
  std::vector<std::string> problems;
  for (const char* option : {"law", "count_speed", "early_impacts"}) {
    const ordered_json& one = before.at("options").at(option);
    const ordered_json& two = after.at("options").at(option);
    if (one != two) {
      problems.push_back(fmt::format(
          "the reports measure different things: {} is {} in the first and {} in the second",
          option, printable(one.dump()), printable(two.dump())));
    }
  }
  return problems;
}

}  // namespace tautline::bench
