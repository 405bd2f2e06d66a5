#include "bench/report/json/json.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <initializer_list>
#include <map>
#include <string_view>
#include <utility>

#include "bench/base/text.hpp"
#include "bench/data/reader.hpp"
#include "bench/data/writer.hpp"
#include "bench/report/json/fields.hpp"
#include "bench/report/motion.hpp"
#include "bench/report/thinning.hpp"

namespace tautline::bench {
namespace {

Json metrics_json() {
  Json list = Json::array();
  for (const Metric& metric : metric_list()) {
    list.push_back({{"name", metric.name}, {"unit", metric.unit}, {"meaning", metric.meaning}});
  }
  return list;
}

/// `drawn` with its impacts thinned and rounded for a chart, and without the motions of its runs.
Json whole(Report drawn) {
  const std::size_t impacts = impacts_per_run(drawn.runs.size());
  for (RunRow& run : drawn.runs) {
    run.path.reset();
    run = drawable(std::move(run), impacts);
  }
  for (CaseRow& row : drawn.cases) {
    row = drawable(std::move(row));
  }
  Json json = {{"schema", report_schema},
               {"program", {{"name", "tautline"}, {"version", drawn.version}}}};
  Json rows = json_of(drawn);
  for (auto& [key, value] : rows.items()) {
    if (key == "engines") {  // before it, with the options: what the numbers below mean
      json["metrics"] = metrics_json();
    }
    json[key] = std::move(value);
  }
  return json;
}

/// Of impacts what a replay shows.
Json drawn_impacts(const ImpactColumns& impacts) {
  std::vector<double> speed;
  for (const double rate : impacts.rate_before) {
    speed.push_back(rounded(-rate, 4));
  }
  return {{"time", json_of(impacts.time)},
          {"cable", json_of(impacts.cable)},
          {"speed", json_of(speed)},
          {"left_out", impacts.left_out}};
}

// Digits of what a chart has many of, and of what it draws over decades without a tooltip.
constexpr int point_digits = 4;
constexpr int decade_digits = 3;

/// Every number of `json` with as many digits as a chart or a tooltip can show; a whole one without
/// its point.
void round_for_charts(Json& json, int digits) {
  if (json.is_number_float()) {
    constexpr double countable = 1e15;
    const double value = rounded(json.get<double>(), digits);
    const bool whole_number = std::trunc(value) == value && std::abs(value) < countable;
    json = whole_number ? Json(static_cast<std::int64_t>(value)) : Json(value);
  } else if (json.is_structured()) {
    for (auto& [key, inside] : json.items()) {
      if (key != "step") {  // which names a run
        round_for_charts(inside, digits);
      }
    }
  }
}

/// Keeps of an object the keys that a chart reads.
void keep(Json& object, std::initializer_list<std::string_view> keys) {
  if (!object.is_object()) {
    return;
  }
  Json kept = Json::object();
  for (const std::string_view key : keys) {
    kept[std::string(key)] = object.at(std::string(key));
  }
  object = std::move(kept);
}

/// The impacts of a run as the audit draws them: the columns without their names, in an order that
/// common.js knows. A column of one value throughout is that value.
void shorten_impacts(Json& impacts) {
  if (!impacts.is_object()) {
    return;
  }
  for (const char* key : {"rate_before", "rate_after", "arm"}) {
    round_for_charts(impacts.at(key), point_digits);
  }
  for (const char* key : {"tangential_error", "angular_error"}) {
    round_for_charts(impacts.at(key), decade_digits);
  }
  Json columns = Json::array({impacts.at("time")});
  for (const char* key : {"cable", "requested", "rate_before", "rate_after", "arm",
                          "tangential_error", "angular_error"}) {
    const Json& column = impacts.at(key);
    const bool constant =
        !column.empty() && std::all_of(column.begin(), column.end(),
                                       [&](const Json& one) { return one == column.front(); });
    columns.push_back(constant ? column.front() : column);
  }
  columns.push_back(impacts.at("left_out"));
  impacts = std::move(columns);
}

/// The parts of a deviation without their names, in the order of the causes.
void shorten_attribution(Json& attribution) {
  keep(attribution, {"deviation", "covered", "parts"});
  if (attribution.is_object() && attribution.at("parts").is_object()) {
    Json parts = Json::array();
    for (const Json& part : attribution.at("parts")) {
      parts.push_back(part);
    }
    attribution["parts"] = std::move(parts);
  }
  round_for_charts(attribution, point_digits);
}

/// What a simulated second cost, run by run: [median, quartile, quartile] of the repetitions.
void add_costs(Json& runs, const Report& report) {
  std::map<RunKey, const TimingRow*> timing;
  for (const TimingRow& row : report.context.timing) {
    timing.emplace(row.key, &row);
  }
  for (std::size_t place = 0; place < report.runs.size(); ++place) {
    if (const auto found = timing.find(report.runs[place].key); found != timing.end()) {
      const TimingRow& row = *found->second;
      runs[place]["cost"] = {row.second_cost, row.second_spread.lower, row.second_spread.upper};
      round_for_charts(runs[place]["cost"], point_digits);
    }
  }
}

/// `report`, which is `of` as JSON, without what no chart of the page reads: its tables have every
/// number.
Json for_charts(Json report, const Report& of) {
  for (Json& run : report.at("runs")) {
    for (const char* key : {"details", "verdict", "output_tail", "reason", "path"}) {
      run.erase(key);
    }
    keep(run.at("metrics"), {"early_position_error", "horizon_position_error"});
    shorten_impacts(run.at("impacts"));
    keep(run.at("audit"), {"ladder"});
    if (run.at("audit").is_null() || run.at("audit").at("ladder").is_null()) {
      run.erase("audit");
    }
    shorten_attribution(run.at("attribution"));
  }
  add_costs(report.at("runs"), of);
  for (Json& engine : report.at("engines")) {
    if (engine.contains("models")) {
      for (Json& model : engine.at("models")) {
        keep(model, {"name"});
      }
    }
  }
  report.at("context").erase("timing");
  report.erase("distributions");  // which have a page of their own
  for (Json& row : report.at("summary")) {
    keep(row.at("metrics"), {"early_position_error", "horizon_position_error"});
  }
  for (const char* key :
       {"runs", "summary", "causes", "context"}) {  // the replay needs its cases whole
    round_for_charts(report.at(key), 6);
  }
  return report;
}

std::string on_one_line(const Json& value) {
  return value.dump(-1, ' ', false, Json::error_handler_t::replace);
}

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

}  // namespace

std::string report_json(const Report& report) {
  std::string out;
  write_lines(whole(report), 0, out);
  return out + "\n";
}

std::string page_json(const Report& report) {
  return on_one_line(for_charts(whole(report), report));
}

std::string motions_json(const Report& report, const std::string& the_case) {
  std::string out = "[";
  for (const RunRow& run : report.runs) {
    if (run.key.the_case == the_case && run.path && run.impacts) {
      const RunRow drawn = drawable(run, most_impacts);
      out += (out.size() > 1 ? ",\n" : "\n") +
             on_one_line({{"engine", run.key.engine},
                          {"model", run.key.model},
                          {"step", run.key.step},
                          {"path", json_of(*run.path)},
                          {"impacts", drawn_impacts(*drawn.impacts)}});
    }
  }
  return out + "\n]";
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
    Report report;
    read(json, report);
    std::for_each(report.engines.begin(), report.engines.end(), complete);
    report.version = json.at("program").at("version").get<std::string>();
    return {std::move(report), {}};
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

std::string run_json(const RunRow& run) {
  return json_of(drawable(run, most_impacts)).dump(2, ' ', false, Json::error_handler_t::replace) +
         "\n";
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

}  // namespace tautline::bench
