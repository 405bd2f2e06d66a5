// The data of the report's page: what its charts and its replay read. The tables of the page have
// every number.

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdint>
#include <map>

#include "bench/base/listed.hpp"
#include "bench/replay/replay.hpp"
#include "bench/report/json/fields.hpp"
#include "bench/report/json/json.hpp"

namespace tautline::bench {
namespace {

// Digits of what a chart has many of, and of what else it draws.
constexpr int point_digits = 4;
constexpr int chart_digits = 6;

/// The errors that a chart can show; of one run, or over cases.
template <class Value>
struct ShownErrors {
  Value early;
  Value horizon;

  explicit ShownErrors(const std::vector<Value>& metrics)
      : early(metrics[place_of("early_position_error").value()]),
        horizon(metrics[place_of("horizon_position_error").value()]) {}
};

template <class Visitor, class Value>
void fields(Visitor& visit, ShownErrors<Value>& errors) {
  visit("early_position_error", errors.early);
  visit("horizon_position_error", errors.horizon);
}

/// Where a deviation comes from.
struct ShownCauses {
  double deviation;                          // [m]
  double covered;                            // [-]
  std::optional<std::vector<double>> parts;  // [m], in the order of the causes

  explicit ShownCauses(const Attribution& of)
      : deviation(rounded(of.deviation, point_digits)), covered(rounded(of.covered, point_digits)) {
    if (of.parts) {
      const auto told = static_cast<std::ptrdiff_t>(causes_of(*of.parts).size());
      parts.emplace(of.parts->begin(), of.parts->begin() + told);
      round_all(*parts, point_digits);
    }
  }
};

template <class Visitor>
void fields(Visitor& visit, ShownCauses& causes) {
  visit("deviation", causes.deviation);
  visit("covered", causes.covered);
  visit("parts", causes.parts);
}

/// The columns that `fields` shows it without their names, which `names` has: behind the first, a
/// column of one value throughout is that value.
class Columns {
 public:
  template <class Value>
  void operator()(const char* key, const Value& value, const Says& /*says*/ = {}) {
    Json column = json_of(value);
    const bool constant = !values.empty() && column.is_array() && !column.empty() &&
                          std::all_of(column.begin(), column.end(),
                                      [&](const Json& one) { return one == column[0]; });
    names.push_back(key);
    values.push_back(constant ? column[0] : std::move(column));
  }

  static void means(const char* /*meaning*/) {}

