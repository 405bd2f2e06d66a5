#include <fmt/format.h>

#include <CLI/CLI.hpp>
#include <memory>
#include <utility>

#include "bench/base/process.hpp"
#include "bench/base/text.hpp"
#include "bench/gate/gate_text.hpp"
#include "bench/program/commands.hpp"
#include "bench/program/common.hpp"
#include "bench/program/request.hpp"
#include "bench/program/results.hpp"
#include "bench/report/words.hpp"
#include "bench/store/manifest.hpp"
#include "bench/store/shard.hpp"
#include "bench/suite/step_search.hpp"

namespace tautline::bench {
namespace {

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

/// Which step each model needs.
int within_command(const Request& request) {
  const SuiteOptions& options = request.options;
  const std::vector<Reference> references = solve_all(options.cases, options.law);
  catch_interruption();
  std::vector<std::string> problems;
  const auto search = [&](const auto& reference) {
    const StepNeeded needed = step_needed(reference, *request.within);
    StepSearch steps = search_steps(options, reference, needed);
    const std::string name = printable(reference.the_case.name);
    const std::size_t searched = steps.found.size();
    if (!steps.measured() && !interruption()) {
      problems.push_back(
          fmt::format("{}: {}", name,
                      searched == 0 ? "no engine that works has a model to search"
                                    : "no run of any model came to the end: the table says why"));
    }
    fmt::print("{}", steps_text(reference, needed, std::move(steps.found)));
    if (interruption()) {
      problems.push_back(fmt::format("interrupted: of {}, {} of {} models are searched", name,
                                     searched, steps.models));
    }
  };
  for (const Reference& any : references) {
    fmt::print("{}", &any == references.data() ? "" : "\n");
    std::visit(search, any);
    if (interruption()) {
      break;
    }
  }
  return complain(problems) ? exit_failed : exit_done;
}

int bench_command(const BenchCommand& command) {
  const Request request = read_request(command);
  if (complain(request.problems)) {
    return exit_usage;
  }
  if (request.within) {
    return within_command(request);
  }
  auto [tree, manifest, result, report, replay] = run_request(request, command.command_line);
  const ResultsTarget target = {command.out, command.json, command.gate, request.listed,
                                command.all};
  report.live_page = command.playground;
  write_results(target, report, replay);
  print_results(target, report, what_was_done(request, result, report.context));
  if (result.interrupted) {
    const char* left = result.runs.size() == result.due ? ", the draws are not" : "";
    complain(
        {fmt::format("interrupted: {} of {} runs are finished and in the report{}; the same "
                     "command with --resume does the rest",
                     result.runs.size(), result.due, left)});
    return exit_failed;
  }
  manifest.shard.elapsed = report.context.elapsed;
  write_manifest(command.out, manifest);
  if (!command.list_problems.empty()) {
    write_output(command.list_problems,
                 problems_file_of(report, request.listed_before, request.listed));
  }
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
