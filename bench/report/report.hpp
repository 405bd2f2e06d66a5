#pragma once

#include <Eigen/Core>
#include <algorithm>
#include <array>
#include <cstddef>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "bench/judge/models.hpp"
#include "bench/judge/step_needed.hpp"
#include "bench/measure/attribution/attribution.hpp"
#include "bench/measure/audit.hpp"
#include "bench/measure/metric_list.hpp"
#include "bench/solution/certificate.hpp"
#include "tautline/case.hpp"
#include "tautline/engine.hpp"
#include "tautline/settling.hpp"

namespace tautline::bench {

// A report: what a suite leaves, row by row. report/json/json.hpp writes and reads it; all tables,
// the gate and the comparison of two reports are drawn from it alone.

/// The page of a report of so many cases has the motions of all runs in it; of more cases, they lie
/// in a file for each case next to it.
inline constexpr std::size_t most_cases_in_page = 1;

/// The engine that is the exact solution itself; its rows stand apart.
inline constexpr const char* control = "exact";

/// The number of the report's form: its key `schema`.
inline constexpr int report_schema = 6;

/// One run among those of a report.
struct RunKey {
  std::string the_case;
  std::string engine;
  std::string model;
  double step = 0.0;  // [s]

  auto operator<=>(const RunKey&) const = default;  // NOLINT(modernize-use-nullptr): it has none
};

/// The runs of one engine, model and step over the cases.
struct SetupKey {
  std::string engine;
  std::string model;
  double step = 0.0;  // [s]

  auto operator<=>(const SetupKey&) const = default;  // NOLINT(modernize-use-nullptr): it has none
};
[[nodiscard]] inline SetupKey setup_of(const RunKey& run) {
  return {run.engine, run.model, run.step};
}

/// How a run ended.
enum class Status {
  finished,
  stopped,      // its simulation could go no further, late enough to be compared
  diverged,     // the body left every reasonable range
  failed,       // crashed, timed out, gave nonsense, or stopped too early
  unsupported,  // the engine says that it cannot do what the case or the options ask for
};
[[nodiscard]] const char* to_string(Status status);

/// A run that ended as it should: finished, or stopped where its model goes no further, or was not
/// begun as the engine cannot do it.
[[nodiscard]] constexpr bool did_its_work(Status status) {
  return status != Status::diverged && status != Status::failed;
}

/// What the comparison with the exact motion says beside the metrics of the list.
struct RunDetails {
  struct OfWindow {
    double until = 0.0;    // [s]
    double covered = 0.0;  // [s]
    std::size_t exact = 0;
    std::size_t found = 0;
    std::size_t matched = 0;
  };
  std::array<OfWindow, windows.size()> of_windows;  // by Window
  std::vector<LastImpactMatch> last_impacts;
  std::optional<SwingMatch> swing;
  std::optional<MeasuredRestitution> restitution;
  std::optional<ExactAndFound> rest_tension;     // [N]
  std::optional<ExactAndFound> largest_tension;  // [N]
  std::optional<ExactAndFound> first_impulse;    // [N s]
  std::optional<ContactMatch> contacts;          // none without an elastic cable
  std::size_t stride = 1;                        // every stride-th step was sampled
  std::size_t recorded_impacts = 0;              //
  std::size_t slow_impacts = 0;                  // that were only counted

  [[nodiscard]] const OfWindow& in(Window window) const {
    return of_windows[static_cast<std::size_t>(window)];
  }
};

/// What a verdict comes to: the words that everything says. Their meanings: words.hpp.
enum class Word { sound, listed_problem, problem, too_few };
inline constexpr std::array all_words = {Word::sound, Word::listed_problem, Word::problem,
                                         Word::too_few};
[[nodiscard]] const char* to_string(Word word);  // "sound", "listed problem", ...

/// The kinds of problems that a run can have.
inline constexpr std::array<std::string_view, 12> problem_kinds = {
    "failure", "restitution", "position", "events",   "missed-impacts",     "overstretch",
    "energy",  "flight",      "rotation", "sleeping", "tangential-impulse", "angular-impulse"};

/// True where a finding of the audit of this kind is a problem of its own; a finding on rebounds is
/// the judgement's, and how long an impact takes is none.
[[nodiscard]] constexpr bool is_problem(std::string_view finding) {
  return finding == "sleeping" || finding == "tangential-impulse" || finding == "angular-impulse";
}

/// Something that is wrong with a run.
struct Problem {
  std::string kind;             // of `problem_kinds`
  std::string sentence;         // what, with its numbers
  std::optional<double> value;  // of the kind: a ratio, a deviation, a count
  bool listed = false;          // among the problems that a person has listed
  std::string reason;           // why it is there; of one that is not listed ""
};

struct Verdict {
  Word word = Word::too_few;
  std::vector<Problem> problems;
};

/// One run.
struct RunRow {
  RunKey key;
  Status status = Status::finished;
  std::string reason;                      // of any status but finished
  std::optional<std::string> output_tail;  // the last that a run that failed printed
  std::optional<MetricValues> metrics;     // none where there is nothing to compare
  std::optional<RunDetails> details;       // set exactly where `metrics` is
  std::optional<Ladder> ladder;
  std::optional<Judgement> judgement;  // set exactly where `metrics` is
  std::optional<Attribution> attribution;
  std::optional<Verdict> verdict;

