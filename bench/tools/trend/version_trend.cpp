#include "bench/tools/trend/version_trend.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <map>
#include <string_view>
#include <utility>

#include "bench/base/html.hpp"
#include "bench/base/listed.hpp"
#include "bench/base/text.hpp"
#include "bench/data/describer.hpp"
#include "bench/gate/changes_fields.hpp"
#include "bench/gate/changes_output.hpp"
#include "bench/page/document.hpp"
#include "bench/report/columns.hpp"
#include "bench/report/scorecard.hpp"
#include "bench/report/words.hpp"
#include "tautline_bench_trend_words.inc"

namespace tautline::bench {

template <class Visitor>
void fields(Visitor& visit, TrendVersion& version) {
  const bool has_report = version.problem.empty();
  using Text = std::optional<std::string>;
  visit("version", version.version);
  visit("untried", version.untried,
        "the engine.toml names versions that it is made for, and not this one");
  visit("report", has_report ? Text(version.file) : std::nullopt,
        "the file of its report; null: it has none");
  visit("problem", has_report ? std::nullopt : Text(version.problem), "why it has none");
}

template <class Visitor>
void fields(Visitor& visit, VersionTrend& trend) {
  visit("engine", trend.engine);
  visit("package", trend.package, "of npm");
  visit("range", trend.range, "as npm reads it");
  visit("versions", trend.versions, "from the oldest to the newest");
  visit("trend", trend.trend,
        "over the versions that have a report, which it names; null: no version has one");
}

/// Of several engines.
struct VersionTrends {
  std::vector<VersionTrend> engines;
};

template <class Visitor>
void fields(Visitor& visit, VersionTrends& trends) {
  schema_field(visit, 1);
  visit("engines", trends.engines, Says().not_empty());
}

namespace {

/// By how much a metric changed [-]: 1 not at all, otherwise more, whichever way; infinity where a
/// factor says nothing.
double size_of_change(const MetricChange& change) {
  const double before = change.before.value_or(0.0);
  const double after = change.after.value_or(0.0);
  return before > 0.0 && after > 0.0 ? std::max(before / after, after / before)
                                     : std::numeric_limits<double>::infinity();
}

/// One move for each model, step and metric, the largest first.
std::vector<VersionMove> moves_to(const std::string& version,
                                  const std::vector<MetricChange>& changes) {
  std::map<std::pair<SetupKey, std::size_t>, VersionMove> found;
  for (const MetricChange& change : changes) {
    const auto [place, is_new] =
        found.try_emplace({setup_of(change.key), change.metric}, VersionMove{version, change, 0});
    VersionMove& move = place->second;
    ++move.runs;
    if (size_of_change(change) > size_of_change(move.most)) {
      move.most = change;
    }
  }
  std::vector<VersionMove> result = listed(found, [](const auto& one) { return one.second; });
  std::stable_sort(result.begin(), result.end(),
                   [](const VersionMove& one, const VersionMove& two) {
                     return size_of_change(one.most) > size_of_change(two.most);
                   });
  return result;
}

// Ranks of the columns that go first on a narrow terminal; the page has them all.
constexpr int unit_rank = 1;
constexpr int case_rank = 2;

std::vector<Column> move_columns() {
  std::vector<Column> columns = {word_column("since", ""),
                                 word_column("model", ""),
                                 number_column("step", "s", "", ""),
                                 word_column("metric", ""),
                                 word_column("unit", ""),
                                 word_column("case", ""),
                                 number_column("before", "", "", ""),
                                 number_column("after", "", "", ""),
                                 number_column("factor", "", "", ""),
                                 number_column("runs", "", "", "")};
  columns[4].rank = unit_rank;
  columns[5].rank = case_rank;
  return columns;
}

/// A dash where a factor says nothing.
Cell factor_cell(const MetricChange& change) {
  return brief_cell(std::isfinite(size_of_change(change))
                        ? std::optional(*change.after / *change.before)
                        : std::nullopt);
}

Table moves_table(const std::vector<VersionMove>& moves) {
  Table table(move_columns());
  for (const auto& [version, most, runs] : moves) {
    const Metric& metric = metric_list()[most.metric];
    table.add({word_cell(version), word_cell(most.key.model), number_cell(most.key.step, as_count),
               std::string(metric.name), shown_unit(metric), word_cell(most.key.the_case),
               number_cell(most.before, as_error), number_cell(most.after, as_error),
               factor_cell(most), count_cell(runs)});
  }
  return table;
}

Table costs_table(const Trend& trend) {
  Table table({"since", "model", "step", "cases", "factor"}, 2);
  for (std::size_t index = trend.changes.size(); index > 0; --index) {
    for (const CostChange& change : trend.changes[index - 1].costs) {
      table.add({printable(trend.reports[index].name), printable(change.key.model),
                 fmt::format("{:g}", change.key.step), std::to_string(change.cases),
                 fmt::format("{:.2g}", change.factor)});
    }
  }
  return table;
}

constexpr double milli = 1e-3;

/// The first reason among the runs of `report` that failed, and how many did.
std::string failures_of(const Report& report) {
  const auto failed = [](const RunRow& run) { return !did_its_work(run.status); };
  const auto first = std::find_if(report.runs.begin(), report.runs.end(), failed);
  return first == report.runs.end()
             ? ""
             : fmt::format("{}, {}: {}", to_string(first->status), printable(first->key.model),
                           printable(first->reason));
}

/// A model and step: its metrics and its cost over the reports.
struct Setup {
  std::vector<const TrendRow*> rows;
  const TrendCost* cost = nullptr;
};

std::map<SetupKey, Setup> setups_of(const Trend& trend) {
  std::map<SetupKey, Setup> setups;
  for (const TrendRow& row : trend.rows) {
    setups[row.key].rows.push_back(&row);
  }
  for (const TrendCost& cost : trend.costs) {
    setups[cost.key].cost = &cost;
  }
  return setups;
}

Table table_of(const Trend& trend, const Setup& setup) {
  std::vector<std::string> headings = {"version"};
  for (const TrendRow* row : setup.rows) {
    headings.push_back(metric_heading(metric_list()[row->metric]));
  }
  if (setup.cost != nullptr) {
    headings.emplace_back("cost [ms/s]");
  }
  Table table(headings, 1);
  for (std::size_t index = 0; index < trend.reports.size(); ++index) {
    std::vector<Cell> cells = {printable(trend.reports[index].name)};
    for (const TrendRow* row : setup.rows) {
      const std::optional<TrendPoint>& point = row->points[index];
      cells.push_back(number_cell(point ? std::optional(point->median) : std::nullopt,
                                  metric_list()[row->metric].digits));
    }
    if (setup.cost != nullptr) {
      const std::optional<double> cost = setup.cost->points[index];
      cells.push_back(number_cell(cost ? std::optional(*cost / milli) : std::nullopt, as_error));
    }
    table.add(std::move(cells));
  }
  return table;
}

/// A row for each version: its runs, those that failed, how much changed since the version before,
/// and what is to be said of it.
Table versions_table(const VersionTrend& versions) {
  Table table({"version", "runs", "failed", "worse", "better", "note"}, 1, 1);
  std::size_t reports = 0;
  for (const TrendVersion& version : versions.versions) {
    const std::string untried = version.untried ? "untried: not among engine.toml's versions" : "";
    const std::string said = version.report ? failures_of(*version.report)
                                            : printable(version.problem, longest_sentence);
    const std::string note =
        fmt::format("{}{}{}", untried, untried.empty() || said.empty() ? "" : "; ", said);
    if (!version.report) {
      table.add({printable(version.version), dash, dash, dash, dash, note});
      continue;
    }
    const auto& runs = version.report->runs;
    const auto failed = std::count_if(runs.begin(), runs.end(),
                                      [](const RunRow& run) { return !did_its_work(run.status); });
    const Changes since = reports == 0 ? Changes() : versions.trend->changes[reports - 1];
    ++reports;
    table.add({printable(version.version), std::to_string(runs.size()),
               count_or_dash(static_cast<std::size_t>(failed)), count_or_dash(since.count_worse()),
               count_or_dash(since.count_better()), note});
  }
  return table;
}

/// Each model and step over the versions: medians of its metrics, and its cost.
std::vector<TitledTable> setup_tables(const Trend& trend) {
  return listed(setups_of(trend), [&](const auto& one) {
    const auto& [key, setup] = one;
    return TitledTable{
        fmt::format("{}, step {:g} s", printable(key.model), key.step), table_of(trend, setup),
        setup.cost != nullptr ? words::how_to_read_setups_and_costs : words::how_to_read_setups};
  });
}

/// The words below the tables from `index` on; empty where the next table has the same.
std::string words_below(const std::vector<TitledTable>& tables, std::size_t index) {
  const std::string& words = tables[index].how_to_read;
  return index + 1 < tables.size() && tables[index + 1].how_to_read == words ? "" : words;
}

/// The tables, with names that begin with `id`, and how to read them.
Document document_of(const std::vector<TitledTable>& tables, const std::string& id) {
  Document out;
  for (std::size_t index = 0; index < tables.size(); ++index) {
    out.titled(tables[index].table, fmt::format("{}-{}", id, index),
               markdown_text(tables[index].title));
    out.paragraph(words_below(tables, index), "note");
  }
  return out;
}

/// One engine; `all` has each model and step over the versions, too.
Document document_of(const VersionTrend& versions, bool all) {
  const std::string& id = versions.engine;
  Document out;
  out.paragraph(markdown_text(newest_sentence(versions)), "answer");
  out.table(versions_table(versions), id + "-versions",
            "Worse and better are changes since the version before.");
  if (const std::optional<Trend>& trend = versions.trend) {
    const std::string shows = "Error and cost of " + id + " over its versions";
    out.add(document_of(change_tables(*trend), id + "-changes"));
    out.html(
        figure_html({"tautline-trend-" + id, shows, version_svg(versions), version_csv(versions)}));
    out.in(Medium::markdown).paragraph(fmt::format("![{}]({})", shows, chart_name(id)));
    if (all) {
      out.fold("Every model and step", document_of(setup_tables(*trend), id + "-setups"));
    }
    Document missing;
    add_missing(missing, trend->latest);
    out.in(Medium::terminal).add(missing);
  }
  return Document().section(id, markdown_text(version_title(versions)), out);
}

Document document_of(const std::vector<VersionTrend>& trends) {
  Document out;
  for (const VersionTrend& versions : trends) {
    out.add(document_of(versions, true));
  }
  return out;
}

constexpr const char* page_title = "Accuracy and cost over versions";

}  // namespace

void find_trend(VersionTrend& versions, const Noise& noise) {
  std::vector<Report> reports;
  std::vector<std::string> names;
  for (const TrendVersion& version : versions.versions) {
    if (version.report) {
      reports.push_back(*version.report);
      names.push_back(version.version);
    }
  }
  if (!reports.empty()) {
    versions.trend = trend(reports, names, noise);
  }
}

std::vector<VersionMove> version_moves(const Trend& trend,
                                       std::vector<MetricChange> Changes::*kind) {
  std::vector<VersionMove> result;
  for (std::size_t index = trend.changes.size(); index > 0; --index) {
    const std::vector<VersionMove> moves =
        moves_to(trend.reports[index].name, trend.changes[index - 1].*kind);
    result.insert(result.end(), moves.begin(), moves.end());
  }
  return result;
}

bool newest_is_worse(const VersionTrend& versions) {
  return versions.versions.empty() || !versions.versions.back().report ||
         (versions.trend && versions.trend->latest.worse());
}

std::vector<TitledTable> change_tables(const Trend& trend) {
  std::vector<TitledTable> tables = {
      {"Worse", moves_table(version_moves(trend, &Changes::got_worse)), words::how_to_read_moves},
      {"Better", moves_table(version_moves(trend, &Changes::got_better)), words::how_to_read_moves},
      {"Costs of a step, which are noisy and judge nothing", costs_table(trend),
       words::how_to_read_costs}};
  std::erase_if(tables, [](const TitledTable& one) { return one.table.empty(); });
  return tables;
}

std::string version_title(const VersionTrend& versions) {
  const std::size_t count = versions.versions.size();
  return fmt::format("{}: {} {} of npm, {} version{}", printable(versions.engine),
                     printable(versions.package), printable(versions.range), count,
                     count == 1 ? "" : "s");
}

std::string newest_sentence(const VersionTrend& versions) {
  const TrendVersion& newest = versions.versions.back();
  std::string out = newest.report ? ""
                                  : fmt::format("{} has no report: {}. ", printable(newest.version),
                                                printable(newest.problem, longest_sentence));
  if (const std::size_t count = versions.trend ? versions.trend->reports.size() : 0; count > 1) {
    out += fmt::format("From {} to {}: {}", versions.trend->reports[count - 2].name,
                       versions.trend->reports[count - 1].name,
                       changes_sentence(versions.trend->latest));
  }
  return out;
}

std::string chart_name(const std::string& engine) { return "trend-" + engine + ".svg"; }

std::string version_text(const VersionTrend& versions, bool all, const TerminalStyle& style) {
  return document_of(versions, all).plain(style);
}

std::string version_markdown(const std::vector<VersionTrend>& trends) {
  return fmt::format("# {}\n\n{}", page_title, document_of(trends).markdown());
}

std::string version_html(const std::vector<VersionTrend>& trends, const PageAssets& assets) {
  PageAssets style_alone;
  style_alone.style = assets.style;
  return html_document(
      {.title = page_title,
       .content = fmt::format("<header>\n<h1>{}</h1>\n</header>\n<main>\n{}</main>\n", page_title,
                              document_of(trends).html()),
       .command = "tautline trend",
       .data_id = "trend-data",
       .data = html_json(version_trends_json(trends)),
       .scripts = assets.figure_scripts},
      style_alone);
}

std::string version_trends_json(const std::vector<VersionTrend>& trends) {
  return text_of(json_of(VersionTrends{trends}));
}

std::string version_trends_schema_json() {
  return text_of(headed("What `tautline trend --json` writes",
                        "How engines do over the versions of their packages.",
                        schema_of(VersionTrends())));
}

}  // namespace tautline::bench
