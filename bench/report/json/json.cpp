#include "bench/report/json/json.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <set>
#include <string>
#include <string_view>
#include <system_error>
#include <utility>
#include <vector>

#include "bench/base/input_file.hpp"
#include "bench/base/text.hpp"
#include "bench/data/describer.hpp"
#include "bench/data/reader.hpp"
#include "bench/data/writer.hpp"
#include "bench/replay/replay.hpp"
#include "bench/report/json/fields.hpp"

namespace tautline::bench {
namespace {

/// Objects this deep have a line for every key, tables one deeper a line for every row: indented to
/// its leaves, a report would be mostly blanks.
constexpr std::size_t deepest_object = 1;

bool has_lines(const Json& value, std::size_t depth) {
  if (value.empty()) {
    return false;
  }
  if (value.is_object()) {
    return depth <= deepest_object;
  }
  return value.is_array() && value.front().is_object() && depth <= deepest_object + 1;
}

void write_lines(const Json& value, std::size_t depth, std::string& out) {
  if (!has_lines(value, depth)) {
    out += on_one_line(value);
    return;
  }
  out += value.is_object() ? '{' : '[';
  bool first = true;
  for (const auto& [key, member] : value.items()) {
    out += first ? "\n" : ",\n";
    first = false;
    out.append(depth + 1, ' ');
    if (value.is_object()) {
      out += on_one_line(key) + ": ";
    }
    write_lines(member, depth + 1, out);
  }
  out += '\n';
  out.append(depth, ' ');
  out += value.is_object() ? '}' : ']';
}

/// Where a motion starts; none of an empty one.
std::optional<Eigen::Vector3d> start_of(const Path& path) {
  return path.x.steps.empty()
             ? std::nullopt
             : std::optional<Eigen::Vector3d>({path.x.start, path.y.start, path.angle.start});
}

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

std::string report_json(const Report& report, const Replay& replay) {
  Json json = {{"schema", report_schema},
               {"program", {{"name", "tautline"}, {"version", report.version}}}};
  Json rows =
      object_of(report, drawable(replay, report.cases.size(), report.runs.size(), most_impacts));
  for (auto& [key, value] : rows.items()) {
    if (key == "engines") {  // before it, with the options: what the numbers below mean
      json["metrics"] = metrics_json();
    }
    json[key] = std::move(value);
  }
  std::string out;
  write_lines(json, 0, out);
  return out + "\n";
}

ReportReading report_from(std::string_view text, const std::string& name) {
  try {
    const Json json = Json::parse(text);
    if (!json.is_object() || !json.contains("schema") || !json.contains("runs")) {
      return {std::nullopt,
              {name + ": is not a report of `tautline bench`: must be its report.json"}};
    }
    if (json.at("schema") != report_schema) {
      return {std::nullopt,
              {fmt::format("{}: has schema {}, must be {}: run `tautline bench` of this version "
                           "for it",
                           name,
                           printable(json.at("schema").is_primitive() ? json.at("schema").dump()
                                                                      : "a list or an object"),
                           report_schema)}};
    }
    ReportReading reading = {Report()};
    Report& report = *reading.report;
    Reader reader(json);
    fields(reader, report, reading.replay);
    std::for_each(report.engines.begin(), report.engines.end(), complete);
    for (std::size_t place = 0; place < report.cases.size(); ++place) {
      report.cases[place].start = start_of(reading.replay.cases[place].path);
    }
    report.version = json.at("program").at("version").get<std::string>();
    return reading;
  } catch (const Json::parse_error& error) {
    const bool ends = error.byte > text.size();
    return {std::nullopt,
            {fmt::format("{}: is not JSON, or not all of it: {} at byte {} of {}", name,
                         ends ? "it ends too early," : "what it holds makes no sense", error.byte,
                         text.size())}};
  } catch (const Json::exception& error) {
    return {std::nullopt,
            {fmt::format("{}: is not a report of `tautline bench`: {}", name,
                         printable(error.what()))}};
  }
}

std::string run_json(const RunRow& run, RunReplay replay) {
  if (replay.impacts) {
    replay.impacts = drawable(*std::move(replay.impacts), most_impacts);
  }
  return object_of(run, replay).dump(2, ' ', false, Json::error_handler_t::replace) + "\n";
}

std::string settings_json(const EngineInfo& engine, const Model& model, double step) {
  const Json json = {{"schema", 1},
                     {"engine", engine.name},
                     {"version", engine.version},
                     {"precision", engine.precision},
                     {"model", model.name},
                     {"sentence", model.sentence},
                     {"step", step},
                     {"settings", json_of(model.settings)}};
  return json.dump(2, ' ', false, Json::error_handler_t::replace) + "\n";
}

std::string record_json(const RunRecord& record, const std::string& fingerprint) {
  return on_one_line({{"fingerprint", fingerprint}, {"record", json_of(record)}}) + "\n";
}

std::optional<RunRecord> record_from(std::string_view text, const std::string& fingerprint) {
  try {
    const Json json = Json::parse(text);
    if (json.at("fingerprint") != fingerprint) {
      return std::nullopt;
    }
    RunRecord record;
    read(json.at("record"), record);
    return record;
  } catch (const Json::exception&) {
    return std::nullopt;
  }
}

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

std::string report_schema_json() {
  Describer program;
  program.add_member("name", {{"const", "tautline"}});
  program("version", std::string());
  Describer metric;
  metric("name", std::string());
  metric("unit", std::string(), "1 for a ratio or a count");
  metric("meaning", std::string());

  Describer members;
  members.add_member("schema", {{"const", report_schema}});
  members.add_member("program", std::move(program).schema());
  members.add_member("metrics", list_of(std::move(metric).schema()),
                     "what a run is measured by; the smaller, the better");
  Report report;
  Replay replay;
  fields(members, report, replay);
  return text_of(headed("Report of `tautline bench`",
                        "Two runs of one suite on one program give the same text but for the last "
                        "key, context.",
                        std::move(members).schema()));
}

}  // namespace tautline::bench
