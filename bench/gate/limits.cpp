// Reads a limits file as strictly as a case file: all that is wrong with it is said at once.

#include "bench/gate/limits.hpp"

#include <algorithm>
#include <cstddef>
#include <utility>

#include "bench/base/input_file.hpp"
#include "bench/base/listed.hpp"
#include "bench/base/problems.hpp"
#include "bench/base/strict_table.hpp"
#include "bench/base/text.hpp"
#include "bench/base/value.hpp"
#include "bench/measure/metric_list.hpp"
#include "shipped_limits.inc"
#include "tautline/case.hpp"

namespace tautline::bench {
namespace {

/// A longer manifest is refused before it is read [bytes].
constexpr std::size_t longest_limits_file = std::size_t{1} << 20U;

/// More entries of one kind than this are a mistake: every run is compared with each of them.
constexpr std::size_t most_entries = 10'000;

/// What a limit is made of: finite, too, times a step or over one.
const Range part_of_limit = {"from 0 to 1e20",
                             [](double x) { return x >= 0.0 && x <= largest_number; }, 0.0};

const Range right_schema = {"1, the form that this program reads",
                            [](double x) { return x == limits_schema; }, limits_schema};

std::vector<std::string> metric_names() {
  return listed<std::string>(metric_list(), &Metric::name);
}

/// What runs may be known for.
std::vector<std::string> names_of_deviations() {
  std::vector<std::string> names = metric_names();
  names.emplace_back(failure);
  names.emplace_back(any_finding);
  for (const FindingKind& kind : finding_kinds) {
    if (contradicts_a_pass(kind.name)) {
      names.emplace_back(kind.name);
    }
  }
  return names;
}

/// The unit of a metric; "" for a name that is none.
std::string unit_of(const std::string& name) {
  const std::optional<std::size_t> place = place_of(name);
  return place ? std::string(metric_list()[*place].unit) : "";
}

/// Holds the patterns of a file against the names that there are.
class Names {
 public:
  explicit Names(const LimitNames& names) : names_(names) {
    for (const LimitNames::Engine& engine : names.engines) {
      engines_.push_back(engine.name);
    }
  }

  void check(const RunPattern& runs, StrictTable& table) const {
    for (const std::string& engine : alternatives(runs.engine)) {
      check_slip("engine", engine, engines_, table);
    }
    for (const std::string& model : alternatives(runs.model)) {
      check_model(runs.engine, model, table);
    }
    for (const std::string& the_case : alternatives(runs.the_case)) {
      check_case(the_case, table);
    }
  }

 private:
  static bool any_matches(const std::string& pattern, const std::vector<std::string>& names) {
    return std::any_of(names.begin(), names.end(),
                       [&](const std::string& name) { return matches(pattern, name); });
  }

  /// A name that is none of `names`, and nearly one.
  static void check_slip(const char* key, const std::string& pattern,
                         const std::vector<std::string>& names, StrictTable& table) {
    const std::string near = suggestion(pattern, names);
    if (!near.empty() && !any_matches(pattern, names)) {
      table.refuse_value(key, std::string("there is no such ") + key + near);
    }
  }

  /// A model that none of the engines has, all of them being here.
  void check_model(const std::string& engine_pattern, const std::string& model,
                   StrictTable& table) const {
    std::vector<std::string> models;
    bool all_here = true;
    for (const LimitNames::Engine& engine : names_.engines) {
      if (matches(engine_pattern, engine.name)) {
        all_here = all_here && engine.models;
        const auto& own = engine.models ? *engine.models : std::vector<std::string>();
        models.insert(models.end(), own.begin(), own.end());
      }
    }
    if (!models.empty() && all_here && !any_matches(model, models)) {
      std::sort(models.begin(), models.end());
      models.erase(std::unique(models.begin(), models.end()), models.end());
      const std::string near = suggestion(model, models);
      table.refuse_value("model", "no engine that this means has such a model" +
                                      (near.empty() ? ", must be " + joined(models, "or") : near));
    }
  }

  /// A case that its series does not have.
  void check_case(const std::string& pattern, StrictTable& table) const {
    const std::string series = pattern.substr(0, pattern.find('/') + 1);
    const bool known = !series.empty() && any_matches(series + "*", names_.cases);
    if (known && !any_matches(pattern, names_.cases)) {
      table.refuse_value("case", "there is no such case" + suggestion(pattern, names_.cases));
    } else {
      check_slip("case", pattern, names_.cases, table);
    }
  }