  /// The metric at this place of the list; none too where there are no metrics.
  [[nodiscard]] std::optional<double> metric(std::size_t place) const {
    return metrics ? metrics->at(place) : std::nullopt;
  }
};

/// A cable as a page draws it.
struct CableRow {
  Vec2 anchor = Vec2::Zero();
  Vec2 attachment = Vec2::Zero();
  double length = 0.0;                // [m]
  std::optional<double> restitution;  // none where it depends on the speed
};

/// Up to when a step-by-step model can follow a case, and what it tells of restitution: from the
/// exact motion alone.
struct Predictable {
  double step = 0.0;               // [s]
  double until = 0.0;              // [s]
  Barrier barrier = Barrier::end;  // why not for longer
  std::size_t readable = 0;  // impacts of the exact motion that a run of this step can be read by
};

/// A case in the plane as a page draws it at rest.
struct PlaneRow {
  Body body;
  Vec2 gravity = Vec2::Zero();  // [m/s^2]
  std::vector<CableRow> geometry;
};

/// Numbers that are given over time: see `BasicFunction`, whose parts these are.
struct FunctionRow {
  struct Piece {
    double from = 0.0;                              // [s]
    std::vector<std::vector<double>> coefficients;  // in rising order, of the time since `from`
  };
  struct Wave {
    std::vector<double> amplitude;
    double frequency = 0.0;  // [rad/s]
    double phase = 0.0;      // [rad]
  };
  std::vector<Piece> pieces;
  std::vector<Wave> waves;
};

/// An end of a cable of a system, or a ring.
struct EndRow {
  std::optional<std::size_t> body;    // index; none: the world
  std::vector<double> at;             // x, y, z [m], in the body's frame or the world
  std::optional<FunctionRow> motion;  // [m], added to it; none: it stays there
};
/// How an elastic cable pulls: the numbers of its `Elasticity`.
struct ElasticityRow {
  std::vector<double> stiffness;             // [N/m, N/m^2, ...], or [N] where it is of the strain
  std::vector<std::vector<double>> corners;  // stretch or strain, and the stiffness from there on
  bool of_strain = false;
  double damping = 0.0;        // [N s/m]
  double damping_ratio = 0.0;  // [-]
  std::string cut;             // force, stretch or never
};
struct SystemCableRow {
  EndRow from;
  std::vector<EndRow> through;
  EndRow to;
  double length = 0.0;                // [m], at the start
  std::optional<double> restitution;  // none where it depends on the speed, or of an elastic cable
  std::optional<FunctionRow> length_over_time;  // [m]; none: it stays as it is
  std::optional<double> from_time;              // [s], when it is hooked up; none: from the start
  std::optional<double> cut_at;                 // [s]; none: never
  std::optional<ElasticityRow> elasticity;      // none: it is inextensible
};
struct SystemBodyRow {
  std::string name;
  double mass = 0.0;            // [kg]
  std::vector<double> inertia;  // [kg m^2], three principal moments; 0: a point mass
};
/// A system in space as a report shows it.
struct SystemRow {
  std::string hash;  // of its case file
  std::vector<SystemBodyRow> bodies;
  std::vector<double> gravity;  // x, y, z [m/s^2], at the start
  std::vector<SystemCableRow> cables;
};

/// What the exact solution says of a case, and what a page needs to draw it at rest.
struct CaseRow {
  std::string name;
  std::string title;  // what tells it from others, in words
  std::size_t cables = 0;
  double duration = 0.0;  // [s]
  std::string ending;
  double end_time = 0.0;            // [s], of the exact solution
  double horizon = 0.0;             // [s]
  std::size_t counted_impacts = 0;  //
  double start_energy = 0.0;        // [J]
  double end_energy = 0.0;          // [J]
  Settling settling;
  std::optional<PlaneRow> plane;         // one of the two
  std::optional<SystemRow> system;       //
  double extent = 0.0;                   // [m], what the anchors and the exact motion cover
  std::optional<Eigen::Vector3d> start;  // x, y [m] and angle [rad]; in JSON that of its path
  std::string live;                      // its address in the live page, not in JSON
  std::optional<std::string> motions;    // file beside the page with those of its runs; none: in it
  std::optional<CertifiedDigits> certified;  // none where it was not asked for
  std::vector<Predictable> predictable;      // for each step of the suite
  std::optional<StepNeeded> step_needed;     // for the usual question