  Json names = Json::array();
  Json values = Json::array();
};

/// The impacts of a run as the audit draws them.
struct ShownImpacts {
  ImpactColumns columns;
};

Columns columns_of(ImpactColumns impacts) {
  for (auto* column : {&impacts.rate_before, &impacts.rate_after, &impacts.arm}) {
    round_all(*column, point_digits);
  }
  Columns columns;
  fields(columns, impacts);
  return columns;
}

Json json_of(const ShownImpacts& impacts) { return columns_of(impacts.columns).values; }

/// The word on restitution as a bar shows it: 0 kept, or no impacts, 1 off, 2 too few impacts to
/// tell, 3 some are lost, 4 scattered.
double bar_word(Rebound word) {
  constexpr std::array words = {0.0, 1.0, 3.0, 3.0, 4.0, 1.0, 2.0, 0.0};  // by Rebound
  return words.at(static_cast<std::size_t>(word));
}

/// The restitution that a run has, as a bar shows it: a word, and the restitution got [-], where
/// the cables of the case ask for one; none of a run that has no one number for it.
std::optional<std::vector<double>> shown_rebound(const CaseRow& the_case, const RunRow& row) {
  const std::optional<double> asked = the_case.asked_restitution();
  if (!row.judgement || !asked) {
    return std::nullopt;
  }
  const Rebounds& rebounds = row.judgement->rebounds;
  if (rebounds.word != Rebound::none && !rebounds.deviation) {
    return std::nullopt;
  }
  const double got = rebounds.word == Rebound::none ? 0.0 : *asked + *rebounds.deviation;
  return std::vector<double>{bar_word(rebounds.word), got};
}

/// A run as the charts draw it.
struct ShownRun {
  RunKey key;
  std::optional<Status> status;  // none of one that finished, as nearly all do
  std::optional<ShownErrors<std::optional<double>>> errors;
  std::optional<ShownImpacts> impacts;
  std::optional<Ladder> ladder;
  std::optional<ShownCauses> causes;
  std::optional<std::vector<double>> cost;  // [s], of a simulated second: median and quartiles
  std::optional<std::vector<double>> rebound;
};

template <class Visitor>
void fields(Visitor& visit, ShownRun& run) {
  fields(visit, run.key);
  visit.if_any("status", run.status);
  visit("metrics", run.errors);
  visit("impacts", run.impacts);
  visit.unless_missing("audit", run.ladder, [](auto& inside, Ladder& ladder) {
    inside.group("audit", "", [&](auto& audit) { audit("ladder", ladder); });
  });
  visit("attribution", run.causes);
  visit.unless_missing("cost", run.cost,
                       [](auto& inside, std::vector<double>& cost) { inside("cost", cost); });
  visit.if_any("e", run.rebound);
}

/// The restitution of a model over all cases: a word, and by how much it is off where it is by one
/// number [-].
struct ShownModel {
  std::string engine;
  std::string model;
  std::vector<double> rebound;
};

template <class Visitor>
void fields(Visitor& visit, ShownModel& model) {
  visit("engine", model.engine);
  visit("model", model.model);
  visit("e", model.rebound);
}

/// An engine by its name, with those of its models.
struct ShownEngine {
  std::string name;
  std::vector<std::string> models;
};

template <class Visitor>
void fields(Visitor& visit, ShownEngine& engine) {
  visit("name", engine.name);
  visit("models", engine.models);
}

/// The answers for one engine, model and step as the charts draw them.
struct ShownSummary {
  SetupKey key;
  std::size_t cases;
  std::size_t failed;
  ShownErrors<std::optional<MedianAndWorst>> errors;
};

template <class Visitor>
void fields(Visitor& visit, ShownSummary& row) {
  fields(visit, row.key);
  visit("cases", row.cases);
  visit("failed", row.failed);
  visit("metrics", row.errors);
}

/// All that the page's scripts read.
struct PageData {
  const Report& report;  // of which they read some parts as they are
  Replay replay;         // of it, thinned
  std::vector<ShownEngine> engines;
  std::vector<ShownSummary> summary;
  std::vector<ShownModel> models;
  std::vector<ShownRun> runs;
};

template <class Visitor>
void fields(Visitor& visit, PageData& page) {
  visit("options", page.report.options);
  visit("engines", page.engines);
  visit.drawn("cases", page.report.cases, page.replay.cases);
  visit("summary", page.summary);
  visit("models", page.models);
  visit("convergence", page.report.convergence);
  visit("findings", page.report.findings);
  visit("causes", page.report.causes);
  visit("runs", page.runs);
  visit.group("context", "", [&](auto& inside) { inside("costs", page.report.context.costs); });
}

/// What a simulated second cost, by run: median and quartiles of the repetitions.
std::map<RunKey, std::vector<double>> costs_of(const Report& report) {
  std::map<RunKey, std::vector<double>> costs;
  for (const TimingRow& row : report.context.timing) {
    std::vector<double>& cost = costs[row.key];
    cost = {row.second_cost, row.second_spread.lower, row.second_spread.upper};
    round_all(cost, point_digits);
  }
  return costs;
}

PageData page_data(const Report& report, const Replay& replay) {
  PageData page = {
      report,
      drawable(replay, report.cases.size(), report.runs.size(), page_impacts(report.runs.size())),
      {},
      {},
      {},
      {}};
  for (const EngineRow& engine : report.engines) {
    ShownEngine& shown = page.engines.emplace_back(ShownEngine{engine.name, {}});
    for (const Model& model : engine.info ? engine.info->models : std::vector<Model>()) {
      shown.models.push_back(model.name);
    }
  }
  for (const SummaryRow& row : report.summary) {
    page.summary.push_back({row.key, row.cases, row.failed, ShownErrors(row.metrics)});
  }
  for (const ModelJudgement& judged : report.models) {
    const Rebounds& rebounds = judged.rebounds;
    page.models.push_back({judged.engine, judged.model, {bar_word(rebounds.word)}});
    if (rebounds.deviation) {
      page.models.back().rebound.push_back(*rebounds.deviation);
    }
  }
  const std::map<RunKey, std::vector<double>> costs = costs_of(report);
  for (std::size_t place = 0; place < report.runs.size(); ++place) {
    const RunRow& row = report.runs[place];
    ShownRun& run = page.runs.emplace_back(ShownRun{row.key, {}, {}, {}, row.ladder, {}, {}, {}});
    if (row.status != Status::finished) {
      run.status = row.status;
    }
    if (const CaseRow* const of = find_by(report.cases, &CaseRow::name, row.key.the_case);
        of != nullptr) {
      run.rebound = shown_rebound(*of, row);
    }
    if (row.metrics) {
      run.errors.emplace(*row.metrics);
    }
    if (std::optional<ImpactColumns>& impacts = page.replay.runs[place].impacts) {
      run.impacts = {*std::move(impacts)};
    }
    if (row.attribution) {
      run.causes.emplace(*row.attribution);
    }
    if (const auto cost = costs.find(row.key); cost != costs.end()) {
      run.cost = cost->second;
    }
  }
  return page;
}

/// Every number of `json` with as many digits as a chart or a tooltip can show; a whole one without
/// its point.
void round_for_charts(Json& json) {
  if (json.is_number_float()) {
    constexpr double countable = 1e15;
    const double value = rounded(json.get<double>(), chart_digits);
    const bool whole_number = std::trunc(value) == value && std::abs(value) < countable;
    json = whole_number ? Json(static_cast<std::int64_t>(value)) : Json(value);
  } else if (json.is_structured()) {
    for (auto& [key, inside] : json.items()) {
      if (key != "step") {  // which names a run
        round_for_charts(inside);
      }
    }
  }
}

/// Of impacts what a replay shows.
Json drawn_impacts(const ImpactColumns& impacts) {
  std::vector<double> speed;
  for (const double rate : impacts.rate_before) {
    speed.push_back(rounded(-rate, point_digits));
  }
  Writer writer;
  writer("time", impacts.time);
  writer("cable", impacts.cable);
  writer("speed", speed);
  writer("left_out", impacts.left_out);
  return std::move(writer).object();
}

}  // namespace

std::string page_json(const Report& report, const Replay& replay) {
  Json json = object_of(page_data(report, replay));
  for (const char* key :
       {"runs", "summary", "models", "causes", "context"}) {  // not what the replay reads
    round_for_charts(json.at(key));
  }
  if (!report.live_page.empty()) {
    json["live_page"] = report.live_page;
    for (std::size_t place = 0; place < report.cases.size(); ++place) {
      json["cases"][place]["live"] = report.cases[place].live;
    }
  }
  json["metrics"] = metrics_json();
  json["impact_columns"] = columns_of(ImpactColumns()).names;
  return on_one_line(json);
}

std::string motions_json(const Report& report, const Replay& replay, const std::string& the_case) {
  std::string out = "[";
  for (std::size_t place = 0; place < report.runs.size(); ++place) {
    const RunKey& key = report.runs[place].key;
    const RunReplay& run = replay.of_run(place);
    if (key.the_case == the_case && run.path && run.impacts) {
      out += (out.size() > 1 ? ",\n" : "\n") +
             on_one_line({{"engine", key.engine},
                          {"model", key.model},
                          {"step", key.step},
                          {"path", json_of(*run.path)},
                          {"impacts", drawn_impacts(drawable(*run.impacts, most_drawn))}});
    }
  }
  return out + "\n]";
}

}  // namespace tautline::bench