  const LimitNames& names_;
  std::vector<std::string> engines_;
};

RunPattern read_pattern(StrictTable& table, const Names& names) {
  RunPattern runs;
  runs.engine = table.text("engine");
  runs.model = table.text("model");
  runs.the_case = table.optional_text("case").value_or("*");
  const std::vector<std::string> precisions = {"float64", "float32"};
  runs.precision = table.optional_one_of("precision", precisions).value_or("*");
  runs.step = table.optional_number("step", above_zero, "[s]");
  names.check(runs, table);
  return runs;
}

Limit read_limit(StrictTable& table, const Names& names) {
  Limit limit;
  limit.runs = read_pattern(table, names);
  limit.metric = table.one_of("metric", metric_names());
  const std::string unit = unit_of(limit.metric);
  const std::string shown = unit.empty() ? "" : "[" + unit + "]";
  limit.constant = table.number("limit", part_of_limit, shown);
  limit.per_step = table.optional_number("per_step", part_of_limit, "").value_or(0.0);
  limit.over_step = table.optional_number("over_step", part_of_limit, "").value_or(0.0);
  if (unit.empty()) {  // the metric has been refused: nothing to hold the unit against
    static_cast<void>(table.text("unit"));
  } else {
    static_cast<void>(table.one_of("unit", {unit}));
  }
  limit.reason = table.text("reason");
  table.refuse_unknown_keys();
  return limit;
}

KnownDeviation read_known(StrictTable& table, const Names& names) {
  KnownDeviation known;
  known.runs = read_pattern(table, names);
  known.metric = table.one_of("metric", names_of_deviations());
  known.in_some = table.flag("in_some");
  known.reason = table.text("reason");
  table.refuse_unknown_keys();
  return known;
}

Unjudged read_unjudged(StrictTable& table, const Names& names) {
  Unjudged unjudged;
  unjudged.runs = read_pattern(table, names);
  unjudged.reason = table.text("reason");
  table.refuse_unknown_keys();
  return unjudged;
}

/// Of each entry of `tables` what `read` makes of it.
template <class Entry>
std::vector<Entry> read_all(std::vector<StrictTable> tables, const Names& names,
                            Entry (*read)(StrictTable&, const Names&)) {
  std::vector<Entry> entries;
  for (StrictTable& table : tables) {
    for (StrictTable& entry : table.each(most_entries)) {
      entries.push_back(read(entry, names));
    }
  }
  return entries;
}

Limits read_tables(const toml::table& file, const Names& names, FileProblems& findings) {
  StrictTable root(&file, "", findings);
  Limits limits;
  static_cast<void>(root.number("schema", right_schema, ""));
  limits.version = root.text("version");
  limits.limits = read_all(
      root.tables("limits", most_entries,
                  "must be tables [[limits]], each with engine, model, metric, limit, unit and "
                  "reason"),
      names, read_limit);
  limits.known = read_all(
      root.optional_tables("known", most_entries,
                           "must be tables [[known]], each with engine, model, metric and reason"),
      names, read_known);
  limits.unjudged = read_all(
      root.optional_tables("not_judged", most_entries,
                           "must be tables [[not_judged]], each with engine, model and reason"),
      names, read_unjudged);
  for (const char* old : {"informative", "unsupported"}) {
    root.refuse_value(old, "is now [[not_judged]], with engine, model and reason");
  }
  root.refuse_unknown_keys();
  return limits;
}

}  // namespace

bool is_finding(std::string_view metric) {
  return metric == any_finding || finding_kind(metric) != nullptr;
}

bool is_about(const KnownDeviation& known, std::string_view metric) {
  return known.metric == metric || (known.metric == any_finding && is_finding(metric));
}

LimitsReading read_limits_text(std::string_view text, const std::string& source_name,
                               const LimitNames& names) {
  FileProblems findings(source_name);
  const std::optional<toml::table> file = parse_toml(text, findings);
  if (!file) {
    return {std::nullopt, findings.sentences()};
  }
  Limits limits = read_tables(*file, Names(names), findings);
  if (!findings.empty()) {
    return {std::nullopt, findings.sentences()};
  }
  limits.file = source_name;
  return {std::move(limits), {}};
}

LimitsReading read_limits_file(const std::filesystem::path& path, const LimitNames& names) {
  const InputFile file = read_input_file(path, longest_limits_file);
  if (file.problem) {
    FileProblems findings(path.native());
    findings.add(0, *file.problem);
    return {std::nullopt, findings.sentences()};
  }
  return read_limits_text(file.content, path.native(), names);
}

Limits shipped_limits() {
  // the tests read it: what ships is sound
  return read_limits_text(shipped_limits_text, "limits.toml, built in").limits.value();
}

}  // namespace tautline::bench
