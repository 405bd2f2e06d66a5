#include "bench/program/results.hpp"

#include <fmt/chrono.h>
#include <fmt/format.h>

#include <algorithm>
#include <chrono>
#include <ctime>
#include <numeric>
#include <utility>

#include "bench/base/atomic_file.hpp"
#include "bench/base/process.hpp"
#include "bench/base/progress.hpp"
#include "bench/base/terminal.hpp"
#include "bench/gate/gate_text.hpp"
#include "bench/gate/verdict.hpp"
#include "bench/measure/certification.hpp"
#include "bench/program/common.hpp"
#include "bench/report/json/json.hpp"
#include "bench/report/output.hpp"
#include "bench/report/scorecard.hpp"
#include "bench/store/manifest.hpp"
#include "bench/store/shard.hpp"
#include "bench/store/tree.hpp"
#include "bench/suite/draws.hpp"
#include "bench/suite/report_of.hpp"

namespace tautline::bench {
namespace {

using Clock = std::chrono::steady_clock;

double seconds_since(Clock::time_point start) {
  return std::chrono::duration<double>(Clock::now() - start).count();
}

/// Runs the suite and shows how far it is.
SuiteResult run_visibly(const SuiteOptions& options, const Expectations& expectations) {
  const std::vector<PlannedRun> runs = plan(options);
  const std::vector<std::size_t> due = places_in_shard(options);
  const double work = std::accumulate(
      due.begin(), due.end(), 0.0,
      [&](double sum, std::size_t place) { return sum + expected_cost(options, runs[place]); });
  Progress progress(work, due.size(), "runs");
  SuiteResult result = run_suite(options, expectations, [&](const PlannedRun& run, bool kept) {
    progress.ended(expected_cost(options, run), kept);
  });
  progress.finish();
  return result;
}

/// The instant that it is, ISO 8601, UTC.
std::string now_utc() {
  return fmt::format("{:%Y-%m-%dT%H:%M:%SZ}", fmt::gmtime(std::time(nullptr)));
}

/// True if a run or an engine did not do what it should.
bool any_failure(const Report& report) {
  return std::any_of(report.runs.begin(), report.runs.end(),
                     [](const RunRow& run) { return !did_its_work(run.status); }) ||
         std::any_of(report.engines.begin(), report.engines.end(), [](const EngineRow& engine) {
           return engine.problem.has_value() && !engine.missing;
         });
}

}  // namespace

RunSuite run_request(const Request& request, const std::string& command_line) {
  const SuiteOptions& options = request.options;
  Context context;
  context.command = command_line;
  context.started = now_utc();
  const auto start = Clock::now();
  const std::vector<Reference> references = solve_all(options.cases, options.law);
  const Expectations expectations = expectations_of(references);
  catch_interruption();  // up to here nothing has been touched
  Descriptor tree = open_tree(options.out, !options.resume);
  Manifest manifest = manifest_of(options, context.command, context.started);
  write_manifest(options.out, manifest);  // before the first run: a tree that is cut off has it
  // of a suite in parts that is for the merge of them
  Certification certification(references, options.certify && options.shard.of == 1);
  SuiteResult result = run_visibly(options, expectations);
  const auto digits = certification.digits();
  std::optional<Distributions> distributions;
  if (options.draws > 0 && !result.interrupted) {
    distributions = compare_draws(options);
    result.interrupted = interruption();
  }
  context.elapsed = seconds_since(start);
  context.program_memory = peak_memory();
  Report report = report_of(options, expectations, digits, result, std::move(context));
  report.distributions = std::move(distributions);
  add_verdicts(report, request.listed);
  Replay replay = replay_of(expectations, result);
  return {std::move(tree), std::move(manifest), std::move(result), std::move(report),
          std::move(replay)};
}

void write_results(const ResultsTarget& target, const Report& report, const Replay& replay) {
  const std::string json = report_json(report, replay);
  write_file(target.out / "report.json", json);
  write_file(target.out / "report.md", report_markdown(report));
  write_motions(target.out, report, replay);
  write_file(target.out / "index.html", report_html(report, replay, page_assets()));
  write_file(target.out / "summary.md", summary_markdown(report));
  for (const Scorecard& card : scorecards(report)) {
    write_file(target.out / card_name(card.engine), card_svg(report, card.engine));
  }
  if (!target.json.empty()) {
    write_output(target.json, json);
  }
}

void print_results(const ResultsTarget& target, const Report& report, const std::string& last) {
  if (target.json != "-") {
    fmt::print("{}\n{}; report: {}, with report.md and report.json next to it\n",
               report_summary(report, target.all, output_style()), last,
               (target.out / "index.html").string());
  }
}

int judged(const ResultsTarget& target, const Report& report) {
  if (!target.gate) {
    return any_failure(report) ? exit_failed : exit_done;
  }
  // a known failure does not break it
  const std::vector<BrokenRow> broken = broken_rows(report, target.listed);
  fmt::print(target.json == "-" ? stderr : stdout, "\n{}",
             gate_text(report, target.listed, broken));
  return broken.empty() ? exit_done : exit_failed;
}

}  // namespace tautline::bench
