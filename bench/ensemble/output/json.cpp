#include <optional>
#include <string>
#include <utility>
#include <vector>

#include "bench/base/text.hpp"
#include "bench/data/describer.hpp"
#include "bench/ensemble/output/atlas.hpp"
#include "bench/ensemble/output/output.hpp"

namespace tautline::bench {

template <class Visitor>
void fields(Visitor& visit, Test& test) {
  visit("effect", test.effect, in_range(0, 1));
  visit("probability", test.probability, in_range(0, 1, "of as large an effect by chance"));
  visit("adjusted", test.adjusted, in_range(0, 1, "for all tests together"));
}

template <class Visitor>
void fields(Visitor& visit, Statistic& statistic) {
  visit("name", statistic.name);
  visit("heading", statistic.heading);
  visit("unit", statistic.unit, "empty: none");
  visit("meaning", statistic.meaning);
}

namespace ensemble_rows {

// The rows of ensemble.json, and their members by name.

struct QuantileRow {
  double part = 0.0;
  Quantile quantile;
};
struct Summed {
  std::size_t count = 0;
  std::size_t without = 0;
  std::optional<double> mean;
  std::optional<double> deviation;
  std::vector<QuantileRow> quantiles;
};
struct SetupEngine {
  std::string name;
  std::string version;
  std::string model;
  double step = 0.0;
};
struct SetupRow {
  std::string name;
  std::string law;
  double completion = 0.0;
  std::optional<SetupEngine> engine;
  std::size_t draws = 0;
  std::size_t problems = 0;
  std::string first_problem;
  ByName<Summed> statistics;
};
struct ComparisonRow {
  std::string setup;
  std::string statistic;
  Comparison comparison;
};
struct AxisRow {
  std::string quantity;
  std::vector<double> values;
};
struct MapsRow {
  std::vector<AxisRow> axes;
  ByName<std::vector<std::optional<double>>> maps;
};
struct Ensemble {
  std::string the_case;
  double until = 0.0;
  std::size_t draws = 0;
  std::size_t seed = 0;
  std::string sampling;
  std::vector<double> speeds;
  bool interrupted = false;
  std::size_t tests = 0;
  std::vector<Statistic> statistics;
  std::vector<SetupRow> setups;
  std::vector<ComparisonRow> comparisons;
  std::optional<MapsRow> atlas;
};

template <class Visitor>
void fields(Visitor& visit, QuantileRow& row) {
  visit("part", row.part, in_range(0, 1));
  visit("value", row.quantile.value, "null: too many draws have none");
  visit("low", row.quantile.low, "null: the sample is too small for a bound");
  visit("high", row.quantile.high, "likewise, or too many draws have none");
}

template <class Visitor>
void fields(Visitor& visit, Summed& row) {
  visit("count", row.count, "draws with a value");
  visit("without", row.without, "draws with none; they count as the largest");
  visit("mean", row.mean, "of the values");
  visit("deviation", row.deviation, "standard, of the values");
  visit("quantiles", row.quantiles);
}

template <class Visitor>
void fields(Visitor& visit, SetupEngine& row) {
  visit("name", row.name);
  visit("version", row.version);
  visit("model", row.model);
  visit("step", row.step, "[s]");
}

template <class Visitor>
void fields(Visitor& visit, SetupRow& row) {
  visit("name", row.name);
  visit("law", row.law, one_of({"simultaneous", "poisson", "sequential", "energetic"}));
  visit("completion", row.completion,
        "part of later velocities that completing an accumulation changes, at most about [-]");
  visit("engine", row.engine, "null: the exact solver");
  visit("draws", row.draws, "that are finished");
  visit("problems", row.problems, "of them, those that failed or are no case");
  visit("first_problem", row.first_problem);
  visit("statistics", row.statistics, "by name, those that this setup tells");
}

template <class Visitor>
void fields(Visitor& visit, ComparisonRow& row) {
  Comparison& one = row.comparison;
  visit("setup", row.setup);
  visit("statistic", row.statistic);
  visit("draws", one.draws,
        at_least(10,
                 "of the setup that were tested: the first ones, where there are more than are "
                 "held"));
  visit("differs", one.differs(), "an adjusted probability is at most the error rate");
  visit("kolmogorov", one.kolmogorov,
        "effect: the largest distance between the distribution functions");
  visit("energy", one.energy,
        "effect: the energy distance as a share of twice the mean distance between the samples; "
        "null: too few draws have a value");
  visit("median_change", one.median_change, "in the unit of the statistic");
  visit("visible", one.visible,
        "the smallest Kolmogorov distance that would be called a difference");
  visit("visible_shift", one.visible_shift,
        "that makes such a distance, in the unit of the statistic");
}

template <class Visitor>
void fields(Visitor& visit, AxisRow& axis) {
  visit("quantity", axis.quantity);
  visit("values", axis.values);
}

template <class Visitor>
void fields(Visitor& visit, MapsRow& maps) {
  visit("axes", maps.axes, Says().of(2));
  visit("maps", maps.maps,
        "by statistic, of each cell, the first axis fastest: the mean of its draws, and of "
        "first_cable the most frequent; null: no draw has a value");
}

template <class Visitor>
void fields(Visitor& visit, Ensemble& row) {
  schema_field(visit, 1);
  visit("case", row.the_case);
  visit("until", row.until, "[s], where every run ends");
  visit("draws", row.draws, at_least(1, "in all: over a grid, those of every point"));
  visit("seed", row.seed);
  visit("sampling", row.sampling, one_of({"random", "sobol"}));
  visit(
      "speeds", row.speeds,
      Says("[m/s], of the last impacts; those faster than the first are counted, those faster than "
           "the second share the loss")
          .of(2));
  visit("interrupted", row.interrupted, "some draws are missing");
  visit("confidence", double{confidence}, "of the intervals of the quantiles");
  visit("error_rate", double{error_rate},
        "at most so often all tests together find a difference where there is none");
  visit("tests", row.tests, "that Holm's correction is over");
  visit("statistics", row.statistics, Says().not_empty());
  visit("setups", row.setups,
        Says("the exact motion first, its variants, the engines").not_empty());
  visit("comparisons", row.comparisons, "of each setup but the first with the first");
  visit("atlas", row.atlas, "of the exact motion over the first two grids; null: there are none");
}

}  // namespace ensemble_rows

namespace {

using namespace ensemble_rows;

Summed row_of(const Summary& summary) {
  const bool some = summary.count > 0;
  Summed row{summary.count,
             summary.without,
             some ? std::optional(summary.mean) : std::nullopt,
             some ? std::optional(summary.deviation) : std::nullopt,
             {}};
  for (std::size_t place = 0; place < quantile_parts.size(); ++place) {
    row.quantiles.push_back({quantile_parts[place], summary.quantiles[place]});
  }
  return row;
}

SetupRow setup_row(const EnsembleReport& report, std::size_t place) {
  const EnsembleSetup& setup = report.request.setups[place];
  const Findings& findings = report.findings;
  SetupRow row{printable(setup.name),
               std::string(to_string(setup.exact.law)),
               setup.exact.completion,
               std::nullopt,
               report.result.draws[place].ended(),
               findings.problems[place],
               printable(findings.first_problems[place]),
               {}};
  for (std::size_t index = 0; index < findings.statistics.size(); ++index) {
    const Statistic& statistic = findings.statistics[index];
    const Summary& summary = findings.summaries[place][index];
    if (tells(setup, statistic, summary)) {
      row.statistics.rows.emplace_back(statistic.name, row_of(summary));
    }
  }
  if (setup.engine) {
    const RegisteredEngine& one = report.request.engines[*setup.engine];
    row.engine = {one.name, printable(one.info->version), setup.model, setup.step};
  }
  return row;
}

std::optional<MapsRow> maps_of(const EnsembleReport& report) {
  const std::optional<Atlas> atlas = atlas_of(report);
  if (!atlas) {
    return std::nullopt;
  }
  MapsRow result;
  for (const Varied& axis : atlas->axes) {
    result.axes.push_back({axis.quantity, axis.distribution.numbers});
  }
  for (const AtlasMap& map : atlas->maps) {
    result.maps.rows.emplace_back(report.findings.statistics[map.statistic].name, map.cells);
  }
  return result;
}

}  // namespace

std::string ensemble_json(const EnsembleReport& report) {
  const EnsembleSpec& spec = report.request.spec;
  Ensemble row{printable(name_of(spec.the_case)),
               duration_of(spec.the_case),
               draw_count(spec),
               spec.seed,
               spec.sampling == Sampling::sobol ? "sobol" : "random",
               {spec.speeds.begin(), spec.speeds.end()},
               report.result.interrupted || report.result.goes_on,
               report.findings.tests(),
               report.findings.statistics,
               {},
               {},
               maps_of(report)};
  for (std::size_t place = 0; place < report.request.setups.size(); ++place) {
    row.setups.push_back(setup_row(report, place));
  }
  for (const Comparison& one : report.findings.comparisons) {
    row.comparisons.push_back({printable(report.request.setups[one.setup].name),
                               report.findings.statistics[one.statistic].name, one});
  }
  return text_of(json_of(row));
}

std::string ensemble_schema_json() {
  return text_of(headed("What `tautline ensemble --json` writes",
                        "Statistics of many draws of a case, by setup, and whether their "
                        "distributions can be told apart.",
                        schema_of(Ensemble())));
}

}  // namespace tautline::bench