  /// The cables of a case in the plane; none of a system.
  [[nodiscard]] const std::vector<CableRow>& geometry() const {
    static const std::vector<CableRow> none;
    return plane ? plane->geometry : none;
  }
  /// The restitution that all inextensible cables have [-]; none where there are none, they differ
  /// or it depends on the speed.
  [[nodiscard]] std::optional<double> asked_restitution() const {
    std::vector<std::optional<double>> asked;
    for (const CableRow& cable : geometry()) {
      asked.push_back(cable.restitution);
    }
    for (const SystemCableRow& cable : system ? system->cables : std::vector<SystemCableRow>()) {
      if (!cable.elasticity) {
        asked.push_back(cable.restitution);
      }
    }
    const bool same = std::count(asked.begin(), asked.end(), asked.empty() ? 0.0 : asked.front()) ==
                      static_cast<std::ptrdiff_t>(asked.size());
    return same && !asked.empty() ? asked.front() : std::nullopt;
  }
};

/// An engine, or why there are no runs of it.
struct EngineRow {
  std::string name;
  std::optional<EngineInfo> info;
  std::optional<std::string> problem;
  bool missing = false;  // there is no plug-in, as opposed to one that failed
};

/// Median and worst over some cases.
struct MedianAndWorst {
  std::optional<double> median;  // none of an extreme
  double worst = 0.0;
};

/// The answers for one engine, model and step over all cases.
struct SummaryRow {
  SetupKey key;
  std::size_t cases = 0;
  std::size_t failed = 0;         // of them
  std::size_t exact = 0;          // impacts up to the horizon
  std::size_t found = 0;          //
  std::size_t matched = 0;        //
  std::size_t exact_settled = 0;  // cases whose exact motion locks: see LastImpactMatch
  std::size_t found_settled = 0;  // runs that have the last impact
  std::vector<std::optional<MedianAndWorst>> metrics;  // of the list; none without a value
};

/// Of log error over log step.
struct Slope {
  double smallest = 0.0;
  double median = 0.0;
  double largest = 0.0;
};

/// How fast errors shrink with the step.
struct ConvergenceRow {
  std::string engine;
  std::string model;
  std::size_t cases = 0;              // with a slope
  std::size_t cases_at_rounding = 0;  // whose errors do not shrink, being rounding
  std::optional<Slope> slope;
};

/// The causes of deviations for one engine, model and step over all cases.
struct CausesRow {
  SetupKey key;
  std::size_t cases = 0;
  std::optional<MedianAndWorst> deviation;  // [m]
  std::optional<CauseParts> shares;         // [-], mean of each cause: they add up to 1
  std::optional<double> covered;            // [-] of the horizon, median: later is not attributed
  std::optional<double> remainder;          // [-] of the deviation, largest
  std::optional<double> model_share;        // [-], mean, where cables are soft: of `SoftParts`
};

/// The causes that the rows of a report tell of.
[[nodiscard]] inline std::span<const Cause> causes_of(const std::vector<CausesRow>& rows) {
  std::span<const Cause> most = causes_of(CauseParts{});
  for (const CausesRow& row : rows) {
    const auto some = causes_of(row.shares.value_or(CauseParts{}));
    most = some.size() > most.size() ? some : most;
  }
  return most;
}

/// How far numbers lie about their median.
struct Spread {
  double smallest = 0.0;
  double lower = 0.0;  // quartile
  double upper = 0.0;  // quartile
};

/// What one run cost: medians over repetitions of the same motion.
struct TimingRow {
  RunKey key;
  double memory = 0.0;          // [bytes], the most the worker held at once
  double step_cost = 0.0;       // [s], processor time of one step
  double reference_cost = 0.0;  // [s], of one closed-form flight and its gaps
  double cost_ratio = 0.0;      // [-], of the two
  double second_cost = 0.0;     // [s], processor time of one simulated second
  Spread second_spread;         // [s], of that over the repetitions
  std::size_t repetitions = 0;  //
};

/// The cost for one engine, model and step: medians over the cases.
struct CostRow {
  SetupKey key;
  double cost_ratio = 0.0;   // [-]
  double second_cost = 0.0;  // [s]
  Spread second_spread;      // [s], of that over the cases
  std::size_t cases = 0;
};

/// What was asked of the suite.
struct ReportOptions {
  std::vector<double> steps;  // [s]
  std::string law;
  double count_speed = 0.0;  // [m/s]
  std::size_t early_impacts = 0;
  double time_limit = 0.0;    // [s]
  double memory_limit = 0.0;  // [bytes]
  bool certify = false;       // each case, in many digits
};

/// A statistic of many draws of a case, by one engine, model and step: how far its distribution is
/// from that of the exact motions.
struct DistributionRow {
  std::string statistic;         // by its name
  std::optional<double> median;  // none where fewer than half of the draws have a value
  double distance = 0.0;         // [-], Kolmogorov's and Smirnov's D: 0 for the same, 1 for apart
  double probability = 1.0;      // of one as large by chance, of this or the energy distance,
                                 // corrected for all tests together
  double visible = 1.0;          // [-], the smallest D that would be called a difference
  bool differs = false;          // by D or by the energy distance
};

/// The draws of one engine, model and step.
struct DistributionsRow {
  SetupKey key;
  std::size_t failed = 0;                   // draws without values
  std::vector<DistributionRow> statistics;  // fewer than `Distributions` has where some are unknown
};

/// What many draws of one case say of the engines, where a single run says nothing: beyond its
/// horizon.
struct Distributions {
  struct Statistic {
    std::string name;
    std::string heading;
    std::string unit;              // or empty
    std::optional<double> median;  // of the exact motions
  };
  std::string the_case;
  std::size_t draws = 0;
  double deviation = 0.0;  // [m], [rad], [m/s], [rad/s]: of each number of the start
  std::string page;        // beside the report
  std::vector<Statistic> statistics;
  std::vector<DistributionsRow> setups;
};

/// Where the listed problems come from.
struct ProblemsSource {
  std::string file;
  std::string version;
};

/// One of the parts that a suite was dealt out in, and how it was made.
struct ShardRow {
  std::size_t number = 1;  // from 1 to `of`
  std::size_t of = 1;
  std::string command;   // as it was typed
  std::string started;   // ISO 8601, UTC
  double elapsed = 0.0;  // [s]; 0 of one that did not come to its end
  std::string processor;
  std::size_t cores = 0;
};

/// What made the report: all that differs from machine to machine and from day to day.
struct Context {
  std::string command;          // as it was typed
  std::string started;          // ISO 8601, UTC
  double elapsed = 0.0;         // [s]
  double program_memory = 0.0;  // [bytes], the most this program held at once
  double worker_memory = 0.0;   // [bytes], the most one worker held
  std::size_t kept_runs = 0;    // taken from an earlier invocation
  std::string processor;
  std::size_t cores = 0;
  std::string compiler;
  std::string build_type;
  std::string flags;
  std::string commit;
  std::vector<CostRow> costs;
  std::vector<TimingRow> timing;
  std::vector<ShardRow> shards;  // that were merged; none of one machine's report
};

struct Report {
  std::string version;  // of the program
  bool complete = true;
  std::size_t planned_runs = 0;
  ReportOptions options;
  std::vector<EngineRow> engines;
  /// The models of each engine that run no system, and those of its others that run no elastic
  /// cable where a system has one; not in JSON.
  std::vector<std::string> in_the_plane_alone;
  std::vector<std::string> inextensible_alone;
  std::vector<CaseRow> cases;
  std::vector<SummaryRow> summary;
  std::vector<ConvergenceRow> convergence;
  std::vector<ModelJudgement> models;
  std::vector<Finding> findings;
  std::vector<CausesRow> causes;
  std::vector<RunRow> runs;
  std::optional<ProblemsSource> listed;        // none without verdicts
  std::optional<Distributions> distributions;  // none where no draws were asked for
  Context context;
  std::string live_page;  // where it is, for links of the page; empty: nowhere. Not in JSON

  /// True where runs have contacts of elastic cables.
  [[nodiscard]] bool has_contacts() const {
    return std::any_of(runs.begin(), runs.end(),
                       [](const RunRow& run) { return run.details && run.details->contacts; });
  }
};

}  // namespace tautline::bench
