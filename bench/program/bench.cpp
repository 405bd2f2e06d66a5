#include <fmt/chrono.h>
#include <fmt/format.h>

#include <CLI/CLI.hpp>
#include <algorithm>
#include <chrono>
#include <cmath>
#include <ctime>
#include <memory>
#include <thread>

#include "bench/base/atomic_file.hpp"
#include "bench/base/process.hpp"
#include "bench/base/progress.hpp"
#include "bench/base/text.hpp"
#include "bench/cases/catalogue.hpp"
#include "bench/gate/broken.hpp"
#include "bench/gate/gate_text.hpp"
#include "bench/gate/verdict.hpp"
#include "bench/program/commands.hpp"
#include "bench/program/common.hpp"
#include "bench/program/limit_names.hpp"
#include "bench/program/options.hpp"
#include "bench/report/html/page.hpp"
#include "bench/report/json/json.hpp"
#include "bench/report/markdown.hpp"
#include "bench/report/scorecard/pull_request.hpp"
#include "bench/report/scorecard/scorecard.hpp"
#include "bench/report/terminal.hpp"
#include "bench/suite/motion_files.hpp"
#include "bench/suite/report_of.hpp"
#include "bench/suite/suite.hpp"
#include "bench/suite/tree.hpp"

namespace tautline::bench {
namespace {

using Clock = std::chrono::steady_clock;

/// What `tautline bench` was asked.
struct BenchCommand {
  std::vector<std::string> cases;
  std::vector<std::string> engines;
  std::vector<std::string> models;
  std::vector<double> steps = {1e-2, 1e-3, 1e-4};  // [s]
  std::optional<double> until;                     // [s], instead of each case's duration
  ImpactLaw law = ImpactLaw::simultaneous;
  std::filesystem::path out = "results";
  std::optional<unsigned> jobs;  // one per core if not given
  bool resume = false;
  double time_limit = 60.0;         // [s]
  std::optional<std::string> gate;  // limits file; breaking it makes the exit code 1
  std::string json;
  std::string command_line;  // as it was typed, for the report
};

/// What the command line asks for, or every sentence of what is wrong with it.
struct Request {
  SuiteOptions options;
  Limits limits;  // of --gate, or those that ship
  std::vector<std::string> problems;
};

void append(std::vector<std::string>& sentences, const std::vector<std::string>& more) {
  sentences.insert(sentences.end(), more.begin(), more.end());
}

Request read_request(const BenchCommand& command) {
  Request request;
  SuiteOptions& options = request.options;
  const std::vector<std::string> everything = {"breakwater/*"};
  CaseSelection selection = select_cases(command.cases.empty() ? everything : command.cases);
  append(request.problems, selection.problems);
  options.cases = std::move(selection.cases);
  if (command.until && !(*command.until > 0.0 && std::isfinite(*command.until))) {
    request.problems.push_back(
        fmt::format("--until {}: must be a finite number above 0 [s]", *command.until));
  } else {
    for (Case& the_case : options.cases) {
      the_case.duration = command.until.value_or(the_case.duration);
    }
  }
  EngineChoice choice = choose_engines(command.engines);
  append(request.problems, choice.problems);
  append(request.problems, unknown_models(choice.engines, command.models));
  options.engines = std::move(choice.engines);
  options.models = command.models;
  options.steps = command.steps;
  options.law = command.law;
  options.out = command.out;
  options.resume = command.resume;
  options.limits.time = command.time_limit;
  options.jobs = command.jobs.value_or(std::max(1U, std::thread::hardware_concurrency()));
  append(request.problems, suite_problems(options));
  append(request.problems, missing_folder("--json", command.json, command.out));
  if (command.gate) {
    LimitsReading reading =
        read_limits_file(*command.gate, limit_names(options.engines, options.cases));
    append(request.problems, reading.problems);
    request.limits = std::move(reading.limits).value_or(Limits());
  } else {
    request.limits = shipped_limits();
  }
  if (command.out.empty()) {
    request.problems.emplace_back("--out: is empty; give a folder to write the results to");
  }
  return request;
}

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

void write_reports(const BenchCommand& command, const Report& report) {
  const std::string json = report_json(report);
  write_file(command.out / "report.json", json);
  write_file(command.out / "report.md", report_markdown(report));
  write_motions(command.out, report);
  write_file(command.out / "index.html", report_html(report, page_assets()));
  write_file(command.out / "summary.md", summary_markdown(report));
  for (const Scorecard& card : scorecards(report)) {
    write_file(command.out / card_name(card.engine), card_svg(report, card.engine));
  }
  if (!command.json.empty()) {
    write_output(command.json, json);
  }
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
  Progress progress(plan(options).size(), "runs");
  const SuiteResult result =
      run_suite(options, references, [&](std::size_t ended) { progress.show(ended); });
  progress.finish();
  context.elapsed = std::chrono::duration<double>(Clock::now() - start).count();
  context.program_memory = peak_memory();
  Report report = report_of(options, references, result, std::move(context));
  add_verdicts(report, request.limits);
  write_reports(command, report);
  if (command.json != "-") {
    fmt::print(
        "{}\n{} runs in {:.1f} s, {:.0f} MB; report: {}, with report.md and report.json "
        "beside it\n",
        report_summary(report, output_style()), result.runs.size(), report.context.elapsed,
        (report.context.program_memory + options.jobs * report.context.worker_memory) / 1e6,
        (command.out / "index.html").string());
  }
  if (result.interrupted) {
    complain(
        {fmt::format("interrupted: {} of {} runs are finished and in the report; the same "
                     "command with --resume does the rest",
                     result.runs.size(), result.planned)});
    return exit_failed;
  }
  if (command.gate) {  // a known failure does not break it
    const std::vector<BrokenRow> broken = broken_rows(report, request.limits);
    fmt::print(command.json == "-" ? stderr : stdout, "\n{}",
               gate_text(report, request.limits, broken));
    return broken.empty() ? exit_done : exit_failed;
  }
  return any_failure(report) ? exit_failed : exit_done;
}

void print_schema() {
  fmt::print("{}", report_schema_json());
  throw CLI::Success();  // as --help ends
}

}  // namespace

void add_bench(CLI::App& app, int& code, const std::string& command_line) {
  CLI::App* const command =
      app.add_subcommand("bench", "Cases x engines x models x steps: all their runs, and a report");
  const auto asked = std::make_shared<BenchCommand>();
  asked->command_line = command_line;
  command->add_option("CASES", asked->cases, case_help)->default_str("'breakwater/*'");
  command
      ->add_option("--engines,--engine", asked->engines,
                   "names or plug-in paths: bullet64,./libmine.so (default: all)")
      ->delimiter(',')
      ->allow_extra_args(false);  // a case may follow
  command->add_option("--models", asked->models, "only these models: row,event (default: all)")
      ->delimiter(',')
      ->allow_extra_args(false);
  command->add_option("--steps", asked->steps, "steps [s]")
      ->delimiter(',')
      ->allow_extra_args(false)
      ->capture_default_str();
  command->add_option("--until", asked->until, "end every run at this time [s]");
  add_law(*command, asked->law, law_help);
  command->add_option("--out", asked->out, "folder for the report and the runs' files")
      ->capture_default_str();
  command->add_option("--jobs", asked->jobs, "runs at a time (default: one per core)");
  command->add_flag("--resume", asked->resume, "keep the runs that --out already has");
  command->add_option("--time-limit", asked->time_limit, "end a run after this long [s]")
      ->capture_default_str();
  command
      ->add_option("--json", asked->json,
                   "also write the report as JSON to this file, or to stdout: -")
      ->check(named_file);
  command->add_flag_callback("--schema", print_schema,
                             "print the JSON schema of report.json, and end");
  command->add_option(
      "--gate", asked->gate,
      "a limits file (TOML): print the runs that break a limit, and end with exit code 1");
  command->callback([asked, &code] { code = bench_command(*asked); });
}

}  // namespace tautline::bench
