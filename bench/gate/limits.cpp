// Reads a limits file as strictly as a case file: all that is wrong with it is said at once.

#include "bench/gate/limits.hpp"

#include <cstddef>
#include <utility>

#include "bench/base/input_file.hpp"
#include "bench/base/toml/problems.hpp"
#include "bench/base/toml/strict_table.hpp"
#include "bench/base/toml/value.hpp"
#include "bench/measure/metric_list.hpp"
#include "shipped_limits.inc"

namespace tautline::bench {
namespace {

/// A longer manifest is refused before it is read [bytes].
constexpr std::size_t longest_limits_file = std::size_t{1} << 20U;

/// More entries of one kind than this are a mistake: every run is held against each of them.
constexpr std::size_t most_entries = 10'000;

const Range right_schema = {"1, the form that this program reads",
                            [](double x) { return x == limits_schema; }};

std::vector<std::string> metric_names() {
  std::vector<std::string> names;
  for (const Metric& metric : metric_list()) {
    names.emplace_back(metric.name);
  }
  return names;
}

std::vector<std::string> metric_names_and_failure() {
  std::vector<std::string> names = metric_names();
  names.emplace_back(failure);
  return names;
}

/// The unit of a metric; "" for a name that is none.
std::string unit_of(const std::string& name) {
  const std::optional<std::size_t> place = place_of(name);
  return place ? std::string(metric_list()[*place].unit) : "";
}

RunPattern read_pattern(StrictTable& table) {
  RunPattern runs;
  runs.engine = table.text("engine");
  runs.model = table.text("model");
  runs.the_case = table.optional_text("case").value_or("*");
  const std::vector<std::string> precisions = {"float64", "float32"};
  runs.precision = table.optional_one_of("precision", precisions).value_or("*");
  runs.step = table.optional_number("step", above_zero, "[s]");
  return runs;
}

Limit read_limit(StrictTable& table) {
  Limit limit;
  limit.runs = read_pattern(table);
  limit.metric = table.one_of("metric", metric_names());
  const std::string unit = unit_of(limit.metric);
  const std::string shown = unit.empty() ? "" : "[" + unit + "]";
  limit.constant = table.number("limit", zero_or_above, shown);
  limit.per_step = table.optional_number("per_step", zero_or_above, "").value_or(0.0);
  limit.over_step = table.optional_number("over_step", zero_or_above, "").value_or(0.0);
  if (unit.empty()) {  // the metric has been refused: nothing to hold the unit against
    static_cast<void>(table.text("unit"));
  } else {
    static_cast<void>(table.one_of("unit", {unit}));
  }
  limit.reason = table.text("reason");
  table.refuse_unknown_keys();
  return limit;
}

KnownDeviation read_known(StrictTable& table) {
  KnownDeviation known;
  known.runs = read_pattern(table);
  known.metric = table.one_of("metric", metric_names_and_failure());
  known.reason = table.text("reason");
  table.refuse_unknown_keys();
  return known;
}

Unjudged read_unjudged(StrictTable& table) {
  Unjudged unjudged;
  unjudged.runs = read_pattern(table);
  unjudged.reason = table.text("reason");
  table.refuse_unknown_keys();
  return unjudged;
}

Limits read_tables(const toml::table& file, FileProblems& findings) {
  StrictTable root(&file, "", findings);
  Limits limits;
  static_cast<void>(root.number("schema", right_schema, ""));
  limits.version = root.text("version");
  for (StrictTable& table :
       root.tables("limits", most_entries,
                   "must be tables [[limits]], each with engine, model, metric, limit, unit and "
                   "reason")) {
    limits.limits.push_back(read_limit(table));
  }
  for (StrictTable& table : root.optional_tables(
           "known", most_entries,
           "must be tables [[known]], each with engine, model, metric and reason")) {
    limits.known.push_back(read_known(table));
  }
  for (StrictTable& table :
       root.optional_tables("not_judged", most_entries,
                            "must be tables [[not_judged]], each with engine, model and reason")) {
    limits.unjudged.push_back(read_unjudged(table));
  }
  root.refuse_unknown_keys();
  return limits;
}

}  // namespace

LimitsReading read_limits_text(std::string_view text, const std::string& source_name) {
  FileProblems findings(source_name);
  const std::optional<toml::table> file = parse_toml(text, findings);
  if (!file) {
    return {std::nullopt, findings.sentences()};
  }
  Limits limits = read_tables(*file, findings);
  if (!findings.empty()) {
    return {std::nullopt, findings.sentences()};
  }
  limits.file = source_name;
  return {std::move(limits), {}};
}

LimitsReading read_limits_file(const std::filesystem::path& path) {
  const InputFile file = read_input_file(path, longest_limits_file);
  if (file.problem) {
    FileProblems findings(path.native());
    findings.add(0, *file.problem);
    return {std::nullopt, findings.sentences()};
  }
  return read_limits_text(file.content, path.native());
}

Limits shipped_limits() {
  // the tests read it: what ships is sound
  return read_limits_text(shipped_limits_text, "limits.toml, built in").limits.value();
}

}  // namespace tautline::bench
