#include "bench/program/suites/running.hpp"

#include <chrono>
#include <numeric>
#include <utility>

#include "bench/base/process.hpp"
#include "bench/base/progress.hpp"
#include "bench/gate/verdict.hpp"
#include "bench/measure/certification.hpp"
#include "bench/program/suites/results.hpp"
#include "bench/suite/draws/compare_draws.hpp"
#include "bench/suite/manifest.hpp"
#include "bench/suite/report_of.hpp"
#include "bench/suite/shard.hpp"
#include "bench/suite/tree.hpp"

namespace tautline::bench {
namespace {

using Clock = std::chrono::steady_clock;

double seconds_since(Clock::time_point start) {
  return std::chrono::duration<double>(Clock::now() - start).count();
}

/// Runs the suite and shows how far it is.
SuiteResult run_visibly(const SuiteOptions& options, const std::vector<ReferenceCase>& references) {
  const std::vector<PlannedRun> runs = plan(options);
  const std::vector<std::size_t> due = places_in_shard(options);
  const double work = std::accumulate(
      due.begin(), due.end(), 0.0,
      [&](double sum, std::size_t place) { return sum + expected_cost(options, runs[place]); });
  Progress progress(work, due.size(), "runs");
  SuiteResult result = run_suite(options, references, [&](const PlannedRun& run, bool kept) {
    progress.ended(expected_cost(options, run), kept);
  });
  progress.finish();
  return result;
}

}  // namespace

RunSuite run_request(const Request& request, const std::string& command_line) {
  const SuiteOptions& options = request.options;
  Context context;
  context.command = command_line;
  context.started = now_utc();
  const auto start = Clock::now();
  const std::vector<ReferenceCase> references = solve_cases(options.cases, options.law);
  catch_interruption();  // up to here nothing has been touched
  Descriptor tree = open_tree(options.out, !options.resume);
  Manifest manifest = manifest_of(options, context.command, context.started);
  write_manifest(options.out, manifest);  // before the first run: a tree that is cut off has it
  // of a suite in parts that is for the merge of them
  Certification certification(references, options.certify && options.shard.of == 1);
  SuiteResult result = run_visibly(options, references);
  const auto digits = certification.digits();
  std::optional<Distributions> distributions;
  if (options.draws > 0 && !result.interrupted) {
    distributions = compare_draws(options);
    result.interrupted = interruption();
  }
  context.elapsed = seconds_since(start);
  context.program_memory = peak_memory();
  Report report = report_of(options, references, digits, result, std::move(context));
  report.distributions = std::move(distributions);
  add_verdicts(report, request.limits);
  return {std::move(tree), std::move(manifest), std::move(result), std::move(report)};
}

}  // namespace tautline::bench
