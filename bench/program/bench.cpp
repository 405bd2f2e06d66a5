#include <fmt/format.h>

#include <CLI/CLI.hpp>
#include <chrono>
#include <memory>
#include <numeric>

#include "bench/base/process.hpp"
#include "bench/base/progress.hpp"

#include "bench/gate/verdict.hpp"
#include "bench/measure/certification.hpp"
#include "bench/program/commands.hpp"
#include "bench/program/common.hpp"
#include "bench/program/suites/request.hpp"
#include "bench/program/suites/results.hpp"
#include "bench/report/words.hpp"
#include "bench/suite/manifest.hpp"
#include "bench/suite/report_of.hpp"
#include "bench/suite/shard.hpp"
#include "bench/suite/suite.hpp"
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

/// "quick suite: 576 runs in 41.2 s, 136 MB", "shard 3/16: 36 of 576 runs in 3.1 s, 90 MB".
std::string what_was_done(const Request& request, const SuiteResult& result,
                          const Context& context) {
  std::string out = request.suite != nullptr ? fmt::format("{} suite", request.suite->name) : "";
  if (const Shard shard = request.options.shard; shard.of > 1) {
    out += fmt::format("{}shard {}", out.empty() ? "" : ", ", to_string(shard));
  }
  const std::string runs = result.due < result.planned ? fmt::format("{} of {}", result.runs.size(),
                                                                     counted(result.planned, "run"))
                                                       : counted(result.runs.size(), "run");
  return fmt::format("{}{}{} in {:.1f} s, {:.0f} MB", out, out.empty() ? "" : ": ", runs,
                     context.elapsed,
                     (context.program_memory + request.options.jobs * context.worker_memory) / 1e6);
}

int bench_command(const BenchCommand& command) {
  const Request request = read_request(command);
  if (!request.problems.empty()) {
    complain(request.problems);
    return exit_usage;
  }
  const SuiteOptions& options = request.options;
  Context context;
  context.command = command.command_line;
  context.started = now_utc();
  const auto start = Clock::now();
  const std::vector<ReferenceCase> references = solve_cases(options.cases, options.law);
  catch_interruption();  // up to here nothing has been touched
  const Descriptor tree = open_tree(options.out, !options.resume);
  Manifest manifest = manifest_of(options, context.command, context.started);
  write_manifest(options.out, manifest);  // before the first run: a tree that is cut off has it
  // of a suite in parts that is for the merge of them
  Certification certification(references, options.certify && options.shard.of == 1);
  const SuiteResult result = run_visibly(options, references);
  const auto digits = certification.digits();
  context.elapsed = seconds_since(start);
  context.program_memory = peak_memory();
  Report report = report_of(options, references, digits, result, std::move(context));
  add_verdicts(report, request.limits);
  const ResultsTarget target = {command.out, command.json, command.gate, request.limits};
  write_results(target, report);
  print_results(target, report, what_was_done(request, result, report.context));
  if (result.interrupted) {
    complain(
        {fmt::format("interrupted: {} of {} runs are finished and in the report; the same "
                     "command with --resume does the rest",
                     result.runs.size(), result.due)});
    return exit_failed;
  }
  manifest.shard.elapsed = report.context.elapsed;
  write_manifest(options.out, manifest);
  return judged(target, report);
}

}  // namespace

void add_bench(CLI::App& app, int& code, const std::string& command_line) {
  CLI::App* const command =
      app.add_subcommand("bench", "Cases x engines x models x steps: all their runs, and a report");
  const auto asked = std::make_shared<BenchCommand>();
  asked->command_line = command_line;
  add_bench_options(*command, *asked);
  command->callback([asked, &code] { code = bench_command(*asked); });
}

}  // namespace tautline::bench
